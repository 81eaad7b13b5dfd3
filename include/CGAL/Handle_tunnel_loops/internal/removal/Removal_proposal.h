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

#include <CGAL/Handle_tunnel_loops/internal/removal/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/caps.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/subdivide_along.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A region to be taken out of a mesh, or out of the mesh subdivided along a loop.
class Removal_proposal
{
public:
  Removal_proposal(const Surgery_mesh& mesh, Cut_region region)
      : mesh_(&mesh)
      , region_(std::move(region))
      , out_(region_.faces()) {}

  /// the faces at a simple closed walk after a subdivision, which is made of a copy of the mesh.
  /// None only if the walk goes around a face.
  static std::optional<Removal_proposal> subdivided(const Surgery_mesh& mesh,
                                                    const Closed_walk& walk) {
    auto copy = std::make_unique<Surgery_mesh>(mesh);
    std::vector<Index> parents = Subdivision_along_walk(*copy, walk).parents();
    std::optional<Cut_region> region = Cut_region::around(*copy, walk);
    if(!region)
      return std::nullopt;
    Removal_proposal proposal(*copy, std::move(*region));
    proposal.set_parts(mesh, std::move(copy), parents);
    return proposal;
  }

  /// the faces of the mesh that are to be replaced, in ascending order.
  const std::vector<Index>& out() const { return out_; }

  /// the vertices of these, in ascending order.
  std::vector<Index> vertices(const Surgery_mesh& mesh) const {
    std::vector<Index> vertices;
    for(Index f : out_)
      vertices.insert(vertices.end(), mesh.corners(f).begin(), mesh.corners(f).end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  const Cut_region& region() const { return region_; }

  /// the mesh that the region is one of.
  const Surgery_mesh& mesh_of_region() const { return *mesh_; }

  bool is_subdivided() const { return subdivided_ != nullptr; }

  /// what may take the place of these faces, the best way first.
  std::vector<Patch> patches() const {
    std::vector<Patch> ways = caps_of(*mesh_, region_);
    if(is_subdivided())
      for(Patch& caps : ways)
        caps = with_parts(caps);
    return ways;
  }

private:
  void set_parts(const Surgery_mesh& mesh,
                 std::unique_ptr<Surgery_mesh> subdivided,
                 const std::vector<Index>& parents) {
    const Index first_vertex = mesh.vertex_bound(), first_face = mesh.face_bound();
    out_.clear();
    for(Index f = first_face; f < subdivided->face_bound(); ++f) {
      out_.push_back(parents[f - first_face]);
      if(!subdivided->is_alive(f) || region_.contains(f))
        continue;
      Surgery_mesh::Face corners = subdivided->corners(f);
      for(Index& v : corners)
        if(v >= first_vertex)
          v = v - first_vertex + Patch::first_own;
      parts_.faces.push_back(corners);
      parts_.parents.push_back(parents[f - first_face]);
    }
    for(Index f : region_.faces())
      if(f < first_face)
        out_.push_back(f);
    std::sort(out_.begin(), out_.end());
    out_.erase(std::unique(out_.begin(), out_.end()), out_.end());
    for(Index v = first_vertex; v < subdivided->vertex_bound(); ++v)
      parts_.points.push_back(subdivided->point(v));
    first_vertex_ = first_vertex;
    subdivided_ = std::move(subdivided);
  }

  // The points of the subdivision come before those of the caps.
  Patch with_parts(const Patch& caps) const {
    const Index shift = static_cast<Index>(parts_.points.size());
    Patch patch = parts_;
    patch.points.insert(patch.points.end(), caps.points.begin(), caps.points.end());
    for(Surgery_mesh::Face f : caps.faces) {
      for(Index& v : f)
        if(v >= Patch::first_own)
          v += shift;
        else if(v >= first_vertex_)
          v = v - first_vertex_ + Patch::first_own;
      patch.faces.push_back(f);
    }
    return patch;
  }

  const Surgery_mesh* mesh_;
  Cut_region region_;
  std::vector<Index> out_;
  std::unique_ptr<Surgery_mesh> subdivided_;
  Index first_vertex_ = 0; // of the subdivision
  Patch parts_;            // of faces around the region
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_REMOVAL_PROPOSAL_H
