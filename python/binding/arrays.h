// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_ARRAYS_H
#define HTL_PYTHON_ARRAYS_H

#include "app/mesh_types.h"
#include "app/read/soup.h"
#include "app/read/soup_diagnosis.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace htl_python {

namespace py = pybind11;

/// is thrown when arrays are no mesh; Python sees `MeshError`.
class Mesh_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// points, (n, 3) of any real type, and faces, (m, k) of any integer type for each k that there is,
/// in any order in memory; nothing is known of them but that the vertices are there.
htloops::Soup soup_of(const py::array& points, const std::vector<py::array>& faces);

/// throws `Mesh_error` with all that is wrong, if anything is, and with advice.
void throw_if_no_surface(const std::vector<htloops::Defect>& defects, const char* advice = "");

/// the mesh of such arrays, of triangles. Vertices and faces keep their numbers. Throws
/// `Mesh_error` with all that is wrong.
htloops::Mesh mesh_of(const py::array& points, const py::array& triangles);

/// a vertex by its number; throws `std::invalid_argument` if there is none.
htloops::Mesh::Vertex_index vertex_of(const htloops::Mesh& mesh, py::ssize_t number);
std::vector<htloops::Mesh::Vertex_index> vertices_of(const htloops::Mesh& mesh,
                                                     const std::vector<py::ssize_t>& numbers);

template <typename Number> py::array_t<Number> array_of(const std::vector<Number>& numbers) {
  return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// the same, in rows.
template <typename Number>
py::array_t<Number> array_of(const std::vector<Number>& numbers, py::ssize_t columns) {
  return array_of(numbers).reshape({static_cast<py::ssize_t>(numbers.size()) / columns, columns});
}

/// points or triangles, a row for each.
template <typename Number, typename Triples> py::array_t<Number> rows_of(const Triples& triples) {
  py::array_t<Number> array({static_cast<py::ssize_t>(triples.size()), py::ssize_t(3)});
  Number* next = array.mutable_data();
  for(const auto& triple : triples)
    for(int i = 0; i < 3; ++i)
      *next++ = static_cast<Number>(triple[i]);
  return array;
}

/// the points and the faces of a mesh.
py::tuple arrays_of(const htloops::Mesh& mesh);

} // namespace htl_python

#endif // HTL_PYTHON_ARRAYS_H
