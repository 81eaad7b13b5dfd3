// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_CHANGES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_CHANGES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Where a surface has been changed, one time after the other.
class Surface_changes
{
public:
  /// the number of changes, by which they are known: those that come later have numbers from it on.
  std::size_t size() const { return boxes_.size(); }

  void add(const Box<3>& box) { boxes_.push_back(box); }

  /// whether any of them, from a number on, may have touched what is in a box.
  bool are_any_in(const Box<3>& box, std::size_t first = 0) const {
    return std::any_of(boxes_.begin() + static_cast<std::ptrdiff_t>(first), boxes_.end(),
                       [&](const Box<3>& change) { return change.meets(box); });
  }

private:
  std::vector<Box<3>> boxes_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SURFACE_CHANGES_H
