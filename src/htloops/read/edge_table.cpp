// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/edge_table.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

// calls visit(smaller vertex, larger vertex, halfedge).
template <typename Visit> void for_each_halfedge(const Soup& soup, Visit visit) {
  std::uint32_t halfedge = 0;
  for(const Soup_face& face : soup.faces)
    for(int i = 0; i < 3; ++i, ++halfedge) {
      const auto [near_vertex, far_vertex] = std::minmax({face[i], face[(i + 1) % 3]});
      visit(near_vertex, far_vertex, halfedge);
    }
}

} // namespace

Edge_table::Edge_table(const Soup& soup)
    : first_(soup.points.size() + 1, 0)
    , entries_(3 * soup.faces.size()) {
  for_each_halfedge(soup, [this](std::uint32_t near_vertex, std::uint32_t, std::uint32_t) {
    ++first_[near_vertex];
  });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  // Filling backwards leaves each number at the beginning of its range.
  for_each_halfedge(
      soup, [this](std::uint32_t near_vertex, std::uint32_t far_vertex, std::uint32_t halfedge) {
        entries_[--first_[near_vertex]] = {far_vertex, halfedge};
      });
  for(std::size_t v = 0; v + 1 < first_.size(); ++v)
    std::sort(entries_.begin() + first_[v], entries_.begin() + first_[v + 1],
              [](const Entry& a, const Entry& b) {
                return std::make_pair(a.far_vertex, a.halfedge) <
                       std::make_pair(b.far_vertex, b.halfedge);
              });
}

} // namespace htloops
