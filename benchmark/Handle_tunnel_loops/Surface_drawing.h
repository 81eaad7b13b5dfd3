// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_SURFACE_DRAWING_H
#define BENCHMARK_SURFACE_DRAWING_H

#include "Loop_places.h"
#include "Subjects.h"
#include "Svg.h"
#include "mean_edge_length.h"

#include <algorithm>
#include <limits>
#include <utility>

/// \file Surface_drawing.h
/// Surfaces with loops on them, in figures.

namespace corpus {

/// A surface as seen from a direction without perspective, what is near over what is far.
class Surface_drawing
{
public:
  using Vector = CGAL::Exact_predicates_inexact_constructions_kernel::Vector_3;

  /// in a square of a figure.
  Surface_drawing(svg::Figure& figure,
                  const Mesh& mesh,
                  const svg::Place& corner,
                  double side,
                  const Vector& view = Vector(0.6, -1., 0.8))
      : figure_(figure)
      , mesh_(mesh) {
    axes_[2] = unit(view);
    axes_[0] = unit(CGAL::cross_product(Vector(0., 0., 1.), axes_[2]));
    axes_[1] = CGAL::cross_product(axes_[2], axes_[0]);
    fit(corner, side);
    lift_ = 0.7 * mean_edge_length(mesh);
    for(const Mesh::Face_index f : mesh.faces())
      add(f);
  }

  void add_loop(const Closed_polyline& points, const std::string& colour, double width = 1.6) {
    loops_.push_back({points, colour, width});
  }

  /// handles orange, tunnels blue.
  void add_loops(const Pairs& pairs, double width = 1.6) {
    const std::vector<Closed_polyline> loops = sampled_loops(pairs);
    for(std::size_t i = 0; i < loops.size(); ++i)
      add_loop(loops[i], i % 2 == 0 ? svg::orange : svg::blue, width);
  }

  void add_dot(const Space_point& p, const std::string& colour) { dots_.emplace_back(p, colour); }

  void draw() {
    std::stable_sort(faces_.begin(), faces_.end(), [](const Front_face& a, const Front_face& b) {
      return a.depths[0] + a.depths[1] + a.depths[2] < b.depths[0] + b.depths[1] + b.depths[2];
    });
    for(const Front_face& face : faces_)
      figure_.area({face.corners.begin(), face.corners.end()}, face.colour);
    for(const Line& loop : loops_)
      draw_visible_parts(loop);
    for(const auto& [point, colour] : dots_)
      if(is_visible(point))
        figure_.dot(place(point), colour, 2.5);
  }

private:
  struct Front_face
  {
    std::array<svg::Place, 3> corners;
    std::array<double, 3> depths; // to the eye
    std::string colour;

    // Whether it lies before a place, and further than by a length.
    bool hides(const svg::Place& p, double depth, double length) const {
      const auto area = [](const svg::Place& a, const svg::Place& b, const svg::Place& c) {
        return (b.first - a.first) * (c.second - a.second) -
               (c.first - a.first) * (b.second - a.second);
      };
      const auto& [a, b, c] = corners;
      const double all = area(a, b, c);
      const double u = area(p, b, c) / all, v = area(a, p, c) / all, w = area(a, b, p) / all;
      return u > 0. && v > 0. && w > 0. &&
             u * depths[0] + v * depths[1] + w * depths[2] > depth + length;
    }
  };

  struct Line
  {
    Closed_polyline points;
    std::string colour;
    double width;
  };

  bool is_visible(const Space_point& p) const {
    return std::none_of(faces_.begin(), faces_.end(), [&](const Front_face& face) {
      return face.hides(place(p), along(p, 2), lift_);
    });
  }

  void draw_visible_parts(const Line& loop) {
    std::vector<svg::Place> part;
    const auto end_part = [&] {
      if(part.size() > 1)
        figure_.line(part, loop.colour, loop.width);
      part.clear();
    };
    for(std::size_t i = 0; i < loop.points.size(); ++i) {
      const Space_point &a = loop.points[i], &b = loop.points[(i + 1) % loop.points.size()];
      if(!is_visible(CGAL::midpoint(a, b))) {
        end_part();
        continue;
      }
      if(part.empty())
        part.push_back(place(a));
      part.push_back(place(b));
    }
    end_part();
  }

  static Vector unit(const Vector& v) { return v / std::sqrt(v.squared_length()); }

  double along(const Space_point& p, std::size_t axis) const {
    return (p - CGAL::ORIGIN) * axes_[axis];
  }

  void fit(const svg::Place& corner, double side) {
    std::array<double, 2> low, high;
    low.fill(std::numeric_limits<double>::max());
    high.fill(std::numeric_limits<double>::lowest());
    for(const Mesh::Vertex_index v : mesh_.vertices())
      for(const std::size_t i : {0, 1}) {
        low[i] = (std::min)(low[i], along(mesh_.point(v), i));
        high[i] = (std::max)(high[i], along(mesh_.point(v), i));
      }
    scale_ = 0.94 * side / (std::max)(high[0] - low[0], high[1] - low[1]);
    shift_ = {corner.first + side / 2. - scale_ * (low[0] + high[0]) / 2.,
              corner.second + side / 2. + scale_ * (low[1] + high[1]) / 2.};
  }

  svg::Place place(const Space_point& p) const {
    return {shift_.first + scale_ * along(p, 0), shift_.second - scale_ * along(p, 1)};
  }

  void add(Mesh::Face_index f) {
    std::vector<Space_point> corners;
    for(const Mesh::Vertex_index v : vertices_around_face(mesh_.halfedge(f), mesh_))
      corners.push_back(mesh_.point(v));
    const Vector normal = CGAL::cross_product(corners[1] - corners[0], corners[2] - corners[0]);
    if(!(normal * axes_[2] > 0.))
      return; // turned away
    const double light = unit(normal) * unit(axes_[2] + 0.5 * axes_[1] - 0.4 * axes_[0]);
    Front_face face;
    for(std::size_t i = 0; i < 3; ++i) {
      face.corners[i] = place(corners[i]);
      face.depths[i] = along(corners[i], 2);
    }
    face.colour = shade(light);
    faces_.push_back(face);
  }

  // One digit of each colour is enough.
  static std::string shade(double light) {
    const int level = std::clamp(int(std::lround(9. + 6. * light)), 8, 15);
    char text[8];
    std::snprintf(text, sizeof(text), "#%x%x%x", unsigned(level) - 1, unsigned(level) - 1,
                  unsigned(level));
    return text;
  }

  svg::Figure& figure_;
  const Mesh& mesh_;
  std::array<Vector, 3> axes_; // to the right, upwards, to the eye
  double scale_ = 1., lift_ = 0.;
  svg::Place shift_;
  std::vector<Front_face> faces_;
  std::vector<Line> loops_;
  std::vector<std::pair<Space_point, std::string>> dots_;
};

} // namespace corpus

#endif // BENCHMARK_SURFACE_DRAWING_H
