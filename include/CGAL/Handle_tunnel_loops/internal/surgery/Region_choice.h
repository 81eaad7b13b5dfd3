// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

/// How a region is laid along the loops of a handle.
struct Region_choice
{
  enum Style {
    KNOB,  ///< the faces at both loops, and some rings more, of a handle that sits on the surface
           ///< like a knob on a lid
    BORE,  ///< the wall of a bore that the loop goes around; with rings, and of bores that it
           ///< meets, if it does
    STRIP, ///< a narrow strip along the loop
    RINGS, ///< the faces at the loop, and some rings more
    WHOLE  ///< the faces at both loops, and some rings more
  };
  Style style;
  std::size_t loop; ///< the number of its choice
  int rings;
  bool may_cross = false; ///< whether caps may cross what the surface there crosses

  bool takes_both_loops() const { return style == WHOLE || style == KNOB; }
  bool is_along_curve() const { return style == STRIP || style == BORE; }

  friend bool operator==(const Region_choice& a, const Region_choice& b) {
    return a.style == b.style && a.loop == b.loop && a.rings == b.rings &&
           a.may_cross == b.may_cross;
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_REGION_CHOICE_H
