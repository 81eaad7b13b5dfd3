// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/seen_lines.h"

#include "draw/samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace htloops {
namespace {

constexpr std::size_t points_of_line = 48;
constexpr std::size_t fine = 768, coarse = 256; // cells of a map, along each side

Vector between(const Vector& a, const Vector& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Whether each side of a triangle is passed the other way by another one: the numbers of both
// directions cancel each other.
bool is_closed(const std::vector<htl_scene::Triangle>& triangles) {
  std::uint64_t sum = 0;
  for(const auto& t : triangles)
    for(std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      sum += mixed((a << 32) + b + 1) - mixed((b << 32) + a + 1);
    }
  return sum == 0;
}

double side_of(const std::vector<Vector>& points,
               const std::vector<htl_scene::Triangle>& triangles) {
  if(!is_closed(triangles))
    return 0.;
  double volume = 0.;
  for(const auto& [a, b, c] : triangles)
    volume += dot(points[a], cross(points[b], points[c]));
  return volume > 0. ? 1. : volume < 0. ? -1. : 0.;
}

bool is_in(const Vector& p, const Vector& a, const Vector& b, const Vector& c, const Vector& n) {
  constexpr double tolerance = 1e-6; // of rounding, in the unit ball
  if(std::abs(dot(n, minus(p, a))) > tolerance)
    return false;
  const auto is_inside = [&](const Vector& from, const Vector& to) {
    const Vector side = minus(to, from);
    return dot(cross(side, minus(p, from)), n) >= -tolerance * norm(side);
  };
  return is_inside(a, b) && is_inside(b, c) && is_inside(c, a);
}

// Finds the points that are in boxes.
class Point_grid
{
public:
  template <typename Point_of>
  Point_grid(std::size_t count, const Point_of& point_of)
      : first_in_(side * side * side + 2, 0)
      , numbers_(count) {
    for(std::size_t i = 0; i < count; ++i)
      ++first_in_[cell_of(point_of(i)) + 2];
    for(std::size_t c = 2; c < first_in_.size(); ++c)
      first_in_[c] += first_in_[c - 1];
    for(std::size_t i = 0; i < count; ++i)
      numbers_[first_in_[cell_of(point_of(i)) + 1]++] = i;
  }

  template <typename Visit> void visit_in(Vector low, Vector high, const Visit& visit) const {
    constexpr double slack = 1e-5;
    std::array<std::size_t, 3> first, last;
    for(std::size_t i = 0; i < 3; ++i) {
      first[i] = place(low[i] - slack);
      last[i] = place(high[i] + slack);
    }
    for(std::size_t z = first[2]; z <= last[2]; ++z)
      for(std::size_t y = first[1]; y <= last[1]; ++y) {
        const std::size_t row = (z * side + y) * side; // points of a row follow each other
        for(std::size_t k = first_in_[row + first[0]]; k < first_in_[row + last[0] + 1]; ++k)
          visit(numbers_[k]);
      }
  }

private:
  static constexpr std::size_t side = 48;

  static std::size_t place(double x) {
    return static_cast<std::size_t>(std::clamp((x + 1.) / 2. * side, 0., side - 1.));
  }
  static std::size_t cell_of(const Vector& p) {
    return (place(p[2]) * side + place(p[1])) * side + place(p[0]);
  }

  std::vector<std::size_t> first_in_, numbers_;
};

} // namespace

Depth_map::Depth_map(const Vector& from, std::size_t cells)
    : from_(from)
    , right_(unit(cross(std::abs(from[2]) < 0.9 ? Vector{0., 0., 1.} : Vector{1., 0., 0.}, from)))
    , upwards_(cross(from, right_))
    , cells_(cells)
    , nearest_(cells * cells, -std::numeric_limits<double>::infinity()) {}

Vector Depth_map::placed(const Vector& point) const {
  const double half =
      0.499 * double(cells_); // what is on the rim of the ball is in the square, too
  return {(dot(point, right_) + 1.) * half, (dot(point, upwards_) + 1.) * half, dot(point, from_)};
}

void Depth_map::add(const Vector& point) { add_placed(placed(point)); }

void Depth_map::add_placed(const Vector& p) {
  double& depth = nearest(static_cast<int>(p[0]), static_cast<int>(p[1]));
  depth = (std::max)(depth, p[2]);
}

// All three are placed.
void Depth_map::add(const Vector& a, const Vector& b, const Vector& c, double side) {
  // Cells have their middles at halves. All of this is positive.
  const int first_x = static_cast<int>((std::min)({a[0], b[0], c[0]}) + 0.5),
            first_y = static_cast<int>((std::min)({a[1], b[1], c[1]}) + 0.5);
  const double last_x = (std::max)({a[0], b[0], c[0]}) - 0.5,
               last_y = (std::max)({a[1], b[1], c[1]}) - 0.5;
  if(first_x > last_x || first_y > last_y)
    return;
  const auto area = [](const Vector& p, const Vector& q, double x, double y) {
    return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
  };
  const double whole = area(a, b, c[0], c[1]);
  if(whole == 0. || whole * side < 0.)
    return;
  for(int y = first_y; y <= last_y; ++y)
    for(int x = first_x; x <= last_x; ++x) {
      const double of_a = area(b, c, x + 0.5, y + 0.5) / whole,
                   of_b = area(c, a, x + 0.5, y + 0.5) / whole, of_c = 1. - of_a - of_b;
      if(of_a < 0. || of_b < 0. || of_c < 0.)
        continue;
      double& depth = nearest(x, y);
      depth = (std::max)(depth, of_a * a[2] + of_b * b[2] + of_c * c[2]);
    }
}

bool Depth_map::is_free(const Vector& point, const Vector& normal) const {
  const Vector p = placed(point);
  // A slope rises within the cells that it is in.
  constexpr double steepest = 6.;
  const double facing = std::abs(dot(normal, from_));
  const double rise =
      facing > 0. ? std::sqrt((std::max)(0., 1. - facing * facing)) / facing : steepest;
  const double cell = 2. / double(cells_);
  // Lines may be outside of the ball that is around the surface.
  const double last = double(cells_ - 1);
  return nearest(static_cast<int>(std::clamp(p[0], 0., last)),
                 static_cast<int>(std::clamp(p[1], 0., last))) <
         p[2] + cell * (0.5 + (std::min)(rise, steepest));
}

Seen_lines::Seen_lines(const htl_scene::Surface& surface,
                       const std::vector<std::vector<Vector>>& lines) {
  const Ball_around ball(surface.points);
  points_ = ball.moved(surface.points);
  samples_ = samples_of(points_, surface.triangles, 40000.);
  side_ = side_of(points_, surface.triangles);
  choose_cells(surface.triangles);
  for(std::vector<Vector> line : lines) {
    for(Vector& p : line)
      p = ball(p);
    add_points(line);
  }
  find_normals(surface);
}

// As many on each line, in equal steps.
void Seen_lines::add_points(const std::vector<Vector>& line) {
  double length = 0.;
  for(std::size_t i = 0; i < line.size(); ++i)
    length += norm(minus(line[(i + 1) % line.size()], line[i]));
  lengths_.push_back(length);
  double passed = 0.;
  std::size_t k = 0;
  for(std::size_t i = 0; i < line.size(); ++i) {
    const Vector& a = line[i];
    const Vector& b = line[(i + 1) % line.size()];
    const double step = norm(minus(b, a));
    for(; k < points_of_line; ++k) {
      const double at = (double(k) + 0.5) / points_of_line * length - passed;
      if(!(at <= step))
        break;
      points_on_lines_.push_back({between(a, b, step > 0. ? at / step : 0.), unit(minus(b, a))});
    }
    passed += step;
  }
  for(; k < points_of_line; ++k) // rounding left some for the end
    points_on_lines_.push_back({line.empty() ? Vector{} : line.front(), {}});
}

// Of the faces at a point the first, and the one that makes the largest angle with it.
void Seen_lines::find_normals(const htl_scene::Surface& surface) {
  if(points_on_lines_.empty() || side_ == 0.)
    return;
  const Point_grid grid(points_on_lines_.size(),
                        [this](std::size_t i) { return points_on_lines_[i].point; });
  for(const auto& [i, j, k] : surface.triangles) {
    const Vector &a = points_[i], &b = points_[j], &c = points_[k];
    Vector low, high;
    for(std::size_t x = 0; x < 3; ++x) {
      low[x] = (std::min)({a[x], b[x], c[x]});
      high[x] = (std::max)({a[x], b[x], c[x]});
    }
    grid.visit_in(low, high, [&](std::size_t number) {
      Point_on_line& on_line = points_on_lines_[number];
      const Vector n = unit(normal_of(a, b, c));
      if(n == Vector{} || !is_in(on_line.point, a, b, c, n))
        return;
      auto& [first, second] = on_line.normals;
      if(first == Vector{})
        first = second = {side_ * n[0], side_ * n[1], side_ * n[2]};
      else if(side_ * dot(first, n) < dot(first, second))
        second = {side_ * n[0], side_ * n[1], side_ * n[2]};
    });
  }
}

bool Seen_lines::is_seen(const Point_on_line& point, const Depth_map& depths) const {
  constexpr double grazing = 0.03;
  const auto& [first, second] = point.normals;
  if(first == Vector{})
    return depths.is_free(point.point, first);
  const double facing = dot(first, depths.from()), other = dot(second, depths.from());
  return (std::max)(facing, other) > grazing &&
         depths.is_free(point.point, facing > other ? first : second);
}

// How much the surface at a point is turned to the eye, 0 to 1.
double Seen_lines::facing_of(const Point_on_line& point, const Depth_map& depths) {
  const auto& [first, second] = point.normals;
  if(first == Vector{})
    return 1.;
  return (std::max)({dot(first, depths.from()), dot(second, depths.from()), 0.});
}

Seen_lines::View Seen_lines::view_of(const Depth_map& depths) const {
  View view;
  auto point = points_on_lines_.begin();
  for(const double length : lengths_) {
    view.lines.push_back({length});
    for(std::size_t k = 0; k < points_of_line; ++k, ++point)
      if(is_seen(*point, depths)) {
        const double towards_eye = dot(point->along, depths.from());
        view.lines.back().seen += length / points_of_line;
        view.lines.back().large +=
            length / points_of_line * std::sqrt((std::max)(0., 1. - towards_eye * towards_eye));
      }
  }
  constexpr std::size_t stride = 7;
  std::size_t seen = 0, all = 0;
  for(std::size_t i = 0; i < samples_.size(); i += stride, ++all)
    seen += depths.is_free(samples_[i], {}) ? 1 : 0;
  view.surface = all > 0 ? double(seen) / double(all) : 0.;
  return view;
}

Seen_lines::View Seen_lines::estimate(const Vector& from) const {
  Depth_map depths(from, 96);
  for(const Vector& sample : samples_)
    depths.add(sample);
  return view_of(depths);
}

Seen_lines::View Seen_lines::measure(const Vector& from) const {
  Depth_map depths(from, cells_);
  std::vector<Vector> placed;
  placed.reserve(points_.size());
  for(const Vector& p : points_) {
    placed.push_back(depths.placed(p));
    if(cells_ == coarse)
      depths.add_placed(placed.back());
  }
  for(const auto& [a, b, c] : large_triangles_)
    depths.add(placed[a], placed[b], placed[c], side_);
  return view_of(depths);
}

// Where there are many corners, cells are larger, and triangles that are smaller than one of them
// are known by their corners.
void Seen_lines::choose_cells(const std::vector<htl_scene::Triangle>& triangles) {
  constexpr std::size_t many = 50000;
  if(points_.size() < many) {
    cells_ = fine;
    large_triangles_ = triangles;
    return;
  }
  cells_ = coarse;
  const double cell = 2. / double(cells_);
  for(const auto& t : triangles) {
    const Vector &a = points_[t[0]], &b = points_[t[1]], &c = points_[t[2]];
    const Vector u = minus(b, a), v = minus(c, b), w = minus(a, c);
    if((std::max)({dot(u, u), dot(v, v), dot(w, w)}) > cell * cell)
      large_triangles_.push_back(t);
  }
}

} // namespace htloops
