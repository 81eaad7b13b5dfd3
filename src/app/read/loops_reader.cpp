// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/loops_reader.h"

#include "failure.h"
#include "read/json_node.h"
#include "words.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace htloops {
namespace {

const char known_format[] = "htloops/1";

Loop_record read_loop(const Json_node& node) {
  Loop_record loop;
  loop.length = node.member("length").number();
  const Json_node locations = node.member("locations"), points = node.member("points");
  loop.locations.reserve(locations.size());
  locations.for_each("position", [&](const Json_node& node_of_location) {
    const auto [source, target, ratio] = node_of_location.location();
    loop.locations.push_back({source, target, ratio});
  });
  loop.points.reserve(points.size());
  points.for_each("position",
                  [&](const Json_node& point) { loop.points.push_back(point.point()); });
  return loop;
}

// Files of before there were two kinds do not say.
Basis_kind basis_kind(const Json_node& document) {
  if(!document.has("basis"))
    return Basis_kind::PURE;
  const Json_node basis = document.member("basis");
  for(const Basis_kind kind : {Basis_kind::PURE, Basis_kind::SHORTEST})
    if(basis.is(name_of(kind)))
      return kind;
  basis.fail("is neither pure nor shortest");
}

Loops_record read_document(const Json_node& document) {
  document.require_format(known_format, "'htloops loops MESH -o FILE.json' writes loops");
  Loops_record record;
  const Json_node mesh = document.member("mesh");
  record.number_of_vertices = mesh.member("vertices").count();
  record.number_of_faces = mesh.member("faces").count();
  record.basis_kind = basis_kind(document);
  const Json_node pairs = document.member("pairs");
  record.pairs.reserve(pairs.size());
  pairs.for_each("pair", [&](const Json_node& pair) {
    record.pairs.push_back({read_loop(pair.member("handle")), read_loop(pair.member("tunnel"))});
  });
  record.has_boundaries = document.has("boundaries");
  if(record.has_boundaries)
    document.member("boundaries").for_each("boundary", [&](const Json_node& curve) {
      record.boundaries.push_back({read_loop(curve), std::nullopt});
      if(curve.has("waist"))
        record.boundaries.back().waist = read_loop(curve.member("waist"));
    });
  if(document.has("throats"))
    document.member("throats").for_each(
        "throat", [&](const Json_node& throat) { record.throats.push_back(read_loop(throat)); });
  return record;
}

// Far above rounding, far below what a drawing shows.
constexpr double relative_tolerance = 1e-9;

// As a multiple of it: what a format of single precision does not do.
constexpr double far_beyond_rounding = 1e5;

class Binder
{
public:
  Binder(const Loops_record& record, const Mesh& mesh)
      : record_(record)
      , mesh_(mesh) {}

  Bound_loops bind() {
    result_.basis_kind = record_.basis_kind;
    result_.has_boundaries = record_.has_boundaries;
    if(is_same_mesh()) {
      measure_mesh();
      bind_all();
      say_once_if_mesh_has_moved();
    }
    result_.are_placed = problems_[MISPLACED].empty();
    for(const std::vector<std::string>& problems : problems_)
      result_.problems.insert(result_.problems.end(), problems.begin(), problems.end());
    return std::move(result_);
  }

private:
  // The worst first.
  enum Severity { MISPLACED, WRONG_POINT, WRONG_LENGTH };

  void bind_all() {
    for(std::size_t i = 0; i < record_.pairs.size(); ++i) {
      const auto bind_one_of_pair = [&](Loop_type type) {
        place_ = "pair " + std::to_string(i) + ", " + name_of(type);
        return bind_loop(record_.pairs[i].loop(type), type, i);
      };
      Loop handle = bind_one_of_pair(Loop_type::HANDLE);
      Loop tunnel = bind_one_of_pair(Loop_type::TUNNEL);
      result_.pairs.emplace_back(std::move(handle), std::move(tunnel));
    }
    for(std::size_t i = 0; i < record_.boundaries.size(); ++i) {
      const Boundary_record& boundary = record_.boundaries[i];
      place_ = "boundary " + std::to_string(i);
      result_.curves.push_back(bind_loop(boundary.curve, Loop_type::BOUNDARY, i));
      place_ += ", waist";
      if(boundary.waist)
        result_.waists.push_back(bind_loop(*boundary.waist, Loop_type::BOUNDARY, i));
    }
    for(std::size_t i = 0; i < record_.throats.size(); ++i) {
      place_ = "throat " + std::to_string(i);
      result_.throats.push_back(bind_loop(record_.throats[i], Loop_type::HANDLE, i));
    }
  }

  // Then most points are far from their places, and lengths may be wrong, too.
  void say_once_if_mesh_has_moved() {
    if(2 * number_of_far_points_ <= number_of_points_)
      return;
    problems_[WRONG_POINT].clear();
    problems_[WRONG_LENGTH].clear();
    add_problem(MISPLACED,
                "the points of the loops do not lie on this mesh: was it scaled or moved?");
  }

  void add_problem(Severity severity, const std::string& problem) {
    problems_[severity].push_back(problem);
  }

  bool is_same_mesh() {
    const std::size_t vertices = mesh_.number_of_vertices(), faces = mesh_.number_of_faces();
    if(record_.number_of_vertices == vertices && record_.number_of_faces == faces)
      return true;
    add_problem(MISPLACED, mesh_difference({record_.number_of_vertices, record_.number_of_faces},
                                           {vertices, faces}));
    return false;
  }

