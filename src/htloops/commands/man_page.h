// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MAN_PAGE_H
#define HTLOOPS_MAN_PAGE_H

#include "commands/command_line.h"

#include <string>

namespace htloops {

/// the manual page of the tool, for man(1).
std::string man_page(const Told_command& tool);

} // namespace htloops

#endif // HTLOOPS_MAN_PAGE_H
