// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/point_welding.h"

#include "mend/change_counter.h"
#include "mend/polygons.h"
#include "read/point_merger.h"
#include "read/soup_words.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace htloops {
namespace {

constexpr std::uint32_t no_point = static_cast<std::uint32_t>(-1);

// An edge, as one number, with how many faces it has.
struct Counted_edge
{
  std::uint64_t edge;
  std::uint32_t count;

  bool is_open() const { return count == 1; }
  std::uint32_t first() const { return static_cast<std::uint32_t>(edge >> 32); }
  std::uint32_t second() const { return static_cast<std::uint32_t>(edge); }
};

// Of a face that goes along an edge and back again, it is none.
void append_sides(const Corners& corners, std::vector<std::uint64_t>& sides) {
  const std::size_t before = sides.size();
  for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) {
    if(u != v)
      sides.push_back(key_of_edge(u, v));
  });
  if(corners.size() == 3 && sides.size() == before + 3)
    return; // as nearly always
  const auto begin = sides.begin() + static_cast<std::ptrdiff_t>(before);
  std::sort(begin, sides.end());
  auto kept = begin;
  for(auto side = begin; side != sides.end();) {
    const auto next =
        std::find_if(side, sides.end(), [side](auto other) { return other != *side; });
    if(next == side + 1)
      *kept++ = *side;
    side = next;
  }
  sides.erase(kept, sides.end());
}

std::vector<Counted_edge> edges_of(const Soup& soup) {
  std::vector<std::uint64_t> sides;
  sides.reserve(3 * soup.faces.size() + soup.further_corners.size());
  for_each_polygon(soup,
                   [&](std::size_t, const Corners& corners) { append_sides(corners, sides); });
  std::sort(sides.begin(), sides.end());
  std::vector<Counted_edge> edges;
  for(const std::uint64_t side : sides)
    if(!edges.empty() && edges.back().edge == side)
      ++edges.back().count;
    else
      edges.push_back({side, 1});
  return edges;
}

class Welder
{
public:
  explicit Welder(Mended_soup& mended)
      : mended_(mended)
      , soup_(mended.soup) {}

  void run() {
    const std::vector<Counted_edge> edges = edges_of(soup_);
    if(std::none_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.is_open(); }))
      return;
    Point_merger merger;
    for(const Point& point : soup_.points)
      places_.push_back(merger.number(point));
    number_of_places_ = merger.take_points().size();
    choose_vertices(edges);
    weld();
  }

private:
  std::uint64_t place_of(const Counted_edge& edge) const {
    return key_of_edge(places_[edge.first()], places_[edge.second()]);
  }

  bool has_no_length(const Counted_edge& edge) const {
    return places_[edge.first()] == places_[edge.second()];
  }

  // Those of open edges that have no length, and of edges where another one lies, if one of them is
  // open.
  void choose_vertices(std::vector<Counted_edge> edges) {
    std::sort(edges.begin(), edges.end(), [this](const auto& a, const auto& b) {
      return std::make_pair(place_of(a), a.edge) < std::make_pair(place_of(b), b.edge);
    });
    is_welded_.assign(soup_.points.size(), false);
    for(auto begin = edges.begin(); begin != edges.end();) {
      bool has_open = false;
      auto end = begin;
      for(; end != edges.end() && place_of(*end) == place_of(*begin); ++end)
        has_open = has_open || end->is_open();
      const bool are_several = end - begin > 1;
      for(; begin != end; ++begin)
        if(has_open && (are_several || has_no_length(*begin)))
          is_welded_[begin->first()] = is_welded_[begin->second()] = true;
    }
  }

  void weld() {
    std::vector<std::uint32_t> first_at(number_of_places_, no_point);
    std::vector<std::uint32_t> welded(soup_.points.size());
    Change_counter counter;
    for(std::uint32_t v = 0; v < soup_.points.size(); ++v) {
      welded[v] = v;
      if(!is_welded_[v])
        continue;
      std::uint32_t& first = first_at[places_[v]];
      if(first == no_point)
        first = v;
      else
        counter.add([&] { return name_of_vertex(v) + " with " + name_of_vertex(first); });
      welded[v] = first;
    }
    for(Soup_face& face : soup_.faces)
      for(std::uint32_t& v : face)
        v = welded[v];
    for(std::uint32_t& v : soup_.further_corners)
      v = welded[v];
    counter.report(mended_, "vertex welded with another at the same place",
                   "vertices welded with others at the same place");
  }

  Mended_soup& mended_;
  Soup& soup_;
  std::vector<std::uint32_t> places_; // of points: equal ones have the same number
  std::size_t number_of_places_ = 0;
  std::vector<bool> is_welded_;
};

} // namespace

void weld_points(Mended_soup& mended) { Welder(mended).run(); }

} // namespace htloops
