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

#include "read/input_file.h"
#include "read/soup.h"

namespace htloops {

/// reads an OFF file (also with colours, normals or texture coordinates, which are
/// passed over) several times faster than the reader of CGAL, and says which line is wrong where
/// that one says only that something is. Returns false if the text is in another dialect (four or n
/// coordinates): those are left to CGAL.
/// Throws `Failure` if the text is malformed or ends too early.
bool read_plain_off(const Input_file& file, Soup& soup);

} // namespace htloops

#endif // HTLOOPS_OFF_READER_H
