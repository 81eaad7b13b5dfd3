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

#include "app/draw/meshes.h"
#include "app/solve/cut_solver.h"
#include "app/solve/removal_solver.h"

#include <pybind11/stl.h>

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace htl_python {
namespace {

using htloops::Mesh;
using namespace py::literals;
namespace htl = CGAL::Handle_tunnel_loops;

const std::map<std::string, htl::Removal_method> methods = {
    {"cut", htl::Removal_method::CUT},
    {"fill", htl::Removal_method::FILL},
    {"smallest-change", htl::Removal_method::SMALLEST_CHANGE},
    {"cheapest", htl::Removal_method::SMALLEST_CHANGE}};

template <typename Value> std::optional<Value> chosen(const py::dict& options, const char* name) {
  return py::cast<std::optional<Value>>(options[name]);
}

htloops::Removal_options options_of(const py::dict& options) {
  htloops::Removal_options result;
  result.target_genus = chosen<std::size_t>(options, "genus").value_or(0);
  result.pairs = chosen<std::vector<std::size_t>>(options, "pairs");
  if(const auto length = chosen<double>(options, "shorter_than"))
    result.maximal_length = *length;
  if(const auto length = chosen<double>(options, "necks"))
    result.maximal_length = result.maximal_neck_length = *length;
  if(const auto length = chosen<double>(options, "channels")) {
    result.maximal_length = result.maximal_neck_length = *length;
    result.only_channels = true;
  }
  if(const auto box = chosen<std::array<double, 6>>(options, "box"))
    result.box = CGAL::Bbox_3((*box)[0], (*box)[1], (*box)[2], (*box)[3], (*box)[4], (*box)[5]);
  if(const auto range = chosen<std::array<double, 2>>(options, "bores")) {
    result.minimal_bore_diameter = (*range)[0];
    result.maximal_bore_diameter = (*range)[1];
  }
  result.method = methods.at(py::cast<std::string>(options["by"]));
  for(const auto& [pair, by] : py::cast<std::map<std::size_t, std::string>>(options["methods"]))
    result.methods[pair] = methods.at(by);
  result.force = py::cast<bool>(options["force"]);
  return result;
}

py::dict words_of(const htl::Shape_change& change) {
  return py::dict("volume_removed"_a = change.volume_removed,
                  "volume_added"_a = change.volume_added, "cap_area"_a = change.cap_area,
                  "cap_ratio"_a = change.cap_ratio, "displacement"_a = change.displacement,
                  "burial"_a = change.burial, "sharpest_angle"_a = change.sharpest_angle,
                  "box_growth"_a = change.box_growth);
}

py::list records_of(const std::vector<htl::Removed_handle>& removed) {
  static const char* const ways[] = {"cut", "fill", "whole"};
  py::list list;
  for(const htl::Removed_handle& handle : removed)
    list.append(py::dict("pair"_a = handle.pair, "by"_a = ways[static_cast<int>(handle.by)],
                         "length"_a = handle.length, "area"_a = handle.area,
                         "volume"_a = handle.volume, "change"_a = words_of(handle.change)));
  return list;
}

py::list records_of(const std::vector<htl::Refused_handle>& refused) {
  py::list list;
  for(const htl::Refused_handle& handle : refused)
    list.append(
        py::dict("pair"_a = handle.pair, "length"_a = handle.length, "reason"_a = handle.reason));
  return list;
}

py::dict words_of(const htl::Removal_report& report) {
  return py::dict("genus_before"_a = report.genus_before, "genus_after"_a = report.genus_after,
                  "components_before"_a = report.components_before,
                  "components_after"_a = report.components_after,
                  "change"_a = words_of(report.change()), "removed"_a = records_of(report.removed),
                  "refused"_a = records_of(report.refused),
                  "removed_necks"_a = records_of(report.removed_necks),
                  "refused_necks"_a = records_of(report.refused_necks));
}

py::tuple remove_handles(const py::array& points,
                         const py::array& triangles,
                         const py::dict& loops,
                         const py::dict& chosen,
                         int threads,
                         Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Removal_options options = options_of(chosen);
  const htloops::Pairs pairs = pairs_of(loops, mesh);
  const htloops::Removal_answer answer =
      compute(threads, watch, [&] { return htloops::remove_handles(mesh, pairs, options, watch); });
  const py::tuple arrays = arrays_of(answer.mesh);
  py::dict words = words_of(answer.report);
  words["vertex_origin"] = array_of(answer.vertex_origins);
  words["face_parent"] = array_of(answer.face_parents);
  return py::make_tuple(arrays[0], arrays[1], array_of(answer.face_origins), words);
}

htloops::Face_cuts flags_of(const Mesh& mesh,
                            const std::vector<std::array<py::ssize_t, 2>>& edges) {
  if(edges.empty())
    return {};
  htloops::Face_cuts flags(mesh.number_of_halfedges(), 0);
  for(const auto& [u, v] : edges) {
    const Mesh::Halfedge_index h = mesh.halfedge(vertex_of(mesh, u), vertex_of(mesh, v));
    if(h == Mesh::Halfedge_index())
      throw std::invalid_argument("avoid: the mesh has no edge from " + std::to_string(u) + " to " +
                                  std::to_string(v));
    flags[mesh.edge(h).idx()] = 1;
  }
  return flags;
}

htloops::Cut_options cut_options_of(const Mesh& mesh, const py::dict& chosen) {
  htloops::Cut_options options;
  options.cones = vertices_of(mesh, py::cast<std::vector<py::ssize_t>>(chosen["cones"]));
  options.avoided =
      flags_of(mesh, py::cast<std::vector<std::array<py::ssize_t, 2>>>(chosen["avoid"]));
  options.do_cut_spheres = py::cast<bool>(chosen["cut_spheres"]);
  return options;
}

py::tuple cut_to_disk(const py::array& points,
                      const py::array& triangles,
                      const py::dict& chosen,
                      int threads,
                      Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Cut_options options = cut_options_of(mesh, chosen);
  const auto opened = compute(threads, watch, [&] {
    return htloops::opened_mesh(mesh, htloops::find_cut(mesh, options, watch).edges);
  });
  return py::make_tuple(rows_of<double>(opened.points), rows_of<std::int64_t>(opened.triangles));
}

py::array cut_edges(const py::array& points,
                    const py::array& triangles,
                    const py::dict& chosen,
                    int threads,
                    Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Cut_options options = cut_options_of(mesh, chosen);
  const auto edges =
      compute(threads, watch, [&] { return htloops::find_cut(mesh, options, watch).edges; });
  std::vector<std::int64_t> ends;
  for(const Mesh::Edge_index e : edges)
    for(const int i : {0, 1})
      ends.push_back(mesh.vertex(e, i).idx());
  return array_of(ends, 2);
}

py::list dual_cuts(const py::array& points, const py::array& triangles, int threads, Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const htloops::Dual_cuts answer =
      compute(threads, watch, [&] { return htloops::find_dual_cuts(mesh, 0, watch); });
  py::list cuts;
  for(const htloops::Dual_cut& cut : answer.cuts) {
    std::vector<std::int64_t> edges, times;
    for(const auto& [h, number] : cut.edges) {
      edges.push_back(mesh.source(h).idx());
      edges.push_back(mesh.target(h).idx());
      times.push_back(number);
    }
    cuts.append(py::dict("loop"_a = record_of(mesh, {&cut.loop}),
                         "kind"_a = htloops::name_of(cut.loop.type()),
                         "pair"_a = cut.loop.pair_index(), "edges"_a = array_of(edges, 2),
                         "times"_a = array_of(times)));
  }
  return cuts;
}

} // namespace

void add_surgery(py::module_& module) {
  module.def("remove_handles", &remove_handles);
  module.def("cut_to_disk", &cut_to_disk);
  module.def("cut_edges", &cut_edges);
  module.def("dual_cuts", &dual_cuts);
}

} // namespace htl_python
