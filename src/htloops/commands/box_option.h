// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_BOX_OPTION_H
#define HTLOOPS_BOX_OPTION_H

#include <CGAL/Bbox_3.h>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace htloops {

/// declares `--box`.
CLI::Option* add_box_option(CLI::App& command, std::vector<double>& box, const std::string& what);

/// the box that was given, if one was; throws `Failure` if its corners are in the wrong order.
std::optional<CGAL::Bbox_3> box_of(const std::vector<double>& box);

} // namespace htloops

#endif // HTLOOPS_BOX_OPTION_H
