// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_REEB_H
#define HTL_PYTHON_REEB_H

#include "arrays.h"

#include <string>

namespace htl_python {

/// computes a Reeb graph; what the class `Reeb_graph` of Python is made from.
py::dict find_reeb_graph(const py::array& points,
                         const py::array& triangles,
                         const py::object& values,
                         const py::object& simplify,
                         const std::string& measure,
                         const std::vector<py::ssize_t>& sources,
                         int threads,
                         const py::object& progress);

} // namespace htl_python

#endif // HTL_PYTHON_REEB_H
