// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_ANSWERS_H
#define HTL_PYTHON_ANSWERS_H

#include "arrays.h"

#include "app/solve/reeb_solver.h"
#include "app/solve/removal_solver.h"
#include "app/solve/skeleton_solver.h"

#include <stdexcept>
#include <vector>

/// \file answers.h
/// Results that Python passes back. The functions throw `std::invalid_argument` if the parts of a
/// result are inconsistent, or if it belongs to another mesh.

namespace htl_python {

htloops::Skeleton_answer skeleton_of(const py::dict& record);

htloops::Reeb_answer reeb_answer_of(const py::dict& record, const htloops::Mesh& mesh);

/// from a report of `remove_handles()` and the mesh returned with it.
htloops::Removal_answer removal_of(const py::dict& report, const htloops::Mesh& after);

/// the edges between pairs of vertices.
std::vector<htloops::Mesh::Edge_index> edges_between(const py::array& ends,
                                                     const htloops::Mesh& mesh);

/// the numbers of an array of a record, whatever its shape.
template <typename Number>
std::vector<Number> numbers_of(const py::dict& record, const char* name) {
  const auto array = record[name].cast<py::array_t<Number, py::array::c_style>>();
  return {array.data(), array.data() + array.size()};
}

inline void require(bool fits, const char* what) {
  if(!fits)
    throw std::invalid_argument(what);
}

} // namespace htl_python

#endif // HTL_PYTHON_ANSWERS_H
