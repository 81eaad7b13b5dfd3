// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include <map>
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

// A side of a face, as an edge, with what tells the face from others at the same edge. Of one that
// is there twice, both are the same: it will be dropped, and until then must not hide that an edge
// is open.
using Side = std::pair<std::uint64_t, std::uint32_t>;

// The same for all polygons with the same sides, and nearly always different for others.
std::uint64_t hash_of(const Corners& corners) {
  std::uint64_t sum = 0;
  for_each_side(corners, [&sum](std::uint32_t u, std::uint32_t v) {
    const std::uint64_t product = (edge_key(u, v) + 1) * 0x9E3779B97F4A7C15u;
    sum += (product ^ product >> 32) * 0xC2B2AE3D27D4EB4Fu;
  });
  return sum;
}

// Numbers polygons; those with the same sides have the same number. Looks closely only at those
// whose hashes say that they may.
class Polygon_numbers
{
public:
  explicit Polygon_numbers(const Soup& soup) {
    if(soup.further_corners.empty())
      return;
    std::vector<std::uint64_t> hashes;
    hashes.reserve(soup.faces.size());
    for_each_polygon(
        soup, [&](std::size_t, const Corners& corners) { hashes.push_back(hash_of(corners)); });
    std::sort(hashes.begin(), hashes.end());
    for(std::size_t i = 1; i < hashes.size(); ++i)
      if(hashes[i] == hashes[i - 1])
        repeated_.push_back(hashes[i]);
  }

  std::uint32_t number(std::size_t f, const Corners& corners) {
    const auto own = static_cast<std::uint32_t>(f);
    if(!std::binary_search(repeated_.begin(), repeated_.end(), hash_of(corners)))
      return own;
    return first_.try_emplace(in_standard_order(corners), own).first->second;
  }

private:
  std::vector<std::uint64_t> repeated_; // sorted
  std::map<Corners, std::uint32_t> first_;
};

class Side_collector
{
public:
  explicit Side_collector(const Soup& soup)
      : number_of_points_(static_cast<std::uint32_t>(soup.points.size()))
      , numbers_(soup) {
    sides_.reserve(3 * soup.faces.size() + soup.further_corners.size());
    for_each_polygon(soup, [this](std::size_t f, const Corners& corners) { add(f, corners); });
  }

  std::vector<Side> take_sorted() {
    std::sort(sides_.begin(), sides_.end());
    return std::move(sides_);
  }

private:
  // At an edge, the third corner tells triangles apart.
  void add(std::size_t f, const Corners& corners) {
    if(corners.size() == 3 && corners[0] != corners[1] && corners[1] != corners[2] &&
       corners[2] != corners[0])
      for(std::size_t i = 0; i < 3; ++i)
        sides_.push_back({edge_key(corners[i], corners[(i + 1) % 3]), corners[(i + 2) % 3]});
    else
      add_polygon(f, corners);
  }

  void add_polygon(std::size_t f, const Corners& corners) {
    const std::uint32_t face = number_of_points_ + numbers_.number(f, corners);
    const auto before = static_cast<std::ptrdiff_t>(sides_.size());
    for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) {
      if(u != v)
        sides_.push_back({edge_key(u, v), face});
    });
    drop_slits(before);
  }

  // Of a face that goes along an edge and back again, it is none.
  void drop_slits(std::ptrdiff_t before) {
    const auto begin = sides_.begin() + before;
    std::sort(begin, sides_.end());
    auto kept = begin;
    for(auto side = begin; side != sides_.end();) {
      const auto next = std::find_if(
          side, sides_.end(), [side](const Side& other) { return other.first != side->first; });
      if(next == side + 1)
        *kept++ = *side;
      side = next;
    }
    sides_.erase(kept, sides_.end());
  }

  const std::uint32_t number_of_points_;
  Polygon_numbers numbers_;
  std::vector<Side> sides_;
};

std::vector<Counted_edge> edges_of(const Soup& soup) {
  std::vector<Counted_edge> edges;
  std::uint32_t last_face = 0;
  for(const auto& [edge, face] : Side_collector(soup).take_sorted()) {
    if(edges.empty() || edges.back().edge != edge)
      edges.push_back({edge, 1});
    else if(face != last_face)
      ++edges.back().count;
    last_face = face;
  }
  return edges;
}

class Welder
{
public:
  explicit Welder(Soup& soup)
      : soup_(soup) {}

  bool run() {
    const std::vector<Counted_edge> edges = edges_of(soup_);
    if(std::none_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.is_open(); }))
      return false;
    Point_merger merger;
    for(const Point& point : soup_.points)
      places_.push_back(merger.number(point));
    number_of_places_ = merger.take_points().size();
    choose_vertices(edges);
    return weld();
  }

private:
  std::uint64_t place_of(const Counted_edge& edge) const {
    return edge_key(places_[edge.first()], places_[edge.second()]);
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

  bool weld() {
    std::vector<std::uint32_t> first_at(number_of_places_, no_point);
    std::vector<std::uint32_t> welded(soup_.points.size());
    bool is_any_welded = false;
    for(std::uint32_t v = 0; v < soup_.points.size(); ++v) {
      welded[v] = v;
      if(!is_welded_[v])
        continue;
      std::uint32_t& first = first_at[places_[v]];
      if(first == no_point)
        first = v;
      else
        is_any_welded = true;
      welded[v] = first;
    }
    for(Soup_face& face : soup_.faces)
      for(std::uint32_t& v : face)
        v = welded[v];
    for(std::uint32_t& v : soup_.further_corners)
      v = welded[v];
    return is_any_welded;
  }

  Soup& soup_;
  std::vector<std::uint32_t> places_; // of points: equal ones have the same number
  std::size_t number_of_places_ = 0;
  std::vector<bool> is_welded_;
};

} // namespace

bool weld_points(Mended_soup& mended) { return Welder(mended.soup).run(); }

namespace {

template <typename Visit> void for_each_corner(Soup& soup, Visit visit) {
  for(Soup_face& face : soup.faces)
    std::for_each(face.begin(), face.end(), visit);
  std::for_each(soup.further_corners.begin(), soup.further_corners.end(), visit);
}

} // namespace

Soup join_seams(Soup soup) {
  Welder(soup).run();
  std::vector<std::uint32_t> number(soup.points.size(), no_point);
  for_each_corner(soup, [&number](std::uint32_t v) { number[v] = 0; });
  std::uint32_t used = 0;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(number[v] != no_point) {
      soup.points[used] = soup.points[v];
      number[v] = used++;
    }
  soup.points.erase(soup.points.begin() + used, soup.points.end());
  for_each_corner(soup, [&number](std::uint32_t& v) { v = number[v]; });
  return soup;
}

} // namespace htloops
