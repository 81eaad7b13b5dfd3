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
#include "write/documents.h"
#include "write/files.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
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

// Points that follow each other at the same place are one.
std::vector<Vector> without_repetitions(const std::vector<Vector>& line, bool is_closed) {
  std::vector<Vector> points = line;
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while(is_closed && points.size() > 1 && points.front() == points.back())
    points.pop_back();
  return points;
}

class Tube
{
public:
  Tube(const std::vector<Vector>& line, bool is_closed, double radius)
      : line_(without_repetitions(line, is_closed))
      , is_closed_(is_closed)
      , radius_(radius) {}

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
      const Vector normal = sum(sum({}, std::cos(angle), aside), std::sin(angle), other);
      tube_.normals.push_back(normal);
      tube_.points.push_back(sum(line_[i], radius_, normal));
    }
  }

  // By how many sides the last ring is turned against the first one.
  std::uint32_t turn(const Vector& last, const Vector& first) const {
    const double angle = std::atan2(dot(cross(direction(0), first), last), dot(first, last));
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

  const std::vector<Vector> line_;
  const bool is_closed_;
  const double radius_;
  Smooth_surface tube_;
};

using Colour = std::array<unsigned char, 3>;

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

// A document of glTF and its buffer.
class Gltf
{
public:
  explicit Gltf(const Bounds& bounds) {
    for(int i = 0; i < 3; ++i)
      middle_[i] = bounds.low[i] / 2. + bounds.high[i] / 2.;
  }

