// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "loop_records.h"

#include "app/solve/boundaries.h"
#include "app/write/pair_listing.h"
#include "app/write/tables.h"

#include <pybind11/stl.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

namespace htl_python {
namespace {

using CGAL::Handle_tunnel_loops::Basis_kind;
using CGAL::Handle_tunnel_loops::Certificate;
using CGAL::Handle_tunnel_loops::Loop_linking;
using htloops::Loop;
using htloops::Mesh;
using namespace py::literals;

std::vector<const Loop*> pointers_to(const std::vector<Loop>& loops) {
  std::vector<const Loop*> pointers;
  for(const Loop& loop : loops)
    pointers.push_back(&loop);
  return pointers;
}

py::array_t<std::int64_t> components_of(const Mesh& mesh,
                                        const std::vector<const Loop*>& loops,
                                        std::size_t number_of_components) {
  const std::vector<std::size_t> of_vertices =
      htloops::components_of_vertices(mesh, number_of_components);
  std::vector<std::int64_t> components;
  for(const Loop* loop : loops)
    components.push_back(
        static_cast<std::int64_t>(of_vertices[mesh.source(loop->steps().front().halfedge).idx()]));
  return array_of(components);
}

// Rows, columns and values of the matrix of linking numbers.
py::tuple matrix_of(const std::vector<Loop_linking>& linking) {
  std::vector<std::int64_t> rows, columns, values;
  for(std::size_t i = 0; i < linking.size(); ++i)
    for(const auto& [j, value] : linking[i].row) {
      rows.push_back(static_cast<std::int64_t>(i));
      columns.push_back(static_cast<std::int64_t>(j));
      values.push_back(value);
    }
  return py::make_tuple(array_of(rows), array_of(columns), array_of(values));
}

py::dict seconds_of(const htloops::Answer& answer) {
  py::dict seconds;
  for(std::size_t i = 0; i < CGAL::Handle_tunnel_loops::number_of_stages; ++i) {
    const auto stage = static_cast<CGAL::Handle_tunnel_loops::Stage>(i);
    seconds[CGAL::Handle_tunnel_loops::stage_name(stage)] = answer.statistics.seconds_of(stage);
  }
  seconds["total"] = answer.total_seconds;
  return seconds;
}

// Nothing is believed of it: at() throws where there is no such number.
std::vector<htloops::Loop_record> loop_records(const py::dict& record) {
  const auto points = py::cast<py::array_t<double>>(record["points"]),
             ratios = py::cast<py::array_t<double>>(record["ratios"]),
             lengths = py::cast<py::array_t<double>>(record["lengths"]);
  const auto edges = py::cast<py::array_t<std::int64_t>>(record["edges"]),
             starts = py::cast<py::array_t<std::int64_t>>(record["starts"]);
  std::vector<htloops::Loop_record> loops(static_cast<std::size_t>(lengths.size()));
  for(std::size_t l = 0; l < loops.size(); ++l) {
    loops[l].length = lengths.at(l);
    if(starts.at(l) < 0)
      throw py::index_error();
    for(std::int64_t i = starts.at(l); i < starts.at(l + 1); ++i) {
      loops[l].locations.push_back({edges.at(i, 0), edges.at(i, 1), ratios.at(i)});
      loops[l].points.push_back({points.at(i, 0), points.at(i, 1), points.at(i, 2)});
    }
  }
  return loops;
}

// By pair; what only a bore has is NaN, or -1, where there is none.
py::dict record_of_holes(const htloops::Pairs& pairs, const htloops::Bores& bores) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> diameters, out_of_roundness, walls, depths, deviations;
  std::vector<std::int64_t> drillings;
  std::vector<htloops::Point> centres, axes;
  for(std::size_t i = 0; i < bores.size(); ++i) {
    const std::optional<htloops::Bore>& bore = bores[i];
    const htloops::Listed_hole hole = htloops::hole_of(pairs[i], bore);
    diameters.push_back(hole.diameter);
    out_of_roundness.push_back(bore ? none : hole.out_of_roundness);
    walls.push_back(hole.wall_diameter);
    depths.push_back(bore ? bore->length : none);
    deviations.push_back(bore ? bore->deviation : none);
    drillings.push_back(bore ? static_cast<std::int64_t>(bore->drilling) : -1);
    centres.push_back(bore ? bore->center : htloops::Point(none, none, none));
    axes.push_back(CGAL::ORIGIN +
                   (bore ? bore->axis : htloops::Kernel::Vector_3(none, none, none)));
  }
  return py::dict("diameters"_a = array_of(diameters),
                  "out_of_roundness"_a = array_of(out_of_roundness), "walls"_a = array_of(walls),
                  "depths"_a = array_of(depths), "deviations"_a = array_of(deviations),
                  "drillings"_a = array_of(drillings), "centres"_a = rows_of<double>(centres),
                  "axes"_a = rows_of<double>(axes));
}

// The first of them, as the program has it.
std::string in_words(const std::vector<std::string>& problems) {
  constexpr std::size_t most = 10;
  std::string text;
  for(std::size_t i = 0; i < problems.size() && i < most; ++i)
    text += "\n  " + problems[i];
  if(problems.size() > most)
    text += "\n  and " + std::to_string(problems.size() - most) + " more";
  return text;
}

// None where nobody asked.
void add_layers(py::dict& record, const htloops::Vertex_layers& told) {
  record["layers"] = py::none();
  record["layer_times"] = py::none();
  if(told.layers.empty())
    return;
  record["layers"] = array_of(std::vector<std::int64_t>(told.layers.begin(), told.layers.end()));
  record["layer_times"] = array_of(told.times);
}

} // namespace

