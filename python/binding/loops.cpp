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

#include "app/solve/backends.h"
#include "app/solve/certification.h"
#include "app/solve/details.h"

#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace htl_python {
namespace {

using htloops::Mesh;
using namespace py::literals;

py::dict find_loops(const py::array& points,
                    const py::array& triangles,
                    const std::string& basis,
                    int threads,
                    std::optional<py::ssize_t> seed,
                    bool waists,
                    bool layers,
                    std::optional<double> time_budget,
                    Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Solve_options options;
  options.basis_kind = basis_kind(basis);
  if(seed)
    options.seed = vertex_of(mesh, *seed);
  options.do_find_layers = layers;
  if(time_budget)
    options.maximum_running_time = *time_budget;
  return record_of(mesh, compute(threads, watch, [&] {
                     htloops::Answer answer =
                         htloops::choose_backend("auto").solve(mesh, options, watch);
                     htloops::add_details(mesh, waists, answer);
                     return answer;
                   }));
}

// The certificate of the pairs, and what is wrong with the boundary curves and the waists.
py::dict certify(const py::array& points,
                 const py::array& triangles,
                 const py::dict& record,
                 const Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Bound_loops loops = loops_of(record, mesh);
  const auto kind = basis_kind(py::cast<std::string>(record["basis"]));
  std::vector<std::string> problems;
  htloops::Certificate certificate = compute(0, watch, [&] {
    problems = htloops::problems_of_boundaries(mesh, loops.curves, loops.waists);
    return htloops::certify(mesh, loops.pairs, kind, true);
  });
  for(const std::string& problem : problems)
    certificate.failure += (certificate.failure.empty() ? "" : "\n") + problem;
  py::dict said = certificate_of(certificate);
  said["certified"] = bool(certificate) && problems.empty();
  return said;
}

using Cost = htloops::Costs::value_type;

// What is not known is a ball without points.
py::dict record_of_balls(const htloops::Measures& measures,
                         std::optional<htloops::Ball> htloops::Measure::*which) {
  std::vector<double> diameters, errors;
  std::vector<htloops::Point> throats;
  py::list curves;
  for(const htloops::Measure& measure : measures) {
    const htloops::Ball ball = (measure.*which).value_or(htloops::Ball());
    diameters.push_back(ball.diameter);
    errors.push_back(ball.error);
    throats.push_back(measure.*which ? ball.throat : htloops::Point(0., 0., 0.));
    curves.append(rows_of<double>(ball.curve));
  }
  return py::dict("diameters"_a = array_of(diameters), "errors"_a = array_of(errors),
                  "throats"_a = rows_of<double>(throats), "curves"_a = curves);
}

py::dict measure(const py::array& points,
                 const py::array& triangles,
                 const py::dict& loops,
                 int threads,
                 Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Pairs pairs = pairs_of(loops, mesh);
  const htloops::Measures measures =
      compute(threads, watch, [&] { return htloops::find_measures(mesh, pairs, watch); });
  std::vector<std::string> why;
  std::vector<double> least_noise, most_noise;
  for(std::size_t i = 0; i < measures.size(); ++i) {
    why.push_back(measures[i].why);
    const auto [least, most] = htloops::noise_of(measures[i], pairs[i]);
    least_noise.push_back(least);
    most_noise.push_back(most);
  }
  return py::dict("thickness"_a = record_of_balls(measures, &htloops::Measure::thickness),
                  "clear_width"_a = record_of_balls(measures, &htloops::Measure::clear_width),
                  "least_noise"_a = array_of(least_noise), "most_noise"_a = array_of(most_noise),
                  "why"_a = why);
}

// What cannot be is NaN, with a reason.
py::dict record_of_way(const htloops::Costs& costs,
                       std::optional<htloops::Removed_handle> Cost::*way,
                       std::string Cost::*why_not) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> areas, volumes;
  std::vector<std::string> reasons;
  for(const Cost& cost : costs) {
    areas.push_back(cost.*way ? (cost.*way)->area : unknown);
    volumes.push_back(cost.*way ? (cost.*way)->volume : unknown);
    reasons.push_back(cost.*why_not);
  }
  return py::dict("areas"_a = array_of(areas), "volumes"_a = array_of(volumes),
                  "why_not"_a = reasons);
}

py::dict removal_costs(const py::array& points,
                       const py::array& triangles,
                       const py::dict& loops,
                       int threads,
                       Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Pairs pairs = pairs_of(loops, mesh);
  const htloops::Costs costs =
      compute(threads, watch, [&] { return htloops::find_costs(mesh, pairs, watch); });
  return py::dict("cut"_a = record_of_way(costs, &Cost::cut, &Cost::why_no_cut),
                  "fill"_a = record_of_way(costs, &Cost::fill, &Cost::why_no_fill));
}

} // namespace

void add_loops(py::module_& module) {
  module.def("loops", &find_loops);
  module.def("certify", &certify);
  module.def("measure", &measure);
  module.def("removal_costs", &removal_costs);
}

} // namespace htl_python
