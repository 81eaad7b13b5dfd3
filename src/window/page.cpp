// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "encoding.h"
#include "page_texts.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

Json json_of(const Line_group& group) {
  Json json = {{"name", group.name}, {"colour", group.colour}, {"width", group.width}};
  if(!group.is_in_pictures)
    json["aside"] = true;
  return json;
}

Json json_of(const Line& line) {
  Json json = {{"points", line.points.size()}, {"closed", line.closed}, {"group", line.group}};
  if(line.row != no_row)
    json["row"] = line.row;
  if(line.surface != every_surface)
    json["surface"] = line.surface;
  if(!line.radii.empty())
    json["radii"] = true;
  if(line.way != no_way)
    json["way"] = line.way;
  return json;
}

Json json_of(const Patch& patch) { return {{"name", patch.name}, {"colour", patch.colour}}; }

Json json_of(const std::optional<Point>& view) { return view ? Json(*view) : Json(); }

Json json_of(const Scale& scale) { return {{"name", scale.name}, {"values", scale.values}}; }

Json json_of(const Column& column) {
  Json json = {{"name", column.name}, {"number", column.is_number}};
  if(!column.explanation.empty())
    json["about"] = column.explanation;
  return json;
}

// What has no part is null.
Json json_of_parts(const std::vector<std::size_t>& parts) {
  Json json = Json::array();
  for(const std::size_t part : parts)
    json.push_back(part == no_part ? Json() : Json(part));
  return json;
}

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
    text += c == '<' ? "\\u003c" : std::string(1, c);
  return text;
}

/// what the scripts of a page are told of a scene, besides the streams.
std::string scene_json(const Scene& scene,
                       const Grid& grid,
                       const std::vector<Encoded_surface>& encoded,
                       const Packed& lines) {
  Json surfaces = Json::array();
  for(std::size_t i = 0; i < encoded.size(); ++i)
    surfaces.push_back(json_of(scene, scene.surfaces[i], encoded[i]));
  const Table& table = scene.table;
  for(const std::vector<std::string>& row : table.rows)
    if(row.size() != table.columns.size())
      throw std::logic_error("a row of a page has not a cell for each column");
  const Json json = {{"name", scene.name},
                     {"size", grid.size()},
                     {"extent", grid.extent()},
                     {"unit", scene.unit},
                     {"view", scene.view},
                     {"up", scene.up},
                     {"opacity", scene.opacity},
                     {"bones", scene.has_bones},
                     {"surfaces", surfaces},
                     {"patches", array_of(scene.patches)},
                     {"groups", array_of(scene.groups)},
                     {"lines", array_of(scene.lines)},
                     {"lineStreams", lines.lengths},
                     {"columns", array_of(table.columns)},
                     {"rows", table.rows},
                     {"lengths", table.lengths},
                     {"scales", array_of(table.scales)},
                     {"parts", json_of_parts(table.parts)},
                     {"numbers", table.numbers},
                     {"choice", table.choice},
                     {"noun", table.noun},
                     {"empty", table.empty},
                     {"views", array_of(table.views)}};
  return inside_script(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

// Places, and radii of the lines that have any.
Packed encode_lines(const std::vector<Line>& lines, const Grid& grid) {
  Place_streams streams;
  Stream radii;
  Grid::Place last{};
  std::int32_t last_radius = 0;
  for(const Line& line : lines) {
    for(const Point& p : line.points) {
      const Grid::Place place = grid.place_of(p);
      add_difference(streams, place, last);
      last = place;
    }
    for(const double r : line.radii) {
      const std::int32_t radius = grid.steps_of(r);
      radii.add_signed(radius - last_radius);
      last_radius = radius;
    }
  }
  return packed({&streams[0], &streams[1], &streams[2], &radii});
}

void add_data(const std::string& id, const Packed& data, std::string& html) {
  html += "<script type=\"text/plain\" id=\"" + id + "\">";
  html += data.text;
  html += "</script>\n";
}

std::string script() {
  std::string text;
  for(const std::string_view part : page_scripts)
    text += part;
  return text;
}

std::string paragraphs_of(const Scene& scene) {
  std::string html;
  for(const std::string& text : scene.paragraphs)
    html += "<p>" + html_of(text) + "</p>\n";
  return html;
}

// A text in which @words@ are replaced.
std::string filled(std::string_view form, const std::map<std::string_view, std::string>& contents) {
  std::string text;
  std::size_t size = form.size();
  for(const auto& [word, content] : contents)
    size += content.size();
  text.reserve(size);
  for(;;) {
    const std::size_t begin = form.find('@');
    text += form.substr(0, begin);
    if(begin == std::string_view::npos)
      return text;
    const std::size_t end = form.find('@', begin + 1);
    text += contents.at(form.substr(begin + 1, end - begin - 1));
    form.remove_prefix(end + 1);
  }
}

} // namespace

std::string html_of(std::string_view text) {
  std::string html;
  for(const char c : text)
    html += c == '&'   ? "&amp;"
            : c == '<' ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '"' ? "&quot;"
                       : std::string(1, c);
  return html;
}

std::string page_of(const Scene& scene) {
  const Grid grid(scene);
  const Packed lines = encode_lines(scene.lines, grid);
  std::vector<Encoded_surface> surfaces;
  for(const Surface& surface : scene.surfaces)
    surfaces.push_back(encode_surface(surface, grid));
  std::string data;
  add_data("lines", lines, data);
  for(std::size_t i = 0; i < surfaces.size(); ++i)
    add_data("surface" + std::to_string(i), surfaces[i].streams, data);
  return filled(page_html, {{"title", html_of(scene.title)},
                            {"style", std::string(page_css)},
                            {"paragraphs", paragraphs_of(scene)},
                            {"scene", scene_json(scene, grid, surfaces, lines)},
                            {"data", std::move(data)},
                            {"script", script()}});
}

} // namespace htl_window
