// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_EXPORT_LINES_H
#define HTLOOPS_EXPORT_LINES_H

#include "draw/exported_lines.h"

#include <string>

namespace htloops {

/// throws `Failure` if the name of a file does not tell a format that lines can be written in.
void check_lines_format(const std::string& file);

/// writes lines, in the format that the name of the file tells.
void export_lines(const std::string& file, const Exported_lines& lines);

} // namespace htloops

#endif // HTLOOPS_EXPORT_LINES_H
