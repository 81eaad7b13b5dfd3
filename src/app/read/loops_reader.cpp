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
#include "words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace htloops {
namespace {

using Json = nlohmann::json;

const char known_format[] = "htloops/1";

// A value in a document that knows, for messages, where it stands: which member or element it is,
// and of what. The outer node must live as long as the inner one.
struct Node
{
  static constexpr std::size_t no_index = static_cast<std::size_t>(-1);

  const Json& value;
  const Node* outer = nullptr;
  const char* name = "";
  std::size_t index = no_index;

  bool has(const char* key) const { return value.is_object() && value.contains(key); }

  Node member(const char* key) const {
    if(!value.is_object())
      fail("is not an object");
    const auto found = value.find(key);
    if(found == value.end())
      fail("has no member '" + std::string(key) + "'");
    return {*found, this, key};
  }

  // calls visit(node) for each element; `what` is what an element is called.
  template <typename Visit> void for_each(const char* what, Visit visit) const {
    if(!value.is_array())
      fail("is not an array");
    std::size_t position = 0;
    for(const Json& element : value)
      visit(Node{element, this, what, position++});
  }

  std::array<double, 3> point() const {
    check_is_triple();
    return {number(value[0]), number(value[1]), number(value[2])};
  }

  Location_record location() const {
    check_is_triple();
    return {integer(value[0]), integer(value[1]), number(value[2])};
  }

  std::size_t count() const {
    if(!value.is_number_unsigned())
      fail("is not a count");
    return value.get<std::size_t>();
  }

  double number() const { return number(value); }

  std::string text() const {
    if(!value.is_string())
      fail("is not a text");
    return value.get<std::string>();
  }

  std::array<long long, 3> integers() const {
    check_is_triple();
    for(const Json& x : value)
      if(!x.is_number_integer())
        fail("has something that is not an integer");
    return {value[0].get<long long>(), value[1].get<long long>(), value[2].get<long long>()};
  }

  bool is(const char* text) const { return value.is_string() && value == text; }

  std::size_t size() const { return value.size(); }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Failure(Exit_code::UNREADABLE_FILE, place() + " " + problem);
  }

private:
  std::string place() const {
    if(outer == nullptr)
      return "the document";
    const std::string own =
        index == no_index ? name : std::string(name) + " " + std::to_string(index);
    return outer->outer == nullptr ? own : outer->place() + ", " + own;
  }

  void check_is_triple() const {
    if(!value.is_array() || value.size() != 3)
      fail("is not an array of three numbers");
  }

  long long integer(const Json& x) const {
    if(!x.is_number_integer())
      fail("has a vertex index that is not an integer");
    // An index that is too large for its type is out of range anyway.
    constexpr auto largest = (std::numeric_limits<long long>::max)();
    return x.is_number_unsigned() && x.get<unsigned long long>() > largest ? largest
                                                                           : x.get<long long>();
  }

  // JSON has no infinity; null stands for it.
  double number(const Json& x) const {
    if(x.is_null())
      return std::numeric_limits<double>::infinity();
    if(!x.is_number())
      fail(&x == &value ? "is not a number" : "has something that is not a number");
    return x.get<double>();
  }
};

// What older files do not say.
template <typename Value, typename Read>
void read_if_said(const Node& node, const char* key, std::optional<Value>& value, Read read) {
  if(node.has(key))
    value = (node.member(key).*read)();
}

Loop_record read_loop(const Node& node) {
  Loop_record loop;
  loop.length = node.member("length").number();
  read_if_said(node, "bounds", loop.bounds, &Node::text);
  read_if_said(node, "bounds_alone", loop.bounds_alone, &Node::text);
  const Node locations = node.member("locations"), points = node.member("points");
  loop.locations.reserve(locations.size());
  locations.for_each("position",
                     [&](const Node& location) { loop.locations.push_back(location.location()); });
  loop.points.reserve(points.size());
  points.for_each("position", [&](const Node& point) { loop.points.push_back(point.point()); });
  return loop;
}

// Files of before there were two kinds do not say.
Basis_kind basis_kind(const Node& document) {
  if(!document.has("basis"))
    return Basis_kind::PURE;
  const Node basis = document.member("basis");
  for(const Basis_kind kind : {Basis_kind::PURE, Basis_kind::SHORTEST})
    if(basis.is(name_of(kind)))
      return kind;
  basis.fail("is neither pure nor shortest");
}

