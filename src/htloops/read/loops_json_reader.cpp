// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/loops_json_reader.h"

#include "failure.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace htloops {
namespace {

using Json = nlohmann::json;

const char known_format[] = "htloops/1";

// A value in a document that knows, for messages, where it stands: which member or element it is,
// and of what. The outer node must live as long as the inner one.
class Node
{
public:
  explicit Node(const Json& document)
      : value_(document) {}

  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }

  Node member(const char* key) const {
    if(!value_.is_object())
      fail("is not an object");
    const auto found = value_.find(key);
    if(found == value_.end())
      fail("has no member '" + std::string(key) + "'");
    return Node(*found, this, key, no_index);
  }

  // calls visit(node) for each element; `name` is what an element is called.
  template <typename Visit> void for_each(const char* name, Visit visit) const {
    if(!value_.is_array())
      fail("is not an array");
    std::size_t index = 0;
    for(const Json& element : value_)
      visit(Node(element, this, name, index++));
  }

  std::array<double, 3> point() const {
    check_is_triple();
    return {number(value_[0]), number(value_[1]), number(value_[2])};
  }

  Location_record location() const {
    check_is_triple();
    return {integer(value_[0]), integer(value_[1]), number(value_[2])};
  }

  std::size_t count() const {
    if(!value_.is_number_unsigned())
      fail("is not a count");
    return value_.get<std::size_t>();
  }

  double number() const { return number(value_); }

  bool is(const char* text) const { return value_.is_string() && value_ == text; }

  std::size_t size() const { return value_.size(); }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Failure(Exit_code::UNREADABLE_FILE, place() + " " + problem);
  }

private:
  static constexpr std::size_t no_index = static_cast<std::size_t>(-1);

  Node(const Json& value, const Node* outer, const char* name, std::size_t index)
      : value_(value)
      , outer_(outer)
      , name_(name)
      , index_(index) {}

  std::string place() const {
    if(outer_ == nullptr)
      return "the document";
    const std::string own =
        index_ == no_index ? name_ : std::string(name_) + " " + std::to_string(index_);
    return outer_->outer_ == nullptr ? own : outer_->place() + ", " + own;
  }

  void check_is_triple() const {
    if(!value_.is_array() || value_.size() != 3)
      fail("is not an array of three numbers");
  }

  long long integer(const Json& value) const {
    if(!value.is_number_integer())
      fail("has a vertex index that is not an integer");
    // An index that is too large for its type is out of range anyway.
    constexpr auto largest = (std::numeric_limits<long long>::max)();
    return value.is_number_unsigned() && value.get<unsigned long long>() > largest
               ? largest
               : value.get<long long>();
  }

  // JSON has no infinity; null stands for it.
  double number(const Json& value) const {
    if(value.is_null())
      return std::numeric_limits<double>::infinity();
    if(!value.is_number())
      fail(&value == &value_ ? "is not a number" : "has something that is not a number");
    return value.get<double>();
  }

  const Json& value_;
  const Node* outer_ = nullptr;
  const char* name_ = "";
  std::size_t index_ = no_index;
};

Loop_record read_loop(const Node& node) {
  Loop_record loop;
  loop.length = node.member("length").number();
  const Node locations = node.member("locations"), points = node.member("points");
  loop.locations.reserve(locations.size());
  locations.for_each("position",
                     [&](const Node& location) { loop.locations.push_back(location.location()); });
  loop.points.reserve(points.size());
  points.for_each("position", [&](const Node& point) { loop.points.push_back(point.point()); });
  return loop;
}

// Files of before there were two kinds do not say.
CGAL::Handle_tunnel_loops::Basis_kind basis_kind(const Node& document) {
  using CGAL::Handle_tunnel_loops::Basis_kind;
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
  record.basis_kind = basis_kind(document);
  const Node pairs = document.member("pairs");
  record.pairs.reserve(pairs.size());
  pairs.for_each("pair", [&](const Node& pair) {
    record.pairs.push_back({read_loop(pair.member("handle")), read_loop(pair.member("tunnel"))});
  });
  record.has_boundaries = document.has("boundaries");
  if(record.has_boundaries)
    document.member("boundaries").for_each("boundary", [&](const Node& curve) {
      record.boundaries.push_back({read_loop(curve), std::nullopt});
      if(curve.has("waist"))
        record.boundaries.back().waist = read_loop(curve.member("waist"));
    });
  return record;
}

} // namespace

Loops_record read_loops_json(const Input_file& file) {
  try {
    const Json document = Json::parse(file.content());
    return read_document(Node(document));
  } catch(const Json::exception& exception) {
    throw Failure(Exit_code::UNREADABLE_FILE, file.name() + " is not JSON: " + exception.what());
  } catch(const Failure& failure) {
    throw Failure(failure.code(), file.name() + ": " + failure.what());
  }
}

} // namespace htloops
