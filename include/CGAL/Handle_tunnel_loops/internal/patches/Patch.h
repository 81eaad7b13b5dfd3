// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PATCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PATCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/patches/Placed_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/patches/triangle_contacts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/make_set.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Faces that take the place of others. Corners are vertices of the mesh, or, from `first_own` on,
/// points of the patch.
struct Patch
{
  static constexpr Index first_own = Index(1) << 31;

  std::vector<Surgery_mesh::Point> points;
  std::vector<Surgery_mesh::Face> faces;
  /// the first faces may be parts of faces of the mesh, split at midpoints, and this says of which.
  std::vector<Index> parents = {};

  const Surgery_mesh::Point& point(const Surgery_mesh& mesh, Index v) const {
    return v < first_own ? mesh.point(v) : points[v - first_own];
  }

  Placed_triangle placed(const Surgery_mesh& mesh, std::size_t i) const {
    const Surgery_mesh::Face& f = faces[i];
    return {f, {point(mesh, f[0]), point(mesh, f[1]), point(mesh, f[2])}};
  }
};

/// puts a patch into the place of faces in ascending order. Returns the number of its first face.
inline Index put_in_place(Surgery_mesh& mesh, const std::vector<Index>& faces, const Patch& patch) {
  const Index shift = mesh.vertex_bound();
  for(const Surgery_mesh::Point& p : patch.points)
    mesh.add_vertex(p);
  std::vector<Surgery_mesh::Face> in = patch.faces;
  for(Surgery_mesh::Face& f : in)
    for(Index& v : f)
      if(v >= Patch::first_own)
        v = v - Patch::first_own + shift;
  return mesh.replace(faces, in);
}

/// The faces of a patch where they lie. Parts of faces of the mesh may meet what these meet.
class Placed_patch
{
public:
  /// \p first is added to the numbers of the patch's own points, to tell those of two patches
  /// apart.
  Placed_patch(const Surgery_mesh& mesh, const Patch& patch, Index first = 0) {
    for(std::size_t i = 0; i < patch.faces.size(); ++i) {
      triangles_.push_back(patch.placed(mesh, i));
      for(Index& v : triangles_.back().vertices)
        if(v >= Patch::first_own)
          v += first;
      boxes_.push_back(triangles_.back().box());
      box_.extend(boxes_.back());
    }
    for(Index f : patch.parents)
      parents_.push_back(placed_triangle(mesh, f));
  }

  const std::vector<Placed_triangle>& triangles() const { return triangles_; }

  const Box<3>& box(std::size_t i) const { return boxes_[i]; }

  /// those that are parts of faces of the mesh come first.
  std::size_t number_of_parts() const { return parents_.size(); }

  /// whether one of the triangles meets a face that is not of the patch, and did not before.
  bool meets(std::size_t i, const Placed_triangle& face) const {
    return are_in_contact(triangles_[i], face) &&
           !(is_part(i) && are_in_contact(parents_[i], face));
  }

  bool meets(const Placed_patch& other) const {
    if(!box_.meets(other.box_))
      return false;
    bool meets = false;
    placed_boxes().for_each_meeting(
        other.placed_boxes(), [this](Index i) { return boxes_[i]; },
        [&](Index j) { return other.boxes_[j]; },
        [&](Index i, Index j) {
          meets =
              meets || (this->meets(i, other.triangles_[j]) && !(is_part(i) && other.is_part(j)));
        });
    return meets;
  }

  /// whether all triangles have an area, and none meets another one, but for parts of faces.
  bool is_embedded() const {
    for(std::size_t i = parents_.size(); i < triangles_.size(); ++i)
      if(triangles_[i].is_degenerate())
        return false;
    const Placed_boxes near = placed_boxes();
    const auto box = [this](Index i) { return boxes_[i]; };
    bool is_embedded = true;
    // Parts come first, and do not meet each other.
    near.for_each_meeting(near, box, box, [&](Index i, Index j) {
      is_embedded =
          is_embedded && (i <= j || is_part(i) || !are_in_contact(triangles_[i], triangles_[j]));
    });
    return is_embedded;
  }

  Placed_boxes placed_boxes() const {
    return Placed_boxes(Execution(), boxes_.size(), [this](std::size_t i) { return boxes_[i]; });
  }

private:
  bool is_part(std::size_t i) const { return i < parents_.size(); }

  std::vector<Placed_triangle> triangles_, parents_;
  std::vector<Box<3>> boxes_; // of the triangles
  Box<3> box_ = Box<3>::empty();
};

/// Finds which patches meet a face of the mesh that stays.
class Mesh_contacts
{
public:
  explicit Mesh_contacts(const Surgery_mesh& mesh)
      : mesh_(mesh) {}

  /// takes the faces that have come since into account, which is linear in their number as a rule:
  /// they make a layer by themselves, with layers before that are no larger. So there are few
  /// layers, and no face is put into one more often than that.
  void update(Execution execution) {
    const Index end = mesh_.face_bound();
    Index begin = layers_.empty() ? 0 : layers_.back().end;
    if(begin == end)
      return;
    while(!layers_.empty() && layers_.back().end - layers_.back().begin <= end - begin) {
      begin = layers_.back().begin;
      layers_.pop_back();
    }
    layers_.push_back({begin, end, boxes(execution, begin, end)});
  }

  /// whether a patch meets a face that is not in a set of those that it takes the place of. Near
  /// linear in the size of the patch.
  bool meets(const Placed_patch& patch, const std::vector<Index>& out) const {
    CGAL_precondition(!layers_.empty() && layers_.back().end == mesh_.face_bound());
    const Placed_boxes boxes_of_patch = patch.placed_boxes();
    bool meets = false;
    for(const Layer& layer : layers_)
      layer.boxes.for_each_meeting(
          boxes_of_patch, [&](Index i) { return box(layer.begin + i); },
          [&](Index t) { return patch.box(t); },
          [&](Index i, Index t) {
            const Index f = layer.begin + i;
            meets = meets || (!is_in(f, out) && patch.meets(t, placed_triangle(mesh_, f)));
          });
    return meets;
  }

private:
  // Some faces that follow each other.
  struct Layer
  {
    Index begin, end;
    Placed_boxes boxes;
  };

  // What is gone has no box, and caps are none of the surface.
  bool counts(Index f) const { return mesh_.is_alive(f) && !mesh_.is_in_cap(f); }

  Box<3> box(Index f) const {
    return counts(f) ? placed_triangle(mesh_, f).box() : Box<3>::empty();
  }

  Placed_boxes boxes(Execution execution, Index begin, Index end) const {
    return Placed_boxes(execution, end - begin, [this, begin](std::size_t i) {
      return box(begin + static_cast<Index>(i));
    });
  }

  const Surgery_mesh& mesh_;
  std::vector<Layer> layers_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PATCHES_PATCH_H
