// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Grid.h"
#include "Streams.h"
#include "encode_surface.h"
#include "html_text.h"
#include "page_texts.h"
#include "scene_json.h"
#include "window.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace htl_window {
namespace {

Packed encode_lines(const std::vector<Line>& lines, const Grid& grid) {
  Place_streams streams;
  Grid::Place last{};
  for(const Line& line : lines)
    for(const Point& p : line.points) {
      const Grid::Place place = grid.place_of(p);
      add_difference(streams, place, last);
      last = place;
    }
  return packed({&streams[0], &streams[1], &streams[2]});
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
