// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/spread_lines.h"

#include "draw/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace htloops {
namespace {

constexpr int cells_of_lines = 256, cells_of_surface = 64; // along each side of the square

// Cells of a square around the unit ball as it is seen from a direction.
class Covered_cells
{
public:
  Covered_cells(const Vector& from, int cells)
      : axes_(axes_across(from))
      , cells_(cells)
      , is_covered_(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), 0) {}

  // Covers the cell of a point, and those around it that are so many columns and rows away in all.
  void add(const Vector& point, int width) {
    const int column = place(dot(point, axes_[0])), row = place(dot(point, axes_[1]));
    for(int dy = -width; dy <= width; ++dy)
      for(int dx = -width; dx <= width; ++dx)
        if(std::abs(dx) + std::abs(dy) <= width)
          cover(column + dx, row + dy);
  }

  double part() const {
    return double(std::count(is_covered_.begin(), is_covered_.end(), 1)) /
           double(is_covered_.size());
  }

private:
  static std::array<Vector, 2> axes_across(const Vector& from) {
    const Vector right =
        unit(cross(std::abs(from[2]) < 0.9 ? Vector{0., 0., 1.} : Vector{1., 0., 0.}, from));
    return {right, cross(from, right)};
  }

  // Lines may be outside of the ball that is around the surface.
  int place(double x) const {
    return static_cast<int>(std::clamp((x + 1.) / 2. * cells_, 0., cells_ - 1.));
  }

  void cover(int column, int row) {
    if(column >= 0 && row >= 0 && column < cells_ && row < cells_)
      is_covered_[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_) +
                  static_cast<std::size_t>(column)] = 1;
  }

  std::array<Vector, 2> axes_;
  int cells_;
  std::vector<char> is_covered_;
};

// Adds points along a line that leave no cell out.
void add_points_along(const std::vector<Vector>& line, std::vector<Vector>& points) {
  constexpr double largest_step = 1. / cells_of_lines, longest = 64.; // of what is not far outside
  for(std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vector &a = line[i], side = minus(line[i + 1], a);
    const auto steps =
        static_cast<std::size_t>(1. + (std::min)(norm(side), longest) / largest_step);
    for(std::size_t k = 0; k < steps; ++k) {
      const double t = double(k) / double(steps);
      points.push_back({a[0] + t * side[0], a[1] + t * side[1], a[2] + t * side[2]});
    }
  }
  if(!line.empty())
    points.push_back(line.back());
}

} // namespace

Spread_lines::Spread_lines(const htl_scene::Surface& surface,
                           const std::vector<std::vector<Vector>>& lines) {
  const Ball_around ball(surface.points);
  for(const std::vector<Vector>& line : lines)
    add_points_along(ball.moved(line), on_lines_);
  on_surface_ = samples_of(ball.moved(surface.points), surface.triangles, 20000.);
}

Spread_lines::View Spread_lines::look_from(const Vector& from) const {
  Covered_cells lines(from, cells_of_lines), surface(from, cells_of_surface);
  for(const Vector& p : on_lines_)
    lines.add(p, 1);
  for(const Vector& p : on_surface_)
    surface.add(p, 0);
  return {lines.part(), surface.part()};
}

} // namespace htloops
