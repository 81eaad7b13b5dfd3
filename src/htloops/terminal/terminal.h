// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TERMINAL_H
#define HTLOOPS_TERMINAL_H

#include <cstdio>
#include <string>

namespace htloops {

/// whether a person looks at the stream.
bool is_terminal(std::FILE* stream);

/// whether to colour what goes to the stream; `when` is auto, always or never.
bool use_colour(const std::string& when, std::FILE* stream);

} // namespace htloops

#endif // HTLOOPS_TERMINAL_H
