// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/exported_lines.h"

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

namespace {

void add_lines(Exported_lines& lines, const Pair& pair, std::size_t index) {
  for(const CGAL::Loop_type type : loop_types)
    lines.lines.push_back({pair.loop(type).points(), true, colour_of(type), name_of(type),
                           type == CGAL::Loop_type::HANDLE ? 0 : 1, index,
                           pair.loop(type).length()});
}

} // namespace

Exported_lines lines_of(const Pairs& pairs) {
  Exported_lines result = {"handle and tunnel loops", "pair", {}};
  for(const Pair& pair : pairs)
    add_lines(result, pair, pair.handle().pair_index());
  return result;
}

Exported_lines lines_of(const Answer& answer, const Pair_listing& listing) {
  Exported_lines result = {"handle and tunnel loops", "pair", {}};
  for(const Listed_pair& listed : listing)
    add_lines(result, answer.pairs[listed.pair], listed.pair);
  const auto add = [&result](const std::vector<Loop>& loops, const auto& colour, const char* kind,
                             int number) {
    for(const Loop& loop : loops)
      result.lines.push_back({loop.points(), true, colour, kind, number, loop.pair_index(),
                              loop.length(), false, false});
  };
  add(answer.boundaries.curves, colour_of_boundary_curve, "boundary", 2);
  add(answer.boundaries.waists, colour_of(CGAL::Loop_type::BOUNDARY), "waist", 3);
  return result;
}

} // namespace htloops
