// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOP_COLOURS_H
#define HTLOOPS_LOOP_COLOURS_H

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>

#include <array>

namespace htloops {

/// the colour (red, green, blue) of a kind of loops, in exports and pictures alike.
constexpr std::array<unsigned char, 3> colour_of(CGAL::Loop_type type) {
  using Colour = std::array<unsigned char, 3>;
  return type == CGAL::Loop_type::HANDLE   ? Colour{214, 39, 40}
         : type == CGAL::Loop_type::TUNNEL ? Colour{31, 119, 180}
                                           : Colour{44, 160, 44};
}

} // namespace htloops

#endif // HTLOOPS_LOOP_COLOURS_H
