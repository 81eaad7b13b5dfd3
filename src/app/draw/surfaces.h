// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SURFACES_H
#define HTLOOPS_SURFACES_H

#include "mesh_types.h"
#include "solve/reeb_solver.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/arc_shapes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace htloops {

using Vector = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;

inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// the vector of length one, or the null vector.
inline Vector unit(const Vector& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  return length > 0. ? Vector{a[0] / length, a[1] / length, a[2] / length} : Vector{};
}

/// The box around points.
struct Bounds
{
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  Vector low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};

  void add(const Vector& p) {
    for(int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], p[i]);
      high[i] = (std::max)(high[i], p[i]);
    }
  }
};

// Meshes as pictures and pages take them.

inline std::array<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<std::array<double, 3>> coordinates(const std::vector<Point>& points);

/// What is drawn of a surface.
struct Drawn_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<unsigned char, 3>> colours; ///< of the triangles, or none
};

Drawn_surface drawn_surface(const Mesh& mesh);

/// Cuts faces between levels of a function on the vertices, to triangles. Points are those of the
/// mesh, and where edges were cut: the same from both sides.
class Level_cutter
{
  using Vertex = Mesh::Vertex_index;
  using Corners = std::array<Vertex, 3>;
  using Polygon = std::vector<std::uint32_t>;

public:
  using Face_part = CGAL::Handle_tunnel_loops::internal::Face_part;
  using Triangle = std::array<std::uint32_t, 3>;

  /// \p values are by vertex. Both must outlive the object.
  Level_cutter(const Mesh& mesh, const std::vector<double>& values);

  double value(Vertex v) const { return values_[v.idx()]; }

  /// calls `add(triangle, arc)` for the triangles of a face. What its parts are, say
  /// `parts.parts_of(corners)` and, of a side, `parts.parts_of(low, high)`, by increasing value.
  template <typename Parts, typename Add>
  void cut(Mesh::Face_index f, Parts& parts, const Add& add) {
    const Corners corners = corners_of(f);
    const bool is_turned = !has_orientation(f, corners);
    const std::vector<Face_part> found = parts.parts_of(corners);
    if(found != parts.parts_of(corners[0], corners[2]))
      cut_to_fan(f, parts, add);
    else if(found.front().low < found.back().high)
      for(const Face_part& part : found)
        add_polygon(polygon(corners, part.low, part.high), part.arc, is_turned, add);
    else // all of it is at one level
      add_polygon(whole(corners), found.front().arc, is_turned, add);
  }

  std::vector<std::array<double, 3>> take_points() { return std::move(points_); }

private:
  // Where the three sides of a face do not tell the same, each has a third of it.
  template <typename Parts, typename Add>
  void cut_to_fan(Mesh::Face_index f, Parts& parts, const Add& add) {
    const std::uint32_t middle = add_middle(f);
    for(Mesh::Halfedge_index side : mesh_.halfedges_around_face(mesh_.halfedge(f)))
      cut_side(side, middle, parts, add);
  }

  template <typename Parts, typename Add>
  void cut_side(Mesh::Halfedge_index side, std::uint32_t middle, Parts& parts, const Add& add) {
    Vertex low = mesh_.source(side), high = mesh_.target(side);
    const bool is_turned = is_before(high, low);
    if(is_turned)
      std::swap(low, high);
    std::uint32_t from = low.idx();
    for(const Face_part& part : parts.parts_of(low, high)) {
      const bool is_last = part.high == value(high);
      if(!is_last && !(part.low < part.high))
        continue;
      const std::uint32_t to = is_last ? std::uint32_t(high.idx()) : point_at(low, high, part.high);
      add_polygon({from, to, middle}, part.arc, is_turned, add);
      from = to;
      if(is_last)
        break;
    }
  }

  // All of them are convex.
  template <typename Add>
  void add_polygon(const Polygon& polygon, std::size_t arc, bool is_turned, const Add& add) {
    for(std::size_t i = 2; i < polygon.size(); ++i)
      add(is_turned ? Triangle{polygon[0], polygon[i], polygon[i - 1]}
                    : Triangle{polygon[0], polygon[i - 1], polygon[i]},
          arc);
  }

  // By value, of equal ones by number.
  bool is_before(Vertex v, Vertex w) const {
    return std::make_pair(value(v), v) < std::make_pair(value(w), w);
  }

  static Polygon whole(const Corners& corners) {
    return {corners[0].idx(), corners[1].idx(), corners[2].idx()};
  }

  // The corners of a face by increasing value.
  Corners corners_of(Mesh::Face_index f) const;

  // Whether the corners follow each other as around the face.
  bool has_orientation(Mesh::Face_index f, const Corners& corners) const;

  // Around what of a face lies between two levels, in the order of the corners.
  Polygon polygon(const Corners& corners, double low, double high);

  // The point of an edge that rises from `low` to `high`.
  std::uint32_t point_at(Vertex low, Vertex high, double level);

  std::uint32_t add_middle(Mesh::Face_index f);

  const Mesh& mesh_;
  const std::vector<double>& values_;
  std::map<std::tuple<Vertex, Vertex, double>, std::uint32_t> cuts_;
  std::vector<std::array<double, 3>> points_;
};

/// The surface in pieces each of which belongs to one arc: faces are cut along the contours where
/// fronts meet, so that the border of a part is as smooth as the function.
struct Arc_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangle_arcs;
};

Arc_surface arc_surface(const Mesh& mesh, const Reeb_answer& answer);

/// the same in the colours of the arcs.
Drawn_surface drawn_surface(const Arc_surface& surface);

} // namespace htloops

#endif // HTLOOPS_SURFACES_H
