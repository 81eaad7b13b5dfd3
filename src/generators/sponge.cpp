// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Hole_rows.h"
#include "Random.h"
#include "kinds.h"
#include "request_checks.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// A block of unit cubes with square holes through its whole depth. Holes and walls are equally
/// wide, so two holes never touch, not even at an edge, and the surface is manifold.
class Drilled_block
{
public:
  Drilled_block(std::size_t holes, std::size_t hole_width)
      : rows_(holes)
      , hole_width_(hole_width)
      , width_(hole_width * (2 * rows_.columns() + 1))
      , height_(hole_width * (2 * rows_.rows() + 1))
      , top_faces_(2 * (width_ * height_ - holes * hole_width * hole_width))
      , ring_faces_(2 * (2 * (width_ + height_) + 4 * holes * hole_width)) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  std::size_t faces(std::size_t depth) const { return 2 * top_faces_ + depth * ring_faces_; }

  /// the depth at which the block has about a number of faces.
  std::size_t depth_for(std::size_t faces) const {
    const double walls = static_cast<double>(faces) - 2. * static_cast<double>(top_faces_);
    return walls < ring_faces_ ? 1 : static_cast<std::size_t>(std::lround(walls / ring_faces_));
  }

  bool is_solid(std::ptrdiff_t x, std::ptrdiff_t y) const {
    if(x < 0 || y < 0 || x >= std::ptrdiff_t(width_) || y >= std::ptrdiff_t(height_))
      return false;
    const std::size_t column = x / hole_width_, row = y / hole_width_;
    return row % 2 == 0 || column % 2 == 0 || column / 2 >= rows_.holes_in_row(row / 2);
  }

private:
  Hole_rows rows_;
  std::size_t hole_width_, width_, height_;
  std::size_t top_faces_, ring_faces_; // of one of the two caps; of the walls, per unit of depth
};

struct Block_size
{
  std::size_t hole_width, depth;
};

/// of the blocks with about a number of faces, the one that is closest to a cube.
Block_size choose_size(std::size_t holes, std::size_t faces) {
  Block_size best = {1, 1};
  double least_error = std::numeric_limits<double>::infinity();
  for(std::size_t hole_width = 1;; ++hole_width) {
    const Drilled_block block(holes, hole_width);
    const std::size_t depth = block.depth_for(faces);
    if(hole_width > 1 && block.faces(depth) > 1.1 * faces)
      return best;
    const double error = std::abs(std::log(double(depth) / block.width()));
    if(error < least_error) {
      least_error = error;
      best = {hole_width, depth};
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
    for(std::size_t y = 0; y < block_.height(); ++y)
      for(std::size_t x = 0; x < block_.width(); ++x)
        if(block_.is_solid(x, y)) {
          add_caps(x, y);
          add_walls(x, y);
        }
  }

  Soup take() { return std::move(soup_); }

private:
  /// The vertices above a point of the plane grid: at the bottom, at the top and, on a wall, at the
  /// heights between, which are consecutive.
  struct Column
  {
    std::uint32_t bottom = 0, top = 0, first_between = 0;
  };

  std::size_t grid_index(std::size_t x, std::size_t y) const {
    return y * (block_.width() + 1) + x;
  }

  void number_vertices() {
    columns_.resize((block_.width() + 1) * (block_.height() + 1));
    for(std::size_t y = 0; y <= block_.height(); ++y)
      for(std::size_t x = 0; x <= block_.width(); ++x) {
        const std::ptrdiff_t i = x, j = y;
        const int solid = block_.is_solid(i - 1, j - 1) + block_.is_solid(i, j - 1) +
                          block_.is_solid(i - 1, j) + block_.is_solid(i, j);
        if(solid == 0)
          continue;
        Column& column = columns_[grid_index(x, y)];
        column.bottom = add_point(x, y, 0);
        column.first_between = column.bottom + 1;
        if(solid < 4)
          for(std::uint32_t z = 1; z < depth_; ++z)
            add_point(x, y, z);
        column.top = add_point(x, y, depth_);
      }
  }

  std::uint32_t add_point(std::size_t x, std::size_t y, std::uint32_t z) {
    soup_.points.push_back({double(x), double(y), double(z)});
    return static_cast<std::uint32_t>(soup_.points.size() - 1);
  }

  std::uint32_t vertex(std::size_t x, std::size_t y, std::uint32_t z) const {
    const Column& column = columns_[grid_index(x, y)];
    return z == 0 ? column.bottom : z == depth_ ? column.top : column.first_between + (z - 1);
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

Soup make_sponge(const Request& request) {
  require_faces(request, "sponge", Drilled_block(request.genus, 1).faces(1));
  const Block_size size = choose_size(request.genus, request.faces);
  const Drilled_block block(request.genus, size.hole_width);
  return Block_surface(block, size.depth, request.seed).take();
}

} // namespace

const Kind sponge_kind = {
    "sponge",
    "a block of cubes with a square hole through it for each handle, with flat faces and sharp "
    "edges; any genus g, from about 60 + 30 g faces",
    make_sponge};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
