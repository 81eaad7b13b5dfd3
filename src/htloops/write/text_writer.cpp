// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/text_writer.h"

#include <charconv>
#include <cstdio>

namespace htloops {

void append_number(std::string& text, double value) {
  char digits[32];
#ifdef __cpp_lib_to_chars
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
#else
  std::snprintf(digits, sizeof digits, "%.17g", value);
  text += digits;
#endif
}

void Text_writer::flush() {
  throw_if_interrupted();
  file_.write(buffer_.data(), buffer_.size());
  buffer_.clear();
}

void Text_writer::show() {
  flush();
  file_.show();
}

void Text_writer::finish() {
  flush();
  file_.commit();
}

} // namespace htloops
