// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OBJ_LINES_H
#define HTLOOPS_OBJ_LINES_H

#include <string>

namespace htloops {

/// the text of an OBJ file, where a backslash continues a line, without continued lines. Their ends
/// are put off to the end of the whole line, so that all other lines keep their numbers.
std::string join_continued_lines(std::string text);

} // namespace htloops

#endif // HTLOOPS_OBJ_LINES_H
