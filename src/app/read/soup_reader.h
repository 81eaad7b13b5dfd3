// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_READER_H
#define HTLOOPS_SOUP_READER_H

#include "read/input_file.h"
#include "read/soup.h"

namespace htloops {

/// reads OFF, OBJ, PLY and STL, by the extension of the file name.
/// The vertices keep the order of the file; those of an STL file, which has none, are numbered as
/// they come, equal points being one vertex. Throws `Failure` if the file cannot be read, ends too
/// early, or names a vertex that is not there.
Soup read_soup(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_SOUP_READER_H
