// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_NUMBERS_H
#define HTLOOPS_NUMBERS_H

#include <string>
#include <string_view>

namespace htloops {

/// whether a word is a number, of any form but hexadecimal, and which; too large a one is infinite.
bool parse_number(std::string_view word, double& value);

/// appends the shortest decimal number that reads back as exactly `value`: the same text on all
/// machines.
void append_number(std::string& text, double value);

} // namespace htloops

#endif // HTLOOPS_NUMBERS_H
