// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/Gltf_document.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace htloops {
namespace {

void append_chunk(std::string& bytes, const std::string& kind, const std::string& content) {
  append_bytes(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += kind + content;
}

// As they are after rounding.
void add_bounds(Json& accessor, const std::vector<Gltf_document::Point>& points) {
  for(const char* name : {"min", "max"}) {
    accessor[name] = Json::array();
    for(std::size_t i = 0; i < 3; ++i) {
      const auto less = [i](const auto& p, const auto& q) { return p[i] < q[i]; };
      const auto [least, most] = std::minmax_element(points.begin(), points.end(), less);
      accessor[name].push_back(static_cast<float>((name[1] == 'i' ? *least : *most)[i]));
    }
  }
}

} // namespace

void Gltf_document::add_node(const std::string& name,
                             const std::vector<Point>& points,
                             const std::vector<Point>& normals,
                             const std::vector<Triangle>& triangles,
                             Json primitive) {
  const std::size_t positions = accessor_of(points);
  add_bounds(json_["accessors"][positions], points);
  primitive["attributes"] = {{"POSITION", positions}};
  if(!normals.empty())
    primitive["attributes"]["NORMAL"] = accessor_of(normals);
  primitive["indices"] = accessor_of(triangles);
  json_["meshes"].push_back({{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
  json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}});
}

std::size_t Gltf_document::add_material(Json material) {
  json_["materials"].push_back(std::move(material));
  return json_["materials"].size() - 1;
}

std::string Gltf_document::file(Json root) {
  const std::size_t nodes = json_.contains("nodes") ? json_["nodes"].size() : 0;
  for(std::size_t i = 0; i < nodes; ++i)
    root["children"].push_back(i);
  json_["nodes"].push_back(std::move(root));
  json_["scenes"] = Json::array({{{"nodes", Json::array({nodes})}}});
  if(!buffer_.empty())
    json_["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
  std::string text = text_of(json_);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  constexpr std::size_t headers = 28;
  std::string result = "glTF";
  append_bytes(result, std::uint32_t(2));
  append_bytes(result, static_cast<std::uint32_t>(headers + text.size() + buffer_.size()));
  append_chunk(result, "JSON", text);
  append_chunk(result, std::string("BIN\0", 4), buffer_);
  return result;
}

// Vectors of single precision, or the corners of triangles one by one.
template <typename Number>
std::size_t Gltf_document::accessor_of(const std::vector<std::array<Number, 3>>& rows) {
  constexpr bool are_corners = std::is_integral_v<Number>;
  constexpr int array_buffer = 34962, element_array_buffer = 34963;
  constexpr int single = 5126, unsigned_number = 5125; // types of numbers
  const std::size_t begin = buffer_.size();
  for(const auto& row : rows)
    for(const Number number : row)
      append_bytes(buffer_,
                   static_cast<std::conditional_t<are_corners, std::uint32_t, float>>(number));
  json_["bufferViews"].push_back({{"buffer", 0},
                                  {"byteOffset", begin},
                                  {"byteLength", buffer_.size() - begin},
                                  {"target", are_corners ? element_array_buffer : array_buffer}});
  json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                {"componentType", are_corners ? unsigned_number : single},
                                {"count", rows.size() * (are_corners ? 3u : 1u)},
                                {"type", are_corners ? "SCALAR" : "VEC3"}});
  return json_["accessors"].size() - 1;
}

} // namespace htloops
