// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup.h"

#include "read/formats.h"
#include "read/input_file.h"

#include <cstring>
#include <string_view>

namespace htloops {
namespace {

static_assert(sizeof(Point) == 3 * sizeof(double), "points are compared by their bytes");

bool are_same(const Point& p, const Point& q) { return std::memcmp(&p, &q, sizeof p) == 0; }

// Its lower bits, which are used, depend on the upper bits of the coordinates, which differ most.
std::size_t hash_of(const Point& point) {
  std::uint64_t hash = 0;
  for(int i = 0; i < 3; ++i) {
    const double x = point[i];
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return static_cast<std::size_t>(hash);
}

bool is_of_text(char c) { return c == '\t' || c == '\n' || c == '\r' || (' ' <= c && c <= '~'); }

// By the mark and the first character: the header of a binary file may begin as it likes.
bool is_utf16(std::string_view content) {
  if(content.size() < 4)
    return false;
  const std::string_view mark = content.substr(0, 2);
  return (mark == "\xFF\xFE" && is_of_text(content[2]) && content[3] == '\0') ||
         (mark == "\xFE\xFF" && content[2] == '\0' && is_of_text(content[3]));
}

} // namespace

std::uint32_t Point_merger::number(const Point& point) {
  if(!is_finite(point)) {
    points_.push_back(point);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  const Point with_one_zero(point.x() + 0., point.y() + 0., point.z() + 0.);
  if(2 * points_.size() >= slots_.size())
    grow();
  std::uint32_t& number = slots_[slot_of(with_one_zero)];
  if(number == nothing) {
    number = static_cast<std::uint32_t>(points_.size());
    points_.push_back(with_one_zero);
  }
  return number;
}

// That of the point, or where it would go.
std::size_t Point_merger::slot_of(const Point& point) const {
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash_of(point) & mask;
  while(slots_[slot] != nothing && !are_same(points_[slots_[slot]], point))
    slot = (slot + 1) & mask;
  return slot;
}

void Point_merger::grow() {
  slots_.assign(2 * slots_.size(), nothing);
  for(std::size_t i = 0; i < points_.size(); ++i)
    if(is_finite(points_[i]))
      slots_[slot_of(points_[i])] = static_cast<std::uint32_t>(i);
}

Soup read_soup(const Input_file& file) {
  if(is_utf16(file.content()))
    fail_to_read(file.name(), "the file is UTF-16; save it as UTF-8 or ASCII");
  if(file.is_of_format(".off"))
    return read_off(file.name(), file.content());
  if(file.is_of_format(".obj"))
    return read_obj(file.name(), std::string(file.content()));
  if(file.is_of_format(".ply"))
    return read_ply(file.name(), file.content());
  if(file.is_of_format(".stl"))
    return read_stl(file.name(), file.content());
  fail_to_read(file.name(),
               "its format, which follows from the extension, is not supported; those that are: "
               ".off .obj .ply .stl (--format says which one it is whatever its name)");
}

} // namespace htloops
