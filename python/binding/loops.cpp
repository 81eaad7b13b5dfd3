// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "loops.h"

#include "loop_records.h"
#include "waiting.h"

#include "htloops/draw/loops_page.h"
#include "htloops/failure.h"
#include "htloops/solve/backends.h"
#include "htloops/solve/boundaries.h"
#include "htloops/solve/certification.h"
#include "htloops/write/pair_table.h"

#include <stdexcept>

namespace htl_python {

using htloops::Mesh;

py::dict find_loops(const py::array& points,
                    const py::array& triangles,
                    const std::string& basis,
                    int threads,
                    const py::object& seed,
                    bool waists,
                    const py::object& progress) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Solve_options options;
  options.basis_kind = basis_kind(basis);
  options.number_of_threads = threads;
  if(!seed.is_none())
    options.seed = vertex_of(mesh, py::cast<py::ssize_t>(seed));
  htloops::Answer answer;
  wait_for(progress, [&](htloops::Progress& told) {
    answer = htloops::choose_backend("auto").solve(mesh, options, told);
    if(answer.statistics.number_of_boundaries > 0)
      answer.boundaries = htloops::find_boundaries(mesh, waists);
  });
  return record_of(mesh, answer);
}

py::dict certify(const py::array& points, const py::array& triangles, const py::dict& loops) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Pairs pairs = pairs_of(loops, mesh);
  const auto kind = basis_kind(py::cast<std::string>(loops["basis"]));
  CGAL::Handle_tunnel_loops::Certificate certificate;
  wait_for(py::none(),
           [&](htloops::Progress&) { certificate = htloops::certify(mesh, pairs, kind, true); });
  py::dict record;
  add_certificate(certificate, record);
  return record;
}

void write_page(const py::array& points,
                const py::array& triangles,
                const py::dict& loops,
                const std::string& file,
                const std::string& title) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Answer answer;
  answer.pairs = pairs_of(loops, mesh);
  try {
    wait_for(py::none(), [&](htloops::Progress&) {
      answer.boundaries = htloops::find_boundaries(mesh, false);
      write_loops_page(file, {}, title, mesh, answer, htloops::list_pairs(mesh, answer.pairs),
                       std::to_string(answer.pairs.size()) + " pairs of loops\n");
    });
  } catch(const htloops::Failure& failure) {
    PyErr_SetString(PyExc_OSError, failure.what());
    throw py::error_already_set();
  }
}

} // namespace htl_python
