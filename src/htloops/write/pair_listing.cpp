// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/pair_listing.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace htloops {
namespace {

bool lies_in(const CGAL::Bbox_3& inner, const CGAL::Bbox_3& outer) {
  for(int i = 0; i < 3; ++i)
    if(!(outer.min(i) <= inner.min(i) && inner.max(i) <= outer.max(i)))
      return false;
  return true;
}

bool is_wanted(const Loop& loop, const Listing_options& options) {
  return loop.length() < options.shorter_than &&
         (!options.box ||
          lies_in(CGAL::bbox_3(loop.points().begin(), loop.points().end()), *options.box));
}

bool is_wanted(const Pair& pair, const Listing_options& options) {
  return (is_wanted(pair.handle(), options) || is_wanted(pair.tunnel(), options)) &&
         pair.handle().length() > options.longer_than &&
         pair.tunnel().length() > options.longer_than;
}

bool precedes(const Listed_pair& a, const Listed_pair& b, Pair_order order) {
  switch(order) {
  case Pair_order::SIZE:
    return std::tie(a.size, a.pair) < std::tie(b.size, b.pair);
  case Pair_order::LENGTH:
    return std::make_tuple(a.handle_length + a.tunnel_length, a.pair) <
           std::make_tuple(b.handle_length + b.tunnel_length, b.pair);
  case Pair_order::PLACE:
    return std::tie(a.centre, a.pair) < std::tie(b.centre, b.pair);
  default:
    return a.pair < b.pair;
  }
}

} // namespace

double diagonal_of(const Mesh& mesh) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

Listed_pair listed_pair(const Pair& pair, std::size_t number, double diagonal) {
  const double handle = pair.handle().length(), tunnel = pair.tunnel().length();
  const Loop& shorter = handle <= tunnel ? pair.handle() : pair.tunnel();
  const CGAL::Bbox_3 box = CGAL::bbox_3(shorter.points().begin(), shorter.points().end());
  const auto middle = [&box](int i) { return box.min(i) / 2. + box.max(i) / 2.; };
  return {
      number, handle, tunnel, shorter.length() / diagonal, Point(middle(0), middle(1), middle(2)),
      box};
}

Pair_listing list_pairs(const Mesh& mesh, const Pairs& pairs, const Listing_options& options) {
  const double diagonal = diagonal_of(mesh);
  Pair_listing listing;
  for(std::size_t i = 0; i < pairs.size(); ++i)
    if(is_wanted(pairs[i], options))
      listing.push_back(listed_pair(pairs[i], i, diagonal));
  std::sort(listing.begin(), listing.end(), [&](const Listed_pair& a, const Listed_pair& b) {
    return precedes(a, b, options.order);
  });
  return listing;
}

} // namespace htloops
