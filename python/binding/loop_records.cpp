// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "loop_records.h"

#include "htloops/read/loops_binding.h"
#include "htloops/solve/boundaries.h"
#include "htloops/write/linking_words.h"
#include "htloops/write/pair_listing.h"

#include <pybind11/stl.h>

#include <stdexcept>

namespace htl_python {
namespace {

using CGAL::Handle_tunnel_loops::Basis_kind;
using CGAL::Handle_tunnel_loops::Certificate;
using CGAL::Handle_tunnel_loops::Loop_linking;
using htloops::Loop;
using htloops::Mesh;

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
  return array_of(std::move(components));
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
  return py::make_tuple(array_of(std::move(rows)), array_of(std::move(columns)),
                        array_of(std::move(values)));
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

template <typename Number>
py::array_t<Number, py::array::c_style | py::array::forcecast> member(const py::dict& record,
                                                                      const char* name) {
  return py::cast<py::array_t<Number, py::array::c_style | py::array::forcecast>>(record[name]);
}

// The loops of a record, as they stand in a file.
std::vector<htloops::Loop_record> loop_records(const py::dict& record) {
  const auto points = member<double>(record, "points"), ratios = member<double>(record, "ratios"),
             lengths = member<double>(record, "lengths");
  const auto edges = member<std::int64_t>(record, "edges"),
             starts = member<std::int64_t>(record, "starts");
  const bool is_sound = points.ndim() == 2 && points.shape(1) == 3 && edges.ndim() == 2 &&
                        edges.shape(1) == 2 && ratios.ndim() == 1 && starts.ndim() == 1 &&
                        edges.shape(0) == points.shape(0) && ratios.shape(0) == points.shape(0) &&
                        starts.shape(0) == lengths.shape(0) + 1;
  if(!is_sound)
    throw std::invalid_argument("the arrays of the loops do not fit together");
  std::vector<htloops::Loop_record> loops;
  for(py::ssize_t l = 0; l < lengths.shape(0); ++l) {
    if(starts.at(l) < 0 || starts.at(l) > starts.at(l + 1) || starts.at(l + 1) > points.shape(0))
      throw std::invalid_argument("the arrays of the loops do not fit together");
    htloops::Loop_record loop;
    loop.length = lengths.at(l);
    for(py::ssize_t i = starts.at(l); i < starts.at(l + 1); ++i) {
      loop.locations.push_back({edges.at(i, 0), edges.at(i, 1), ratios.at(i)});
      loop.points.push_back({points.at(i, 0), points.at(i, 1), points.at(i, 2)});
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

} // namespace

Basis_kind basis_kind(const std::string& name) {
  for(const Basis_kind kind : {Basis_kind::PURE, Basis_kind::SHORTEST})
    if(name == CGAL::Handle_tunnel_loops::name_of(kind))
      return kind;
  throw std::invalid_argument("basis is 'pure' or 'shortest', not '" + name + "'");
}

py::dict record_of(const Mesh& mesh, const std::vector<const Loop*>& loops) {
  std::vector<double> points, ratios, lengths;
  std::vector<std::int64_t> edges, starts = {0};
  for(const Loop* loop : loops) {
    for(const Loop::Step& step : loop->steps()) {
      edges.push_back(mesh.source(step.halfedge).idx());
      edges.push_back(mesh.target(step.halfedge).idx());
      ratios.push_back(step.ratio);
    }
    for(const htloops::Point& p : loop->points())
      points.insert(points.end(), {p.x(), p.y(), p.z()});
    starts.push_back(static_cast<std::int64_t>(ratios.size()));
    lengths.push_back(loop->length());
  }
  py::dict record;
  record["points"] = array_of(std::move(points), 3);
  record["edges"] = array_of(std::move(edges), 2);
  record["ratios"] = array_of(std::move(ratios));
  record["starts"] = array_of(std::move(starts));
  record["lengths"] = array_of(std::move(lengths));
  return record;
}

void add_certificate(const Certificate& certificate, py::dict& record) {
  std::vector<std::string> sides, sides_alone;
  for(const Loop_linking& linking : certificate.linking) {
    sides.push_back(htloops::word_for_side(linking));
    sides_alone.push_back(htloops::word_for_side_alone(linking));
  }
  record["bounds"] = sides;
  record["bounds_alone"] = sides_alone;
  record["linking"] = matrix_of(certificate.linking);
  py::dict facts;
  facts["certified"] = bool(certificate);
  facts["closed_on_surface"] = certificate.closed_on_surface;
  facts["basis"] = certificate.basis;
  facts["pairing"] = certificate.pairing;
  facts["types"] = certificate.types;
  facts["handles_bound_inside"] = certificate.handles_bound_inside;
  facts["tunnels_bound_outside"] = certificate.tunnels_bound_outside;
  facts["failure"] = certificate.failure;
  record["certificate"] = facts;
}

py::dict record_of(const Mesh& mesh, const htloops::Answer& answer) {
  std::vector<const Loop*> loops;
  htloops::for_each_loop(answer.pairs, [&](const Loop& loop, CGAL::Loop_type, std::size_t) {
    loops.push_back(&loop);
  });
  const auto& statistics = answer.statistics;
  py::dict record = record_of(mesh, loops);
  record["components"] = components_of(mesh, loops, statistics.number_of_components);
  add_certificate(answer.certificate, record);
  record["basis"] = CGAL::Handle_tunnel_loops::name_of(answer.certificate.basis_kind);
  record["number_of_vertices"] = statistics.number_of_vertices;
  record["number_of_faces"] = statistics.number_of_faces;
  record["number_of_components"] = statistics.number_of_components;
  record["diagonal"] = htloops::diagonal_of(mesh);
  record["seconds"] = seconds_of(answer);
  record["threads"] = answer.number_of_threads;
  const auto curves = pointers_to(answer.boundaries.curves);
  py::dict boundaries = record_of(mesh, curves);
  boundaries["components"] = components_of(mesh, curves, statistics.number_of_components);
  record["boundaries"] = boundaries;
  record["waists"] = record_of(mesh, pointers_to(answer.boundaries.waists));
  return record;
}

htloops::Pairs pairs_of(const py::dict& record, const Mesh& mesh) {
  std::vector<htloops::Loop_record> loops = loop_records(record);
  if(loops.size() % 2 != 0)
    throw std::invalid_argument("loops come in pairs");
  htloops::Loops_record all;
  all.number_of_vertices = py::cast<std::size_t>(record["number_of_vertices"]);
  all.number_of_faces = py::cast<std::size_t>(record["number_of_faces"]);
  for(std::size_t i = 0; i < loops.size(); i += 2)
    all.pairs.push_back({std::move(loops[i]), std::move(loops[i + 1])});
  htloops::Bound_loops bound = htloops::bind_loops(all, mesh);
  std::string message;
  for(const std::string& problem : bound.problems)
    message += (message.empty() ? "" : "\n") + problem;
  if(!message.empty())
    throw std::invalid_argument("the loops are not on this mesh: " + message);
  return std::move(bound.pairs);
}

} // namespace htl_python