  void measure_mesh() {
    double largest = 0.;
    for(const Point& p : mesh_.points())
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    // Of the smallest numbers, each product and each sum loses as much as they are.
    tolerance_ = relative_tolerance * largest + 8. * std::numeric_limits<double>::denorm_min();
  }

  // Its points are those of the file where these are right: what is fitted to them may depend on
  // the last digit.
  Loop bind_loop(const Loop_record& record, Loop_type type, std::size_t number) {
    if(record.locations.empty())
      add_problem(MISPLACED, place_ + ": it has no locations");
    if(record.locations.size() != record.points.size())
      add_problem(WRONG_POINT, place_ + ": " + std::to_string(record.locations.size()) +
                                   " locations, but " + std::to_string(record.points.size()) +
                                   " points");
    std::vector<Loop::Step> steps;
    std::vector<Point> points;
    for(std::size_t i = 0; i < record.locations.size(); ++i) {
      position_ = i;
      const Location_record& location = record.locations[i];
      const Mesh::Halfedge_index halfedge = bind_location(location);
      if(halfedge == Mesh::Halfedge_index())
        continue;
      steps.push_back({halfedge, location.ratio});
      points.push_back(point_at(steps.back()));
      if(i < record.points.size())
        check_point(points.back(), record.points[i]);
    }
    const double length = checked_length(record, points);
    return Loop(std::move(steps), std::move(points), length, type, number);
  }

  void add_problem_here(const std::string& problem, Severity severity = MISPLACED) {
    add_problem(severity, place_ + ", position " + std::to_string(position_) + ": " + problem);
  }

  // the null halfedge if there is no such place.
  Mesh::Halfedge_index bind_location(const Location_record& location) {
    bool is_sound = true;
    for(const long long vertex : {location.source, location.target})
      if(vertex < 0 || vertex >= static_cast<long long>(mesh_.number_of_vertices())) {
        add_problem_here("vertex " + std::to_string(vertex) + " does not exist: the mesh has " +
                         std::to_string(mesh_.number_of_vertices()) + " vertices");
        is_sound = false;
      }
    if(!(location.ratio >= 0. && location.ratio <= 1.)) {
      add_problem_here("the ratio " + in_words(location.ratio) + " is not between 0 and 1");
      is_sound = false;
    }
    if(!is_sound)
      return Mesh::Halfedge_index();
    const Mesh::Halfedge_index halfedge =
        mesh_.halfedge(Mesh::Vertex_index(static_cast<std::uint32_t>(location.source)),
                       Mesh::Vertex_index(static_cast<std::uint32_t>(location.target)));
    if(halfedge == Mesh::Halfedge_index())
      add_problem_here("no edge joins vertices " + std::to_string(location.source) + " and " +
                       std::to_string(location.target));
    return halfedge;
  }

  Point point_at(const Loop::Step& step) const {
    const Point& p = mesh_.point(mesh_.source(step.halfedge));
    const Point& q = mesh_.point(mesh_.target(step.halfedge));
    // Not p + t * (q - p): the difference may overflow where neither point does.
    const double s = 1. - step.ratio, t = step.ratio;
    return Point(s * p.x() + t * q.x(), s * p.y() + t * q.y(), s * p.z() + t * q.z());
  }

  void check_point(Point& expected, const std::array<double, 3>& found) {
    double distance = 0.;
    for(int i = 0; i < 3; ++i) // NaN stays
      if(const double d = std::abs(expected[i] - found[i]); !(d <= distance))
        distance = d;
    ++number_of_points_;
    number_of_far_points_ += distance <= far_beyond_rounding * tolerance_ ? 0 : 1;
    if(distance <= tolerance_)
      expected = Point(found[0], found[1], found[2]);
    else
      add_problem_here("the point does not match the location", WRONG_POINT);
  }

  // That of the file, unless it is wrong.
  double checked_length(const Loop_record& record, const std::vector<Point>& points) {
    double length = 0.;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      const Point& q = points[i + 1 == points.size() ? 0 : i + 1];
      length += length_of_vector(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
    }
    if(points.size() != record.locations.size() || length == record.length)
      return record.length;
    const double tolerance =
        relative_tolerance * length + tolerance_ +
        8. * static_cast<double>(points.size()) * std::numeric_limits<double>::denorm_min();
    if(std::abs(length - record.length) <= tolerance)
      return record.length;
    add_problem(WRONG_LENGTH, place_ + ": length is given as " + in_words(record.length) +
                                  ", but is " + in_words(length));
    return length;
  }

  const Loops_record& record_;
  const Mesh& mesh_;
  Bound_loops result_;
  std::array<std::vector<std::string>, 3> problems_; // by severity
  double tolerance_ = 0.;
  std::size_t number_of_points_ = 0, number_of_far_points_ = 0;
  // Where the binder is, for messages.
  std::string place_;
  std::size_t position_ = 0;
};

} // namespace

Loops_record read_loops_json(const Input_file& file) { return read_json(file, read_document); }

Bound_loops bind_loops(const Loops_record& record, const Mesh& mesh) {
  return Binder(record, mesh).bind();
}

} // namespace htloops
