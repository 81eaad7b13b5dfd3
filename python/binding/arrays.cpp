// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "arrays.h"

#include "htloops/mend/mending.h"
#include "htloops/read/mesh_builder.h"
#include "htloops/read/soup.h"
#include "htloops/read/soup_diagnosis.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace htl_python {
namespace {

using htloops::Soup;

[[noreturn]] void fail_with_shape(const py::array& array, const std::string& expected) {
  throw std::invalid_argument(expected + "; its shape is " +
                              std::string(py::str(array.attr("shape"))));
}

// Calls visit(row, column, number) for an array of numbers of one type, wherever they lie.
template <typename Number, typename Visit>
void for_each_number(const py::array& array, Visit visit) {
  const char* const begin = static_cast<const char*>(array.data());
  for(py::ssize_t i = 0; i < array.shape(0); ++i)
    for(py::ssize_t j = 0; j < array.shape(1); ++j) {
      Number number;
      std::memcpy(&number, begin + i * array.strides(0) + j * array.strides(1), sizeof number);
      visit(i, j, number);
    }
}

template <typename Number> bool is_of(const py::array& array) {
  return array.dtype().is(py::dtype::of<Number>());
}

void read_points(const py::array& array, Soup& soup) {
  if(array.ndim() != 2 || array.shape(1) != 3)
    fail_with_shape(array, "V has to be an array of shape (n, 3), the coordinates of the vertices");
  soup.points.resize(static_cast<std::size_t>(array.shape(0)));
  double row[3];
  const auto set = [&](py::ssize_t i, py::ssize_t j, auto x) {
    row[j] = static_cast<double>(x);
    if(j == 2)
      soup.points[static_cast<std::size_t>(i)] = htloops::Point(row[0], row[1], row[2]);
  };
  if(is_of<double>(array))
    for_each_number<double>(array, set);
  else if(is_of<float>(array))
    for_each_number<float>(array, set);
  else
    for_each_number<double>(py::array_t<double, py::array::forcecast>(array), set);
}

template <typename Integer> void read_corners(const py::array& array, Soup& soup) {
  const std::size_t bound = soup.points.size();
  for_each_number<Integer>(array, [&](py::ssize_t i, py::ssize_t j, Integer vertex) {
    const bool is_negative = vertex < Integer(0);
    if(is_negative || static_cast<std::uint64_t>(vertex) >= bound)
      throw Mesh_error("face " + std::to_string(i) + " names vertex " + std::to_string(vertex) +
                       ", of " + std::to_string(bound));
    soup.set_corner(soup.faces[static_cast<std::size_t>(i)], static_cast<std::size_t>(j),
                    static_cast<std::uint32_t>(vertex));
  });
}

void read_faces(const py::array& array, Soup& soup) {
  if(array.ndim() != 2 || array.shape(1) < 3)
    fail_with_shape(array, "F has to be an array of shape (m, 3), three vertices for each face");
  soup.faces.resize(static_cast<std::size_t>(array.shape(0)));
  for(htloops::Soup_face& face : soup.faces)
    face.resize(static_cast<std::size_t>(array.shape(1)));
  if(is_of<std::int32_t>(array))
    read_corners<std::int32_t>(array, soup);
  else if(is_of<std::int64_t>(array))
    read_corners<std::int64_t>(array, soup);
  else if(is_of<std::uint32_t>(array))
    read_corners<std::uint32_t>(array, soup);
  else if(is_of<std::uint64_t>(array))
    read_corners<std::uint64_t>(array, soup);
  else if(const char kind = array.dtype().kind(); kind == 'i' || kind == 'u')
    read_corners<std::int64_t>(py::array_t<std::int64_t, py::array::forcecast>(array), soup);
  else
    throw std::invalid_argument("F has to be an array of integers, not of " +
                                std::string(py::str(array.dtype())));
}

// As the library does, but before anything is copied.
void check_size(const py::array& points, const py::array& faces) {
  constexpr py::ssize_t most = py::ssize_t(1) << 31;
  if(points.ndim() == 2 && points.shape(0) > most)
    throw Mesh_error("the mesh has more than 2^31 vertices");
  if(faces.ndim() == 2 && faces.shape(1) > 0 && faces.shape(0) > most / faces.shape(1))
    throw Mesh_error("the mesh has more than 2^31 halfedges");
}

} // namespace

