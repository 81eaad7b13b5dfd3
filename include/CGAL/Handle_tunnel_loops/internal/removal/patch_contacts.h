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

/// The faces of a patch where they lie, and which of them are near a place.
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
  }

  const std::vector<Placed_triangle>& triangles() const { return triangles_; }

  /// whether all triangles have an area, and none meets another one.
  bool is_embedded() const {
    if(std::any_of(triangles_.begin(), triangles_.end(),
                   [](const Placed_triangle& t) { return t.is_degenerate(); }))
      return false;
    const Box_tree<3> tree = boxes();
    for(Index i = 0; i < triangles_.size(); ++i) {
      bool meets = false;
      tree.for_each_meeting(triangles_[i].box(), [&](Index j, const Box<3>&) {
        meets = meets || (i < j && Triangle_contact(triangles_[i], triangles_[j])());
      });
      if(meets)
        return false;
    }
    return true;
  }

  bool meets(const Placed_patch& other) const {
    if(!box_.meets(other.box_))
      return false;
    const Box_tree<3> tree = boxes();
    bool meets = false;
    for(const Placed_triangle& t : other.triangles_)
      if(!meets)
        tree.for_each_meeting(t.box(), [&](Index i, const Box<3>&) {
          meets = meets || Triangle_contact(triangles_[i], t)();
        });
    return meets;
  }

private:
  Box_tree<3> boxes() const {
    std::vector<Box<3>> boxes;
    for(const Placed_triangle& t : triangles_)
      boxes.push_back(t.box());
    return Box_tree<3>(std::move(boxes));
  }

  std::vector<Placed_triangle> triangles_;
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
  std::vector<Placed_triangle> triangles;
  std::vector<Box<3>> boxes;
  std::vector<Index> owner;
  for(std::size_t i = 0; i < replacements.size(); ++i) {
    const Placed_patch placed(mesh, *replacements[i].patch);
    for(const Placed_triangle& t : placed.triangles()) {
      triangles.push_back(t);
      boxes.push_back(t.box());
      owner.push_back(static_cast<Index>(i));
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
    tree.for_each_meeting(face.box(), [&](Index t, const Box<3>&) {
      const std::vector<Index>& out = *replacements[owner[t]].out;
      if(!meets[owner[t]] && !std::binary_search(out.begin(), out.end(), f) &&
         Triangle_contact(triangles[t], face)())
        meets[owner[t]] = 1;
    });
  });
  return {meets.begin(), meets.end()};
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_PATCH_CONTACTS_H
