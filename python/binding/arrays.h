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

#include "generators/generators.h"
#include "htloops/mesh_types.h"
#include "htloops/read/soup.h"
#include "htloops/read/soup_diagnosis.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace htl_python {

namespace py = pybind11;

/// is thrown when arrays are no mesh; Python sees `MeshError`.
class Mesh_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// points, (n, 3) of any real type, and faces, (m, k) of any integer type, in any order in memory;
/// nothing is known of them but that the vertices are there.
htloops::Soup soup_of(const py::array& points, const py::array& faces);

/// throws `Mesh_error` with all that is wrong, if anything is, and with advice.
void throw_if_no_surface(const htloops::Diagnosis& diagnosis, const char* advice = "");

/// the mesh of such arrays, of triangles. Vertices and faces keep their numbers. Throws
/// `Mesh_error` with all that is wrong, or `std::invalid_argument` if the arrays are none of these.
htloops::Mesh mesh_of(const py::array& points, const py::array& triangles);

/// a vertex by its number; throws `std::invalid_argument` if there is none.
htloops::Mesh::Vertex_index vertex_of(const htloops::Mesh& mesh, py::ssize_t number);

/// values by vertex, of any real type.
std::vector<double> values_of(const py::array& values, std::size_t number_of_vertices);

/// an array that takes over what is in a vector.
template <typename Number> py::array_t<Number> array_of(std::vector<Number> numbers) {
  auto owner = std::make_unique<std::vector<Number>>(std::move(numbers));
  const py::capsule base(owner.get(), [](void* p) { delete static_cast<std::vector<Number>*>(p); });
  const std::vector<Number>& kept = *owner.release();
  return py::array_t<Number>(static_cast<py::ssize_t>(kept.size()), kept.data(), base);
}

/// the same, in rows.
template <typename Number>
py::array_t<Number> array_of(std::vector<Number> numbers, py::ssize_t columns) {
  const auto rows = static_cast<py::ssize_t>(numbers.size()) / columns;
  return array_of(std::move(numbers)).reshape({rows, columns});
}

/// the points and the faces of a mesh without holes in its numbering.
std::pair<py::array, py::array> arrays_of(const htloops::Mesh& mesh);
std::pair<py::array, py::array> arrays_of(const CGAL::Handle_tunnel_loops::generators::Soup& soup);

} // namespace htl_python

#endif // HTL_PYTHON_ARRAYS_H
