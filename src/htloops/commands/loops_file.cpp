// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/loops_file.h"

#include "app/failure.h"

#include <cstddef>

namespace htloops {

std::string indented(const std::vector<std::string>& lines) {
  constexpr std::size_t largest_number_of_lines = 10;
  std::string text;
  for(std::size_t i = 0; i < lines.size() && i < largest_number_of_lines; ++i)
    text += "\n  " + lines[i];
  if(lines.size() > largest_number_of_lines)
    text +=
        "\n  and " + std::to_string(lines.size() - largest_number_of_lines) + " more such lines";
  return text;
}

void require_none(const std::string& loops_file, const std::vector<std::string>& problems) {
  if(!problems.empty())
    throw Failure(Exit_code::NOT_CERTIFIED,
                  loops_file + " fails its certificate:" + indented(problems));
}

Bound_loops read_loops_on(const Mesh& mesh, const std::string& loops_file) {
  Bound_loops loops = bind_loops(read_loops_json(loops_file), mesh);
  require_none(loops_file, loops.problems);
  return loops;
}

} // namespace htloops
