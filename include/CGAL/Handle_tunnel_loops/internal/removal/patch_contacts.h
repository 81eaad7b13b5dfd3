// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_PATCH_CONTACTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_PATCH_CONTACTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/triangle_contacts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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
      box_.extend(triangles_.back().box());
    }
    for(Index f : patch.parents)
      parents_.push_back(placed_triangle(mesh, f));
  }

  const std::vector<Placed_triangle>& triangles() const { return triangles_; }

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
    const Box_tree<3> tree = boxes();
    bool meets = false;
    for(std::size_t j = 0; j < other.triangles_.size(); ++j)
      tree.for_each_meeting(other.triangles_[j].box(), [&](Index i, const Box<3>&) {
        meets = meets || (this->meets(i, other.triangles_[j]) && !(is_part(i) && other.is_part(j)));
      });
    return meets;
  }

  /// whether all triangles have an area, and none meets another one, but for parts of faces.
  bool is_embedded() const {
    for(std::size_t i = parents_.size(); i < triangles_.size(); ++i)
      if(triangles_[i].is_degenerate())
        return false;
    const Box_tree<3> tree = boxes();
    for(Index i = 0; i < triangles_.size(); ++i) {
      bool meets = false;
      tree.for_each_meeting(triangles_[i].box(), [&](Index j, const Box<3>&) {
        meets = meets || (j < i && !is_part(i) && are_in_contact(triangles_[i], triangles_[j]));
      });
      if(meets)
        return false;
    }
    return true;
  }

private:
  bool is_part(std::size_t i) const { return i < parents_.size(); }

  Box_tree<3> boxes() const {
    std::vector<Box<3>> boxes;
    for(const Placed_triangle& t : triangles_)
      boxes.push_back(t.box());
    return Box_tree<3>(std::move(boxes));
  }

  std::vector<Placed_triangle> triangles_, parents_;
  Box<3> box_ = Box<3>::empty();
};

/// A patch, and the faces that it is to take the place of, in ascending order.
struct Replacement
{
  const std::vector<Index>* out;
  const Patch* patch;
};

/// by replacement, whether its patch meets a face of the mesh that stays. Near linear in the size
/// of the mesh and the patches.
inline std::vector<char> meet_mesh(Execution execution,
                                   const Surgery_mesh& mesh,
                                   const std::vector<Replacement>& replacements) {
  struct Owner
  {
    Index replacement, triangle;
  };
  std::vector<Placed_patch> patches;
  std::vector<Box<3>> boxes;
  std::vector<Owner> owners; // by box
  for(Index i = 0; i < replacements.size(); ++i) {
    patches.emplace_back(mesh, *replacements[i].patch);
    const std::vector<Placed_triangle>& triangles = patches.back().triangles();
    for(Index t = 0; t < triangles.size(); ++t) {
      boxes.push_back(triangles[t].box());
      owners.push_back({i, t});
    }
  }
  const Box_tree<3> tree(std::move(boxes));
  std::vector<std::atomic<char>> meets(replacements.size());
  for(std::atomic<char>& m : meets)
    m = 0;
  for_each_index(execution, mesh.face_bound(), [&](std::size_t i) {
    const Index f = static_cast<Index>(i);
    if(!mesh.is_alive(f))
      return;
    const Placed_triangle face = placed_triangle(mesh, f);
    tree.for_each_meeting(face.box(), [&](Index b, const Box<3>&) {
      const Owner& owner = owners[b];
      const std::vector<Index>& out = *replacements[owner.replacement].out;
      if(!meets[owner.replacement] && !std::binary_search(out.begin(), out.end(), f) &&
         patches[owner.replacement].meets(owner.triangle, face))
        meets[owner.replacement] = 1;
    });
  });
  return {meets.begin(), meets.end()};
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_PATCH_CONTACTS_H
