// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge.h>

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Box_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Largest_distance.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Measures one change.
class Shape_measure
{
  using Kernel = Largest_distance::Kernel;
  using Point = Largest_distance::Point;
  using Triangles = Largest_distance::Triangles;

public:
  Shape_measure(const Surgery_mesh& mesh, const std::vector<Index>& out, const Patch& patch)
      : mesh_(mesh)
      , out_(out)
      , patch_(patch) {}

  /// of the solid behind the faces, if the mesh is changed.
  double volume_taken() const {
    const Point origin = point(patch_.faces.front()[0]);
    double volume = 0.;
    for(Index f : out_)
      volume += CGAL::volume(origin, triangle(f)[0], triangle(f)[1], triangle(f)[2]);
    for(const Surgery_mesh::Face& f : patch_.faces)
      volume -= CGAL::volume(origin, point(f[0]), point(f[1]), point(f[2]));
    return volume;
  }

  /// areas, and where the caps are sharp.
  void measure_caps(Judged_change& change) const {
    change.cap_area = 0.;
    for(std::size_t cap = 0; cap < patch_.caps.size(); ++cap) {
      double area = 0.;
      for(std::size_t i = patch_.caps[cap]; i < patch_.end_of_cap(cap); ++i)
        area += std::sqrt(triangle(patch_.faces[i]).squared_area());
      change.cap_area += area;
      const double rim = measure_edges(cap, change);
      change.cap_ratio = (std::max)(change.cap_ratio, area * 4. * CGAL_PI / (rim * rim));
    }
  }

  /// how far caps are from the surface that they take the place of.
  double displacement(const Largest_distance::Accuracy& accuracy) const {
    const Box_axes& axes = mesh_.box_axes(); // distances are the same, and found in less time
    Triangles old;
    for(Index f : out_)
      add(mesh_.corners(f), axes, old);
    return Largest_distance(std::move(old), accuracy).from(caps(axes));
  }

  /// how far faces at vertices that are taken out are above the caps; \p outward is which side that
  /// is. What is below is buried in the solid.
  double burial(double outward, const Largest_distance::Accuracy& accuracy) const {
    std::vector<Index> left;
    for(const Surgery_mesh::Face& f : patch_.faces)
      for(Index v : f)
        if(v < Patch::first_own)
          left.push_back(v);
    make_set(left);
    Triangles gone;
    for(Index f : out_) {
      const Surgery_mesh::Face& corners = mesh_.corners(f);
      if(!std::all_of(corners.begin(), corners.end(), [&](Index v) { return is_in(v, left); }))
        add(corners, Box_axes(), gone);
    }
    return Largest_distance(caps(Box_axes()), accuracy).above(outward, std::move(gone));
  }

  Box<3> box_of_caps() const {
    Box<3> box = Box<3>::empty();
    for(std::size_t i = patch_.caps.front(); i < patch_.faces.size(); ++i)
      box.extend(patch_.placed(mesh_, i).box());
    return box;
  }

private:
  using Vector = Kernel::Vector_3;

  Point point(Index v) const {
    const Surgery_mesh::Point& p = patch_.point(mesh_, v);
    return {p.x(), p.y(), p.z()};
  }
  Kernel::Triangle_3 triangle(const Surgery_mesh::Face& f) const {
    return {point(f[0]), point(f[1]), point(f[2])};
  }
  Kernel::Triangle_3 triangle(Index f) const { return triangle(mesh_.corners(f)); }

  // By coordinates along some axes. Those on a line have no normal.
  void add(const Surgery_mesh::Face& f, const Box_axes& axes, Triangles& all) const {
    const auto turned = [&](Index v) {
      const internal::Vector p = axes.turned(Surgery_mesh::place_of(patch_.point(mesh_, v)));
      return Point(p[0], p[1], p[2]);
    };
    const Kernel::Triangle_3 t(turned(f[0]), turned(f[1]), turned(f[2]));
    if(!t.is_degenerate() && !triangle(f).is_degenerate())
      all.push_back(t);
  }

  Triangles caps(const Box_axes& axes) const {
    Triangles caps;
    for(std::size_t i = patch_.caps.front(); i < patch_.faces.size(); ++i)
      add(patch_.faces[i], axes, caps);
    return caps;
  }

  // A side of a face of the patch.
  struct Side
  {
    Index low, high;  // vertices
    std::size_t face; // of the patch
    Index from, to;
  };

