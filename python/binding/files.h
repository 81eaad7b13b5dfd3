// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_FILES_H
#define HTL_PYTHON_FILES_H

#include "arrays.h"

#include <string>

namespace htl_python {

/// points and triangles of a mesh file, with the remedies of the tool.
py::tuple read(const std::string& file, bool triangulate, bool repair);

/// points, triangles and what became of them, of arrays that are no surface: by face the one of the
/// given ones, by vertex too, and what was done, as pairs of a number and words.
py::tuple repair(const py::array& points, const py::array& faces);

} // namespace htl_python

#endif // HTL_PYTHON_FILES_H
