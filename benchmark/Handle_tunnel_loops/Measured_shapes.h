// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_MEASURED_SHAPES_H
#define BENCHMARK_MEASURED_SHAPES_H

#include "generators/Shape.h"
#include "generators/generators.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

/// \file Measured_shapes.h
/// Shapes of which the measures are known.

namespace measured_shapes {

namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Soup;

/// What is known of a shape, and its meshes, the finer the larger the density.
struct Measured_shape
{
  const char* name;
  std::vector<double> thickness, clear_width; ///< in falling order
  std::function<Soup(double density)> mesh;
};

/// A place of a profile: how far from the axis, and how high.
using Profile = std::vector<std::array<double, 2>>;

/// what a closed profile, counted clockwise with the axis on the left, sweeps around the axis.
inline Soup revolved(const Profile& profile, std::size_t around) {
  Soup soup;
  const std::size_t n = profile.size();
  const auto vertex = [&](std::size_t i, std::size_t k) {
    return std::uint32_t(i % around * n + k % n);
  };
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t k = 0; k < n; ++k) {
      const double angle = 2. * CGAL_PI * double(i) / double(around);
      soup.points.push_back(
          {profile[k][0] * std::cos(angle), profile[k][0] * std::sin(angle), profile[k][1]});
      soup.triangles.push_back({vertex(i, k), vertex(i, k + 1), vertex(i + 1, k + 1)});
      soup.triangles.push_back({vertex(i, k), vertex(i + 1, k + 1), vertex(i + 1, k)});
    }
  return soup;
}

/// with about so many places on it for each unit of length.
inline Profile divided(const Profile& corners, double per_unit) {
  Profile profile;
  for(std::size_t k = 0; k < corners.size(); ++k) {
    const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
    const double parts = std::ceil(std::hypot(b[0] - a[0], b[1] - a[1]) * per_unit);
    for(double i = 0.; i < parts; ++i)
      profile.push_back({a[0] + i / parts * (b[0] - a[0]), a[1] + i / parts * (b[1] - a[1])});
  }
  return profile;
}

inline std::vector<double> falling(std::vector<double> values) {
  std::sort(values.begin(), values.end(), std::greater<double>());
  return values;
}

/// A round bore through a plate.
struct Round_bore
{
  double x, y, radius;
};

/// The thicknesses of a plate from the origin to (x, y, height) with upright bores: walls between
/// bores, and between bores and the outside, that are less than a ball wide bar its way. Bores that
/// are tied together by barred walls are gone around as one, or not at all if they are tied to the
/// outside. So a handle is lost with each wall of the shortest tree of walls.
inline std::vector<double>
plate_thicknesses(double x, double y, double height, const std::vector<Round_bore>& bores) {
  std::vector<double> wall, thicknesses; // from each bore to the tree that grows from the outside
  for(const Round_bore& b : bores)
    wall.push_back((std::min)({b.x, b.y, x - b.x, y - b.y}) - b.radius);
  for(std::size_t n = 0; n < bores.size(); ++n) {
    const auto next = std::size_t(std::min_element(wall.begin(), wall.end()) - wall.begin());
    thicknesses.push_back((std::min)(wall[next], height));
    wall[next] = std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < bores.size(); ++i)
      if(std::isfinite(wall[i]))
        wall[i] =
            (std::min)(wall[i], std::hypot(bores[i].x - bores[next].x, bores[i].y - bores[next].y) -
                                    bores[i].radius - bores[next].radius);
  }
  return falling(thicknesses);
}

/// of a plate with its bores. Faces are as many as the smallest bore needs.
inline Measured_shape
plate(const char* name, double x, double y, double height, const std::vector<Round_bore>& bores) {
  std::string text = "block 0 0 0 " + std::to_string(x) + " " + std::to_string(y) + " " +
                     std::to_string(height) + " 0\n";
  Measured_shape shape{name, plate_thicknesses(x, y, height, bores), {}, {}};
  double least = std::numeric_limits<double>::infinity();
  for(const Round_bore& b : bores) {
    const std::string place = std::to_string(b.x) + " " + std::to_string(b.y) + " ";
    text += "cut cylinder " + place + "-1 " + place + std::to_string(height + 1.) + " " +
            std::to_string(b.radius) + "\n";
    shape.clear_width.push_back(2. * b.radius); // and back around the rim, where there is room
    least = (std::min)(least, b.radius);
  }
  shape.clear_width = falling(shape.clear_width);
  const double faces = 2. * (x * y + x * height + y * height) / (least * least) * 220.;
  shape.mesh = [text, faces](double density) {
    generators::Request request;
    request.faces = std::size_t(faces * density);
    return mesh_of_shape(generators::Shape(text), request, "shape");
  };
  return shape;
}

inline std::function<Soup(double)> described(const std::string& text, double faces) {
  return [=](double density) {
    generators::Request request;
    request.faces = std::size_t(faces * density);
    return mesh_of_shape(generators::Shape(text), request, "shape");
  };
}

