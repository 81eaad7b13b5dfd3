// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_SURGERY_H
#define HTL_PYTHON_SURGERY_H

#include "arrays.h"

#include <string>
#include <vector>

namespace htl_python {

/// removes handles of a mesh; points, triangles, the face that each comes from or -1, and a report.
py::tuple remove_handles(const py::array& points,
                         const py::array& triangles,
                         const py::dict& options,
                         int threads,
                         const py::object& progress);

/// points and triangles of the mesh cut open to a disk, and edges, length and genus.
py::tuple cut_to_disk(const py::array& points,
                      const py::array& triangles,
                      const std::vector<py::ssize_t>& cones,
                      bool cut_spheres,
                      int threads,
                      const py::object& progress);

/// for each handle and tunnel loop, and all boundary curves but one of each component, the cut that
/// crosses it once and no other: edges and how often it runs along each.
py::list dual_cuts(const py::array& points,
                   const py::array& triangles,
                   int threads,
                   const py::object& progress);

} // namespace htl_python

#endif // HTL_PYTHON_SURGERY_H
