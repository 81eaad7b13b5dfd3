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
#include "loop_records.h"
#include "watch.h"

#include "app/solve/throat_solver.h"

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace htl_python {
namespace {

using namespace py::literals;
using htloops::Throat;

py::dict record_of_throats(const htloops::Mesh& mesh, const std::vector<Throat>& throats) {
  std::vector<const htloops::Loop*> loops;
  std::vector<double> prominences;
  std::vector<bool> separating, inside, outside;
  std::vector<std::string> kinds;
  std::vector<std::optional<std::size_t>> pairs;
  std::vector<std::vector<std::int64_t>> through;
  for(const Throat& throat : throats) {
    loops.push_back(&throat.loop);
    prominences.push_back(throat.prominence);
    separating.push_back(throat.is_separating);
    inside.push_back(throat.bounds_inside);
    outside.push_back(throat.bounds_outside);
    kinds.emplace_back(htloops::name_of(throat.loop.type()));
    pairs.push_back(throat.pair);
    through.emplace_back();
    for(const htloops::Mesh::Vertex_index v : throat.through)
      through.back().push_back(v.idx());
  }
  return py::dict("prominences"_a = array_of(prominences), "separating"_a = separating,
                  "inside"_a = inside, "outside"_a = outside, "kinds"_a = kinds, "pairs"_a = pairs,
                  "through"_a = through, **record_of(mesh, loops));
}

py::dict find_throats(const py::array& points,
                      const py::array& triangles,
                      const py::dict& loops,
                      const std::vector<py::ssize_t>& through,
                      double least_prominence,
                      int threads,
                      Watch& watch) {
  const htloops::Mesh mesh = mesh_of(points, triangles);
  const htloops::Pairs pairs = pairs_of(loops, mesh);
  std::vector<htloops::Mesh::Vertex_index> vertices;
  for(const py::ssize_t v : through)
    vertices.push_back(vertex_of(mesh, v));
  return record_of_throats(
      mesh, compute(threads, watch, [&] {
        return htloops::find_throats(mesh, pairs, {}, vertices, least_prominence).all;
      }));
}

} // namespace

void add_throats(py::module_& module) { module.def("throats", &find_throats); }

} // namespace htl_python
