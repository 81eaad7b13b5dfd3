// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup.h"

#include "interrupt.h"
#include "read/input_file.h"
#include "read/unpacking.h"

#include <cstring>

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

} // namespace

void check_corners(const std::string& file, const Soup& soup) {
  const std::size_t n = soup.points.size();
  auto further = soup.further_corners.begin();
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto check = [&](std::uint32_t vertex) {
      if(vertex >= n)
        fail_to_read(file, no_such_vertex(f, vertex, n));
    };
    const Soup_face& face = soup.faces[f];
    for(const std::uint32_t vertex : face)
      check(vertex);
    for(std::size_t i = 3; i < face.size(); ++i)
      check(*further++);
  }
}

void check_size(const std::string& file, const Soup& soup) {
  throw_if_interrupted();
  check_room(file, soup.points.size() * sizeof(Point) + soup.faces.size() * sizeof(Soup_face));
}

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

} // namespace htloops
