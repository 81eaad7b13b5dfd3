// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Field.h"
#include "Random.h"
#include "functions.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// A number of holes in rows, as close to a square as it goes: the first rows have one hole more
/// than the others if the number does not divide.
struct Hole_rows
{
  explicit Hole_rows(std::size_t number)
      : holes(number)
      , rows((std::max)(1l, std::lround(std::sqrt(double(number))))) {}

  /// of the longest rows; at least one, as if for a hole that is not there.
  std::size_t columns() const { return (std::max<std::size_t>)((holes + rows - 1) / rows, 1); }

  /// the number of rows that have `columns()` holes.
  std::size_t full_rows() const { return holes % rows == 0 ? rows : holes % rows; }

  std::size_t holes_in_row(std::size_t row) const {
    return holes / rows + (row < holes % rows ? 1 : 0);
  }

  std::size_t holes, rows;
};

/// A flat slab with round holes at distance one, its rims rounded.
class Slab : public Field
{
public:
  explicit Slab(std::size_t holes)
      : rows_(holes)
      , full_rows_(static_cast<double>(rows_.full_rows())) {}

  // The points within the rim's radius of a flat region, which is the outline without the holes,
  // made smaller by that radius.
  double operator()(const Vector& p) const override {
    const double from_region = (std::max)(outline(p.x(), p.y()), hole(p.x(), p.y())) + rim_radius;
    return hypotenuse((std::max)(from_region, 0.), p.z()) - rim_radius;
  }

  Box box() const override {
    const double x = rows_.columns() / 2. + margin;
    return {Vector(-x, -0.5 - margin, -rim_radius),
            Vector(x, rows_.rows - 0.5 + margin, rim_radius)};
  }

private:
  static constexpr double rim_radius = 0.2, hole_radius = 0.25, corner_radius = 0.45, margin = 0.05;

  /// the distance to a rectangle with round corners, negative inside.
  static double rectangle(double x, double y, double half_width, double half_height) {
    const double dx = std::abs(x) - (half_width - corner_radius);
    const double dy = std::abs(y) - (half_height - corner_radius);
    return hypotenuse((std::max)(dx, 0.), (std::max)(dy, 0.)) + (std::min)((std::max)(dx, dy), 0.) -
           corner_radius;
  }

  /// the distance to one rectangle around the full rows and one around all rows as wide as the
  /// short ones.
  double outline(double x, double y) const {
    const double columns = static_cast<double>(rows_.columns()), all = double(rows_.rows);
    const double full =
        rectangle(x, y - (full_rows_ - 1.) / 2., columns / 2. + margin, full_rows_ / 2. + margin);
    if(full_rows_ == all)
      return full;
    return (std::min)(
        full, rectangle(x, y - (all - 1.) / 2., (columns - 1.) / 2. + margin, all / 2. + margin));
  }

  /// the distance into the nearest hole, negative outside of it.
  double hole(double x, double y) const {
    double nearest = std::numeric_limits<double>::infinity();
    const double last_row = static_cast<double>(rows_.rows) - 1.;
    for(const double beside : {std::floor(y), std::floor(y) + 1.}) {
      const double row = std::clamp(beside, 0., last_row);
      const double count = static_cast<double>(rows_.holes_in_row(static_cast<std::size_t>(row)));
      if(count == 0.)
        continue;
      const double half = (count - 1.) / 2.;
      const double centre = std::clamp(std::round(x + half), 0., count - 1.) - half;
      nearest = (std::min)(nearest, hypotenuse(x - centre, y - row));
    }
    return hole_radius - nearest;
  }

  Hole_rows rows_;
  double full_rows_;
};

/// A block of unit cubes with square holes through its whole depth. Holes and walls are equally
/// wide, so two holes never touch, not even at an edge, and the surface is manifold.
struct Drilled_block
{
  Drilled_block(std::size_t holes, std::size_t width_of_hole)
      : rows(holes)
      , hole_width(width_of_hole)
      , width(hole_width * (2 * rows.columns() + 1))
      , height(hole_width * (2 * rows.rows + 1))
      , top_faces(2 * (width * height - holes * hole_width * hole_width))
      , ring_faces(2 * (2 * (width + height) + 4 * holes * hole_width)) {}

  std::size_t faces(std::size_t depth) const { return 2 * top_faces + depth * ring_faces; }

  /// the depth at which the block has about a number of faces.
  std::size_t depth_for(std::size_t faces) const {
    const double walls = static_cast<double>(faces) - 2. * static_cast<double>(top_faces);
    return walls < ring_faces ? 1 : static_cast<std::size_t>(std::lround(walls / ring_faces));
  }

  bool is_solid(std::ptrdiff_t x, std::ptrdiff_t y) const {
    if(x < 0 || y < 0 || x >= std::ptrdiff_t(width) || y >= std::ptrdiff_t(height))
      return false;
    const std::size_t column = x / hole_width, row = y / hole_width;
    return row % 2 == 0 || column % 2 == 0 || column / 2 >= rows.holes_in_row(row / 2);
  }

  Hole_rows rows;
  std::size_t hole_width, width, height;
  std::size_t top_faces, ring_faces; ///< of one of the two caps; of the walls, per unit of depth
};

