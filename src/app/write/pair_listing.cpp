// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/pair_listing.h"

#include <CGAL/Handle_tunnel_loops/Loop_shape.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace htloops {
namespace {

CGAL::Bbox_3 box_of(const std::vector<Point>& points) {
  return CGAL::bbox_3(points.begin(), points.end());
}

bool lies_in(const CGAL::Bbox_3& inner, const CGAL::Bbox_3& outer) {
  for(int i = 0; i < 3; ++i)
    if(!(outer.min(i) <= inner.min(i) && inner.max(i) <= outer.max(i)))
      return false;
  return true;
}

bool is_wanted(const Loop& loop, const Listing_options& options) {
  const bool is_any_length_wanted =
      std::isinf(options.shorter_than); // a length may be infinite, too
  return (is_any_length_wanted || loop.length() < options.shorter_than) &&
         (!options.box || lies_in(box_of(loop.points()), *options.box));
}

bool is_wanted(const Pair& pair, const Listing_options& options) {
  return (is_wanted(pair.handle(), options) || is_wanted(pair.tunnel(), options)) &&
         (options.longer_than == 0. || (pair.handle().length() > options.longer_than &&
                                        pair.tunnel().length() > options.longer_than));
}

double noise_or_infinity(const Listed_pair& pair) {
  return pair.measure ? pair.measure->noise.most : (std::numeric_limits<double>::infinity)();
}

bool precedes(const Listed_pair& a, const Listed_pair& b, Pair_order order) {
  switch(order) {
  case Pair_order::SIZE:
    return std::tie(a.size, a.pair) < std::tie(b.size, b.pair);
  case Pair_order::LENGTH:
    return std::make_tuple(a.handle_length + a.tunnel_length, a.pair) <
           std::make_tuple(b.handle_length + b.tunnel_length, b.pair);
  case Pair_order::NOISE:
    return std::make_tuple(noise_or_infinity(a), a.pair) <
           std::make_tuple(noise_or_infinity(b), b.pair);
  case Pair_order::PLACE:
    return std::tie(a.centre, a.pair) < std::tie(b.centre, b.pair);
  default:
    return a.pair < b.pair;
  }
}

// Relative to the diagonal of a box, in units in which neither is too large.
double relative_length(const Loop& loop, const CGAL::Bbox_3& box) {
  double largest = 0.;
  for(int i = 0; i < 3; ++i)
    largest = (std::max)(largest, box.max(i) / 2. - box.min(i) / 2.);
  if(!(largest > 0.))
    return 0.; // all is at one place
  const auto distance = [largest](const auto& difference) {
    return length_of_vector(difference(0) / largest, difference(1) / largest,
                            difference(2) / largest);
  };
  double length = 0.;
  const std::vector<Point>& points = loop.points();
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[i + 1 == points.size() ? 0 : i + 1];
    length += distance([&](int k) { return p[k] / 2. - q[k] / 2.; });
  }
  return length / distance([&](int k) { return box.max(k) / 2. - box.min(k) / 2.; });
}

std::optional<Listed_ball> listed(const std::optional<Ball>& ball) {
  return ball ? std::optional(Listed_ball{ball->diameter, ball->error, ball->throat})
              : std::nullopt;
}

Listed_measure listed(const Measure& measure, const Pair& pair) {
  return {listed(measure.thickness),
          listed(measure.clear_width),
          range_of(measure.thickness, pair.handle()),
          range_of(measure.clear_width, pair.tunnel()),
          noise_of(measure, pair),
          measure.why};
}

const Loop& shorter_loop(const Pair& pair, const CGAL::Bbox_3& box) {
  return relative_length(pair.handle(), box) <= relative_length(pair.tunnel(), box) ? pair.handle()
                                                                                    : pair.tunnel();
}

// Of which handle, among some of a report.
template <typename Handle>
std::optional<Handle> find_pair(const std::vector<Handle>& handles, std::size_t pair) {
  const auto found = std::find_if(handles.begin(), handles.end(),
                                  [pair](const Handle& handle) { return handle.pair == pair; });
  return found == handles.end() ? std::nullopt : std::optional(*found);
}

} // namespace

Listed_hole hole_of(const Pair& pair, const std::optional<Bore>& bore) {
  const double wall_diameter = pair.handle().length() / CGAL_PI;
  if(bore)
    return {bore->diameter, bore, 0., wall_diameter};
  const auto circle = CGAL::loop_shape(pair.tunnel().points()).best_circle;
  return {circle ? circle->diameter : 0., std::nullopt, circle ? circle->out_of_roundness : 0.,
          wall_diameter};
}

Point middle_of(const CGAL::Bbox_3& box) {
  const auto middle = [&box](int i) { return box.min(i) / 2. + box.max(i) / 2.; };
  return {middle(0), middle(1), middle(2)};
}

double size_of(const Pair& pair, const CGAL::Bbox_3& box_of_mesh) {
  return relative_length(shorter_loop(pair, box_of_mesh), box_of_mesh);
}

Listed_pair listed_pair(const Answer& answer, std::size_t number, const CGAL::Bbox_3& box_of_mesh) {
  const Pair& pair = answer.pairs[number];
  const Loop& shorter = shorter_loop(pair, box_of_mesh);
  const CGAL::Bbox_3 box = box_of(shorter.points());
  const auto bore = number < answer.bores.size() ? answer.bores[number] : std::nullopt;
  return {number,
          pair.handle().length(),
          pair.tunnel().length(),
          relative_length(shorter, box_of_mesh),
          bore ? bore->center : middle_of(box),
          box,
          hole_of(pair, bore),
          number < answer.measures.size() ? std::optional(listed(answer.measures[number], pair))
                                          : std::nullopt,
          number < answer.costs.size() ? std::optional(answer.costs[number]) : std::nullopt};
}

Pair_listing list_removals(const Pair_listing& listing, const Removal_report& report) {
  Pair_listing chosen;
  for(const Listed_pair& pair : listing) {
    const Listed_removal removal = {find_pair(report.removed, pair.pair),
                                    find_pair(report.refused, pair.pair)};
    if(!removal.done && !removal.refused)
      continue;
    chosen.push_back(pair);
    chosen.back().removal = removal;
  }
  return chosen;
}

Pair_listing list_pairs(const Mesh& mesh, const Answer& answer, const Listing_options& options) {
  const CGAL::Bbox_3 box = box_of(mesh);
  Pair_listing listing;
  for(std::size_t i = 0; i < answer.pairs.size(); ++i)
    if(is_wanted(answer.pairs[i], options))
      listing.push_back(listed_pair(answer, i, box));
  if(!std::isinf(options.noise_below))
    listing.erase(std::remove_if(listing.begin(), listing.end(),
                                 [&](const Listed_pair& pair) { // surely not below it
                                   return !pair.measure ||
                                          pair.measure->noise.least >= options.noise_below;
                                 }),
                  listing.end());
  std::sort(listing.begin(), listing.end(), [&](const Listed_pair& a, const Listed_pair& b) {
    return precedes(a, b, options.order);
  });
  return listing;
}

} // namespace htloops
