// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LENGTHS_OUTSIDE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LENGTHS_OUTSIDE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/reeb/Embedded_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/winding_numbers.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// How much of each line lies outside of the solid, about: looked at in places that are so far
/// apart, and at least once on each of its segments. Nothing where winding numbers are not known.
inline std::vector<double> lengths_outside(Execution execution,
                                           const Flat_mesh& mesh,
                                           const std::vector<Polyline>& lines,
                                           double spacing) {
  struct Part
  {
    std::size_t line;
    double length;
  };
  constexpr double largest_number = 32.;
  std::vector<Vector> places;
  std::vector<Part> parts;
  for(std::size_t l = 0; l < lines.size(); ++l)
    for(std::size_t i = 1; i < lines[l].size(); ++i) {
      const Vector &a = lines[l][i - 1], way = lines[l][i] - a;
      const double length = norm(way);
      if(!(length > 0.))
        continue;
      const int number = static_cast<int>((std::min)(length / spacing, largest_number)) + 1;
      for(int j = 0; j < number; ++j) {
        places.push_back(a + ((j + 0.5) / number) * way);
        parts.push_back({l, length / number});
      }
    }
  const std::vector<int> winding = winding_numbers(execution, mesh, places);
  std::vector<double> outside(lines.size(), 0.);
  for(std::size_t i = 0; i < winding.size(); ++i)
    if(winding[i] == 0)
      outside[parts[i].line] += parts[i].length;
  return outside;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_LENGTHS_OUTSIDE_H
