// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OFF_READER_H
#define HTLOOPS_OFF_READER_H

#include "read/soup.h"

#include <string>
#include <string_view>

namespace htloops {

/// reads the text of an OFF file, also with homogeneous coordinates; colours, normals and texture
/// coordinates are passed over. Throws `Failure`, naming file and line, if it is malformed.
Soup read_off(const std::string& file, std::string_view text);

} // namespace htloops

#endif // HTLOOPS_OFF_READER_H
