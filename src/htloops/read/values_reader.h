// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VALUES_READER_H
#define HTLOOPS_VALUES_READER_H

#include "read/input_file.h"

#include <cstddef>
#include <vector>

namespace htloops {

/// reads as many finite numbers as there are vertices, separated by blanks or line ends; throws
/// `Failure`, naming the line or the vertex, if they are not there.
std::vector<double> read_values(const Input_file& file, std::size_t number_of_vertices);

} // namespace htloops

#endif // HTLOOPS_VALUES_READER_H
