// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_WAITING_H
#define HTL_PYTHON_WAITING_H

#include "htloops/solve/progress.h"

#include <pybind11/pybind11.h>

#include <functional>

namespace htl_python {

namespace py = pybind11;

/// computes in another thread, while this one gives way to other threads of Python, looks for
/// Ctrl-C and tells `progress`, a callable or None, how far it is, from 0 to 1. What either throws
/// is thrown here, after the computation has ended; if the callable returns False it ends, too.
void wait_for(const py::object& progress, const std::function<void(htloops::Progress&)>& compute);

/// ends what is being computed, and all that is asked for from now on: the interpreter is about to
/// end, after which no thread may come back to it.
void stop_waiting();

} // namespace htl_python

#endif // HTL_PYTHON_WAITING_H
