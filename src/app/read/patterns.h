// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_READ_PATTERNS_H
#define HTLOOPS_READ_PATTERNS_H

#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// whether there is a "*", a "?" or a "[" in it.
bool is_pattern(const std::string& word);

/// whether a name, without folders, is one that a pattern stands for: in it "*" is any text, "?"
/// any byte, and "[a-cx]" one of some, "[!a-cx]" none of them.
bool fits(std::string_view name, std::string_view pattern);

/// the files and folders that a pattern stands for, of which each folder may be one, too; sorted.
/// What begins with a dot must be asked for by a dot.
std::vector<std::string> names_fitting(const std::string& words);

} // namespace htloops

#endif // HTLOOPS_READ_PATTERNS_H
