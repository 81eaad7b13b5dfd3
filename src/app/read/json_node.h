// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_JSON_NODE_H
#define HTLOOPS_JSON_NODE_H

#include "failure.h"
#include "read/input_file.h"
#include "read/json_errors.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>

namespace htloops {

using Json = nlohmann::json;

/// A value in a document that knows, for messages, where it stands: which member or element it is,
/// and of what. The outer node must live as long as the inner one.
struct Json_node
{
  static constexpr std::size_t no_index = static_cast<std::size_t>(-1);

  const Json& value;
  const Json_node* outer = nullptr;
  const char* name = "";
  std::size_t index = no_index;

  bool has(const char* key) const { return value.is_object() && value.contains(key); }

  Json_node member(const char* key) const {
    if(!value.is_object())
      fail("is not an object");
    const auto found = value.find(key);
    if(found == value.end())
      fail("has no member '" + std::string(key) + "'");
    return {*found, this, key};
  }

  /// calls visit(node) for each element; `what` is what an element is called.
  template <typename Visit> void for_each(const char* what, Visit visit) const {
    if(!value.is_array())
      fail("is not an array");
    std::size_t position = 0;
    for(const Json& element : value)
      visit(Json_node{element, this, what, position++});
  }

  std::array<double, 3> point() const {
    check_is_triple();
    return {number(value[0]), number(value[1]), number(value[2])};
  }

  std::tuple<long long, long long, double> location() const {
    check_is_triple();
    return {integer(value[0]), integer(value[1]), number(value[2])};
  }

  std::size_t count() const {
    if(!value.is_number_unsigned())
      fail("is not a non-negative integer");
    return value.get<std::size_t>();
  }

  double number() const { return number(value); }

  std::string text() const {
    if(!value.is_string())
      fail("is not a string");
    return value.get<std::string>();
  }

  /// fails if a document has another format than a known one; `source` says what writes that.
  void require_format(const char* known, const char* source) const {
    const Json_node format = member("format");
    if(!format.is(known))
      fail("has the format " + format.text() + ", not " + known + "; " + source);
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
      fail(&x == &value ? "is not a number" : "has an element that is not a number");
    return x.get<double>();
  }
};

/// what `read(node)` makes of the document in a file; throws `Failure`, naming what is missing or
/// of the wrong type.
template <typename Read> auto read_json(const Input_file& file, Read read) {
  try {
    const Json document = Json::parse(file.content());
    return read(Json_node{document});
  } catch(const Json::exception& exception) {
    throw Failure(Exit_code::UNREADABLE_FILE,
                  file.name() + " is not valid JSON: " +
                      words_of_json_error(exception.what(), file.content()));
  } catch(const Failure& failure) {
    const std::string what = failure.what(), name = file.name() + ": ";
    throw Failure(failure.code(), what.compare(0, name.size(), name) == 0 ? what : name + what);
  }
}

} // namespace htloops

#endif // HTLOOPS_JSON_NODE_H
