// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Class_shortening.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Purification.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Time_budget.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

namespace right_classes {

static bool is_any_new(const std::vector<Index>& before) {
  return std::find(before.begin(), before.end(), no_index) != before.end();
}

static void put(std::vector<Crossing_loop>& loops, std::vector<Flat_pair>& pairs) {
  for(std::size_t k = 0; k < pairs.size(); ++k)
    pairs[k] = {std::move(loops[2 * k]), std::move(loops[2 * k + 1])};
}

// Which of loops are new, and named so.
static std::vector<char> new_ones(const std::vector<Index>& before) {
  std::vector<char> is_new;
  for(Index b : before)
    is_new.push_back(b == no_index);
  return is_new;
}

// Shortens pairs that `before` names; the loops that are replaced have no name afterwards.
static void shorten(Class_shortening& shortening,
                    std::vector<Flat_pair>& pairs,
                    const std::vector<char>& is_pure,
                    const std::vector<char>& is_new,
                    std::vector<Index>& before) {
  std::vector<Crossing_loop> loops = Purification::loops_of(pairs);
  const std::vector<Index> sources = shortening.run(loops, is_pure, is_new);
  put(loops, pairs);
  const std::vector<Index> first = before;
  for(std::size_t i = 0; i < sources.size(); ++i)
    before[i] = sources[i] == no_index ? no_index : first[sources[i]];
}

// The time that it takes is kept back for relating pairs once more.
static Loop_relations
relate_all(const Relate_pairs& relate, const std::vector<Flat_pair>& pairs, Time_budget& time) {
  const double began = time.seconds_spent();
  Loop_relations relations = relate(pairs, nullptr);
  time.keep_back(time.seconds_spent() - began);
  return relations;
}

// Short loops that bound come first, where there are many. What is not pure after all is as it was
// at first. Returns what loops were before; `is_made` are those that have been put together.
static std::vector<Index> purify(Class_shortening& shortening,
                                 Purification& purification,
                                 const Loop_relations& relations,
                                 const std::vector<Flat_pair>& first,
                                 std::vector<Flat_pair>& pairs,
                                 std::vector<char>& is_made) {
  std::vector<Crossing_loop> loops = Purification::loops_of(pairs);
  std::optional<Loop_sides> sides = purification.sides(loops, relations);
  if(std::optional<Loop_sides> changed = shortening.take_bounding_loops(loops, *sides))
    sides = std::move(changed);
  put(loops, pairs);
  std::vector<Index> before = purification.run(pairs, relations.components, std::move(sides));
  is_made = new_ones(before);
  for(Index i = 0; i < before.size(); ++i)
    if(!purification.is_pure()[i / 2]) {
      pairs[i / 2] = first[i / 2];
      before[i] = i;
    } else if(before[i] != no_index)
      before[i] = shortening.sources()[before[i]];
  return before;
}

// Where new loops do not bound although their classes should, the surface crosses itself, and the
// pairs that there were take their places again. Returns whether there are any.
static bool take_back(const std::vector<Flat_pair>& first,
                      const std::vector<char>& is_pure,
                      const Loop_relations& relations,
                      std::vector<Flat_pair>& pairs) {
  const std::vector<char> inside = relations.bounds_alone(true),
                          outside = relations.bounds_alone(false);
  std::set<std::size_t> components;
  for(std::size_t k = 0; k < pairs.size(); ++k)
    if(is_pure[k] && (!inside[2 * k] || !outside[2 * k + 1]))
      components.insert(relations.components[2 * k]);
  for(std::size_t k = 0; k < pairs.size(); ++k)
    if(components.count(relations.components[2 * k]) != 0)
      pairs[k] = first[k];
  return !components.empty();
}

// Loops that come from a coarse mesh are straight, but no geodesics yet, and what was put together
// of very many is not even that. They stay so if there is no time left.
static void tighten(Execution execution,
                    const Flat_mesh& mesh,
                    Time_budget& time,
                    std::vector<Flat_pair>& pairs) {
  constexpr double work_by_face = 512.;
  double crossings = 0.;
  for(const Flat_pair& pair : pairs)
    crossings += double(pair.handle.size() + pair.tunnel.size());
  for_each_index(
      execution, 2 * pairs.size(),
      [&](std::size_t i) {
        if(time.is_any_left())
          Loop_tightening(execution, mesh)
              .tighten_among(i % 2 == 0 ? pairs[i / 2].handle : pairs[i / 2].tunnel,
                             work_by_face * double(mesh.number_of_faces()), crossings);
      },
      1);
}

} // namespace right_classes

std::optional<Loop_relations> find_right_classes(Execution execution,
                                                 const Flat_mesh& mesh,
                                                 const Class_options& options,
                                                 const Relate_pairs& relate,
                                                 std::vector<Flat_pair>& pairs,
                                                 Progress& progress,
                                                 const Coarse_mesh* coarse) {
  // Parts of the time, about, when they begin or end.
  constexpr double first_linking = 0.25, second_linking = 0.75;
  std::optional<Loop_relations> relations;
  bool is_any_loose = coarse != nullptr;
  std::optional<Class_shortening> shortening;
  shortening.emplace(execution, mesh, coarse, options.search_effort, progress);
  if(options.do_link) {
    relations = right_classes::relate_all(relate, pairs, progress.time());
    const std::vector<Flat_pair> first = pairs;
    progress.advance(first_linking);
    Purification purification(execution, mesh, options.do_shorten, progress, coarse);
    std::vector<char> is_made;
    std::vector<Index> before =
        options.do_shorten
            ? right_classes::purify(*shortening, purification, *relations, first, pairs, is_made)
            : purification.run(pairs, *relations);
    is_any_loose = is_any_loose || purification.is_any_loose();
    if(options.do_shorten)
      right_classes::shorten(*shortening, pairs, purification.is_pure(), is_made, before);
    progress.advance(second_linking);
    if(!right_classes::is_any_new(before))
      relations->renumber(before);
    else {
      if(options.kind == Basis_kind::PURE)
        shortening.reset(); // its meshes are large
      const Known_relations known = {*relations, before};
      relations = relate(pairs, &known);
      if(right_classes::take_back(first, purification.is_pure(), *relations, pairs))
        relations.reset();
    }
  }
  if(options.kind == Basis_kind::SHORTEST) {
    std::vector<Index> before(2 * pairs.size(), Index(0));
    shortening->forget_pairs();
    if(options.do_shorten)
      right_classes::shorten(*shortening, pairs, std::vector<char>(pairs.size(), 0),
                             std::vector<char>(before.size(), 0), before);
    match_loops(execution, mesh, pairs);
    relations.reset();
  }
  if(is_any_loose && options.do_shorten)
    right_classes::tighten(execution, mesh, progress.time(), pairs);
  return relations;
}

} // namespace CGAL::Handle_tunnel_loops::internal
