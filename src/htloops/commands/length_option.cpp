// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/length_option.h"

#include "failure.h"
#include "read/text_cursor.h"
#include "write/pair_listing.h"

#include <cmath>
#include <string_view>

namespace htloops {

Length_option parse_length(const std::string& option, const std::string& text) {
  Length_option length;
  std::string_view number = text;
  if(!number.empty() && number.back() == '%') {
    length.is_percentage = true;
    number.remove_suffix(1);
  }
  Text_cursor cursor(number);
  if(!cursor.read(length.value) || cursor.skip_to_content() || !(length.value > 0.) ||
     !std::isfinite(length.value))
    throw Failure(Exit_code::WRONG_USAGE,
                  option + " " + text + ": not a length, such as 0.25, nor a percentage of the " +
                      "diagonal of the bounding box, such as 3%");
  return length;
}

double length_on(const Mesh& mesh, const Length_option& length) {
  if(!length.is_percentage)
    return length.value;
  return length.value / 100. * diagonal_of(mesh);
}

} // namespace htloops
