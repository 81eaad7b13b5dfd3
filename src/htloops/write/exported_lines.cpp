// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/exported_lines.h"

#include "write/loop_colours.h"

namespace htloops {

std::size_t Exported_lines::number_of_points() const {
  std::size_t count = 0;
  for(const Exported_line& line : lines)
    count += line.points.size();
  return count;
}

std::size_t Exported_lines::number_of_edges() const {
  std::size_t count = 0;
  for(const Exported_line& line : lines)
    count += line.number_of_edges();
  return count;
}

Exported_lines lines_of(const Pairs& pairs) {
  Exported_lines result = {"handle and tunnel loops", "pair", {}};
  for_each_loop(pairs, [&result](const Loop& loop, CGAL::Loop_type type, std::size_t pair) {
    result.lines.push_back({loop.points(), true, colour_of(type), name_of(type),
                            type == CGAL::Loop_type::HANDLE ? 0 : 1, pair, loop.length()});
  });
  return result;
}

Exported_lines lines_of(const Answer& answer) {
  Exported_lines result = lines_of(answer.pairs);
  for(const Loop& loop : answer.boundaries.waists)
    result.lines.push_back({loop.points(), true, colour_of(loop.type()), name_of(loop.type()), 2,
                            loop.pair_index(), loop.length()});
  return result;
}

} // namespace htloops