Loops_record read_document(const Node& document) {
  if(!document.member("format").is(known_format))
    document.fail("is not of the format " + std::string(known_format));
  Loops_record record;
  const Node mesh = document.member("mesh");
  record.number_of_vertices = mesh.member("vertices").count();
  record.number_of_faces = mesh.member("faces").count();
  read_if_said(mesh, "components", record.number_of_components, &Node::count);
  read_if_said(mesh, "boundaries", record.number_of_boundaries, &Node::count);
  read_if_said(mesh, "genus", record.genus, &Node::count);
  record.basis_kind = basis_kind(document);
  const Node pairs = document.member("pairs");
  record.pairs.reserve(pairs.size());
  pairs.for_each("pair", [&](const Node& pair) {
    record.pairs.push_back(
        {read_loop(pair.member("handle")), read_loop(pair.member("tunnel")), {}});
    read_if_said(pair, "size", record.pairs.back().size,
                 static_cast<double (Node::*)() const>(&Node::number));
  });
  if(document.has("linking")) {
    record.linking.emplace();
    document.member("linking").for_each(
        "entry", [&](const Node& entry) { record.linking->push_back(entry.integers()); });
  }
  record.has_boundaries = document.has("boundaries");
  if(record.has_boundaries)
    document.member("boundaries").for_each("boundary", [&](const Node& curve) {
      record.boundaries.push_back({read_loop(curve), std::nullopt});
      if(curve.has("waist"))
        record.boundaries.back().waist = read_loop(curve.member("waist"));
    });
  return record;
}

// Far above rounding, far below what a drawing shows.
constexpr double relative_tolerance = 1e-9;

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
  }

  void add_problem(Severity severity, const std::string& problem) {
    problems_[severity].push_back(problem);
  }

  bool is_same_mesh() {
    const std::size_t vertices = mesh_.number_of_vertices(), faces = mesh_.number_of_faces();
    if(record_.number_of_vertices == vertices && record_.number_of_faces == faces)
      return true;
    add_problem(MISPLACED, "it is about a mesh of " + std::to_string(record_.number_of_vertices) +
                               " vertices and " + std::to_string(record_.number_of_faces) +
                               " faces; this one has " + std::to_string(vertices) + " and " +
                               std::to_string(faces));
    return false;
  }

  void measure_mesh() {
    double largest = 0.;
    for(const Point& p : mesh_.points())
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    // Of the smallest numbers, each product and each sum loses as much as they are.
    tolerance_ = relative_tolerance * largest + 8. * std::numeric_limits<double>::denorm_min();
  }

  Loop bind_loop(const Loop_record& record, Loop_type type, std::size_t number) {
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
        add_problem_here("vertex " + std::to_string(vertex) + " is not one of the " +
                         std::to_string(mesh_.number_of_vertices()) + " of the mesh");
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
      add_problem_here("no edge joins the vertices " + std::to_string(location.source) + " and " +
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

  void check_point(const Point& expected, const std::array<double, 3>& found) {
    for(int i = 0; i < 3; ++i)
      if(!(std::abs(expected[i] - found[i]) <= tolerance_)) {
        add_problem_here("the point is not where the location is", WRONG_POINT);
        return;
      }
  }

  // That of the file, unless it is wrong.
  double checked_length(const Loop_record& record, const std::vector<Point>& points) {
    double length = 0.;
    for(std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      const Point& q = points[i + 1 == points.size() ? 0 : i + 1];
      length += std::hypot(q.x() - p.x(), q.y() - p.y(), q.z() - p.z());
    }
    if(points.size() != record.locations.size() || length == record.length)
      return record.length;
    const double tolerance =
        relative_tolerance * length + tolerance_ +
        8. * static_cast<double>(points.size()) * std::numeric_limits<double>::denorm_min();
    if(std::abs(length - record.length) <= tolerance)
      return record.length;
    add_problem(WRONG_LENGTH, place_ + ": the length is given as " + in_words(record.length) +
                                  " and is " + in_words(length));
    return length;
  }

  const Loops_record& record_;
  const Mesh& mesh_;
  Bound_loops result_;
  std::array<std::vector<std::string>, 3> problems_; // by severity
  double tolerance_ = 0.;
  // Where the binder is, for messages.
  std::string place_;
  std::size_t position_ = 0;
};

} // namespace

Loops_record read_loops_json(const Input_file& file) {
  try {
    const Json document = Json::parse(file.content());
    return read_document(Node{document});
  } catch(const Json::exception& exception) {
    throw Failure(Exit_code::UNREADABLE_FILE, file.name() + " is not JSON: " + exception.what());
  } catch(const Failure& failure) {
    throw Failure(failure.code(), file.name() + ": " + failure.what());
  }
}

Bound_loops bind_loops(const Loops_record& record, const Mesh& mesh) {
  return Binder(record, mesh).bind();
}

} // namespace htloops