/// all of them. The surfaces of solids that are swept or described are faceted, by chords that are
/// within 0.3% of the smallest measure.
inline std::vector<Measured_shape> all() {
  std::vector<Measured_shape> shapes;
  // A circle of radius 0.4, whose centre goes along one of radius 1.
  shapes.push_back({"torus", {0.8}, {1.2}, [](double density) {
                      const auto n = std::size_t(60. * std::sqrt(density));
                      Profile circle;
                      for(std::size_t k = 0; k < n; ++k) {
                        const double angle = -2. * CGAL_PI * double(k) / double(n);
                        circle.push_back({1. + 0.4 * std::cos(angle), 0.4 * std::sin(angle)});
                      }
                      return revolved(circle, 2 * n);
                    }});
  // Six flat sides around a hole with six flat sides: distances between those are smaller than
  // distances between edges, by the cosine of 30 degrees.
  shapes.push_back({"nut", {0.5 * std::sqrt(0.75)}, {1. * std::sqrt(0.75)}, [](double density) {
                      const Profile corners = {{0.5, 0.}, {0.5, 1.}, {1., 1.}, {1., 0.}};
                      return revolved(divided(corners, density - 0.5), 6);
                    }});
  // The channel is 0.4 + z^2 / 2 wide. In the middle a ball fits between it and the outside, at a
  // radius of 1.2: the parabola is less curved than the ball.
  shapes.push_back({"hourglass", {0.8}, {0.8}, [](double density) {
                      const auto n = std::size_t(40. * std::sqrt(density));
                      Profile corners;
                      for(std::size_t k = 0; k <= n; ++k) {
                        const double z = 1.6 * double(k) / double(n) - 0.8;
                        corners.push_back({0.4 + z * z / 2., z});
                      }
                      corners.push_back({1.2, 0.8});
                      corners.push_back({1.2, -0.8});
                      return revolved(divided(corners, 0.6 * double(n)), 2 * n);
                    }});
  shapes.push_back(plate("bore near a side", 4., 3., 1., {{1.2, 1.5, 0.5}}));
  shapes.push_back(
      plate("three bores", 6., 3., 0.8, {{1.2, 1.5, 0.5}, {3., 1.4, 0.7}, {4.9, 1.6, 0.4}}));
  shapes.push_back(plate("thin plate", 5., 5., 0.5,
                         {{1.3, 1.3, 0.5}, {3.7, 1.3, 0.5}, {1.3, 3.7, 0.6}, {3.5, 3.5, 0.8}}));
  // Wide enough for a ball as large as the plate is high; the narrow part of the hole counts.
  shapes.push_back({"screw hole",
                    {1.},
                    {0.6},
                    described("genus 1\nblock -2 -2 0 2 2 1 0\n"
                              "cut cylinder 0 0 -1 0 0 2 0.3\n"
                              "cut cylinder 0 0 0.6 0 0 2 0.6\n",
                              110000.)});
  // Each ring, of radius 1, spans a disc through which others pass, 0.6 from the ring. At the ends
  // it is one, and a place between it and the farthest part of the ring has 0.7 to both. In the
  // middle there are two, 0.8 apart, and a place beside both, 0.42 from the middle, has 0.58 to
  // them and the ring. Less the radius of the tubes. Who goes around a ring goes through its disc.
  shapes.push_back({"chain",
                    {0.4, 0.4, 0.4},
                    {1., 1., 0.76},
                    described("genus 3\nring 0 0 0 0 0 1 1 0.2\nring 1.4 0 0 0 1 0 1 0.2\n"
                              "ring 2.8 0 0 0 0 1 1 0.2\n",
                              100000.)});
  // The wall, the long way and the short way around it; the hole and the hollow.
  shapes.push_back(
      {"hollow ring",
       {0.2, 0.2},
       {1.4, 0.6},
       described("genus 2\nring 0 0 0 0 0 1 1.2 0.5\ncut ring 0 0 0 0 0 1 1.2 0.3\n", 120000.)});
  // A shell with three holes: there is a way through each, and the widest is needed to come back
  // from the others. Between the holes there is more room than in the wall.
  shapes.push_back({"pot",
                    {0.2, 0.2},
                    {0.8, 0.6},
                    described("genus 2\nball 0 0 0 1.2\ncut ball 0 0 0 1\n"
                              "cut cylinder 0 0 0 2 0 0 0.5\ncut cylinder 0 0 0 0 2 0 0.4\n"
                              "cut cylinder 0 0 0 0 0 2 0.3\n",
                              150000.)});
  // The axis of the torus that the knot is on is 1.2 from it, and links it twice; between two of
  // its strands there is less room.
  shapes.push_back({"knot", {0.6}, {1.8}, described("genus 1\nknot 2 3 2 0.8 0.3\n", 90000.)});
  // Six windows: through each a ball comes in, through the widest it goes out. Those of 2 by 3 and
  // of 2 by 4 are as wide as 2 allows, those of 3 by 4 as 3 does; less the bars.
  shapes.push_back({"frame",
                    {0.6, 0.6, 0.6, 0.6, 0.6},
                    {2.4, 1.4, 1.4, 1.4, 1.4},
                    described("genus 5\n"
                              "times 2 by 0 3 0 times 2 by 0 0 4 rod 0 0 0 2 0 0 0.3\n"
                              "times 2 by 2 0 0 times 2 by 0 0 4 rod 0 0 0 0 3 0 0.3\n"
                              "times 2 by 2 0 0 times 2 by 0 3 0 rod 0 0 0 0 0 4 0.3\n",
                              100000.)});
  return shapes;
}

} // namespace measured_shapes

#endif // BENCHMARK_MEASURED_SHAPES_H