// Python has checked the word.
Basis_kind basis_kind(const std::string& name) {
  const auto kind = Basis_kind::SHORTEST;
  return name == CGAL::Handle_tunnel_loops::name_of(kind) ? kind : Basis_kind::PURE;
}

py::dict record_of(const Mesh& mesh, const std::vector<const Loop*>& loops) {
  std::vector<htloops::Point> points;
  std::vector<double> ratios, lengths;
  std::vector<std::int64_t> edges, starts = {0};
  for(const Loop* loop : loops) {
    for(const Loop::Step& step : loop->steps()) {
      edges.push_back(mesh.source(step.halfedge).idx());
      edges.push_back(mesh.target(step.halfedge).idx());
      ratios.push_back(step.ratio);
    }
    points.insert(points.end(), loop->points().begin(), loop->points().end());
    starts.push_back(static_cast<std::int64_t>(ratios.size()));
    lengths.push_back(loop->length());
  }
  return py::dict("points"_a = rows_of<double>(points), "edges"_a = array_of(edges, 2),
                  "ratios"_a = array_of(ratios), "starts"_a = array_of(starts),
                  "lengths"_a = array_of(lengths));
}

py::dict certificate_of(const Certificate& certificate) {
  return py::dict(
      "certified"_a = bool(certificate), "closed_on_surface"_a = certificate.closed_on_surface,
      "basis"_a = certificate.basis, "pairing"_a = certificate.pairing,
      "types"_a = certificate.types, "handles_bound_inside"_a = certificate.handles_bound_inside,
      "tunnels_bound_outside"_a = certificate.tunnels_bound_outside,
      "failure"_a = certificate.failure);
}

std::vector<std::size_t> numbers_of(const std::vector<Loop>& loops) {
  std::vector<std::size_t> numbers;
  for(const Loop& loop : loops)
    numbers.push_back(loop.pair_index());
  return numbers;
}

py::dict record_of(const Mesh& mesh, const htloops::Answer& answer) {
  std::vector<const Loop*> loops;
  htloops::for_each_loop(answer.pairs, [&](const Loop& loop, CGAL::Loop_type, std::size_t) {
    loops.push_back(&loop);
  });
  std::vector<std::string> sides, sides_alone;
  for(const Loop_linking& linking : answer.certificate.linking) {
    sides.push_back(htloops::word_for_side(linking));
    sides_alone.push_back(htloops::word_for_side_alone(linking));
  }
  const std::size_t components = answer.statistics.number_of_components;
  const auto curves = pointers_to(answer.boundaries.curves);
  py::dict boundaries = record_of(mesh, curves);
  boundaries["components"] = components_of(mesh, curves, components);
  py::dict waists = record_of(mesh, pointers_to(answer.boundaries.waists));
  waists["numbers"] = numbers_of(answer.boundaries.waists);
  py::dict record = record_of(mesh, loops);
  add_layers(record, answer.vertex_layers);
  return py::dict(
      "components"_a = components_of(mesh, loops, components), "bounds"_a = sides,
      "bounds_alone"_a = sides_alone, "linking"_a = matrix_of(answer.certificate.linking),
      "certificate"_a = certificate_of(answer.certificate),
      "basis"_a = CGAL::Handle_tunnel_loops::name_of(answer.certificate.basis_kind),
      "ended_by_time"_a = answer.statistics.was_ended_by_time,
      "number_of_vertices"_a = mesh.number_of_vertices(),
      "number_of_faces"_a = mesh.number_of_faces(), "number_of_components"_a = components,
      "diagonal"_a = htloops::diagonal_of(mesh), "seconds"_a = seconds_of(answer),
      "boundaries"_a = boundaries, "waists"_a = waists,
      "holes"_a = record_of_holes(answer.pairs, answer.bores), **record);
}

htloops::Bound_loops loops_of(const py::dict& record, const Mesh& mesh) {
  htloops::Loops_record all;
  all.number_of_vertices = py::cast<std::size_t>(record["number_of_vertices"]);
  all.number_of_faces = py::cast<std::size_t>(record["number_of_faces"]);
  all.has_boundaries = true;
  try {
    std::vector<htloops::Loop_record> loops = loop_records(record);
    if(loops.size() % 2 != 0)
      throw py::index_error();
    for(std::size_t i = 0; i < loops.size(); i += 2)
      all.pairs.push_back({std::move(loops[i]), std::move(loops[i + 1])});
    for(htloops::Loop_record& curve : loop_records(record["boundaries"]))
      all.boundaries.push_back({std::move(curve), std::nullopt});
    const py::dict waists = record["waists"];
    const auto numbers = py::cast<std::vector<std::size_t>>(waists["numbers"]);
    std::vector<htloops::Loop_record> of_curves = loop_records(waists);
    for(std::size_t i = 0; i < of_curves.size(); ++i) {
      if(i >= numbers.size() || numbers[i] >= all.boundaries.size())
        throw py::index_error();
      all.boundaries[numbers[i]].waist = std::move(of_curves[i]);
    }
  } catch(const py::index_error&) {
    throw std::invalid_argument("the arrays of the loops are inconsistent");
  }
  htloops::Bound_loops bound = htloops::bind_loops(all, mesh);
  if(!bound.problems.empty())
    throw std::invalid_argument("the loops are not on this mesh:" + in_words(bound.problems));
  return bound;
}

htloops::Pairs pairs_of(const py::dict& record, const Mesh& mesh) {
  return loops_of(record, mesh).pairs;
}

} // namespace htl_python
