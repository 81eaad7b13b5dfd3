// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/loops_json_writer.h"

#include "face_cuts.h"
#include "version.h"
#include "write/linking_words.h"
#include "write/pair_listing.h"

#include <optional>

namespace htloops {
namespace {

using CGAL::Handle_tunnel_loops::Loop_linking;
using CGAL::Handle_tunnel_loops::Stage;

Json timings(const Answer& answer, double read_seconds) {
  Json json = {{"read", read_seconds}};
  for(std::size_t i = 0; i < CGAL::Handle_tunnel_loops::number_of_stages; ++i) {
    const auto stage = static_cast<Stage>(i);
    if(stage == Stage::DIFFUSION)
      continue; // no loop comes of it
    json[CGAL::Handle_tunnel_loops::stage_name(stage)] = answer.statistics.seconds_of(stage);
  }
  json["total"] = answer.total_seconds;
  return json;
}

Json json_of(const std::optional<std::size_t>& count) { return count ? Json(*count) : Json(); }

Json json_of(const CGAL::Handle_tunnel_loops::Certificate& certificate) {
  return {{"closed_on_surface", certificate.closed_on_surface},
          {"basis", certificate.basis},
          {"pairing", certificate.pairing},
          {"types", certificate.types},
          {"handles_bound_inside", json_of(certificate.handles_bound_inside)},
          {"tunnels_bound_outside", json_of(certificate.tunnels_bound_outside)},
          {"handles_bound_inside_alone", json_of(certificate.handles_bound_inside_alone)},
          {"tunnels_bound_outside_alone", json_of(certificate.tunnels_bound_outside_alone)}};
}

// Row, column and value, where loop 2k is handle k and loop 2k + 1 is tunnel k.
Json json_of(const std::vector<Loop_linking>& linking) {
  Json array = Json::array();
  for(std::size_t i = 0; i < linking.size(); ++i)
    for(const auto& [j, value] : linking[i].row)
      array.push_back(Json::array({i, j, value}));
  return array;
}

// The positions of the locations on edges that are in no face of the file.
Json positions_across_faces(const Loop& loop, const Mesh& mesh, const Face_cuts& cuts) {
  Json positions = Json::array();
  for(std::size_t i = 0; i < loop.steps().size(); ++i)
    if(cuts[mesh.edge(loop.steps()[i].halfedge)])
      positions.push_back(i);
  return positions;
}

Json json_of_line(const Loop& loop, const Mesh& mesh, Json json = Json()) {
  Json locations = Json::array();
  for(const Loop::Step& step : loop.steps())
    locations.push_back(Json::array(
        {mesh.source(step.halfedge).idx(), mesh.target(step.halfedge).idx(), step.ratio}));
  json["locations"] = std::move(locations);
  if(const auto cuts = cuts_of_faces(mesh))
    json["across_faces"] = positions_across_faces(loop, mesh, *cuts);
  json["points"] = json_of_points(loop.points());
  return json;
}

// Of the surface at a loop.
std::size_t
component_of(const Loop& loop, const Mesh& mesh, const std::vector<std::size_t>& components) {
  return components[mesh.source(loop.steps().front().halfedge).idx()];
}

Json json_of(const Loop& loop,
             const Mesh& mesh,
             const std::vector<std::size_t>& components,
             const Loop_linking* linking) {
  Json json = {{"length", loop.length()}, {"component", component_of(loop, mesh, components)}};
  if(linking != nullptr) {
    json["bounds"] = word_for_side(*linking);
    json["bounds_alone"] = word_for_side_alone(*linking);
    if(!linking->problem.empty())
      json["undecided_because"] = linking->problem;
  }
  return json_of_line(loop, mesh, std::move(json));
}

// How small a pair is, and where its shorter loop lies.
Json json_of_place(const Listed_pair& pair) {
  const CGAL::Bbox_3& box = pair.box;
  return {{"size", pair.size},
          {"centre", json_of_point(pair.centre)},
          {"box", Json::array({Json::array({box.xmin(), box.ymin(), box.zmin()}),
                               Json::array({box.xmax(), box.ymax(), box.zmax()})})}};
}

// A boundary curve, with its waist if that was looked for.
Json json_of(const Loop& curve,
             const Boundaries& boundaries,
             const Mesh& mesh,
             const std::vector<std::size_t>& components) {
  Json json = {{"length", curve.length()}, {"component", component_of(curve, mesh, components)}};
  if(!boundaries.waists.empty()) {
    const Loop& waist = boundaries.waists[curve.pair_index()];
    json["waist"] = json_of_line(waist, mesh, {{"length", waist.length()}});
  }
  return json_of_line(curve, mesh, std::move(json));
}

} // namespace

void write_loops_json(const std::string& target,
                      const Mesh& mesh,
                      const Answer& answer,
                      const Run_record& run) {
  const auto& linking = answer.certificate.linking;
  const std::vector<std::size_t> components =
      components_of_vertices(mesh, answer.statistics.number_of_components);
  Json_writer out(target);
  out.member("format", "htloops/1");
  out.member("tool", version());
  Json mesh_json = json_of_mesh(mesh, answer.statistics);
  mesh_json["file"] = run.mesh_file;
  out.member("mesh", mesh_json);
  out.member("options", run.options);
  out.member("backend", answer.backend);
  out.member("threads", answer.number_of_threads);
  out.member("basis", CGAL::Handle_tunnel_loops::name_of(answer.certificate.basis_kind));
  out.member("timings", timings(answer, run.read_seconds));
  out.member("certificate", json_of(answer.certificate));
  if(!linking.empty())
    out.member("linking", json_of(linking));
  if(!answer.statistics.fallback.empty())
    out.member("fallback", answer.statistics.fallback);
  const CGAL::Bbox_3 box = box_of(mesh);
  std::size_t index = 0; // of the next loop
  out.array("pairs", answer.pairs, [&](const Pair& pair) {
    Json json = json_of_place(listed_pair(pair, index / 2, box));
    for(const CGAL::Loop_type type : loop_types) {
      json[name_of(type)] =
          json_of(pair.loop(type), mesh, components, linking.empty() ? nullptr : &linking[index]);
      ++index;
    }
    return json;
  });
  out.array("boundaries", answer.boundaries.curves,
            [&](const Loop& curve) { return json_of(curve, answer.boundaries, mesh, components); });
  out.finish();
}

} // namespace htloops
