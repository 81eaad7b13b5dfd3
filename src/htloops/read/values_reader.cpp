// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/values_reader.h"

#include "read/text_cursor.h"

#include <cmath>

namespace htloops {
std::vector<double> read_values(const Input_file& file, std::size_t number_of_vertices) {
  Text_cursor cursor(file.content());
  std::vector<double> values;
  while(cursor.skip_to_content()) {
    double value = 0.;
    if(!cursor.read(value))
      fail_to_read(file.name(), "line " + std::to_string(cursor.line()) + ": no number");
    if(!std::isfinite(value))
      fail_to_read(file.name(),
                   "the value of vertex " + std::to_string(values.size()) + " is not finite");
    values.push_back(value);
  }
  if(values.size() != number_of_vertices)
    fail_to_read(file.name(), "there are " + std::to_string(values.size()) + " values for " +
                                  std::to_string(number_of_vertices) + " vertices");
  return values;
}

} // namespace htloops
