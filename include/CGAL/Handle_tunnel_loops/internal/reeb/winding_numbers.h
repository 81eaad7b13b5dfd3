// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_WINDING_NUMBERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_WINDING_NUMBERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Points by the cell of a rectangular grid that they are above, seldom more than one to a cell.
/// Around them is a margin of empty cells, for all that is not above or below them.
class Grid_of_points
{
public:
  struct Cell
  {
    Index x, y;
  };

  explicit Grid_of_points(const std::vector<Vector>& points)
      : low_(points.front())
      , high_(points.front())
      , width_(static_cast<Index>(2. * std::sqrt(double(points.size()))) + 1)
      , begin_(std::size_t(width_ + 2) * (width_ + 2) + 1, 0) {
    for(const Vector& p : points)
      for(int d = 0; d < 2; ++d) {
        low_[d] = (std::min)(low_[d], p[d]);
        high_[d] = (std::max)(high_[d], p[d]);
      }
    for(int d = 0; d < 2; ++d)
      scale_[d] = high_[d] > low_[d] ? double(width_) / (high_[d] - low_[d]) : 0.;
    for(const Vector& p : points)
      ++begin_[number_of(cell_of(p)) + 1];
    for(std::size_t c = 0; c + 1 < begin_.size(); ++c)
      begin_[c + 1] += begin_[c];
    sorted_.resize(points.size());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for(std::size_t i = 0; i < points.size(); ++i)
      sorted_[next[number_of(cell_of(points[i]))]++] = i;
  }

  Cell cell_of(const Vector& p) const { return {place(p, 0), place(p, 1)}; }

  /// calls `f(begin, end)` for rows of numbers of points, which are those in a rectangle of cells.
  /// Returns how much there is to do.
  template <typename Function>
  std::size_t for_each_in(const Cell& low, const Cell& high, const Function& f) const {
    std::size_t number = 0;
    for(Index x = low.x; x <= high.x; ++x) {
      const std::size_t begin = begin_[number_of({x, low.y})];
      const std::size_t end = begin_[number_of({x, high.y}) + 1];
      if(begin != end)
        f(sorted_.data() + begin, sorted_.data() + end);
      number += end - begin + 1;
    }
    return number;
  }

private:
  Index place(const Vector& p, int d) const {
    if(p[d] < low_[d])
      return 0;
    if(p[d] > high_[d])
      return width_ + 1;
    return (std::min)(static_cast<Index>((p[d] - low_[d]) * scale_[d]), width_ - 1) + 1;
  }

  std::size_t number_of(const Cell& cell) const {
    return std::size_t(width_ + 2) * cell.x + cell.y;
  }

  Vector low_, high_; // of the points
  double scale_[2];
  Index width_;
  std::vector<std::size_t> begin_, sorted_; // by cell, the numbers of the points
};

/// on which side of the line from `a` to `b` a point is, seen from above: 1 if it is on the left,
/// -1 if not. A point on the line is moved a little, always the same way, so that just one of the
/// triangles around it holds it.
inline int side_from_above(const Vector& a, const Vector& b, const Vector& p) {
  const bool is_turned = b[0] < a[0] || (b[0] == a[0] && b[1] < a[1]);
  const Vector &from = is_turned ? b : a, &to = is_turned ? a : b;
  const double x = to[0] - from[0], y = to[1] - from[1];
  const double area = rounded_product(x, p[1] - from[1]) - rounded_product(y, p[0] - from[0]);
  const bool is_left = area != 0. ? area > 0. : y <= 0.;
  return is_left != is_turned ? 1 : -1;
}

/// 1 if the triangle is above the point with its outside up, -1 if its outside is down, else 0.
inline int crossing_above(const Vector& a, const Vector& b, const Vector& c, const Vector& p) {
  const int side = side_from_above(a, b, p);
  if(side_from_above(b, c, p) != side || side_from_above(c, a, p) != side)
    return 0;
  const Vector normal = cross(b - a, c - a);
  const double height = dot(normal, a - p); // over the part of the normal that points up
  return height * normal[2] > 0. ? side : 0;
}

/// A count of the triangles above each of some points.
class Crossings_above
{
public:
  Crossings_above(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& points)
      : mesh_(mesh)
      , points_(points)
      , grid_(points)
      , cells_(mesh.number_of_vertices())
      , counts_(new std::atomic<int>[points.size()]) {
    for(std::size_t i = 0; i < points.size(); ++i)
      counts_[i] = 0;
    for_each_index(execution, cells_.size(),
                   [&](std::size_t v) { cells_[v] = grid_.cell_of(mesh.points[v]); });
  }

  /// counts those around \p v that it is the least vertex of, as long as there is not too much to
  /// do. Returns how much it had to do.
  std::size_t add_triangles_at(Index v, std::size_t largest_number) {
    const Ring ring = mesh_.ring(v);
    std::size_t number = 0;
    for(Index i = 0; i < ring.size() && number <= largest_number; ++i) {
      const Index a = ring[i], b = ring[ring.next(i)];
      if(v > a || v > b)
        continue;
      const auto [low_x, high_x] = std::minmax({cells_[v].x, cells_[a].x, cells_[b].x});
      const auto [low_y, high_y] = std::minmax({cells_[v].y, cells_[a].y, cells_[b].y});
      number += grid_.for_each_in(
          {low_x, low_y}, {high_x, high_y}, [&](const std::size_t* begin, const std::size_t* end) {
            add_triangle(mesh_.points[v], mesh_.points[a], mesh_.points[b], begin, end);
          });
    }
    return number;
  }

  std::vector<int> counts() const { return {counts_.get(), counts_.get() + points_.size()}; }

private:
  void add_triangle(const Vector& a,
                    const Vector& b,
                    const Vector& c,
                    const std::size_t* begin,
                    const std::size_t* end) {
    const auto [low_x, high_x] = std::minmax({a[0], b[0], c[0]});
    const auto [low_y, high_y] = std::minmax({a[1], b[1], c[1]});
    for(const std::size_t* j = begin; j != end; ++j) {
      const Vector& p = points_[*j];
      if(p[0] >= low_x && p[0] <= high_x && p[1] >= low_y && p[1] <= high_y)
        if(const int crossing = crossing_above(a, b, c, p))
          counts_[*j].fetch_add(crossing, std::memory_order_relaxed);
    }
  }

  const Flat_mesh& mesh_;
  const std::vector<Vector>& points_;
  Grid_of_points grid_;
  std::vector<Grid_of_points::Cell> cells_; // by vertex
  std::unique_ptr<std::atomic<int>[]> counts_;
};

/// How often the surface winds around each of the points, in one pass over its triangles: zero
/// outside. Where triangles are so large that too many points are above and below them, none are
/// told, so that the time is linear.
inline std::vector<int>
winding_numbers(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& points) {
  if(points.empty())
    return {};
  constexpr std::size_t grain = 4096, largest_number_per_vertex = 256;
  Crossings_above crossings(execution, mesh, points);
  std::atomic<bool> are_too_many(false);
  execution.for_ranges(mesh.number_of_vertices(), grain, [&](std::size_t begin, std::size_t end) {
    constexpr std::size_t largest_number = grain * largest_number_per_vertex;
    std::size_t number = 0;
    for(std::size_t v = begin; v < end && number <= largest_number; ++v)
      number += crossings.add_triangles_at(static_cast<Index>(v), largest_number - number);
    if(number > largest_number)
      are_too_many = true;
  });
  return are_too_many ? std::vector<int>() : crossings.counts();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_WINDING_NUMBERS_H
