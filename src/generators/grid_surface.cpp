// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "grid_surface.h"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

Grid_size grid_size(std::size_t faces, double aspect) {
  // A side of three is the least for which no two edges join the same vertices.
  const auto at_least_3 = [](double n) { return (std::max<std::size_t>)(3, std::lround(n)); };
  Grid_size size;
  size.around = at_least_3(std::sqrt(faces / (2. * aspect)));
  size.along = at_least_3(faces / (2. * size.around));
  return size;
}

Soup grid_surface(Grid_size size, const std::function<Vector(std::size_t, std::size_t)>& point) {
  const auto vertex = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>((i % size.along) * size.around + j % size.around);
  };
  Soup soup;
  soup.points.reserve(size.along * size.around);
  soup.triangles.reserve(2 * size.along * size.around);
  for(std::size_t i = 0; i < size.along; ++i)
    for(std::size_t j = 0; j < size.around; ++j) {
      const Vector p = point(i, j);
      soup.points.push_back({p.x(), p.y(), p.z()});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      soup.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return soup;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
