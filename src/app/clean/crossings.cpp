// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/intersections.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>

namespace htloops {
namespace {

using Face = Changeable_mesh::Face_index;
using Kernel_of_copy = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangle = Kernel_of_copy::Triangle_3;
using Segment = Kernel_of_copy::Segment_3;

// Of two faces, each turned such that the corners at common places come first.
struct Common_corners
{
  std::array<Changeable_mesh::Point, 3> a, b;
  std::size_t number = 0;

  Common_corners(const Changeable_mesh& mesh, Face f, Face g)
      : a(corners_of(mesh, f))
      , b(corners_of(mesh, g)) {
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = number; j < 3; ++j)
        if(a[i] == b[j]) {
          std::swap(a[i], a[number]);
          std::swap(b[j], b[number]);
          ++number;
          break;
        }
  }
};

// Whether faces meet in places of their corners, or edges, only.
bool only_touch(const Changeable_mesh& mesh, Face f, Face g) {
  const auto [a, b, number] = Common_corners(mesh, f, g);
  if(number == 1)
    return !CGAL::do_intersect(Segment(a[1], a[2]), Triangle(b[0], b[1], b[2])) &&
           !CGAL::do_intersect(Segment(b[1], b[2]), Triangle(a[0], a[1], a[2]));
  if(number == 2) // then they lie on each other, or not
    return !CGAL::coplanar(a[0], a[1], a[2], b[2]) ||
           CGAL::coplanar_orientation(a[0], a[1], a[2], b[2]) == CGAL::NEGATIVE;
  return false;
}

// New numbers of faces, by those before; none of those that are gone.
using Numbers = std::vector<std::int64_t>;

Numbers new_numbers(const std::vector<std::size_t>& faces) {
  Numbers numbers;
  for(std::size_t f = 0; f < faces.size(); ++f) {
    numbers.resize((std::max)(numbers.size(), faces[f] + 1), nothing_before);
    numbers[faces[f]] = std::int64_t(f);
  }
  return numbers;
}

Pairs_of_faces kept(const Pairs_of_faces& pairs, const Numbers& numbers) {
  const auto is_there = [&](std::uint32_t f) {
    return f < numbers.size() && numbers[f] != nothing_before;
  };
  Pairs_of_faces result;
  for(const auto& [f, g] : pairs)
    if(is_there(f) && is_there(g))
      result.push_back({std::uint32_t(numbers[f]), std::uint32_t(numbers[g])});
  return result;
}

} // namespace

Crossings crossings_of(const Changeable_mesh& mesh) {
  std::vector<std::pair<Face, Face>> found;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(
      mesh, std::back_inserter(found));
  Crossings crossings;
  for(const auto& [f, g] : found)
    if(f != g)
      (only_touch(mesh, f, g) ? crossings.touching : crossings.crossing)
          .push_back({(std::min)(f, g).idx(), (std::max)(f, g).idx()});
  std::sort(crossings.crossing.begin(), crossings.crossing.end());
  std::sort(crossings.touching.begin(), crossings.touching.end());
  return crossings;
}

Crossings kept_crossings(const Crossings& before, const Changed_mesh& changed) {
  if(before.crossing.empty() && before.touching.empty())
    return {};
  const Numbers numbers = new_numbers(changed.faces);
  return {kept(before.crossing, numbers), kept(before.touching, numbers)};
}

} // namespace htloops
