// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/copies.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace htloops {
namespace {

using Exact_place = Changeable_mesh::Point;
using Places = std::vector<std::array<Exact_place, 3>>;

// Of parts with as many faces in the same box, numbers in ascending order.
std::vector<std::vector<std::uint32_t>> similar_parts(const Parts& parts) {
  std::map<std::pair<std::size_t, std::array<double, 6>>, std::vector<std::uint32_t>> similar;
  for(std::uint32_t i = 0; i < parts.all.size(); ++i) {
    const CGAL::Bbox_3& box = parts.all[i].box;
    similar[{parts.all[i].faces,
             {box.xmin(), box.ymin(), box.zmin(), box.xmax(), box.ymax(), box.zmax()}}]
        .push_back(i);
  }
  std::vector<std::vector<std::uint32_t>> groups;
  for(auto& group : similar)
    if(group.second.size() > 1)
      groups.push_back(std::move(group.second));
  return groups;
}

// The triangles of a part, whatever their order and orientation.
Places places_of(const Changeable_mesh& mesh,
                 const std::vector<Changeable_mesh::Face_index>& faces) {
  Places places;
  for(const Changeable_mesh::Face_index f : faces) {
    places.push_back(corners_of(mesh, f));
    std::sort(places.back().begin(), places.back().end());
  }
  std::sort(places.begin(), places.end());
  return places;
}

} // namespace

std::vector<char> find_copies(const Changeable_mesh& mesh, const Parts& parts) {
  std::vector<char> is_copy(parts.all.size(), 0);
  const std::vector<std::vector<std::uint32_t>> groups = similar_parts(parts);
  if(groups.empty())
    return is_copy;
  std::map<std::uint32_t, std::vector<Changeable_mesh::Face_index>> faces; // of those in groups
  for(const auto& group : groups)
    for(const std::uint32_t i : group)
      faces[i].reserve(parts.all[i].faces);
  for(const Changeable_mesh::Face_index f : mesh.faces())
    if(const auto of_part = faces.find(parts.of_face[f.idx()]); of_part != faces.end())
      of_part->second.push_back(f);
  for(const auto& group : groups) {
    std::vector<Places> seen;
    for(const std::uint32_t i : group) {
      Places places = places_of(mesh, faces[i]);
      is_copy[i] = std::find(seen.begin(), seen.end(), places) != seen.end();
      if(!is_copy[i])
        seen.push_back(std::move(places));
    }
  }
  return is_copy;
}

} // namespace htloops
