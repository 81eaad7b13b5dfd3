// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/soup_triangulation.h"

#include "mend/change_counter.h"
#include "mend/polygon_triangulation.h"
#include "mend/polygons.h"
#include "read/soup_words.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <unordered_set>
#include <utility>

namespace htloops {
namespace {

// Edges of the faces as they are in the file, each as often as there are faces; sorted.
std::vector<std::uint64_t> edges_of_polygons(const Soup& soup) {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * soup.faces.size() + soup.further_corners.size());
  for_each_polygon(soup, [&](std::size_t, const Corners& corners) {
    for_each_side(corners,
                  [&](std::uint32_t u, std::uint32_t v) { edges.push_back(edge_key(u, v)); });
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

class Triangulator
{
public:
  explicit Triangulator(Mended_soup& mended)
      : mended_(mended)
      , edges_(edges_of_polygons(mended.soup)) {}

  void run() {
    Soup soup;
    std::vector<std::uint32_t> face_in_file;
    soup.faces.reserve(mended_.soup.faces.size() + mended_.soup.further_corners.size());
    Change_counter counter;
    for_each_polygon(mended_.soup, [&](std::size_t f, const Corners& corners) {
      if(corners.size() <= 3) {
        add_face(soup, corners);
      } else {
        counter.add([&] { return name_of_face(mended_.face_in_file[f]); });
        for(const auto& [u, v, w] : triangles_of(corners))
          add_face(soup, {u, v, w});
      }
      face_in_file.resize(soup.faces.size(), mended_.face_in_file[f]);
    });
    soup.points = std::move(mended_.soup.points);
    mended_.soup = std::move(soup);
    mended_.face_in_file = std::move(face_in_file);
    keep_diagonals();
    counter.report(mended_, "face of more than three vertices made triangles",
                   "faces of more than three vertices made triangles");
  }

private:
  bool is_edge(std::uint32_t u, std::uint32_t v) const {
    return std::binary_search(edges_.begin(), edges_.end(), edge_key(u, v));
  }

  // A duplicate is cut as the first of its kind, so that its triangles are duplicates, too.
  Triangles triangles_of(const Corners& corners) {
    if(!has_crowded_side(corners))
      return cut(corners);
    const Corners standard = in_standard_order(corners);
    const auto [found, is_new] = cut_already_.try_emplace(standard);
    if(is_new)
      found->second = cut(standard);
    Triangles triangles = found->second;
    const auto first = std::min_element(corners.begin(), corners.end()) - corners.begin();
    const bool is_turned =
        corners[(static_cast<std::size_t>(first) + 1) % corners.size()] != standard[1];
    if(is_turned)
      for(auto& t : triangles)
        std::swap(t[1], t[2]);
    return triangles;
  }

  bool has_crowded_side(const Corners& corners) const {
    bool is_crowded = false;
    for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) {
      const auto [begin, end] = std::equal_range(edges_.begin(), edges_.end(), edge_key(u, v));
      is_crowded = is_crowded || end - begin > 2;
    });
    return is_crowded;
  }

  Triangles cut(const Corners& corners) {
    const Triangles triangles =
        triangulate_polygon(mended_.soup.points, corners, [this](std::uint32_t u, std::uint32_t v) {
          return !is_edge(u, v) && diagonals_.count(edge_key(u, v)) == 0;
        });
    for(const auto& t : triangles)
      for(int i = 0; i < 3; ++i)
        if(!is_edge(t[i], t[(i + 1) % 3]))
          diagonals_.insert(edge_key(t[i], t[(i + 1) % 3]));
    return triangles;
  }

  void keep_diagonals() {
    for(const std::uint64_t key : diagonals_)
      mended_.diagonals.push_back(
          {static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)});
    std::sort(mended_.diagonals.begin(), mended_.diagonals.end());
  }

  Mended_soup& mended_;
  std::vector<std::uint64_t> edges_; // sorted
  std::unordered_set<std::uint64_t> diagonals_;
  std::map<Corners, Triangles> cut_already_; // of polygons with an edge of too many faces
};

} // namespace

void triangulate(Mended_soup& mended) {
  if(!mended.soup.further_corners.empty())
    Triangulator(mended).run();
}

} // namespace htloops
