// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TOOL_H
#define HTLOOPS_TOOL_H

namespace htloops {

/// does what the words of a command line say; returns the exit code.
int run_tool(int argc, char** argv);

} // namespace htloops

#endif // HTLOOPS_TOOL_H
