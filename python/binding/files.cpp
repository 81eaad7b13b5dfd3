// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "arrays.h"
#include "functions.h"
#include "watch.h"

#include "app/failure.h"
#include "app/mend/mending.h"
#include "app/mend/mesh_reader.h"
#include "app/write/mesh_writer.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace htl_python {
namespace {

py::tuple read(const std::string& name,
               std::string content,
               bool triangulate,
               bool repair,
               const Watch& watch) {
  return arrays_of(compute(0, watch, [&] {
    return htloops::read_mesh(htloops::Input_file::in_memory(name, std::move(content)),
                              {triangulate, repair})
        .mesh;
  }));
}

// They need not be a surface.
CGAL::Handle_tunnel_loops::generators::Soup written_soup(const py::array& points,
                                                         const py::array& triangles) {
  const htloops::Soup soup = soup_of(points, {triangles});
  CGAL::Handle_tunnel_loops::generators::Soup written;
  for(const auto& p : soup.points)
    written.points.push_back({p[0], p[1], p[2]});
  for(const htloops::Soup_face& face : soup.faces)
    written.triangles.push_back({face[0], face[1], face[2]});
  return written;
}

void write(const std::string& file,
           const py::array& points,
           const py::array& triangles,
           const Watch& watch) {
  htloops::check_mesh_format(file);
  const auto soup = written_soup(points, triangles);
  compute(0, watch, [&] { htloops::write_mesh(file, soup); });
}

// Nothing: all of them.
htloops::Remedies remedies_of(const std::optional<std::vector<std::string>>& steps) {
  htloops::Remedies remedies = {true, true};
  for(std::size_t i = 0; steps && i < htloops::number_of_repair_steps; ++i)
    remedies.steps[i] = std::count(steps->begin(), steps->end(),
                                   htloops::name_of(static_cast<htloops::Repair_step>(i))) != 0;
  return remedies;
}

py::tuple repair(const py::array& points,
                 const std::vector<py::array>& faces,
                 const Watch& watch,
                 const std::optional<std::vector<std::string>>& steps) {
  const htloops::Remedies remedies = remedies_of(steps);
  htloops::Soup soup = soup_of(points, faces);
  htloops::Mended_soup mended;
  compute(0, watch, [&] {
    mended = htloops::mend(std::move(soup), remedies);
    throw_if_no_surface(htloops::diagnose(mended.soup));
  });
  std::vector<std::int64_t> vertex_origin;
  for(std::uint32_t v = 0; v < mended.soup.points.size(); ++v)
    vertex_origin.push_back(mended.in_file(v));
  std::vector<std::pair<std::size_t, std::string>> changes;
  for(const htloops::Change& change : mended.changes)
    changes.emplace_back(change.count, change.words);
  return py::make_tuple(
      rows_of<double>(mended.soup.points), rows_of<std::int64_t>(mended.soup.faces),
      array_of(std::vector<std::int64_t>(mended.face_in_file.begin(), mended.face_in_file.end())),
      array_of(vertex_origin), changes);
}

} // namespace

void add_files(py::module_& module) {
  module.def("read", &read);
  module.def("write", &write);
  module.def("repair", &repair, py::arg("points"), py::arg("faces"), py::arg("watch"),
             py::arg("steps") = py::none());
}

} // namespace htl_python
