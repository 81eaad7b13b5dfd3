// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "arrays.h"

#include "app/mend/mending.h"
#include "app/read/soup_diagnosis.h"

#include <algorithm>
#include <string>

namespace htl_python {
namespace {

using htloops::Soup;

// Calls visit(row, numbers). Other types are converted some rows at a time, to avoid a second copy.
template <typename Number, typename Visit> void for_each_row(const py::array& array, Visit visit) {
  constexpr int flags =
      py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;
  constexpr py::ssize_t many = 1 << 14;
  for(py::ssize_t begin = 0; begin < array.shape(0); begin += many) {
    const py::ssize_t end = (std::min)(begin + many, array.shape(0));
    const py::array_t<Number, flags> rows(array[py::slice(begin, end, 1)]);
    for(py::ssize_t i = begin; i < end; ++i)
      visit(i, rows.data(i - begin, 0));
  }
}

void add_faces(const py::array& array, Soup& soup) {
  const auto size = static_cast<std::size_t>(array.shape(1));
  for_each_row<std::int64_t>(array, [&](py::ssize_t i, const std::int64_t* corners) {
    htloops::Soup_face& face = soup.faces.emplace_back();
    face.resize(size);
    for(std::size_t j = 0; j < size; ++j) {
      if(corners[j] < 0 || static_cast<std::size_t>(corners[j]) >= soup.points.size())
        throw Mesh_error("face " + std::to_string(i) + " refers to vertex " +
                         std::to_string(corners[j]) + ", which does not exist: there are " +
                         std::to_string(soup.points.size()) + " vertices");
      soup.set_corner(face, j, static_cast<std::uint32_t>(corners[j]));
    }
  });
}

const char* advice_on(const Soup& soup) {
  const Soup mended = htloops::mend(soup, {true, true}).soup;
  return htloops::diagnose(mended).empty() ? "\nrepair() fixes this" : "";
}

} // namespace

Soup soup_of(const py::array& points, const std::vector<py::array>& faces) {
  Soup soup;
  soup.points.reserve(static_cast<std::size_t>(points.shape(0)));
  for_each_row<double>(
      points, [&](py::ssize_t, const double* p) { soup.points.emplace_back(p[0], p[1], p[2]); });
  std::size_t number_of_faces = 0;
  for(const py::array& array : faces)
    number_of_faces += static_cast<std::size_t>(array.shape(0));
  soup.faces.reserve(number_of_faces);
  for(const py::array& array : faces)
    add_faces(array, soup);
  return soup;
}

void throw_if_no_surface(const std::vector<htloops::Defect>& defects, const char* advice) {
  std::string message;
  for(const htloops::Defect& defect : defects)
    message += (message.empty() ? "" : "\n") + defect.message;
  if(!message.empty())
    throw Mesh_error(message + advice);
}

htloops::Mesh mesh_of(const py::array& points, const py::array& triangles) {
  const Soup soup = soup_of(points, {triangles});
  const py::gil_scoped_release others_may_run;
  htloops::Built_mesh built = htloops::build_mesh(soup);
  if(!built.defects.empty())
    throw_if_no_surface(built.defects, advice_on(soup));
  return std::move(built.mesh);
}

htloops::Mesh::Vertex_index vertex_of(const htloops::Mesh& mesh, py::ssize_t number) {
  const auto count = static_cast<py::ssize_t>(mesh.number_of_vertices());
  if(number < 0 || number >= count)
    throw std::invalid_argument("vertex " + std::to_string(number) + " does not exist: there are " +
                                std::to_string(count) + " vertices");
  const htloops::Mesh::Vertex_index v(static_cast<std::uint32_t>(number));
  if(mesh.is_isolated(v))
    throw std::invalid_argument("vertex " + std::to_string(number) + " belongs to no face");
  return v;
}

std::vector<htloops::Mesh::Vertex_index> vertices_of(const htloops::Mesh& mesh,
                                                     const std::vector<py::ssize_t>& numbers) {
  std::vector<htloops::Mesh::Vertex_index> vertices;
  for(const py::ssize_t number : numbers)
    vertices.push_back(vertex_of(mesh, number));
  return vertices;
}

py::tuple arrays_of(const htloops::Mesh& mesh) {
  std::vector<std::int64_t> corners;
  corners.reserve(3 * mesh.number_of_faces());
  for(const htloops::Mesh::Face_index f : mesh.faces())
    for(const htloops::Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(f), mesh))
      corners.push_back(mesh.source(h).idx()); // to keep the order of the corners
  return py::make_tuple(rows_of<double>(mesh.points()), array_of(corners, 3));
}

} // namespace htl_python
