// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OBJ_READER_H
#define HTLOOPS_OBJ_READER_H

#include "read/soup.h"

#include <string>

namespace htloops {

/// reads the vertices and faces of the text of an OBJ file; all else that the format has is passed
/// over. Throws `Failure`, naming file and line, if the text is malformed.
Soup read_obj(const std::string& file, std::string text);

} // namespace htloops

#endif // HTLOOPS_OBJ_READER_H
