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

#include <CGAL/Bbox_3.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/arc_shapes.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
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

inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline double norm(const Vector& a) { return length_of_vector(a[0], a[1], a[2]); }

/// the vector of length one, or the null vector.
inline Vector unit(const Vector& a) {
  const double length = norm(a);
  return length > 0. ? Vector{a[0] / length, a[1] / length, a[2] / length} : Vector{};
}

/// the box around points.
inline CGAL::Bbox_3 box_of(const std::vector<Vector>& points) {
  CGAL::Bbox_3 box;
  for(const auto& [x, y, z] : points)
    box += CGAL::Bbox_3(x, y, z, x, y, z);
  return box;
}

// Meshes as pictures and pages take them.

inline std::array<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }

template <typename Points> std::vector<std::array<double, 3>> coordinates(const Points& points) {
  std::vector<std::array<double, 3>> result;
  result.reserve(static_cast<std::size_t>(std::distance(points.begin(), points.end())));
  for(const Point& p : points)
    result.push_back(coordinates(p));
  return result;
}

/// What is drawn of a surface.
struct Drawn_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Colour> colours; ///< of the triangles, or none
  double opacity = 1.;         ///< in models, 0 to 1
};

/// of a surface in pages and models, if lines are inside.
constexpr double opacity_around_bones = 0.5;

Drawn_surface drawn_surface(const Mesh& mesh);

/// all edges, by their smaller vertex, then the larger: how they are numbered where they are drawn.
std::vector<Mesh::Edge_index> edges_by_vertices(const Mesh& mesh);

/// A surface in pieces each of which belongs to one arc of a graph, or to one part of another kind.
struct Arc_surface
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> triangle_arcs;
};

/// Cuts the faces of a mesh between levels of a function on the vertices, to triangles. Points are
/// those of the mesh, and where edges were cut: the same from both sides.
class Level_cutter
{
  using Vertex = Mesh::Vertex_index;
  using Corners = std::array<Vertex, 3>;
  using Polygon = std::vector<std::uint32_t>;
  using Face_part = CGAL::Handle_tunnel_loops::internal::Face_part;

public:
  /// \p values are by vertex. Both must outlive the object.
  Level_cutter(const Mesh& mesh, const std::vector<double>& values)
      : mesh_(mesh)
      , values_(values) {}

  /// cuts all faces. What the parts of one are, say `parts.parts_of(corners)` and, of a side,
  /// `parts.parts_of(low, high)`, by increasing value.
  template <typename Parts> Arc_surface cut(Parts& parts) {
    for(const Mesh::Face_index f : mesh_.faces())
      cut_face(f, parts);
    return std::move(surface_);
  }

private:
  template <typename Parts> void cut_face(Mesh::Face_index f, Parts& parts) {
    const Corners corners = corners_of(f);
    const bool is_turned = !has_orientation(f, corners);
    const std::vector<Face_part> found = parts.parts_of(corners);
    if(found != parts.parts_of(corners[0], corners[2]))
      cut_to_fan(f, parts);
    else if(found.front().low < found.back().high)
      for(const Face_part& part : found)
        add_polygon(polygon(corners, part.low, part.high), part.arc, is_turned);
    else // all of it is at one level
      add_polygon({corners[0].idx(), corners[1].idx(), corners[2].idx()}, found.front().arc,
                  is_turned);
  }

  // Where the three sides of a face do not tell the same, each has a third of it.
  template <typename Parts> void cut_to_fan(Mesh::Face_index f, Parts& parts) {
    const std::uint32_t middle = add_middle(f);
    for(Mesh::Halfedge_index side : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
      cut_side(side, middle, parts);
  }

  template <typename Parts>
  void cut_side(Mesh::Halfedge_index side, std::uint32_t middle, Parts& parts) {
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
      add_polygon({from, to, middle}, part.arc, is_turned);
      from = to;
      if(is_last)
        break;
    }
  }

  // All of them are convex.
  void add_polygon(const Polygon& polygon, std::size_t arc, bool is_turned);

  double value(Vertex v) const { return values_[v.idx()]; }

  // By value, of equal ones by number.
  bool is_before(Vertex v, Vertex w) const {
    return std::make_pair(value(v), v) < std::make_pair(value(w), w);
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
  Arc_surface surface_ = {coordinates(mesh_.points()), {}, {}};
};

/// The parts of the arcs: faces are cut along the contours where fronts meet, so that the border of
/// a part is as smooth as the function; if the graph is contracted, as `surface_of_labels()` does.
Arc_surface arc_surface(const Mesh& mesh, const Reeb_answer& answer);

/// a surface in the colours of its parts.
Drawn_surface drawn_surface(const Arc_surface& surface,
                            const std::function<Colour(std::size_t)>& colour_of_part);

/// The parts of labels of the vertices: faces are cut between those of different labels, where that
/// makes the borders straight.
Arc_surface surface_of_labels(const Mesh& mesh, const std::vector<std::size_t>& labels);

} // namespace htloops

#endif // HTLOOPS_SURFACES_H