htloops::Soup soup_of(const py::array& points, const py::array& faces) {
  Soup soup;
  check_size(points, faces);
  read_points(points, soup);
  read_faces(faces, soup);
  return soup;
}

namespace {

const char* advice_on(const Soup& soup) {
  const htloops::Soup mended = htloops::mend(soup, {true, true}).soup;
  return htloops::diagnose(mended).defects.empty() ? "\nrepair() mends it" : "";
}

} // namespace

void throw_if_no_surface(const htloops::Diagnosis& diagnosis, const char* advice) {
  std::string message;
  for(const htloops::Defect& defect : diagnosis.defects)
    message += (message.empty() ? "" : "\n") + defect.message;
  if(!message.empty())
    throw Mesh_error(message + advice);
}

htloops::Mesh mesh_of(const py::array& points, const py::array& triangles) {
  const Soup soup = soup_of(points, triangles);
  const py::gil_scoped_release others_may_run;
  const htloops::Diagnosis diagnosis = htloops::diagnose(soup);
  if(!diagnosis.defects.empty())
    throw_if_no_surface(diagnosis, advice_on(soup));
  return htloops::build_mesh(soup, diagnosis);
}

htloops::Mesh::Vertex_index vertex_of(const htloops::Mesh& mesh, py::ssize_t number) {
  const auto count = static_cast<py::ssize_t>(mesh.number_of_vertices());
  const htloops::Mesh::Vertex_index v(static_cast<std::uint32_t>(number));
  if(number < 0 || number >= count || mesh.is_isolated(v))
    throw std::invalid_argument("vertex " + std::to_string(number) +
                                (number < 0 || number >= count
                                     ? " is not one of the " + std::to_string(count)
                                     : " has no face"));
  return v;
}

std::vector<double> values_of(const py::array& values, std::size_t number_of_vertices) {
  const py::array_t<double, py::array::c_style | py::array::forcecast> numbers(values);
  if(numbers.ndim() != 1 || static_cast<std::size_t>(numbers.shape(0)) != number_of_vertices)
    throw std::invalid_argument("f has to be an array of " + std::to_string(number_of_vertices) +
                                " numbers, one for each vertex");
  return {numbers.data(), numbers.data() + number_of_vertices};
}

std::pair<py::array, py::array> arrays_of(const htloops::Mesh& mesh) {
  std::vector<double> points;
  points.reserve(3 * mesh.number_of_vertices());
  for(const htloops::Mesh::Vertex_index v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
      points.push_back(mesh.point(v)[i]);
  std::vector<std::int64_t> corners;
  corners.reserve(3 * mesh.number_of_faces());
  for(const htloops::Mesh::Face_index f : mesh.faces())
    for(const htloops::Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(f), mesh))
      corners.push_back(mesh.source(h).idx()); // so that corners stay in their order
  return {array_of(std::move(points), 3), array_of(std::move(corners), 3)};
}

std::pair<py::array, py::array> arrays_of(const CGAL::Handle_tunnel_loops::generators::Soup& soup) {
  std::vector<double> points;
  points.reserve(3 * soup.points.size());
  for(const auto& p : soup.points)
    points.insert(points.end(), p.begin(), p.end());
  std::vector<std::int64_t> corners;
  corners.reserve(3 * soup.triangles.size());
  for(const auto& triangle : soup.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return {array_of(std::move(points), 3), array_of(std::move(corners), 3)};
}

} // namespace htl_python