  // Returns the length of the rim of a cap.
  double measure_edges(std::size_t cap, Judged_change& change) const {
    const std::size_t begin = patch_.caps[cap], end = patch_.end_of_cap(cap);
    std::vector<Side> sides;
    add_sides(0, patch_.parents.size(), sides);
    add_sides(begin, end, sides);
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
      return std::make_tuple(a.low, a.high, a.face) < std::make_tuple(b.low, b.high, b.face);
    });
    double rim = 0.;
    for(std::size_t i = 0; i < sides.size(); ++i) {
      const bool is_single = (i == 0 || !is_same_edge(sides[i - 1], sides[i])) &&
                             (i + 1 == sides.size() || !is_same_edge(sides[i], sides[i + 1]));
      if(sides[i].face < begin)
        continue; // of a part, which comes before the cap at the same edge
      const bool is_at_part =
          !is_single && i > 0 && is_same_edge(sides[i - 1], sides[i]) && sides[i - 1].face < begin;
      if(is_single || is_at_part)
        rim += std::sqrt(CGAL::squared_distance(point(sides[i].from), point(sides[i].to)));
      if(is_single)
        add_fold(sides[i], change);
      else if(i > 0 && is_same_edge(sides[i - 1], sides[i]))
        add_fold(fold(normal(sides[i].face), normal(sides[i - 1].face)),
                 is_at_part ? change.fold_at_membranes : change.new_fold, change);
    }
    return rim;
  }

  void add_sides(std::size_t begin, std::size_t end, std::vector<Side>& sides) const {
    for(std::size_t i = begin; i < end; ++i)
      for(std::size_t k = 0; k < 3; ++k) {
        const Index u = patch_.faces[i][k], v = patch_.faces[i][(k + 1) % 3];
        sides.push_back({(std::min)(u, v), (std::max)(u, v), i, u, v});
      }
  }

  static bool is_same_edge(const Side& a, const Side& b) {
    return a.low == b.low && a.high == b.high;
  }

  // At a face of the mesh that stays.
  void add_fold(const Side& side, Judged_change& change) const {
    const Index h = mesh_.halfedge(side.from, side.to);
    CGAL_assertion(h != no_index);
    const Vector beyond = normal_of(mesh_, mesh_.face(mesh_.twin(h)));
    const double new_one = fold(normal(side.face), beyond),
                 old_one = fold(normal_of(mesh_, mesh_.face(h)), beyond);
    constexpr double degree = 1.; // as sharp as before, if not more than that
    double none = 0.;
    add_fold(new_one, new_one > old_one + degree ? change.new_fold : none, change);
  }

  static void add_fold(double fold, double& largest, Judged_change& change) {
    change.sharpest_angle = (std::min)(change.sharpest_angle, 180. - fold);
    largest = (std::max)(largest, fold);
  }

  Vector normal(std::size_t face) const {
    return Largest_distance::normal(triangle(patch_.faces[face]));
  }

  // In degrees.
  static double fold(const Vector& m, const Vector& n) {
    return arc_tangent(std::sqrt(CGAL::cross_product(m, n).squared_length()), m * n) * 180. /
           CGAL_PI;
  }

  const Surgery_mesh& mesh_;
  const std::vector<Index>& out_;
  const Patch& patch_;
};

Shape_judge::Shape_judge(const Surgery_mesh& mesh, bool force)
    : force_(force)
    , is_closed_(mesh.number_of_hubs() == 0) {
  Surgery_mesh::Point origin(ORIGIN);
  for(Index f = 0; f < mesh.face_bound(); ++f)
    if(mesh.is_alive(f)) {
      const Placed_triangle t = placed_triangle(mesh, f);
      if(box_.low[0] > box_.high[0])
        origin = t.points[0];
      if(!mesh.is_in_cap(f))
        box_.extend(t.box());
      volume_ += CGAL::volume(origin, t.points[0], t.points[1], t.points[2]);
    }
  for(std::size_t i = 0; i < 3; ++i)
    size_ = (std::max)(size_, box_.high[i] - box_.low[i]);
  outward_ = volume_ < 0. && is_closed_ ? -1. : 1.;
  volume_ = std::abs(volume_);
}

// How far the surface may move.
static double most_distance(const Intended_change& intended) {
  constexpr double most = 0.5;
  return intended.may_be_far ? (std::numeric_limits<double>::infinity)() : most * intended.length;
}

Judged_change Shape_judge::change(const Surgery_mesh& mesh,
                                  const std::vector<Index>& out,
                                  const Patch& patch,
                                  const Intended_change& intended) const {
  const Shape_measure measure(mesh, out, patch);
  Judged_change change;
  const double taken = outward_ * measure.volume_taken();
  (taken > 0. ? change.volume_removed : change.volume_added) = std::abs(taken);
  measure.measure_caps(change);
  const Box<3> caps = measure.box_of_caps();
  for(std::size_t i = 0; i < 3; ++i)
    change.box_growth =
        (std::max)({change.box_growth, box_.low[i] - caps.low[i], caps.high[i] - box_.high[i]});
  constexpr double tolerance = 0.02; // in lengths of the loop
  const Largest_distance::Accuracy accuracy{tolerance * intended.length, most_distance(intended)};
  if(objection(change, intended).empty())
    change.displacement = measure.displacement(accuracy);
  if(objection(change, intended).empty())
    change.burial = measure.burial(outward_, accuracy);
  return change;
}

std::string Shape_judge::objection(const Judged_change& change,
                                   const Intended_change& intended) const {
  constexpr double rounding = 1e-9, most_of_circle = 3., sharpest_fold = 120.,
                   sharpest_at_membranes = 150.;
  std::ostringstream why;
  why.precision(3);
  const auto is_little = [&](double volume) { return !is_closed_ || volume <= rounding * volume_; };
  if(force_)
    return {};
  if(change.box_growth > rounding * size_)
    why << "the bounding box would grow by " << change.box_growth;
  else if(!intended.may_remove && !is_little(change.volume_removed))
    why << "it would remove solid of volume " << change.volume_removed;
  else if(!intended.may_add && !is_little(change.volume_added))
    why << "it would add solid of volume " << change.volume_added;
  else if(change.cap_ratio > most_of_circle)
    why << "a cap would have " << change.cap_ratio
        << " times the area of a circle with the same perimeter";
  else if(change.new_fold > sharpest_fold)
    why << "new faces would be folded by " << change.new_fold << " degrees";
  else if(change.fold_at_membranes > sharpest_at_membranes)
    why << "a cap would meet the surface at an angle of " << 180. - change.fold_at_membranes
        << " degrees";
  else if(change.displacement > most_distance(intended))
    why << "a cap would be " << change.displacement << " away from the surface";
  else if(change.burial > most_distance(intended))
    why << "it would remove surface at a distance of " << change.burial << " from the caps";
  return why.str();
}

} // namespace CGAL::Handle_tunnel_loops::internal
