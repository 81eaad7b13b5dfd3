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

/// the colour (red, green, blue) of a kind of loops, in exports and pictures alike. People who do
/// not see all colours tell these apart (Okabe and Ito, Color Universal Design, 2008).
constexpr std::array<unsigned char, 3> colour_of(CGAL::Loop_type type) {
  using Colour = std::array<unsigned char, 3>;
  return type == CGAL::Loop_type::HANDLE   ? Colour{213, 94, 0}
         : type == CGAL::Loop_type::TUNNEL ? Colour{0, 114, 178}
                                           : Colour{0, 158, 115};
}

/// that of the boundary of the surface itself.
constexpr std::array<unsigned char, 3> colour_of_boundary_curve = {60, 60, 60};

} // namespace htloops

#endif // HTLOOPS_LOOP_COLOURS_H
