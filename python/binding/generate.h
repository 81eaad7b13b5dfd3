// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_GENERATE_H
#define HTL_PYTHON_GENERATE_H

#include "arrays.h"

#include <string>

namespace htl_python {

/// points and triangles of a mesh of a kind. Throws `std::invalid_argument` if there is no such
/// kind, or if what is asked for cannot be.
py::tuple generate(const std::string& kind, const py::dict& request);

/// by name, what the kinds of meshes look like.
py::dict kinds();

} // namespace htl_python

#endif // HTL_PYTHON_GENERATE_H
