// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_TYPES_H
#define HTLOOPS_MESH_TYPES_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Handle_tunnel_loops/Basis_kind.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Triangle_arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace htloops {

namespace internal = CGAL::Handle_tunnel_loops::internal;
using CGAL::Loop_type;
using CGAL::Handle_tunnel_loops::Basis_kind;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Handle_tunnel_loops::Triangle_arrays<Point>;

/// whether a point is somewhere.
inline bool is_finite(const Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

/// in any unit; the same on all machines.
inline double length_of_vector(double x, double y, double z) {
  return internal::rounded_length_of_any(x, y, z);
}

/// the diagonal of a box.
inline double diagonal_of(const CGAL::Bbox_3& box) {
  return length_of_vector(box.xmax() - box.xmin(), box.ymax() - box.ymin(),
                          box.zmax() - box.zmin());
}

inline CGAL::Bbox_3 box_of(const Mesh& mesh) {
  return CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
}

/// the diagonal of the box of a mesh.
inline double diagonal_of(const Mesh& mesh) { return diagonal_of(box_of(mesh)); }

/// a line without elements that are equal to the one before; if it is closed, the last one comes
/// before the first.
template <typename T>
std::vector<T> without_repetitions(std::vector<T> line, bool is_closed = true) {
  line.erase(std::unique(line.begin(), line.end()), line.end());
  while(is_closed && line.size() > 1 && line.front() == line.back())
    line.pop_back();
  return line;
}

using Pair = CGAL::Handle_tunnel_pair<Mesh>;
using Loop = Pair::Loop;
using Pairs = std::vector<Pair>;

/// Both kinds, in the order in which they are written.
constexpr Loop_type loop_types[] = {Loop_type::HANDLE, Loop_type::TUNNEL};

/// calls `visit(loop, type, index of the pair)` for all loops.
template <typename Visit> void for_each_loop(const Pairs& pairs, Visit visit) {
  for(std::size_t i = 0; i < pairs.size(); ++i)
    for(const Loop_type type : loop_types)
      visit(pairs[i].loop(type), type, i);
}

/// the word for a kind, as it stands in files and messages.
inline const char* name_of(Loop_type type) {
  return type == Loop_type::HANDLE ? "handle" : type == Loop_type::TUNNEL ? "tunnel" : "boundary";
}

/// the number for a kind, as it stands in files: 0, 1, and 2 for a boundary curve.
constexpr int kind_number_of(Loop_type type) {
  return type == Loop_type::HANDLE ? 0 : type == Loop_type::TUNNEL ? 1 : 2;
}

/// Whether an edge, by its number, lies across a face of the file, which was cut into triangles;
/// empty if all were triangles.
using Face_cuts = std::vector<char>;

/// Red, green and blue.
using Colour = std::array<unsigned char, 3>;

/// A number for each vertex, in the order of the vertices, as PLY files have them.
struct Vertex_property
{
  std::string name;
  std::string type; ///< a type of PLY
  std::vector<double> values;

  bool is_real() const { return type.find("float") == 0 || type.find("double") == 0; }
};

using Vertex_properties = std::vector<Vertex_property>;

inline bool has_property(const Vertex_properties& properties, const std::string& name) {
  return std::any_of(properties.begin(), properties.end(),
                     [&name](const Vertex_property& p) { return p.name == name; });
}

} // namespace htloops

#endif // HTLOOPS_MESH_TYPES_H
