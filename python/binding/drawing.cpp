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
#include "app/draw/pages.h"
#include "app/draw/pictures.h"
#include "app/draw/scenes.h"
#include "app/solve/boundaries.h"
#include "app/solve/details.h"
#include "app/words.h"
#include "app/write/tables.h"
#include "window/window.h"

#include <pybind11/stl.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace htl_python {
namespace {

using htl_scene::Scene;
using htloops::counted;
using htloops::Mesh;
using htloops::View;

const htloops::Choice choice = {"pairs = [", "]"};

// Makes the scene, without Python. Titles end before the name.
using Make_scene = std::function<Scene(const View&)>;

Make_scene scene_of_loops(const Mesh& mesh, const py::dict& record) {
  return [&mesh, pairs = pairs_of(record, mesh)](const View& view) {
    htloops::Answer answer; // only what is drawn
    answer.pairs = pairs;
    answer.boundaries = htloops::find_boundaries(mesh, false);
    answer.bores = htloops::find_bores(mesh, answer.pairs);
    return htloops::scene_of_loops(view, "", mesh, answer, htloops::list_pairs(mesh, answer),
                                   counted(pairs.size(), "pair", "pairs") + " of loops\n", choice);
  };
}

Make_scene scene_of_skeleton(const Mesh& mesh, const py::dict& record) {
  const htloops::Skeleton_answer answer = skeleton_of(record);
  require(answer.vertex_point.size() == mesh.number_of_vertices(),
          "the skeleton belongs to another mesh");
  return [&mesh, answer](const View& view) {
    const std::string words = counted(answer.arcs.size(), "arc", "arcs") + ", " +
                              counted(htloops::number_of_cycles(answer.graph), "cycle", "cycles") +
                              (answer.certificate() ? ", certified\n" : ", not certified\n");
    return htloops::scene_of_skeleton(view, "", mesh, answer, words);
  };
}

Make_scene scene_of_reeb_graph(const Mesh& mesh, const py::dict& record) {
  return [&mesh, answer = reeb_answer_of(record, mesh),
          cycles = record["number_of_cycles"].cast<std::size_t>()](const View& view) {
    const std::string words = counted(num_edges(answer.graph), "arc", "arcs") + ", " +
                              counted(cycles, "cycle", "cycles") + "\n";
    return htloops::scene_of_reeb_graph(view, "", mesh, answer, htloops::list_arcs(mesh, answer),
                                        words);
  };
}

Make_scene scene_of_removal(const Mesh& mesh, const py::dict& record) {
  const Mesh after = mesh_of(record["points"], record["triangles"]);
  htloops::Removal_answer removal = removal_of(record["report"], after);
  for(const std::int64_t origin : removal.face_origins)
    require(origin < static_cast<std::int64_t>(mesh.number_of_faces()),
            "the handles were not removed from this mesh");
  return [&mesh, removal, pairs = pairs_of(record["loops"], mesh)](const View& view) {
    htloops::Answer answer;
    answer.pairs = pairs;
    const htloops::Pair_listing listing =
        list_removals(htloops::list_pairs(mesh, answer), removal.report);
    const std::string words = htloops::summary(removal.report);
    return htloops::scene_of_removal(view, {"", choice, mesh, pairs, listing, removal, words});
  };
}

Make_scene scene_of_cut(const Mesh& mesh, const py::dict& record) {
  return [&mesh, edges = edges_between(record["edges"], mesh)](const View& view) {
    return htloops::scene_of_cut(view, "", mesh, htloops::lines_of(mesh, edges),
                                 counted(edges.size(), "edge", "edges") + "\n");
  };
}

Make_scene scene_of(const Mesh& mesh, const std::string& kind, const py::dict& record) {
  return kind == "loops"      ? scene_of_loops(mesh, record)
         : kind == "skeleton" ? scene_of_skeleton(mesh, record)
         : kind == "reeb"     ? scene_of_reeb_graph(mesh, record)
         : kind == "removal"  ? scene_of_removal(mesh, record)
                              : scene_of_cut(mesh, record);
}

void page(const std::string& file,
          const py::array& points,
          const py::array& triangles,
          const std::string& kind,
          const py::dict& record,
          const std::string& title,
          const Watch& watch) {
  const Mesh mesh = mesh_of(points, triangles);
  const Make_scene make = scene_of(mesh, kind, record);
  compute(0, watch, [&] {
    Scene scene = make({});
    scene.title += title;
    scene.name = title;
    htloops::write_page(file, scene);
  });
}

void picture(const std::string& file,
             const py::array& points,
             const py::array& triangles,
             const std::string& kind,
             const py::dict& record,
             const std::vector<double>& size,
             const Watch& watch) {
  if(!htloops::has_pictures)
    throw std::invalid_argument("this build cannot draw pictures: it was made without libpng");
  const Mesh mesh = mesh_of(points, triangles);
  const Make_scene make = scene_of(mesh, kind, record);
  htloops::Picture_options options;
  options.file = file;
  options.size = size;
  htloops::check_picture_size(options);
  View view;
  view.is_for_rows = false; // only pages ask for rows
  compute(0, watch, [&] { htloops::export_picture(options, make(view)); });
}

} // namespace

void add_drawing(py::module_& module) {
  module.attr("has_pictures") = htloops::has_pictures;
  module.def("page", &page);
  module.def("picture", &picture);
}

} // namespace htl_python
