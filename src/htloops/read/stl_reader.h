// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_STL_READER_H
#define HTLOOPS_STL_READER_H

#include "read/soup.h"

#include <string>
#include <string_view>

namespace htloops {

/// reads the triangles of the content of an STL file, in text or binary form; equal points become
/// one vertex. Throws `Failure`, naming the line of a text, if the content is malformed or ends too
/// early.
Soup read_stl(const std::string& file, std::string_view content);

} // namespace htloops

#endif // HTLOOPS_STL_READER_H
