// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include <utility>

namespace htloops {
namespace {

// The corners of any face of a soup.
class Corners_of_faces
{
public:
  explicit Corners_of_faces(const Soup& soup)
      : soup_(soup) {
    if(soup.further_corners.empty())
      return;
    for(const Soup_face& face : soup.faces) {
      first_further_.push_back(number_of_further_);
      number_of_further_ += face.size() > 3 ? face.size() - 3 : 0;
    }
  }

  Corners operator()(std::uint32_t f) const {
    const Soup_face& face = soup_.faces[f];
    Corners corners(face.begin(), face.end());
    if(face.size() > 3) {
      const std::uint32_t* const further = soup_.further_corners.data() + first_further_[f];
      corners.insert(corners.end(), further, further + (face.size() - 3));
    }
    return corners;
  }

private:
  const Soup& soup_;
  std::vector<std::size_t> first_further_;
  std::size_t number_of_further_ = 0;
};

// Which vertices of before are where afterwards: as the corners of faces tell, a corner being the
// same if it is at the same place in what is the same face or a part of it.
class Vertex_comparison
{
public:
  Vertex_comparison(const Soup& before, const Mended_soup& after)
      : keeps_own_(before.points.size(), false) {
    const Corners_of_faces corners_before(before);
    for_each_polygon(after.soup, [&](std::size_t f, const Corners& corners) {
      const Corners old = corners_before(after.face_in_file[f]);
      for(const std::uint32_t w : corners)
        look_at_corner(before, old, w, after.soup.points[w]);
    });
    sort_moves();
  }

  void report(Change_log& log) {
    report_split(log);
    report_welded(log);
  }

private:
  void look_at_corner(const Soup& before, const Corners& old, std::uint32_t w, const Point& p) {
    if(w < keeps_own_.size() && std::count(old.begin(), old.end(), w) != 0) {
      keeps_own_[w] = true;
      return;
    }
    const auto v = std::find_if(old.begin(), old.end(),
                                [&](std::uint32_t u) { return before.points[u] == p; });
    if(v != old.end())
      moves_.push_back({*v, w});
  }

  void sort_moves() {
    std::sort(moves_.begin(), moves_.end());
    moves_.erase(std::unique(moves_.begin(), moves_.end()), moves_.end());
  }

  bool keeps_own(std::uint32_t v) const { return v < keeps_own_.size() && keeps_own_[v]; }

  // By the vertices of before.
  void report_split(Change_log& log) const {
    for(auto begin = moves_.begin(); begin != moves_.end();) {
      const std::uint32_t v = begin->first;
      std::size_t number = keeps_own(v) ? 1 : 0;
      for(; begin != moves_.end() && begin->first == v; ++begin)
        ++number;
      if(number > 1)
        log.add(Change_kind::VERTICES_SPLIT,
                [&] { return name_of_vertex(v) + " into " + std::to_string(number); });
    }
  }

  // By the vertices of afterwards. Of those that have become one, the first is no change.
  void report_welded(Change_log& log) {
    for(auto& [v, w] : moves_)
      std::swap(v, w);
    sort_moves();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> welded; // which with which
    for(auto begin = moves_.begin(); begin != moves_.end();) {
      const std::uint32_t w = begin->first;
      const std::uint32_t first = keeps_own(w) ? (std::min)(w, begin->second) : begin->second;
      if(keeps_own(w) && first != w)
        welded.push_back({w, first});
      for(; begin != moves_.end() && begin->first == w; ++begin)
        if(begin->second != first)
          welded.push_back({begin->second, first});
    }
    std::sort(welded.begin(), welded.end());
    for(const auto& [v, first] : welded)
      log.add(Change_kind::VERTICES_WELDED, [v = v, first = first] {
        return name_of_vertex(v) + " to " + name_of_vertex(first);
      });
  }

  std::vector<bool> keeps_own_; // whether a vertex has a corner that it had before
  std::vector<std::pair<std::uint32_t, std::uint32_t>> moves_; // from vertex to vertex
};

// Edges that one face names, once.
std::size_t number_of_boundary_edges(const Soup& soup) {
  std::size_t number = 0;
  for_each_run(sorted_sides(soup),
               [&number](std::uint64_t, std::ptrdiff_t faces) { number += faces == 1 ? 1 : 0; });
  return number;
}

} // namespace

void report_vertices(const Soup& before, Mended_soup& mended) {
  Vertex_comparison(before, mended).report(mended.log);
}

void report_boundary(const Soup& before, Mended_soup& mended) {
  const std::size_t old_number = number_of_boundary_edges(before);
  const std::size_t number = number_of_boundary_edges(mended.soup);
  const std::string rest =
      ": " + std::to_string(number) + " instead of " + std::to_string(old_number);
  const auto words = [&](std::size_t count, const char* one, const char* many) {
    return (count == 1 ? one : many) + rest;
  };
  if(number < old_number)
    mended.log.add(Change_kind::BOUNDARY_EDGES_CLOSED, old_number - number,
                   words(old_number - number, "fewer boundary edge", "fewer boundary edges"));
  if(number > old_number)
    mended.log.add(Change_kind::BOUNDARY_EDGES_OPENED, number - old_number,
                   words(number - old_number, "more boundary edge", "more boundary edges"));
}

} // namespace htloops
