// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/dual_cuts_json_writer.h"

#include "write/json_writer.h"

namespace htloops {
namespace {

Json json_of(const Dual_cut& cut, const Mesh& mesh) {
  Json json = {{"loop", name_of(cut.loop.type())}};
  json[cut.loop.type() == CGAL::Loop_type::BOUNDARY ? "boundary" : "pair"] = cut.loop.pair_index();
  Json edges = Json::array();
  for(const auto& [h, times] : cut.edges)
    edges.push_back(Json::array({mesh.source(h).idx(), mesh.target(h).idx(), times}));
  json["edges"] = std::move(edges);
  return json;
}

} // namespace

void write_dual_cuts_json(const std::string& target, const Mesh& mesh, const Dual_cuts& cuts) {
  Json_writer out(target);
  out.member("format", "htloops-dual/1");
  out.member("mesh", json_of_mesh(mesh, cuts.statistics));
  out.array("cuts", cuts.cuts, [&](const Dual_cut& cut) { return json_of(cut, mesh); });
  out.finish();
}

} // namespace htloops
