// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/view.h"

#include "draw/seen_lines.h"
#include "draw/spread_lines.h"
#include "draw/surfaces.h"
#include "draw/upright.h"
#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

// A direction that something may be seen from, and how good it is in itself.
struct Candidate
{
  Vector from; // of length one
  double height;
  double weight;
};

// Things are looked at from a little above, hardly ever from below.
double weight_of_height(double height) {
  const double too_high = (std::max)(0., height - 0.55), too_low = (std::max)(0., 0.15 - height);
  return 1. - 0.7 * too_high - 0.4 * too_low;
}

// From the right of what is taken for the front, and a little above.
Candidate usual_candidate(const Axes& axes) {
  const Vector from = unit(axes.in_space({0.6, 1., 0.5}));
  constexpr double preference = 1.05; // another one has to be clearly better
  return {from, dot(from, axes.up), preference};
}

// Calls f(i) for all i below n, by all threads. Each takes long.
template <typename Function> void for_each_number(std::size_t n, const Function& f) {
  internal::for_each_index(internal::Execution::parallel(), n, f, 1);
}

// Points that are spread evenly over the sphere, along a spiral; the usual direction comes first.
std::vector<Candidate> candidates_around(const Vector& up) {
  constexpr std::size_t count = 240;
  const Axes axes = axes_of(up);
  std::vector<Candidate> candidates = {usual_candidate(axes)};
  for(std::size_t i = 0; i < count; ++i) {
    const double height = 1. - (2. * double(i) + 1.) / count;
    const double radius = std::sqrt(1. - height * height);
    const double angle = 2.399963229728653 * double(i); // the golden one
    const Vector from =
        axes.in_space({radius * internal::cosine(angle), radius * internal::sine(angle), height});
    candidates.push_back({unit(from), height, weight_of_height(height)});
  }
  return candidates;
}

// The length that is seen of all lines.
double seen_length(const Seen_lines::View& view) {
  return std::accumulate(view.lines.begin(), view.lines.end(), 0.,
                         [](double sum, const auto& line) { return sum + line.seen; });
}

/*
How good a view is. Each line counts by the part of it that is seen, and by how large that is, and
the more the shorter it is: that is what one looks for, and it is seen from few directions. That
many specks do not outweigh the large handles is seen to elsewhere, by the length that is seen in
all. All lines count more than the surface.
*/
double value_of(const Seen_lines::View& view) {
  double shares = 0., weights = 0.;
  for(const auto& line : view.lines) {
    const double weight = 1. / (std::max)(line.length, 1e-3);
    shares += weight * (0.4 * line.seen + 0.6 * line.large) / (std::max)(line.length, 1e-12);
    weights += weight;
  }
  constexpr double weight_of_lines = 4.;
  return view.surface + (weights > 0. ? weight_of_lines * shares / weights : 0.);
}

// The numbers of all, those with the largest values first.
std::vector<std::size_t> by_value(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return values[i] > values[j]; });
  return order;
}

// Whatever counts besides, nearly as much is seen as could be.
constexpr double least_part_of_most = 0.82;

// Candidates that deserve a closer look.
std::vector<std::size_t> promising(const std::vector<Candidate>& candidates,
                                   const std::vector<Seen_lines::View>& views) {
  std::vector<double> lengths, values;
  for(std::size_t i = 0; i < views.size(); ++i) {
    lengths.push_back(seen_length(views[i]));
    values.push_back(candidates[i].weight * value_of(views[i]));
  }
  const std::vector<std::size_t> by_length = by_value(lengths);
  constexpr std::size_t of_each = 4;
  std::vector<std::size_t> chosen(by_length.begin(), by_length.begin() + of_each);
  for(const std::size_t i : by_value(values)) {
    if(chosen.size() == 2 * of_each)
      break;
    if(lengths[i] >= least_part_of_most * lengths[by_length.front()] &&
       std::find(chosen.begin(), chosen.end(), i) == chosen.end())
      chosen.push_back(i);
  }
  return chosen;
}

// Of each group, the part of its length that is seen, and how large that is.
struct Group_view
{
  double share = 0., large = 0.;
};

std::vector<Group_view> group_views(const Seen_lines::View& view,
                                    const std::vector<std::size_t>& lines_in_group) {
  std::vector<Group_view> groups;
  auto line = view.lines.begin();
  for(const std::size_t count : lines_in_group) {
    double length = 0.;
    groups.emplace_back();
    for(std::size_t k = 0; k < count; ++k, ++line) {
      length += line->length;
      groups.back().share += line->seen;
      groups.back().large += line->large;
    }
    groups.back().share /= (std::max)(length, 1e-12);
    groups.back().large /= (std::max)(length, 1e-12);
  }
  return groups;
}

// All lines as one group.
Group_view as_group(const Seen_lines::View& view) {
  return group_views(view, {view.lines.size()}).front();
}

