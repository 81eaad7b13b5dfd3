// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_FUNCTIONS_H
#define HTL_PYTHON_FUNCTIONS_H

#include <pybind11/pybind11.h>

namespace htl_python {

// What the module offers, by the file in which it is. The last argument of each function that
// computes is a `Watch`; handle_tunnel_loops/_core.pyi has the others.
void add_cleaning(pybind11::module_& module);
void add_drawing(pybind11::module_& module);
void add_files(pybind11::module_& module);
void add_generators(pybind11::module_& module);
void add_loops(pybind11::module_& module);
void add_reeb(pybind11::module_& module);
void add_skeleton(pybind11::module_& module);
void add_surgery(pybind11::module_& module);
void add_throats(pybind11::module_& module);

} // namespace htl_python

#endif // HTL_PYTHON_FUNCTIONS_H
