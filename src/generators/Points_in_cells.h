// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_POINTS_IN_CELLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_POINTS_IN_CELLS_H

#include "Field.h"
#include "vertex_normals.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {

/// The points of a mesh, sorted into cubes to find those near a place.
class Points_in_cells
{
public:
  Points_in_cells(const Soup& soup, double side)
      : soup_(soup)
      , side_(side)
      , box_{point_of(soup, 0), point_of(soup, 0)} {
    for(std::uint32_t v = 0; v < soup.points.size(); ++v)
      box_ = box_.with(point_of(soup, v));
    for(int axis = 0; axis < 3; ++axis)
      cells_[axis] = static_cast<int>((box_.high[axis] - box_.low[axis]) / side) + 1;
    begin_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
    points_.resize(soup.points.size());
    for(std::uint32_t v = 0; v < soup.points.size(); ++v)
      ++begin_[cell_of(v)];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    for(std::uint32_t v = 0; v < soup.points.size(); ++v)
      points_[--begin_[cell_of(v)]] = v;
  }

  /// those no further from a place than a radius, which is at most the side.
  std::vector<std::uint32_t> within(const Vector& p, double radius) const {
    std::vector<std::uint32_t> near;
    const std::array<int, 3> at = coordinates(p);
    for(int k = (std::max)(at[2] - 1, 0); k <= (std::min)(at[2] + 1, cells_[2] - 1); ++k)
      for(int j = (std::max)(at[1] - 1, 0); j <= (std::min)(at[1] + 1, cells_[1] - 1); ++j)
        for(int i = (std::max)(at[0] - 1, 0); i <= (std::min)(at[0] + 1, cells_[0] - 1); ++i)
          for(std::uint32_t e = begin_[number({i, j, k})]; e < begin_[number({i, j, k}) + 1]; ++e)
            if((point_of(soup_, points_[e]) - p).squared_length() <= radius * radius)
              near.push_back(points_[e]);
    return near;
  }

private:
  std::array<int, 3> coordinates(const Vector& p) const {
    std::array<int, 3> at;
    for(int axis = 0; axis < 3; ++axis)
      at[axis] =
          std::clamp(static_cast<int>((p[axis] - box_.low[axis]) / side_), 0, cells_[axis] - 1);
    return at;
  }
  std::size_t number(const std::array<int, 3>& at) const {
    return (std::size_t(at[2]) * cells_[1] + at[1]) * cells_[0] + at[0];
  }
  std::size_t cell_of(std::uint32_t v) const { return number(coordinates(point_of(soup_, v))); }

  const Soup& soup_;
  double side_;
  Box box_;
  std::array<int, 3> cells_;
  std::vector<std::uint32_t> begin_, points_;
};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_POINTS_IN_CELLS_H