  // What is of one colour is of one kind.
  void add(const std::string& name,
           const std::string& kind,
           const Smooth_surface& surface,
           const Colour& colour) {
    if(surface.triangles.empty())
      return;
    Bounds bounds;
    for(const Vector& p : surface.points)
      bounds.add(relative(p));
    const Json attributes = {
        {"POSITION", accessor_of_points(surface.points, bounds)},
        {"NORMAL", accessor_of(surface.normals.size(), "VEC3", single, array_buffer,
                               [&] { append_numbers(surface.normals); })}};
    const Json primitive = {
        {"attributes", attributes},
        {"indices", accessor_of(3 * surface.triangles.size(), "SCALAR", unsigned_number,
                                element_array_buffer, [&] { append(surface.triangles); })},
        {"material", material(kind, colour)}};
    json_["meshes"].push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}});
  }

  // The file: a header, and two chunks of whole words.
  std::string file() {
    Json children = Json::array();
    for(std::size_t i = 0; i < json_["nodes"].size(); ++i)
      children.push_back(i);
    json_["nodes"].push_back({{"name", "all"}, {"translation", middle_}, {"children", children}});
    json_["scenes"] = Json::array({{{"nodes", Json::array({children.size()})}}});
    json_["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
    std::string text = text_of(json_);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string result = "glTF";
    append_word(result, 2);
    append_word(result, static_cast<std::uint32_t>(28 + text.size() + buffer_.size()));
    append_chunk(result, "JSON", text);
    append_chunk(result, std::string("BIN\0", 4), buffer_);
    return result;
  }

private:
  static constexpr int single = 5126, unsigned_number = 5125; // types of numbers
  static constexpr int array_buffer = 34962, element_array_buffer = 34963;

  Vector relative(const Vector& p) const {
    return {p[0] - middle_[0], p[1] - middle_[1], p[2] - middle_[2]};
  }

  static void append_word(std::string& bytes, std::uint32_t word) {
    for(int shift = 0; shift < 32; shift += 8)
      bytes += static_cast<char>(word >> shift & 255u);
  }

  static void
  append_chunk(std::string& bytes, const std::string& kind, const std::string& content) {
    append_word(bytes, static_cast<std::uint32_t>(content.size()));
    bytes += kind + content;
  }

  void append_number(double value) {
    const auto number = static_cast<float>(value);
    std::uint32_t word;
    std::memcpy(&word, &number, sizeof word);
    append_word(buffer_, word);
  }

  void append_numbers(const std::vector<Vector>& vectors) {
    for(const Vector& v : vectors)
      for(const double x : v)
        append_number(x);
  }

  void append(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    for(const auto& triangle : triangles)
      for(const std::uint32_t corner : triangle)
        append_word(buffer_, corner);
  }

  template <typename Append>
  std::size_t
  accessor_of(std::size_t count, const char* type, int component, int target, Append append) {
    const std::size_t begin = buffer_.size();
    append();
    json_["bufferViews"].push_back({{"buffer", 0},
                                    {"byteOffset", begin},
                                    {"byteLength", buffer_.size() - begin},
                                    {"target", target}});
    json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                  {"componentType", component},
                                  {"count", count},
                                  {"type", type}});
    return json_["accessors"].size() - 1;
  }

  std::size_t accessor_of_points(const std::vector<Vector>& points, const Bounds& bounds) {
    const std::size_t accessor = accessor_of(points.size(), "VEC3", single, array_buffer, [&] {
      for(const Vector& p : points)
        for(const double x : relative(p))
          append_number(x);
    });
    // As they are after rounding.
    const auto rounded = [](const Vector& v) {
      return Json{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    };
    json_["accessors"][accessor]["min"] = rounded(bounds.low);
    json_["accessors"][accessor]["max"] = rounded(bounds.high);
    return accessor;
  }

  // One for each colour; glTF wants the amount of light.
  std::size_t material(const std::string& kind, const Colour& colour) {
    const auto [position, is_new] = materials_.try_emplace(colour, materials_.size());
    if(is_new) {
      Json light = Json::array();
      for(const unsigned char part : colour)
        light.push_back(std::pow(part / 255., 2.2));
      light.push_back(1.);
      json_["materials"].push_back(
          {{"name", kind},
           {"pbrMetallicRoughness",
            {{"baseColorFactor", light}, {"metallicFactor", 0.}, {"roughnessFactor", 0.7}}},
           {"doubleSided", true}});
    }
    return position->second;
  }

  Vector middle_;
  Json json_ = {{"asset", {{"version", "2.0"}, {"generator", "htloops"}}},
                {"scene", 0},
                {"scenes", Json::array()},
                {"nodes", Json::array()},
                {"meshes", Json::array()},
                {"materials", Json::array()},
                {"accessors", Json::array()},
                {"bufferViews", Json::array()},
                {"buffers", Json::array()}};
  std::string buffer_;
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
    gltf.add("surface", "surface", {surface.points, normals, surface.triangles}, plain);
    return;
  }
  std::vector<Colour> colours = surface.colours;
  std::sort(colours.begin(), colours.end());
  colours.erase(std::unique(colours.begin(), colours.end()), colours.end());
  for(std::size_t i = 0; i < colours.size(); ++i)
    gltf.add("part " + std::to_string(i), "part " + std::to_string(i),
             in_colour(surface, normals, colours[i]), colours[i]);
}

} // namespace

Smooth_surface tube_around(const std::vector<Vector>& line, bool is_closed, double radius) {
  return Tube(line, is_closed, radius).build();
}

void export_gltf(const std::string& file,
                 const Drawn_surface& surface,
                 const Exported_lines& lines) {
  Bounds bounds;
  for(const Vector& p : surface.points)
    bounds.add(p);
  const double diagonal = std::hypot(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1],
                                     bounds.high[2] - bounds.low[2]);
  constexpr double least = 1e-25, most = 1e25;
  if(!surface.points.empty() && !(diagonal > least && diagonal < most))
    throw Failure(Exit_code::WRONG_USAGE,
                  "--gltf " + file +
                      ": the numbers of glTF are of single precision, in which the " +
                      "surface is too " + (diagonal > least ? "large" : "small"));
  Gltf gltf(bounds);
  add_surface(gltf, surface, diagonal);
  constexpr double relative_radius = 0.003;
  for(const Exported_line& line : lines.lines)
    gltf.add(line.kind + " " + std::to_string(line.index), line.kind,
             tube_around(coordinates(line.points), line.is_closed, relative_radius * diagonal),
             line.colour);
  write_text(file, gltf.file());
}

} // namespace htloops
