// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "commands/box_option.h"

#include "commands/common_options.h"
#include "failure.h"

#include <CLI/CLI.hpp>

#include <cstddef>

namespace htloops {

CLI::Option* add_box_option(CLI::App& command, std::vector<double>& box, const std::string& what) {
  return command.add_option("--box", box, what + " with a loop that lies in a box")
      ->option_text("x,y,z,X,Y,Z")
      ->delimiter(',')
      ->expected(6)
      ->check(why_not_finite);
}

std::optional<CGAL::Bbox_3> box_of(const std::vector<double>& box) {
  if(box.empty())
    return std::nullopt;
  for(std::size_t i = 0; i < 3; ++i)
    if(!(box[i] <= box[i + 3]))
      throw Failure(Exit_code::WRONG_USAGE,
                    "--box: its least corner comes first, then its largest");
  return CGAL::Bbox_3(box[0], box[1], box[2], box[3], box[4], box[5]);
}

} // namespace htloops
