// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "answers.h"
#include "arrays.h"
#include "functions.h"
#include "loop_records.h"
#include "watch.h"

#include "app/draw/meshes.h"
#include "app/solve/cut_solver.h"
#include "app/solve/details.h"
#include "app/solve/removal_solver.h"
#include "app/write/tables.h"

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
                  "box_growth"_a = change.box_growth, "crossings"_a = change.crossings);
}

py::list records_of(const std::vector<htl::Removed_handle>& removed) {
  py::list list;
  for(const htl::Removed_handle& handle : removed)
    list.append(py::dict("pair"_a = handle.pair, "by"_a = htloops::name_of(handle),
                         "length"_a = handle.length, "area"_a = handle.area,
                         "volume"_a = handle.volume, "change"_a = words_of(handle.change),
                         "patch"_a = handle.patch));
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

// Numbers of patches, -1 for none.
std::vector<std::int64_t> patch_numbers(const std::vector<std::size_t>& patches) {
  std::vector<std::int64_t> result;
  for(const std::size_t patch : patches)
    result.push_back(patch == htloops::Removal_answer::no_patch ? -1
                                                                : static_cast<std::int64_t>(patch));
  return result;
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
  words["face_patch"] = array_of(patch_numbers(answer.patches));
  return py::make_tuple(arrays[0], arrays[1], array_of(answer.face_origins), words);
}

Mesh::Edge_index
edge_between(const Mesh& mesh, py::ssize_t u, py::ssize_t v, const std::string& name) {
  const Mesh::Halfedge_index h = mesh.halfedge(vertex_of(mesh, u), vertex_of(mesh, v));
  if(h == Mesh::Halfedge_index())
    throw std::invalid_argument(name + ": the mesh has no edge from " + std::to_string(u) + " to " +
                                std::to_string(v));
  return mesh.edge(h);
}

htloops::Face_cuts flags_of(const Mesh& mesh,
                            const std::vector<std::array<py::ssize_t, 2>>& edges) {
  if(edges.empty())
    return {};
  htloops::Face_cuts flags(mesh.number_of_halfedges(), 0);
  for(const auto& [u, v] : edges) {
    flags[edge_between(mesh, u, v, "avoid").idx()] = 1;
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

// As far as it is drawn.
std::vector<htl::Removed_handle> removed_of(const py::list& records) {
  std::vector<htl::Removed_handle> removed;
  for(const py::handle& record : records) {
    const auto number = [&](const char* name) { return record[name].cast<double>(); };
    const py::dict change = record["change"];
    htl::Removed_handle handle{};
    handle.pair = record["pair"].cast<std::size_t>();
    const auto by = record["by"].cast<std::string>();
    handle.by = by == "cut"    ? htl::Removal_way::CUT
                : by == "fill" ? htl::Removal_way::FILL
                               : htl::Removal_way::WHOLE;
    handle.length = number("length");
    handle.area = number("area");
    handle.volume = number("volume");
    handle.change.volume_removed = change["volume_removed"].cast<double>();
    handle.change.volume_added = change["volume_added"].cast<double>();
    handle.change.cap_ratio = change["cap_ratio"].cast<double>();
    handle.change.displacement = change["displacement"].cast<double>();
    handle.change.sharpest_angle = change["sharpest_angle"].cast<double>();
    handle.patch = record["patch"].cast<std::size_t>();
    removed.push_back(handle);
  }
  return removed;
}

std::vector<htl::Refused_handle> refused_of(const py::list& records) {
  std::vector<htl::Refused_handle> refused;
  for(const py::handle& record : records)
    refused.push_back({record["pair"].cast<std::size_t>(), record["length"].cast<double>(),
                       record["reason"].cast<std::string>()});
  return refused;
}

} // namespace

htloops::Removal_answer removal_of(const py::dict& report, const Mesh& after) {
  htloops::Removal_answer removal;
  removal.mesh = after;
  removal.report = {report["genus_before"].cast<std::size_t>(),
                    report["genus_after"].cast<std::size_t>(),
                    report["components_before"].cast<std::size_t>(),
                    report["components_after"].cast<std::size_t>(),
                    removed_of(report["removed"]),
                    refused_of(report["refused"]),
                    removed_of(report["removed_necks"]),
                    refused_of(report["refused_necks"])};
  const std::size_t patches = removal.report.removed.size() + removal.report.removed_necks.size();
  const auto face_patch = numbers_of<std::int64_t>(report, "face_patch");
  require(face_patch.size() == after.number_of_faces(), "the report belongs to another mesh");
  for(const std::int64_t patch : face_patch) {
    require(patch < static_cast<std::int64_t>(patches),
            "the report refers to patches that do not exist");
    removal.patches.push_back(patch < 0 ? htloops::Removal_answer::no_patch
                                        : static_cast<std::size_t>(patch));
  }
  for(const auto* handles : {&removal.report.removed, &removal.report.removed_necks})
    for(const htl::Removed_handle& handle : *handles)
      require(handle.patch < patches, "the report refers to patches that do not exist");
  removal.face_origins = numbers_of<std::int64_t>(report, "face_origin");
  return removal;
}

std::vector<Mesh::Edge_index> edges_between(const py::array& ends, const Mesh& mesh) {
  std::vector<Mesh::Edge_index> edges;
  for(const auto& [u, v] : ends.cast<std::vector<std::array<py::ssize_t, 2>>>())
    edges.push_back(edge_between(mesh, u, v, "the cut"));
  return edges;
}

void add_surgery(py::module_& module) {
  module.def("remove_handles", &remove_handles);
  module.def("check_noise", &htloops::check_noise);
  module.def("cut_to_disk", &cut_to_disk);
  module.def("cut_edges", &cut_edges);
  module.def("dual_cuts", &dual_cuts);
}

} // namespace htl_python
