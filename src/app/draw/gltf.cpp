// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/gltf.h"

#include "failure.h"
#include "write/Gltf_document.h"
#include "write/files.h"

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace htloops {
namespace {

constexpr std::uint32_t sides = 8;

Vector sum(const Vector& a, double factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

// Across a direction.
Vector across(const Vector& direction, const Vector& wanted) {
  const Vector aside = unit(sum(wanted, -dot(wanted, direction), direction));
  if(dot(aside, aside) > 0.5)
    return aside;
  const Vector least = std::abs(direction[0]) < 0.6 ? Vector{1., 0., 0.} : Vector{0., 1., 0.};
  return unit(sum(least, -dot(least, direction), direction));
}

class Tube
{
public:
  Tube(const std::vector<Vector>& line, bool is_closed, const std::vector<double>& radii)
      : is_closed_(is_closed) {
    for(std::size_t i = 0; i < line.size(); ++i)
      if(line_.empty() || line[i] != line_.back()) {
        line_.push_back(line[i]);
        radii_.push_back(radii[i]);
      }
    while(is_closed && line_.size() > 1 && line_.front() == line_.back())
      line_.pop_back();
  }

  Smooth_surface build() {
    if(line_.size() < 2)
      return {};
    Vector aside = across(direction(0), {0., 0., 1.});
    const Vector first = aside;
    for(std::size_t i = 0; i < line_.size(); ++i)
      add_ring(i, aside = across(direction(i), aside));
    for(std::size_t i = 0; i + 1 < line_.size(); ++i)
      join(i, i + 1, 0);
    if(is_closed_)
      join(line_.size() - 1, 0, turn(across(direction(0), aside), first));
    return std::move(tube_);
  }

private:
  // Of the line at a point, in the middle between what comes before and after.
  Vector direction(std::size_t i) const {
    const std::size_t n = line_.size();
    const std::size_t before = i > 0 ? i - 1 : is_closed_ ? n - 1 : 0;
    const std::size_t after = i + 1 < n ? i + 1 : is_closed_ ? 0 : i;
    const Vector to = unit(sum(line_[i], -1., line_[before]));
    const Vector from = unit(sum(line_[after], -1., line_[i]));
    const Vector both = unit(sum(to, 1., from));
    return dot(both, both) > 0.5 ? both : to;
  }

  void add_ring(std::size_t i, const Vector& aside) {
    const Vector other = cross(direction(i), aside);
    for(std::uint32_t k = 0; k < sides; ++k) {
      const double angle = 2. * pi * k / sides;
      const Vector normal =
          sum(sum({}, internal::cosine(angle), aside), internal::sine(angle), other);
      tube_.normals.push_back(normal);
      tube_.points.push_back(sum(line_[i], radii_[i], normal));
    }
  }

  // By how many sides the last ring is turned against the first one.
  std::uint32_t turn(const Vector& last, const Vector& first) const {
    const double angle =
        internal::arc_tangent(dot(cross(direction(0), first), last), dot(first, last));
    return static_cast<std::uint32_t>(std::lround(angle / (2. * pi) * sides) + sides) % sides;
  }

  void join(std::size_t from, std::size_t to, std::uint32_t shift) {
    const auto corner = [](std::size_t ring, std::uint32_t k) {
      return static_cast<std::uint32_t>(ring * sides + k % sides);
    };
    for(std::uint32_t k = 0; k < sides; ++k) {
      const std::uint32_t a = corner(from, k), b = corner(from, k + 1);
      const std::uint32_t c = corner(to, k + shift), d = corner(to, k + 1 + shift);
      tube_.triangles.push_back({a, b, c});
      tube_.triangles.push_back({b, d, c});
    }
  }

  std::vector<Vector> line_;
  std::vector<double> radii_;
  const bool is_closed_;
  Smooth_surface tube_;
};

// The sums of the normals of the faces around each point.
std::vector<Vector> normals_of(const Drawn_surface& surface, double diagonal) {
  std::vector<Vector> normals(surface.points.size());
  for(const auto& [a, b, c] : surface.triangles) {
    Vector u, v;
    for(int i = 0; i < 3; ++i) {
      u[i] = (surface.points[b][i] - surface.points[a][i]) / diagonal;
      v[i] = (surface.points[c][i] - surface.points[a][i]) / diagonal;
    }
    for(const std::uint32_t corner : {a, b, c})
      normals[corner] = sum(normals[corner], 1., cross(u, v));
  }
  for(Vector& n : normals)
    if((n = unit(n)) == Vector{})
      n = {0., 0., 1.};
  return normals;
}

// Surfaces around the middle of a box.
class Gltf
{
public:
  explicit Gltf(const CGAL::Bbox_3& box)
      : middle_(coordinates(middle_of(box))) {}

  // What is of one colour is of one kind.
  void add(const std::string& name,
           const std::string& kind,
           const Smooth_surface& surface,
           const Colour& colour,
           double opacity = 1.) {
    if(surface.triangles.empty())
      return;
    std::vector<Vector> points;
    for(const Vector& p : surface.points)
      points.push_back(sum(p, -1., middle_));
    document_.add_node(name, points, surface.normals, surface.triangles,
                       {{"material", material(kind, colour, opacity)}});
  }

  std::string file() { return document_.file({{"name", "all"}, {"translation", middle_}}); }

private:
  // One for each colour; glTF wants the amount of light.
  std::size_t material(const std::string& kind, const Colour& colour, double opacity) {
    const auto [position, is_new] = materials_.try_emplace(colour, materials_.size());
    if(is_new) {
      Json light = Json::array();
      for(const unsigned char part : colour)
        light.push_back(part == 0 ? 0. : internal::power(part / 255., 2.2));
      light.push_back(opacity);
      document_.add_material(
          {{"name", kind},
           {"pbrMetallicRoughness",
            {{"baseColorFactor", light}, {"metallicFactor", 0.}, {"roughnessFactor", 0.7}}},
           {"alphaMode", opacity < 1. ? "BLEND" : "OPAQUE"},
           {"doubleSided", true}});
    }
    return position->second;
  }

  Vector middle_;
  Gltf_document document_;
  std::map<Colour, std::size_t> materials_;
};

// The triangles of one colour, with all points.
Smooth_surface
in_colour(const Drawn_surface& surface, const std::vector<Vector>& normals, const Colour& colour) {
  Smooth_surface part;
  std::map<std::uint32_t, std::uint32_t> numbers;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if(surface.colours[t] != colour)
      continue;
    part.triangles.emplace_back();
    for(int i = 0; i < 3; ++i) {
      const std::uint32_t v = surface.triangles[t][i];
      const auto [position, is_new] =
          numbers.try_emplace(v, static_cast<std::uint32_t>(part.points.size()));
      if(is_new) {
        part.points.push_back(surface.points[v]);
        part.normals.push_back(normals[v]);
      }
      part.triangles.back()[i] = position->second;
    }
  }
  return part;
}

void add_surface(Gltf& gltf, const Drawn_surface& surface, double diagonal) {
  constexpr Colour plain = {204, 212, 222};
  const std::vector<Vector> normals = normals_of(surface, diagonal);
  if(surface.colours.empty()) {
    gltf.add("surface", "surface", {surface.points, normals, surface.triangles}, plain,
             surface.opacity);
    return;
  }
  std::vector<Colour> colours = surface.colours;
  std::sort(colours.begin(), colours.end());
  colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
  for(std::size_t i = 0; i < colours.size(); ++i)
    gltf.add("part " + std::to_string(i), "part " + std::to_string(i),
             in_colour(surface, normals, colours[i]), colours[i], surface.opacity);
}

} // namespace

Smooth_surface
tube_around(const std::vector<Vector>& line, bool is_closed, const std::vector<double>& radii) {
  return Tube(line, is_closed, radii).build();
}

Smooth_surface tube_around(const std::vector<Vector>& line, bool is_closed, double radius) {
  return tube_around(line, is_closed, std::vector<double>(line.size(), radius));
}

// A tube along the upright axis, with the poles as its first and last rings.
Smooth_surface ball_around(const Vector& middle, double radius) {
  constexpr int rings = 7;
  std::vector<Vector> line;
  std::vector<double> radii;
  for(int i = 0; i < rings; ++i) {
    const double angle = pi * i / (rings - 1);
    line.push_back(sum(middle, -radius * internal::cosine(angle), {0., 0., 1.}));
    radii.push_back(radius * internal::sine(angle));
  }
  Smooth_surface ball = tube_around(line, false, radii);
  for(std::size_t i = 0; i < ball.points.size(); ++i)
    ball.normals[i] = unit(sum(ball.points[i], -1., middle));
  return ball;
}

namespace {

// As thick as it says, else as lines are.
Smooth_surface model_of(const Exported_line& line, double radius) {
  const std::vector<Vector> points = coordinates(line.points);
  std::vector<double> radii = line.radii;
  if(radii.empty())
    radii.assign(points.size(), line.width * radius);
  return points.size() == 1 ? ball_around(points[0], radii[0])
                            : tube_around(points, line.is_closed, radii);
}

} // namespace

void export_gltf(const std::string& file,
                 const Drawn_surface& surface,
                 const Exported_lines& lines) {
  const CGAL::Bbox_3 box = box_of(surface.points);
  const double diagonal = diagonal_of(box);
  constexpr double least = 1e-25, most = 1e25;
  if(!surface.points.empty() && !(diagonal > least && diagonal < most))
    throw wrong_usage("--gltf " + file + ": the surface is too " +
                      (diagonal <= least ? "small" : "large") +
                      " for glTF, which has single precision");
  Gltf gltf(box);
  add_surface(gltf, surface, diagonal);
  constexpr double relative_radius = 0.003;
  for(const Exported_line& line : lines.lines)
    gltf.add(line.kind + " " + std::to_string(line.index), line.kind,
             model_of(line, relative_radius * diagonal), line.colour);
  write_text(file, gltf.file());
}

} // namespace htloops
