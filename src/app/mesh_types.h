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

#include <CGAL/Handle_tunnel_loops/Basis_kind.h>
#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htloops {

using CGAL::Loop_type;
using CGAL::Handle_tunnel_loops::Basis_kind;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

/// whether a point is somewhere.
inline bool is_finite(const Point& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

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

/// Whether an edge lies across a face of the file, which was cut into triangles.
using Face_cuts = Mesh::Property_map<Mesh::Edge_index, bool>;

/// They go with the mesh.
inline Face_cuts add_face_cuts(Mesh& mesh) {
  return mesh.add_property_map<Mesh::Edge_index, bool>("e:cuts_face", false).first;
}

// What CGAL 5 and CGAL 6 return for a map that may not be there.
inline std::optional<Face_cuts> if_found(const std::pair<Face_cuts, bool>& map) {
  return map.second ? std::optional<Face_cuts>(map.first) : std::nullopt;
}
inline std::optional<Face_cuts> if_found(const std::optional<Face_cuts>& map) { return map; }

/// nothing for a mesh whose faces all were triangles.
inline std::optional<Face_cuts> cuts_of_faces(const Mesh& mesh) {
  return if_found(mesh.property_map<Mesh::Edge_index, bool>("e:cuts_face"));
}

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