/// of the blocks with about a number of faces, the one that is closest to a cube, and its depth.
std::pair<Drilled_block, std::size_t> choose_block(std::size_t holes, std::size_t faces) {
  std::pair<Drilled_block, std::size_t> best = {Drilled_block(holes, 1), 1};
  double least_error = std::numeric_limits<double>::infinity();
  for(std::size_t hole_width = 1;; ++hole_width) {
    const Drilled_block block(holes, hole_width);
    const std::size_t depth = block.depth_for(faces);
    if(hole_width > 1 && block.faces(depth) > 1.1 * faces)
      return best;
    const double error = std::abs(logarithm(double(depth) / block.width));
    if(error < least_error) {
      least_error = error;
      best = {block, depth};
    }
  }
}

/// Writes the boundary of a block, each unit square cut along a random diagonal.
class Block_surface
{
public:
  Block_surface(const Drilled_block& block, std::size_t depth, unsigned seed)
      : block_(block)
      , depth_(static_cast<std::uint32_t>(depth))
      , random_(seed) {
    const std::size_t faces = block.faces(depth);
    soup_.triangles.reserve(faces);
    soup_.points.reserve(faces / 2 + 2);
    number_vertices();
    for(std::size_t y = 0; y < block_.height; ++y)
      for(std::size_t x = 0; x < block_.width; ++x)
        if(block_.is_solid(x, y)) {
          add_caps(x, y);
          add_walls(x, y);
        }
  }

  Soup take() { return std::move(soup_); }

private:
  /// The vertices above a point of the plane grid: at the bottom, at the top and, on a wall, at the
  /// heights between, which follow that at the bottom.
  struct Column
  {
    std::uint32_t bottom = 0, top = 0;
  };

  std::size_t grid_index(std::size_t x, std::size_t y) const { return y * (block_.width + 1) + x; }

  void number_vertices() {
    columns_.resize((block_.width + 1) * (block_.height + 1));
    for(std::size_t y = 0; y <= block_.height; ++y)
      for(std::size_t x = 0; x <= block_.width; ++x) {
        const std::ptrdiff_t i = x, j = y;
        const int solid = block_.is_solid(i - 1, j - 1) + block_.is_solid(i, j - 1) +
                          block_.is_solid(i - 1, j) + block_.is_solid(i, j);
        if(solid == 0)
          continue;
        Column& column = columns_[grid_index(x, y)];
        column.bottom = add_point(soup_, Vector(x, y, 0));
        if(solid < 4)
          for(std::uint32_t z = 1; z < depth_; ++z)
            add_point(soup_, Vector(x, y, z));
        column.top = add_point(soup_, Vector(x, y, depth_));
      }
  }

  std::uint32_t vertex(std::size_t x, std::size_t y, std::uint32_t z) const {
    const Column& column = columns_[grid_index(x, y)];
    return z == depth_ ? column.top : column.bottom + z;
  }

  void add_square(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    if(random_.below(2) == 0) {
      soup_.triangles.push_back({a, b, c});
      soup_.triangles.push_back({a, c, d});
    } else {
      soup_.triangles.push_back({b, c, d});
      soup_.triangles.push_back({b, d, a});
    }
  }

  void add_caps(std::size_t x, std::size_t y) {
    add_square(vertex(x, y, depth_), vertex(x + 1, y, depth_), vertex(x + 1, y + 1, depth_),
               vertex(x, y + 1, depth_));
    add_square(vertex(x, y, 0), vertex(x, y + 1, 0), vertex(x + 1, y + 1, 0), vertex(x + 1, y, 0));
  }

  void add_walls(std::size_t x, std::size_t y) {
    const std::ptrdiff_t i = x, j = y;
    // Each wall runs with the solid on its left.
    if(!block_.is_solid(i, j - 1))
      add_wall(x, y, x + 1, y);
    if(!block_.is_solid(i + 1, j))
      add_wall(x + 1, y, x + 1, y + 1);
    if(!block_.is_solid(i, j + 1))
      add_wall(x + 1, y + 1, x, y + 1);
    if(!block_.is_solid(i - 1, j))
      add_wall(x, y + 1, x, y);
  }

  void add_wall(std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1) {
    for(std::uint32_t z = 0; z < depth_; ++z)
      add_square(vertex(x0, y0, z), vertex(x1, y1, z), vertex(x1, y1, z + 1),
                 vertex(x0, y0, z + 1));
  }

  const Drilled_block& block_;
  std::uint32_t depth_;
  Random random_;
  Soup soup_;
  std::vector<Column> columns_;
};

} // namespace

Soup make_multi_torus(const Request& request) {
  require_faces(request, "multi-torus", 200 + 200 * request.genus);
  return mesh_of_field(Slab(request.genus), request, "multi-torus");
}

Soup make_sponge(const Request& request) {
  require_faces(request, "sponge", Drilled_block(request.genus, 1).faces(1));
  const auto [block, depth] = choose_block(request.genus, request.faces);
  return Block_surface(block, depth, request.seed).take();
}

} // namespace CGAL::Handle_tunnel_loops::generators
