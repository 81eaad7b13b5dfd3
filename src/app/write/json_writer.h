// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_JSON_WRITER_H
#define HTLOOPS_JSON_WRITER_H

#include "mesh_types.h"
#include "write/files.h"

#include <nlohmann/json.hpp>

#include <array>
#include <string>

namespace htloops {

/// Members keep their order. What is not finite is written as null, as JSON has no infinity, which
/// a length may reach where coordinates almost do.
using Json = nlohmann::ordered_json;

/// A file with an object of JSON, written member by member, each on a line of its own; of a long
/// array each element. So a thousand long loops are no tree to keep in memory.
class Json_writer
{
public:
  explicit Json_writer(const std::string& target)
      : out_(target) {}

  void member(const char* name, const Json& value) {
    begin_member(name);
    out_ << text_of(value);
  }

  /// writes an array of what `json_of(element)` makes of the elements of a range.
  template <typename Range, typename Json_of>
  void array(const char* name, const Range& range, Json_of json_of) {
    begin_member(name);
    const char* separator = "[\n    ";
    for(const auto& element : range) {
      out_ << separator << text_of(json_of(element));
      separator = ",\n    ";
    }
    out_ << (*separator == '[' ? "[]" : "\n  ]");
  }

  void finish() {
    out_ << "\n}\n";
    out_.finish();
  }

private:
  // A name of a file may be anything; what is no UTF-8 is replaced.
  static std::string text_of(const Json& value) {
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

  void begin_member(const char* name) {
    out_ << separator_ << "\n  \"" << name << "\": ";
    separator_ = ",";
  }

  Text_writer out_;
  const char* separator_ = "{";
};

inline Json json_of_point(const Point& point) {
  return std::array<double, 3>{point.x(), point.y(), point.z()};
}

} // namespace htloops

#endif // HTLOOPS_JSON_WRITER_H
