// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PLY_READER_H
#define HTLOOPS_PLY_READER_H

#include "read/soup.h"

#include <string>
#include <string_view>

namespace htloops {

/// reads the vertices and faces of the content of a PLY file, in text or binary form, of whatever
/// type their numbers are; all else is passed over. Throws `Failure`, naming line or byte, if the
/// content is malformed or ends too early.
Soup read_ply(const std::string& file, std::string_view content);

} // namespace htloops

#endif // HTLOOPS_PLY_READER_H