// Few directions such that from one of them each group is seen nearly as well as it can be: one
// after another, that which adds most to what is reached already.
std::vector<std::size_t> spread(const std::vector<std::vector<double>>& values_by_direction,
                                std::vector<double> reached) {
  constexpr std::size_t most = 8;
  std::vector<std::size_t> chosen;
  while(chosen.size() < most) {
    std::size_t best = 0;
    double largest = 0.;
    for(std::size_t d = 0; d < values_by_direction.size(); ++d) {
      double added = 0.;
      for(std::size_t g = 0; g < reached.size(); ++g)
        added += (std::max)(0., values_by_direction[d][g] - reached[g]);
      if(added > largest) {
        largest = added;
        best = d;
      }
    }
    if(!(largest > 1e-3))
      break;
    chosen.push_back(best);
    for(std::size_t g = 0; g < reached.size(); ++g)
      reached[g] = (std::max)(reached[g], values_by_direction[best][g]);
  }
  return chosen;
}

// The directions from which a group is seen best.
std::vector<std::size_t> best_for(const std::vector<std::vector<double>>& values_by_direction,
                                  std::size_t group) {
  constexpr std::size_t count = 5;
  std::vector<double> values;
  for(const std::vector<double>& of_groups : values_by_direction)
    values.push_back(of_groups[group]);
  std::vector<std::size_t> order = by_value(values);
  order.resize(count);
  return order;
}

// How good a view of a group is.
double value_of(const Group_view& view) { return 1.5 * view.share + 0.5 * view.large; }

/// Looks at lines on a surface from many directions: estimates what is seen from all of them, and
/// measures it from those that deserve it.
class View_search
{
public:
  View_search(const htl_scene::Surface& surface,
              const std::vector<Polyline>& lines,
              const Vector& up)
      : seen_(surface, lines)
      , has_lines_(!lines.empty())
      , candidates_(candidates_around(up))
      , views_(candidates_.size())
      , is_measured_(candidates_.size(), 0) {
    for_each_number(candidates_.size(),
                    [&](std::size_t d) { views_[d] = seen_.estimate(candidates_[d].from); });
  }

  /// from where the lines are seen best; without lines, the surface.
  Vector best_direction() {
    std::vector<std::size_t> chosen(candidates_.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t(0));
    if(has_lines_) {
      chosen = promising(candidates_, views_);
      measure(chosen);
    }
    double most = 0.;
    for(const std::size_t d : chosen)
      most = (std::max)(most, seen_length(views_[d]));
    std::size_t best = chosen.front();
    double largest = -1.;
    for(const std::size_t d : chosen)
      if(const double value = candidates_[d].weight * value_of(views_[d]);
         value > largest && seen_length(views_[d]) >= least_part_of_most * most)
      {
        largest = value;
        best = d;
      }
    return candidates_[best].from;
  }

  /// from where each group is seen best; see `best_views()`.
  std::vector<std::optional<Vector>>
  best_for_groups(const std::vector<std::size_t>& lines_in_group) {
    lines_in_group_ = lines_in_group;
    best_.assign(lines_in_group.size(), std::nullopt);
    largest_.assign(lines_in_group.size(), 0.);
    const std::vector<std::vector<double>> values = values_of_groups();
    std::vector<double> reached(lines_in_group.size(), 0.);
    for(std::size_t d = 0; d < candidates_.size(); ++d)
      if(is_measured_[d] != 0) {
        look_from(d);
        for(std::size_t g = 0; g < reached.size(); ++g)
          reached[g] = (std::max)(reached[g], values[d][g]);
      }
    const std::vector<std::size_t> chosen = spread(values, std::move(reached));
    measure(chosen);
    for(const std::size_t d : chosen)
      look_from(d);
    // What is seen from few directions only may be missed by all of these.
    std::size_t tries = 8;
    for(std::size_t g = 0; g < best_.size(); ++g)
      for(const std::size_t d : best_for(values, g))
        if(!best_[g] && values[d][g] > 0.5 && tries > 0) {
          look_from(d);
          --tries;
        }
    return best_;
  }

private:
  void measure(const std::vector<std::size_t>& directions) {
    for_each_number(directions.size(), [&](std::size_t i) {
      const std::size_t d = directions[i];
      if(is_measured_[d] == 0)
        views_[d] = seen_.measure(candidates_[d].from);
      is_measured_[d] = 1;
    });
  }

  std::vector<std::vector<double>> values_of_groups() const {
    std::vector<std::vector<double>> values(candidates_.size());
    for(std::size_t d = 0; d < candidates_.size(); ++d)
      for(const Group_view& view : group_views(views_[d], lines_in_group_))
        values[d].push_back(candidates_[d].weight * value_of(view));
    return values;
  }

  void look_from(std::size_t d) {
    measure({d});
    const std::vector<Group_view> views = group_views(views_[d], lines_in_group_);
    for(std::size_t g = 0; g < views.size(); ++g)
      if(const double value = candidates_[d].weight * value_of(views[g]);
         views[g].share >= 0.5 && value > largest_[g])
      {
        largest_[g] = value;
        best_[g] = candidates_[d].from;
      }
  }

