// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LEVEL_CUTTER_H
#define HTLOOPS_LEVEL_CUTTER_H

#include "draw/mesh_arrays.h"
#include "mesh_types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace htloops {

/// Cuts faces between levels of a function on the vertices. Points are those of the mesh, and where
/// edges were cut: the same from both sides.
class Level_cutter
{
public:
  using Vertex = Mesh::Vertex_index;
  using Corners = std::array<Vertex, 3>;
  using Polygon = std::vector<std::uint32_t>;

  /// \p values are by vertex. Both must outlive the object.
  Level_cutter(const Mesh& mesh, const std::vector<double>& values);

  double value(Vertex v) const { return values_[v.idx()]; }

  /// the corners of a face by increasing value, of equal ones by number.
  Corners corners_of(Mesh::Face_index f) const;

  /// whether the corners follow each other as around the face.
  bool has_orientation(Mesh::Face_index f, const Corners& corners) const;

  /// around what of a face lies between two levels: convex, in the order of the corners.
  Polygon polygon(const Corners& corners, double low, double high);

  /// the point of an edge that rises from `low` to `high`, at a level between their values.
  std::uint32_t point_at(Vertex low, Vertex high, double level);

  std::uint32_t add_point(const Point& p);

  std::vector<std::array<double, 3>> take_points() { return std::move(points_); }

private:
  const Mesh& mesh_;
  const std::vector<double>& values_;
  std::map<std::tuple<Vertex, Vertex, double>, std::uint32_t> cuts_;
  std::vector<std::array<double, 3>> points_;
};

/// calls `f(triangle)` for those of a convex polygon, which is turned over if its face is.
template <typename Function>
void for_each_triangle(const Level_cutter::Polygon& polygon, bool is_turned, const Function& f) {
  for(std::size_t i = 2; i < polygon.size(); ++i)
    f(is_turned ? std::array<std::uint32_t, 3>{polygon[0], polygon[i], polygon[i - 1]}
                : std::array<std::uint32_t, 3>{polygon[0], polygon[i - 1], polygon[i]});
}

} // namespace htloops

#endif // HTLOOPS_LEVEL_CUTTER_H
