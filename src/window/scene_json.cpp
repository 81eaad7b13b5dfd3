// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "scene_json.h"

#include <nlohmann/json.hpp>

#include <cstddef>

namespace htl_window {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Scene& scene, const Surface& surface, const Encoded_surface& encoded) {
  Json json = {{"name", surface.name},
               {"vertices", encoded.number_of_vertices},
               {"faces", surface.triangles.size()},
               {"streams", encoded.streams.lengths},
               {"colour", scene.surface_colour}};
  if(!surface.triangle_parts.empty())
    json["parts"] = surface.part_colours;
  return json;
}

Json json_of(const Line_group& group) { return {{"name", group.name}, {"colour", group.colour}}; }

Json json_of(const Line& line) {
  Json json = {{"points", line.points.size()}, {"closed", line.closed}, {"group", line.group}};
  if(line.row != no_row)
    json["row"] = line.row;
  if(line.surface != every_surface)
    json["surface"] = line.surface;
  return json;
}

Json json_of(const Column& column) { return {{"name", column.name}, {"number", column.is_number}}; }

template <typename Range> Json array_of(const Range& range) {
  Json array = Json::array();
  for(const auto& element : range)
    array.push_back(json_of(element));
  return array;
}

// A text that ends the script element in which it stands must not occur in it.
std::string inside_script(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for(const char c : json)
    if(c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

} // namespace

std::string scene_json(const Scene& scene,
                       const Grid& grid,
                       const std::vector<Encoded_surface>& encoded,
                       const Packed& lines) {
  Json surfaces = Json::array();
  for(std::size_t i = 0; i < encoded.size(); ++i)
    surfaces.push_back(json_of(scene, scene.surfaces[i], encoded[i]));
  const Table& table = scene.table;
  const Json json = {{"name", scene.name},
                     {"size", grid.size()},
                     {"view", scene.view},
                     {"up", scene.up},
                     {"opacity", scene.opacity},
                     {"surfaces", surfaces},
                     {"groups", array_of(scene.groups)},
                     {"lines", array_of(scene.lines)},
                     {"lineStreams", lines.lengths},
                     {"columns", array_of(table.columns)},
                     {"rows", table.rows},
                     {"lengths", table.lengths},
                     {"parts", table.parts},
                     {"numbers", table.numbers},
                     {"choice", table.choice}};
  return inside_script(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

} // namespace htl_window
