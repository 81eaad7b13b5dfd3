// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_PROPOSAL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_PROPOSAL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/patches/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/patches/caps.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Part_of_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Subdivision_along_walk.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A region to be taken out of a mesh, or of what is near a loop, subdivided along it.
class Removal_proposal
{
public:
  Removal_proposal(const Surgery_mesh& mesh, Cut_region region)
      : region_(std::move(region))
      , out_(region_.faces()) {
    for(std::size_t i = 0; i < region_.number_of_borders(); ++i)
      for(Index h : region_.border(i))
        around_.push_back(mesh.face(mesh.twin(h)));
  }

  /// the faces at a simple closed walk after a subdivision. None only if the walk goes around a
  /// face, or along the boundary.
  static std::optional<Removal_proposal> subdivided(const Surgery_mesh& mesh,
                                                    const Closed_walk& walk) {
    if(is_on_boundary(mesh, walk))
      return std::nullopt;
    auto part = std::make_unique<Part_of_mesh>(mesh, walk);
    const Closed_walk walk_of_part = part->walk_of_part(walk);
    const std::vector<Index> parents = Subdivision_along_walk(part->mesh(), walk_of_part).parents();
    std::optional<Cut_region> region = Cut_region::around(part->mesh(), walk_of_part);
    if(!region)
      return std::nullopt;
    return Removal_proposal(std::move(part), std::move(*region), parents, walk);
  }

  /// the faces of the mesh that are to be replaced, in ascending order.
  const std::vector<Index>& out() const { return out_; }

  const Cut_region& region() const { return region_; }

  /// where the surface is cut if a region with two borders is taken out.
  Sides_of_cut sides(const Surgery_mesh& mesh) const {
    return is_subdivided() ? sides_of(mesh, walk_) : sides_of(mesh, region_);
  }

  bool is_subdivided() const { return part_ != nullptr; }

  /// whether the mesh is as it was here: all faces that are to be replaced, and those around them,
  /// are there. Not known of a subdivision.
  bool is_up_to_date(const Surgery_mesh& mesh) const {
    const auto is_alive = [&](Index f) { return mesh.is_alive(f); };
    return !is_subdivided() && std::all_of(out_.begin(), out_.end(), is_alive) &&
           std::all_of(around_.begin(), around_.end(), is_alive);
  }

  /// what may take the place of these faces, the best way first.
  std::vector<Patch> patches(const Surgery_mesh& mesh) const {
    if(!is_subdivided())
      return caps_of(mesh, region_);
    std::vector<Patch> ways = caps_of(part_->mesh(), region_);
    for(Patch& caps : ways)
      caps = with_parts(caps);
    return ways;
  }

private:
  Removal_proposal(std::unique_ptr<Part_of_mesh> part,
                   Cut_region region,
                   const std::vector<Index>& parents,
                   const Closed_walk& walk)
      : region_(std::move(region))
      , part_(std::move(part))
      , walk_(walk) {
    const Surgery_mesh& mesh = part_->mesh();
    const Index first_face = part_->face_bound();
    for(Index f = first_face; f < mesh.face_bound(); ++f) {
      const Index parent = part_->face(parents[f - first_face]);
      out_.push_back(parent);
      if(!mesh.is_alive(f) || region_.contains(f))
        continue;
      Surgery_mesh::Face corners = mesh.corners(f);
      for(Index& v : corners)
        v = vertex_of_patch(v);
      parts_.faces.push_back(corners);
      parts_.parents.push_back(parent);
    }
    for(Index f : region_.faces())
      if(f < first_face)
        out_.push_back(part_->face(f));
    make_set(out_);
    for(Index v = part_->vertex_bound(); v < mesh.vertex_bound(); ++v)
      parts_.points.push_back(mesh.point(v));
  }

  // The points of the subdivision come before those of the caps.
  Patch with_parts(const Patch& caps) const {
    const Index shift = static_cast<Index>(parts_.points.size());
    Patch patch = parts_;
    patch.points.insert(patch.points.end(), caps.points.begin(), caps.points.end());
    for(Surgery_mesh::Face f : caps.faces) {
      for(Index& v : f)
        v = v >= Patch::first_own ? v + shift : vertex_of_patch(v);
      patch.faces.push_back(f);
    }
    return patch;
  }

  // Of a vertex of the part.
  Index vertex_of_patch(Index v) const {
    const Index bound = part_->vertex_bound();
    return v < bound ? part_->vertex(v) : v - bound + Patch::first_own;
  }

  Cut_region region_;
  std::vector<Index> out_;
  std::vector<Index> around_; // faces beyond the borders
  // If there is a subdivision.
  std::unique_ptr<Part_of_mesh> part_; // which the region is one of
  Closed_walk walk_;
  Patch parts_; // of faces around the region
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_PROPOSAL_H