  Seen_lines seen_;
  bool has_lines_;
  std::vector<Candidate> candidates_;
  std::vector<Seen_lines::View> views_; // by candidate: estimated, or measured
  std::vector<char> is_measured_;
  std::vector<std::size_t> lines_in_group_;
  std::vector<std::optional<Vector>> best_; // by group, and how good that is
  std::vector<double> largest_;
};

/*
From where lines inside a surface are seen best, if it is looked through: they cover much of the
picture, which they do where they are long in it, and few of them before others. A surface that is
seen from its broad side tells more of its shape, and does so without any lines.
*/
Vector direction_to_spread(const htl_scene::Surface& surface,
                           const std::vector<Polyline>& lines,
                           const Vector& up) {
  const Spread_lines spread(surface, lines);
  const std::vector<Candidate> candidates = candidates_around(up);
  std::vector<Spread_lines::View> views(candidates.size());
  for_each_number(candidates.size(),
                  [&](std::size_t d) { views[d] = spread.look_from(candidates[d].from); });
  Spread_lines::View most = {1e-12, 1e-12};
  for(const Spread_lines::View& view : views) {
    most.lines = (std::max)(most.lines, view.lines);
    most.surface = (std::max)(most.surface, view.surface);
  }
  std::vector<double> values;
  for(std::size_t d = 0; d < candidates.size(); ++d)
    values.push_back(candidates[d].weight *
                     (views[d].lines / most.lines + 0.5 * views[d].surface / most.surface));
  return candidates[by_value(values).front()].from;
}

Vector upright(const View& given, const htl_scene::Surface& surface) {
  return given.up.empty() ? upright_direction(surface)
                          : Vector{given.up[0], given.up[1], given.up[2]};
}

} // namespace

Whole_view view_through(const View& given,
                        const htl_scene::Surface& surface,
                        const std::vector<Polyline>& lines) {
  if(surface.triangles.empty() || !given.from.empty())
    return whole_view(given, surface);
  const Thread_limit limit(given.number_of_threads);
  const Vector up = upright(given, surface);
  return {direction_to_spread(surface, lines, unit(up)), up};
}

Whole_view whole_view(const View& given, const htl_scene::Surface& surface) {
  const Thread_limit limit(given.number_of_threads);
  Whole_view view = {{}, upright(given, surface)};
  if(!given.from.empty())
    view.from = {given.from[0], given.from[1], given.from[2]};
  else if(surface.triangles.empty())
    view.from = usual_candidate(axes_of(unit(view.up))).from;
  else
    view.from = View_search(surface, given.chosen, unit(view.up)).best_direction();
  return view;
}

Views views_of(const View& given,
               const htl_scene::Surface& surface,
               const std::vector<std::vector<Polyline>>& groups) {
  View all = given;
  all.chosen.clear();
  std::vector<std::size_t> lines_in_group;
  for(const std::vector<Polyline>& group : groups) {
    all.chosen.insert(all.chosen.end(), group.begin(), group.end());
    lines_in_group.push_back(group.size());
  }
  if(surface.triangles.empty() || all.chosen.empty())
    return {whole_view(all, surface), std::vector<std::optional<Vector>>(groups.size())};
  const Thread_limit limit(given.number_of_threads);
  const Vector up = upright(given, surface);
  View_search search(surface, all.chosen, unit(up));
  const Vector from = given.from.empty() ? search.best_direction()
                                         : Vector{given.from[0], given.from[1], given.from[2]};
  if(!given.is_for_rows)
    return {{from, up}, {}};
  return {{from, up}, search.best_for_groups(lines_in_group)};
}

std::vector<std::optional<Vector>> best_views(const htl_scene::Surface& surface,
                                              const std::vector<std::vector<Polyline>>& groups,
                                              const Vector& up) {
  View given;
  given.from = {1., 0., 0.}; // the whole is of no interest
  given.up = {up[0], up[1], up[2]};
  return views_of(given, surface, groups).of_groups;
}

Vector best_common_view(const std::vector<Lines_on_surface>& seen, const Vector& up) {
  std::vector<Seen_lines> searched;
  for(const Lines_on_surface& on_surface : seen)
    searched.emplace_back(on_surface.surface, on_surface.lines);
  using Look = Seen_lines::View (Seen_lines::*)(const Vector&) const;
  const auto values = [&](const std::vector<Candidate>& candidates, Look look) {
    std::vector<double> sums(candidates.size(), 0.);
    for_each_number(candidates.size(), [&](std::size_t i) {
      for(const Seen_lines& lines : searched)
        sums[i] += candidates[i].weight * value_of(as_group((lines.*look)(candidates[i].from)));
    });
    return sums;
  };
  const std::vector<Candidate> all = candidates_around(unit(up));
  const std::vector<std::size_t> order = by_value(values(all, &Seen_lines::estimate));
  constexpr std::size_t promising = 8;
  std::vector<Candidate> best;
  for(std::size_t i = 0; i < promising; ++i)
    best.push_back(all[order[i]]);
  return best[by_value(values(best, &Seen_lines::measure)).front()].from;
}

} // namespace htloops
