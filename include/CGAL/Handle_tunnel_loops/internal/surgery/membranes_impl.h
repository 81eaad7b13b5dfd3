// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MEMBRANES_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MEMBRANES_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangulated_polygon.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/insert_vertices.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
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
      shifts_.push_back(0.5 * (left - right));
      const Index next = curve[i + 1 == curve.size() ? 0 : i + 1].halfedge;
      curve_.normals_beyond.push_back(normal_of(mesh, Surgery_mesh::face(next)));
    }
    curve_.at_sides = side;
    forbid_sides_of_parts();
    const Triangulated_polygon filling(curve_);
    is_good_ = filling.is_good() && make_membrane(filling);
  }

  bool are_good() const { return is_good_; }

  void refine() {
    const std::vector<Mesh::Face_index> all(membrane_.faces().begin(), membrane_.faces().end());
    std::vector<Vertex> own;
    insert_vertices(membrane_, all, own);
  }

  /// the parts of the divided faces, and the membranes.
  Patch caps() const {
    Patch patch = strip_.parts();
    for(const bool is_left : {true, false}) {
      const Index first_inner = static_cast<Index>(patch.points.size());
      for(std::size_t i = curve_.size(); i < membrane_.number_of_vertices(); ++i) {
        const Surgery_mesh::Point& p = membrane_.point(Vertex(static_cast<Index>(i)));
        patch.points.push_back(is_left ? p + shift_at(p) : p - shift_at(p));
      }
      patch.caps.push_back(patch.faces.size());
      for(Mesh::Face_index f : membrane_.faces())
        patch.faces.push_back(face_of(f, is_left, first_inner));
    }
    return patch;
  }

private:
  // The points of the curve keep their numbers. As each triangle comes before those at its sides,
  // these have nothing in common but that side.
  bool make_membrane(const Triangulated_polygon& filling) {
    for(const Surgery_mesh::Point& p : curve_.points)
      membrane_.add_vertex(p);
    const auto& triangles = filling.triangles();
    return std::all_of(triangles.rbegin(), triangles.rend(), [this](const auto& t) {
      return membrane_.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) != Mesh::null_face();
    });
  }

  static Vertex vertex(std::size_t i) { return Vertex(static_cast<Index>(i)); }

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

  // Half the way from one membrane to the other: that of the curve nearby.
  Vector shift_at(const Surgery_mesh::Point& p) const {
    constexpr std::size_t enough = 64;
    const std::size_t step = 1 + curve_.size() / enough;
    double weights = 0.;
    Vector sum(NULL_VECTOR);
    for(std::size_t i = 0; i < curve_.size(); i += step) {
      const double d = ((p - curve_.points[i]) / length_).squared_length();
      if(!(d > 0.))
        return shifts_[i];
      weights += 1. / d;
      sum = sum + shifts_[i] / d;
    }
    return sum / weights;
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
  std::vector<Vector> shifts_; // from the curve to the rim on its left, by point
  double length_;
  Mesh membrane_;
  bool is_good_ = false;
};

CGAL_HTL_CORE void for_each_membrane(const Surgery_mesh& mesh,
                                     const Curve_off_vertices& curve,
                                     const Divided_strip& strip,
                                     Polygon_in_space::At_sides side,
                                     const Patch_visitor& is_wanted) {
  Membranes membranes(mesh, curve, strip, side);
  if(!membranes.are_good())
    return;
  const Patch plain = membranes.caps();
  membranes.refine();
  if(!is_wanted(membranes.caps()))
    is_wanted(plain);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MEMBRANES_IMPL_H
