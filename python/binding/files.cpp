// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "files.h"

#include "htloops/mend/mending.h"
#include "htloops/mend/mesh_reader.h"
#include "htloops/read/soup_diagnosis.h"

#include <pybind11/stl.h>

namespace htl_python {
namespace {

py::array_t<std::int64_t> triangles_of(const htloops::Soup& soup) {
  std::vector<std::int64_t> corners;
  corners.reserve(3 * soup.faces.size());
  for(const htloops::Soup_face& face : soup.faces)
    corners.insert(corners.end(), face.begin(), face.end());
  return array_of(std::move(corners), 3);
}

py::array_t<double> points_of(const htloops::Soup& soup) {
  std::vector<double> coordinates;
  coordinates.reserve(3 * soup.points.size());
  for(const htloops::Point& p : soup.points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  return array_of(std::move(coordinates), 3);
}

} // namespace

py::tuple read(const std::string& file, bool triangulate, bool repair) {
  htloops::Mesh mesh;
  {
    const py::gil_scoped_release others_may_run;
    mesh = htloops::read_mesh(htloops::Input_file(file), {triangulate, repair}).mesh;
  }
  const auto [points, triangles] = arrays_of(mesh);
  return py::make_tuple(points, triangles);
}

py::tuple repair(const py::array& points, const py::array& faces) {
  htloops::Soup soup = soup_of(points, faces);
  htloops::Mended_soup mended;
  {
    const py::gil_scoped_release others_may_run;
    mended = htloops::mend(std::move(soup), {true, true});
    throw_if_no_surface(htloops::diagnose(mended.soup));
  }
  std::vector<std::int64_t> vertex_origin;
  for(std::uint32_t v = 0; v < mended.soup.points.size(); ++v)
    vertex_origin.push_back(mended.in_file(v));
  py::list changes;
  for(const htloops::Change& change : mended.changes)
    changes.append(py::make_tuple(change.count, change.words));
  return py::make_tuple(
      points_of(mended.soup), triangles_of(mended.soup),
      array_of(std::vector<std::int64_t>(mended.face_in_file.begin(), mended.face_in_file.end())),
      array_of(std::move(vertex_origin)), changes);
}

} // namespace htl_python
