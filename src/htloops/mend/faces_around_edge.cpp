// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/faces_around_edge.h"

#include "mend/exact_point.h"

#include <algorithm>
#include <tuple>

namespace htloops {
namespace {

constexpr std::uint32_t no_partner = static_cast<std::uint32_t>(-1);

// A face at the edge.
struct Wing
{
  std::uint32_t halfedge;
  bool runs_up; // from the smaller vertex to the larger, after turning
  std::uint32_t piece;
  std::size_t size_of_piece;
  Exact_point tip;
  int sector = 0; // counted around the edge, from the first wing
};

class Edge_star
{
public:
  Edge_star(const Soup& soup,
            const Edge_table::Edge& edge,
            Face_pieces& pieces,
            const std::vector<bool>& is_turned)
      : bottom_(exact_point(soup.points[edge.vertices[0]]))
      , top_(exact_point(soup.points[edge.vertices[1]])) {
    for(std::size_t i = 0; i < edge.size(); ++i) {
      const std::uint32_t h = edge.halfedge(i), f = h / 3;
      const bool runs_up = (soup.source(h) == edge.vertices[0]) != is_turned[f];
      const std::uint32_t tip = soup.source(next_in_triangle(next_in_triangle(h)));
      wings_.push_back(
          {h, runs_up, pieces.piece(f), pieces.size_of_piece(f), exact_point(soup.points[tip])});
    }
    sort_around_edge();
  }

  std::vector<std::array<std::uint32_t, 2>> pairs() {
    partner_.assign(wings_.size(), no_partner);
    for(const std::vector<std::uint32_t>& group : groups_of_pieces())
      match(group);
    std::vector<std::uint32_t> rest;
    for(std::uint32_t i = 0; i < wings_.size(); ++i)
      if(partner_[i] == no_partner)
        rest.push_back(i);
    match(rest);
    std::vector<std::array<std::uint32_t, 2>> result;
    for(std::uint32_t i = 0; i < wings_.size(); ++i)
      if(partner_[i] != no_partner && i < partner_[i])
        result.push_back({wings_[i].halfedge, wings_[partner_[i]].halfedge});
    return result;
  }

private:
  bool is_flat(const Wing& wing) const { return CGAL::collinear(bottom_, top_, wing.tip); }

  // 0: beside the first wing, 1: less than half a turn from it, 2: opposite, 3: more, 4: nowhere,
  // as the face has no area.
  int sector_of(const Wing& wing, const Wing& first) const {
    if(is_flat(wing))
      return 4;
    switch(CGAL::orientation(bottom_, top_, first.tip, wing.tip)) {
    case CGAL::POSITIVE:
      return 1;
    case CGAL::NEGATIVE:
      return 3;
    default:
      return CGAL::coplanar_orientation(bottom_, top_, first.tip, wing.tip) == CGAL::POSITIVE ? 0
                                                                                              : 2;
    }
  }

  bool comes_before(const Wing& a, const Wing& b) const {
    if(a.sector != b.sector)
      return a.sector < b.sector;
    if(a.sector == 1 || a.sector == 3) {
      const CGAL::Orientation turn = CGAL::orientation(bottom_, top_, a.tip, b.tip);
      if(turn != CGAL::COPLANAR)
        return turn == CGAL::POSITIVE;
    }
    return a.halfedge < b.halfedge;
  }

  void sort_around_edge() {
    const auto first = std::find_if(wings_.begin(), wings_.end(),
                                    [this](const Wing& wing) { return !is_flat(wing); });
    if(first == wings_.end())
      return; // in the order of the file
    const Wing reference = *first;
    for(Wing& wing : wings_)
      wing.sector = sector_of(wing, reference);
    std::sort(wings_.begin(), wings_.end(),
              [this](const Wing& a, const Wing& b) { return comes_before(a, b); });
  }

  // Positions of wings around the edge: those of the largest piece, of the next one, ...
  std::vector<std::vector<std::uint32_t>> groups_of_pieces() const {
    std::vector<std::uint32_t> order;
    for(std::uint32_t i = 0; i < wings_.size(); ++i)
      order.push_back(i);
    const auto key = [this](std::uint32_t i) {
      const Wing& wing = wings_[i];
      return std::make_tuple(-static_cast<long long>(wing.size_of_piece), wing.piece);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return key(i) < key(j); });
    std::vector<std::vector<std::uint32_t>> groups;
    for(const std::uint32_t i : order) {
      if(groups.empty() || wings_[groups.back().front()].piece != wings_[i].piece)
        groups.emplace_back();
      groups.back().push_back(i);
    }
    return groups;
  }

  // Like brackets, on a circle: so twice around.
  void match(const std::vector<std::uint32_t>& group) {
    std::vector<std::uint32_t> open;
    for(int round = 0; round < 2; ++round)
      for(const std::uint32_t i : group) {
        if(partner_[i] != no_partner)
          continue;
        if(!wings_[i].runs_up) {
          if(round == 0)
            open.push_back(i);
        } else if(!open.empty()) {
          partner_[i] = open.back();
          partner_[open.back()] = i;
          open.pop_back();
        }
      }
  }

  const Exact_point bottom_, top_;
  std::vector<Wing> wings_;
  std::vector<std::uint32_t> partner_;
};

} // namespace

std::vector<std::array<std::uint32_t, 2>> pairs_around_edge(const Soup& soup,
                                                            const Edge_table::Edge& edge,
                                                            Face_pieces& pieces,
                                                            const std::vector<bool>& is_turned) {
  return Edge_star(soup, edge, pieces, is_turned).pairs();
}

} // namespace htloops
