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

#include "write/documents.h"
#include "write/files.h"

#include <string>

namespace htloops {

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
  void begin_member(const char* name) {
    out_ << separator_ << "\n  \"" << name << "\": ";
    separator_ = ",";
  }

  Text_writer out_;
  const char* separator_ = "{";
};

} // namespace htloops

#endif // HTLOOPS_JSON_WRITER_H
