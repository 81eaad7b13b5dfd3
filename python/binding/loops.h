// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_LOOPS_H
#define HTL_PYTHON_LOOPS_H

#include "arrays.h"

#include <string>

namespace htl_python {

/// finds the loops; what the class `Loops` of Python is made from.
py::dict find_loops(const py::array& points,
                    const py::array& triangles,
                    const std::string& basis,
                    int threads,
                    const py::object& seed,
                    bool waists,
                    const py::object& progress);

/// what has been proved of loops, given as in that dictionary.
py::dict certify(const py::array& points, const py::array& triangles, const py::dict& loops);

/// writes a page in which the mesh with its loops can be turned.
void write_page(const py::array& points,
                const py::array& triangles,
                const py::dict& loops,
                const std::string& file,
                const std::string& title);

} // namespace htl_python

#endif // HTL_PYTHON_LOOPS_H
