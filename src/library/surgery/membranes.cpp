// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Collar.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangulated_polygon.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/insert_vertices.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A membrane across a curve, and how it is made into two, on either side of it.
class Membranes
{
  using Mesh = Surface_mesh<Surgery_mesh::Point>;
  using Vertex = Mesh::Vertex_index;
  using Vector = Surgery_mesh::Kernel::Vector_3;

public:
  Membranes(const Surgery_mesh& mesh,
            const Curve_off_vertices& curve,
            const Divided_strip& strip,
            Polygon_in_space::At_sides side)
      : strip_(strip)
      , length_(curve.length()) {
    for(std::size_t i = 0; i < curve.size(); ++i) {
      curve_.points.push_back(curve.point(mesh, i));
      const auto &left = strip.parts().points[2 * i], &right = strip.parts().points[2 * i + 1];
      widths_.push_back(std::sqrt(CGAL::squared_distance(left, right)) / 2.);
      const Index next = curve[i + 1 == curve.size() ? 0 : i + 1].halfedge;
      curve_.normals_beyond.push_back(normal_of(mesh, Surgery_mesh::face(next)));
    }
    curve_.at_sides = side;
    forbid_sides_of_parts();
  }

  /// of the points of the curve. Returns whether there is one.
  bool span() {
    start();
    return fill(curve_, 0);
  }

  /// at the end of a collar, which is as high as a part of the length of the curve.
  bool span_with_collar(double part) {
    start();
    const Collar collar(curve_, part * length_);
    if(!collar.is_good())
      return false;
    for(const Surgery_mesh::Point& p : collar.inner().points)
      membrane_.add_vertex(p);
    return add_faces(collar.triangles(), 0) && fill(collar.inner(), curve_.size());
  }

  void refine() {
    const std::vector<Mesh::Face_index> all(membrane_.faces().begin(), membrane_.faces().end());
    std::vector<Vertex> own;
    insert_vertices(membrane_, all, own);
  }

  /// the parts of the divided faces, and the membranes.
  Patch caps() const {
    Patch patch = strip_.parts();
    std::vector<Vector> shifts; // of the vertices that are not on the curve
    for(std::size_t i = curve_.size(); i < membrane_.number_of_vertices(); ++i)
      shifts.push_back(shift_at(Vertex(static_cast<Index>(i))));
    for(const bool is_left : {true, false}) {
      const Index first_inner = static_cast<Index>(patch.points.size());
      for(std::size_t i = 0; i < shifts.size(); ++i) {
        const Vertex v(static_cast<Index>(curve_.size() + i));
        patch.points.push_back(membrane_.point(v) + (is_left ? shifts[i] : -shifts[i]));
      }
      patch.caps.push_back(patch.faces.size());
      for(Mesh::Face_index f : membrane_.faces())
        patch.faces.push_back(face_of(f, is_left, first_inner));
    }
    return patch;
  }

private:
  // The points of the curve keep their numbers.
  void start() {
    membrane_.clear();
    for(const Surgery_mesh::Point& p : curve_.points)
      membrane_.add_vertex(p);
  }

  bool fill(const Polygon_in_space& polygon, std::size_t first_vertex) {
    const Triangulated_polygon filling(polygon);
    return filling.is_good() && add_faces(filling.triangles(), first_vertex);
  }

  // As each triangle comes after those at its sides, or before them, those that follow have nothing
  // in common with what is there but sides.
  bool add_faces(std::vector<std::array<std::size_t, 3>> triangles, std::size_t first_vertex) {
    if(membrane_.number_of_faces() == 0)
      std::reverse(triangles.begin(), triangles.end());
    const auto vertex = [&](std::size_t i) { return Vertex(static_cast<Index>(first_vertex + i)); };
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      return membrane_.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) != Mesh::null_face();
    });
  }

  void forbid_sides_of_parts() {
    std::set<std::pair<std::size_t, std::size_t>> sides;
    for(const Surgery_mesh::Face& f : strip_.parts().faces)
      for(std::size_t k = 0; k < 3; ++k) {
        const Index u = f[k], v = f[(k + 1) % 3];
        if(u >= Patch::first_own && v >= Patch::first_own && u % 2 == v % 2)
          sides.insert(
              std::minmax<std::size_t>((u - Patch::first_own) / 2, (v - Patch::first_own) / 2));
      }
    curve_.are_joined = [sides = std::move(sides)](std::size_t i, std::size_t j) {
      return sides.count(std::minmax(i, j)) != 0;
    };
  }

  // Half the way from one membrane to the other, at right angles to them: no longer than where the
  // curve is near, so that they do not meet.
  Vector shift_at(Vertex v) const {
    constexpr double most_slope = 0.1;
    Vector normal(NULL_VECTOR);
    double room = (std::numeric_limits<double>::infinity)();
    const Surgery_mesh::Point& p = membrane_.point(v);
    for(const auto h : halfedges_around_target(membrane_.halfedge(v), membrane_)) {
      const Vector from = membrane_.point(membrane_.source(h)) - p,
                   to = membrane_.point(membrane_.target(membrane_.next(h))) - p,
                   n = CGAL::cross_product(to, from);
      const double sine = std::sqrt(n.squared_length()),
                   lengths = std::sqrt(from.squared_length() * to.squared_length());
      if(sine > 0.)
        normal = normal + n / sine * arc_sine((std::min)(1., sine / lengths));
      room = (std::min)(room, most_slope * std::sqrt(from.squared_length()));
    }
    for(std::size_t i = 0; i < curve_.size(); ++i)
      room = (std::min)(
          room, widths_[i] + most_slope * std::sqrt(CGAL::squared_distance(p, curve_.points[i])));
    if(curve_.at_sides == Polygon_in_space::OUTSIDE)
      normal = -normal; // the left of the curve is behind the triangles
    const double length = std::sqrt(normal.squared_length());
    return length > 0. ? room / length * normal : normal;
  }

  Surgery_mesh::Face face_of(Mesh::Face_index f, bool is_left, Index first_inner) const {
    Surgery_mesh::Face face;
    std::size_t k = 0;
    for(Vertex v : vertices_around_face(membrane_.halfedge(f), membrane_)) {
      const Index i = v, n = static_cast<Index>(curve_.size());
      face[k++] = Patch::first_own + (i >= n ? first_inner + i - n : 2 * i + (is_left ? 0 : 1));
    }
    if(is_left)
      std::swap(face[1], face[2]);
    return face;
  }

  const Divided_strip& strip_;
  Polygon_in_space curve_;
  std::vector<double> widths_; // from the curve to a rim, by point
  double length_;
  Mesh membrane_;
};

void for_each_membrane(const Surgery_mesh& mesh,
                       const Curve_off_vertices& curve,
                       const Divided_strip& strip,
                       Polygon_in_space::At_sides side,
                       const Patch_visitor& is_wanted) {
  Membranes membranes(mesh, curve, strip, side);
  const auto is_one_wanted = [&] {
    if(!is_wanted(membranes.caps()))
      return false;
    membranes.refine();
    is_wanted(membranes.caps());
    return true;
  };
  if(membranes.span() && is_one_wanted())
    return;
  for(const double part : {0.03, 0.08, 0.01, 0.003})
    if(membranes.span_with_collar(part) && is_one_wanted())
      return;
}

} // namespace CGAL::Handle_tunnel_loops::internal
