// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/stl_guard.h"

#include "read/non_finite_points.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace htloops {
namespace {

constexpr std::size_t header_size = 80;
constexpr std::size_t count_size = 4;
constexpr std::size_t facet_size = 50; // normal and three points of three floats, two more bytes

template <typename T> T value_at(std::string_view content, std::size_t position) {
  T value;
  std::memcpy(&value, content.data() + position, sizeof value);
  return value;
}

// A file is binary if its size says so: the word "solid" opens many a binary file.
bool is_binary(std::string_view content) {
  const auto facets = value_at<std::uint32_t>(content, header_size);
  const bool size_agrees = content.size() == header_size + count_size + facets * facet_size;
  return size_agrees || content.substr(0, 5) != "solid";
}

void check_points(const Input_file& file, std::size_t facet) {
  const std::size_t points = header_size + count_size + facet * facet_size + 3 * sizeof(float);
  for(std::size_t i = 0; i < 9; ++i)
    if(!std::isfinite(value_at<float>(file.content(), points + i * sizeof(float))))
      fail_with_non_finite(file, "face " + std::to_string(facet));
}

} // namespace

void check_stl(const Input_file& file) {
  const std::string_view content = file.content();
  if(content.size() < header_size + count_size) {
    if(content.find("endsolid") == content.npos)
      fail_to_read(file, "it is too short to be an STL file");
    return;
  }
  if(!is_binary(content))
    return;
  const std::size_t announced = value_at<std::uint32_t>(content, header_size);
  const std::size_t found = (content.size() - header_size - count_size) / facet_size;
  if(found < announced)
    fail_to_read(file, "it ends after " + std::to_string(found) + " of " +
                           std::to_string(announced) + " faces");
  for(std::size_t facet = 0; facet < announced; ++facet)
    check_points(file, facet);
}

} // namespace htloops
