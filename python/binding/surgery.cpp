// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "surgery.h"

#include "loop_records.h"
#include "waiting.h"

#include "htloops/draw/cut_exports.h"
#include "htloops/solve/backends.h"
#include "htloops/solve/cut_solver.h"
#include "htloops/solve/dual_cut_solver.h"
#include "htloops/solve/removal_solver.h"
#include "htloops/solve/solvers.h"

#include <pybind11/stl.h>

#include <map>
#include <stdexcept>

namespace htl_python {
namespace {

using htloops::Mesh;
namespace htl = CGAL::Handle_tunnel_loops;

htl::Removal_method method_of(const std::string& name) {
  static const std::map<std::string, htl::Removal_method> methods = {
      {"cut", htl::Removal_method::CUT},
      {"fill", htl::Removal_method::FILL},
      {"cheapest", htl::Removal_method::CHEAPEST}};
  const auto it = methods.find(name);
  if(it == methods.end())
    throw std::invalid_argument("by is 'cut', 'fill' or 'cheapest', not '" + name + "'");
  return it->second;
}

template <typename Value>
std::optional<Value> optional_of(const py::dict& options, const char* name) {
  try {
    return py::cast<std::optional<Value>>(options[name]);
  } catch(const py::cast_error&) {
    throw std::invalid_argument(std::string(name) + " cannot be " +
                                std::string(py::repr(options[name])));
  }
}

htloops::Removal_options options_of(const py::dict& options, int threads) {
  htloops::Removal_options result;
  result.target_genus = optional_of<std::size_t>(options, "genus").value_or(0);
  result.pairs = optional_of<std::vector<std::size_t>>(options, "pairs");
  if(const auto length = optional_of<double>(options, "shorter_than"))
    result.maximal_length = *length;
  if(const auto length = optional_of<double>(options, "necks"))
    result.maximal_neck_length = result.maximal_length = *length;
  if(const auto box = optional_of<std::array<std::array<double, 3>, 2>>(options, "box"))
    result.box = CGAL::Bbox_3((*box)[0][0], (*box)[0][1], (*box)[0][2], (*box)[1][0], (*box)[1][1],
                              (*box)[1][2]);
  result.method = method_of(py::cast<std::string>(options["by"]));
  result.number_of_threads = threads;
  return result;
}

py::list records_of(const std::vector<htl::Removed_handle>& removed) {
  static const char* const ways[] = {"cut", "fill", "whole"};
  py::list list;
  for(const htl::Removed_handle& handle : removed) {
    py::dict record;
    record["pair"] = handle.pair;
    record["by"] = ways[static_cast<int>(handle.by)];
    record["length"] = handle.length;
    record["area"] = handle.area;
    record["volume"] = handle.volume;
    list.append(record);
  }
  return list;
}

py::list records_of(const std::vector<htl::Refused_handle>& refused) {
  py::list list;
  for(const htl::Refused_handle& handle : refused) {
    py::dict record;
    record["pair"] = handle.pair;
    record["length"] = handle.length;
    record["reason"] = handle.reason;
    list.append(record);
  }
  return list;
}

py::dict record_of(const htl::Removal_report& report) {
  py::dict record;
  record["genus_before"] = report.genus_before;
  record["genus_after"] = report.genus_after;
  record["components_before"] = report.components_before;
  record["components_after"] = report.components_after;
  record["removed"] = records_of(report.removed);
  record["refused"] = records_of(report.refused);
  record["removed_necks"] = records_of(report.removed_necks);
  record["refused_necks"] = records_of(report.refused_necks);
  return record;
}

using Origins = Mesh::Property_map<Mesh::Face_index, std::int64_t>;

Origins number_faces(Mesh& mesh) {
  const Origins origins =
      mesh.add_property_map<Mesh::Face_index, std::int64_t>("f:origin", -1).first;
  for(const Mesh::Face_index f : mesh.faces())
    origins[f] = f.idx();
  return origins;
}

} // namespace

py::tuple remove_handles(const py::array& points,
                         const py::array& triangles,
                         const py::dict& given,
                         int threads,
                         const py::object& progress) {
  Mesh mesh = mesh_of(points, triangles);
  const Origins origins = number_faces(mesh);
  const htloops::Removal_options options = options_of(given, threads);
  htloops::Pairs pairs;
  const bool has_loops = !given["loops"].is_none();
  if(has_loops)
    pairs = pairs_of(py::cast<py::dict>(given["loops"]), mesh);
  htloops::Removal_answer answer;
  wait_for(progress, [&](htloops::Progress& told) {
    if(!has_loops) {
      htloops::Solve_options solve_options;
      solve_options.number_of_threads = threads;
      pairs = htloops::solve_on_host(mesh, solve_options, told).pairs;
    }
    answer = htloops::remove_handles(mesh, pairs, options, told);
    mesh.collect_garbage();
  });
  std::vector<std::int64_t> origin;
  for(const Mesh::Face_index f : mesh.faces())
    origin.push_back(origins[f]);
  const auto [new_points, new_triangles] = arrays_of(mesh);
  return py::make_tuple(new_points, new_triangles, array_of(std::move(origin)),
                        record_of(answer.report));
}

py::tuple cut_to_disk(const py::array& points,
                      const py::array& triangles,
                      const std::vector<py::ssize_t>& cones,
                      bool cut_spheres,
                      int threads,
                      const py::object& progress) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Cut_options options;
  for(const py::ssize_t cone : cones)
    options.cones.push_back(vertex_of(mesh, cone));
  options.do_cut_spheres = cut_spheres;
  options.number_of_threads = threads;
  htloops::Cut_answer answer;
  CGAL::Handle_tunnel_loops::generators::Soup opened;
  wait_for(progress, [&](htloops::Progress& told) {
    answer = htloops::find_cut(mesh, options, told);
    opened = htloops::opened_mesh(mesh, answer.edges);
  });
  std::vector<std::int64_t> edges;
  for(const Mesh::Edge_index e : answer.edges)
    for(const int end : {0, 1})
      edges.push_back(mesh.vertex(e, static_cast<unsigned>(end)).idx());
  const auto [new_points, new_triangles] = arrays_of(opened);
  py::dict report;
  report["edges"] = array_of(std::move(edges), 2);
  report["length"] = answer.length;
  report["genus"] = answer.genus;
  return py::make_tuple(new_points, new_triangles, report);
}

py::list dual_cuts(const py::array& points,
                   const py::array& triangles,
                   int threads,
                   const py::object& progress) {
  const Mesh mesh = mesh_of(points, triangles);
  htloops::Dual_cuts answer;
  wait_for(progress,
           [&](htloops::Progress& told) { answer = htloops::find_dual_cuts(mesh, threads, told); });
  py::list cuts;
  for(const htloops::Dual_cut& cut : answer.cuts) {
    std::vector<std::int64_t> edges, times;
    for(const auto& [h, number] : cut.edges) {
      edges.push_back(mesh.source(h).idx());
      edges.push_back(mesh.target(h).idx());
      times.push_back(number);
    }
    py::dict record;
    record["loop"] = record_of(mesh, {&cut.loop});
    record["kind"] = htloops::name_of(cut.loop.type());
    record["pair"] = cut.loop.pair_index();
    record["edges"] = array_of(std::move(edges), 2);
    record["times"] = array_of(std::move(times));
    cuts.append(record);
  }
  return cuts;
}

} // namespace htl_python
