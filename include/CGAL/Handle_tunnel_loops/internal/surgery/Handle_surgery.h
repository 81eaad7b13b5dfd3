// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_SURGERY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_SURGERY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Part_of_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_task.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// One way to remove a handle, prepared and checked: a region to be taken out of a mesh, or of what
/// is near a loop, subdivided along it; and caps that take its place.
class Handle_surgery
{
public:
  Handle_surgery(const Surgery_mesh& mesh, Cut_region region)
      : region_(std::move(region))
      , out_(region_.faces())
      , vertices_(vertices_of(mesh, out_)) {
    for(std::size_t i = 0; i < region_.number_of_borders(); ++i)
      for(Index h : region_.border(i))
        around_.push_back(mesh.face(mesh.twin(h)));
  }

  /// with the faces at a simple closed walk after a subdivision. None only if the walk goes around
  /// a face, or along the boundary.
  static std::optional<Handle_surgery> subdivided(const Surgery_mesh& mesh,
                                                  const Closed_walk& walk) {
    if(is_on_boundary(mesh, walk))
      return std::nullopt;
    auto part = std::make_unique<Part_of_mesh>(mesh, walk);
    const std::vector<Index> parents = split_edges_beside(part->mesh, part->walk);
    std::optional<Cut_region> region = Cut_region::around(part->mesh, part->walk);
    if(!region)
      return std::nullopt;
    return Handle_surgery(mesh, std::move(part), std::move(*region), parents, walk);
  }

  /// the faces of the mesh that are to be replaced, in ascending order.
  const std::vector<Index>& out() const { return out_; }

  /// of these faces, in ascending order.
  const std::vector<Index>& vertices() const { return vertices_; }

  const Cut_region& region() const { return region_; }

  bool is_strip() const { return region_.number_of_borders() == 2; }
  bool is_subdivided() const { return part_ != nullptr; }

  /// where the surface is cut if a strip is taken out.
  Sides_of_cut sides(const Surgery_mesh& mesh) const {
    CGAL_precondition(is_strip());
    return is_subdivided() ? sides_of(mesh, walk_) : sides_of(mesh, region_);
  }

  /// whether the mesh is as it was here: all faces that are to be replaced, and those around them,
  /// are there. Not known of a subdivision.
  bool is_up_to_date(const Surgery_mesh& mesh) const {
    const auto is_alive = [&](Index f) { return mesh.is_alive(f); };
    return !is_subdivided() && std::all_of(out_.begin(), out_.end(), is_alive) &&
           std::all_of(around_.begin(), around_.end(), is_alive);
  }

  // ---- in a round

  /// the best that can be said of any caps.
  enum class Caps {
    NOT_TRIANGULATED, ///< there are none
    SELF_CROSSING,    ///< they meet themselves
    IN_THE_WAY,       ///< they meet a face that stays
    GOOD
  };
  Caps caps() const { return caps_; }

  /// looks for caps that may take the place of the region, the best ones first.
  void find_caps(const Surgery_mesh& mesh, const Mesh_contacts& contacts) {
    is_harmless = false;
    caps_ = Caps::NOT_TRIANGULATED;
    for(const Cap_search search : {Cap_search::ALL, Cap_search::DELAUNAY})
      for(const Patch& caps : caps_of(is_subdivided() ? part_->mesh : mesh, region_, search)) {
        patch_ = is_subdivided() ? with_parts(caps) : caps;
        const Placed_patch placed(mesh, patch_);
        if(!placed.is_embedded())
          caps_ = (std::max)(caps_, Caps::SELF_CROSSING);
        else if(contacts.meets(placed, out_))
          caps_ = (std::max)(caps_, Caps::IN_THE_WAY);
        else {
          caps_ = Caps::GOOD;
          return;
        }
      }
  }

  /// with good caps.
  const Patch& patch() const {
    CGAL_precondition(caps_ == Caps::GOOD);
    return patch_;
  }

  std::vector<Removal_task*> companions; ///< whose handles are in the region as well
  bool is_harmless = false; ///< to the pieces of the surface, with all others that are so

private:
  Handle_surgery(const Surgery_mesh& whole,
                 std::unique_ptr<Part_of_mesh> part,
                 Cut_region region,
                 const std::vector<Index>& parents,
                 const Closed_walk& walk)
      : region_(std::move(region))
      , part_(std::move(part))
      , walk_(walk) {
    const Surgery_mesh& mesh = part_->mesh;
    const Index first_face = static_cast<Index>(part_->faces.size());
    for(Index f = first_face; f < mesh.face_bound(); ++f) {
      const Index parent = part_->faces[parents[f - first_face]];
      out_.push_back(parent);
      if(!mesh.is_alive(f) || region_.contains(f))
        continue;
      parts_.faces.push_back(mesh.corners(f));
      for(Index& v : parts_.faces.back())
        v = vertex_of_patch(v);
      parts_.parents.push_back(parent);
    }
    for(Index f : region_.faces())
      if(f < first_face)
        out_.push_back(part_->faces[f]);
    make_set(out_);
    vertices_ = vertices_of(whole, out_);
    for(Index v = number_of_vertices(); v < mesh.vertex_bound(); ++v)
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

  // Of the part, before it was subdivided.
  Index number_of_vertices() const { return static_cast<Index>(part_->vertices.size()); }

  Index vertex_of_patch(Index v) const {
    return v < number_of_vertices() ? part_->vertices[v]
                                    : v - number_of_vertices() + Patch::first_own;
  }

  Cut_region region_;
  std::vector<Index> out_, vertices_;
  std::vector<Index> around_; // faces beyond the borders
  // If there is a subdivision.
  std::unique_ptr<Part_of_mesh> part_; // which the region is one of
  Closed_walk walk_;
  Patch parts_; // of faces around the region
  // Of this round.
  Caps caps_ = Caps::NOT_TRIANGULATED;
  Patch patch_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_HANDLE_SURGERY_H
