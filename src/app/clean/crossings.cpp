// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/crossings.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace htloops {

Crossings crossings_of(const Changeable_mesh& mesh) {
  using Face = Changeable_mesh::Face_index;
  std::vector<std::pair<Face, Face>> found;
  CGAL::Polygon_mesh_processing::self_intersections<CGAL::Parallel_if_available_tag>(
      mesh, std::back_inserter(found));
  Crossings crossings;
  for(const auto& [f, g] : found)
    if(f != g)
      crossings.push_back({(std::min)(f, g).idx(), (std::max)(f, g).idx()});
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

Crossings kept_crossings(const Crossings& before, const Changed_mesh& changed) {
  if(before.empty())
    return {};
  const std::int64_t last = before.back()[0]; // the first ones of pairs are the smaller ones
  std::vector<std::int64_t> number;
  for(std::size_t f = 0; f < changed.face_origins.size(); ++f)
    if(const std::int64_t origin = changed.face_origins[f]; origin != nothing_before) {
      number.resize((std::max)(number.size(), std::size_t(origin) + 1), nothing_before);
      number[std::size_t(origin)] = std::int64_t(f);
    }
  number.resize((std::max)(number.size(), std::size_t(last) + 1), nothing_before);
  Crossings kept;
  for(const auto& [f, g] : before)
    if(g < number.size() && number[f] != nothing_before && number[g] != nothing_before)
      kept.push_back({std::uint32_t(number[f]), std::uint32_t(number[g])});
  return kept;
}

} // namespace htloops
