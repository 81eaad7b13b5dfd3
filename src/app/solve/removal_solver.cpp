// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/removal_solver.h"

#include "failure.h"
#include "words.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/remove_handles.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>

namespace htloops {
namespace {

namespace parameters = CGAL::parameters;

void check_numbers(const std::vector<std::size_t>& numbers, std::size_t count) {
  for(const std::size_t number : numbers)
    if(number >= count)
      throw wrong_usage(
          "pair " + std::to_string(number) + " does not exist: the mesh has " +
          (count == 0 ? "no handles" : counted(count, "pair", "pairs") + ", numbered from 0"));
}

using Changeable_pair = Changeable_pairs::value_type;

// Which pairs may be looked at, by number.
std::function<bool(const Changeable_pair&)> filter_of(const Removal_options& options,
                                                      std::size_t count) {
  if(!options.pairs)
    return [](const Changeable_pair&) { return true; };
  check_numbers(*options.pairs, count);
  return [&numbers = *options.pairs](const Changeable_pair& pair) {
    return std::count(numbers.begin(), numbers.end(), pair.handle().pair_index()) > 0;
  };
}

// What is wrong with the wish, and not with the mesh, is wrong usage.
template <typename NamedParameters>
Removal_report remove_as_wanted(Changeable_mesh& mesh, const NamedParameters& np) {
  try {
    return CGAL::remove_handles<All_threads_tag>(mesh, np);
  } catch(const CGAL::Handle_tunnel_loops::Invalid_mesh_exception&) {
    throw;
  } catch(const std::invalid_argument& reason) {
    throw wrong_usage(reason.what());
  }
}

using Patches = std::map<Changeable_mesh::Face_index, std::size_t>;

// Parts of faces that were there before, as there are at the rims of caps, are none.
std::vector<std::size_t> patches_of(const Changed_mesh& changed, const Patches& patches) {
  std::vector<std::size_t> result(changed.faces.size(), Removal_answer::no_patch);
  for(std::size_t f = 0; f < result.size(); ++f)
    if(changed.face_parents[f] == nothing_before)
      result[f] = patches.at(
          Changeable_mesh::Face_index(static_cast<Changeable_mesh::size_type>(changed.faces[f])));
  return result;
}

using Vertex = Mesh::Vertex_index;

// Of the neighbours that have a value.
double mean(const Mesh& mesh,
            const std::vector<double>& values,
            const std::vector<bool>& is_known,
            Vertex v) {
  double sum = 0., count = 0.;
  for(const Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    if(is_known[w.idx()]) {
      sum += values[w.idx()];
      count += 1.;
    }
  return sum / count;
}

bool has_known_neighbour(const Mesh& mesh, const std::vector<bool>& is_known, Vertex v) {
  const auto around = CGAL::vertices_around_target(mesh.halfedge(v), mesh);
  return std::any_of(around.begin(), around.end(), [&](Vertex w) { return is_known[w.idx()]; });
}

// Those of the vertices in question that are beside known ones; the others stay.
std::vector<Vertex>
take_next(const Mesh& mesh, const std::vector<bool>& is_known, std::vector<Vertex>& unknown) {
  std::vector<Vertex> next, rest;
  for(const Vertex v : unknown)
    (has_known_neighbour(mesh, is_known, v) ? next : rest).push_back(v);
  unknown.swap(rest);
  return next;
}

} // namespace

Removal_answer remove_handles(const Mesh& mesh,
                              const Pairs& pairs,
                              const Removal_options& options,
                              Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  progress.start("remove");
  CGAL::Handle_tunnel_loops::Removal_options wanted = options;
  if(wanted.target_genus && *wanted.target_genus > pairs.size()) // nothing is to do
    wanted.target_genus = pairs.size();
  Changeable_copy copy(mesh);
  const Changeable_pairs loops = copy.pairs(pairs);
  Face_parents parents;
  Patches patches;
  const auto filtered = parameters::callback(progress.callback())
                            .filter(filter_of(options, pairs.size()))
                            .face_patch_map(boost::make_assoc_property_map(patches))
                            .face_to_face_map(boost::make_assoc_property_map(parents));
  Removal_answer answer;
  answer.number_of_threads = limit.number_of_threads();
  answer.report = remove_as_wanted(
      copy.mesh, parameters::removal_options(wanted, parameters::known_loops(loops, filtered)));
  progress.end();
  static_cast<Changed_mesh&>(answer) = changed_mesh(copy.mesh, mesh, parents);
  answer.patches = patches_of(answer, patches);
  return answer;
}

void spread_properties(const Changed_mesh& changed, Vertex_properties& properties) {
  if(properties.empty())
    return;
  const Mesh& mesh = changed.mesh;
  std::vector<bool> is_known;
  std::vector<Vertex> unknown;
  for(const std::int64_t origin : changed.vertex_origins)
    is_known.push_back(origin != nothing_before);
  for(const Vertex v : mesh.vertices())
    if(!is_known[v.idx()] && !mesh.is_isolated(v))
      unknown.push_back(v);
  for(Vertex_property& property : properties) {
    const std::vector<double> before = std::move(property.values);
    property.values.clear();
    for(const std::int64_t origin : changed.vertex_origins)
      property.values.push_back(origin == nothing_before ? 0. : before[std::size_t(origin)]);
  }
  for(std::vector<Vertex> next; !(next = take_next(mesh, is_known, unknown)).empty();) {
    for(Vertex_property& property : properties)
      for(const Vertex v : next) {
        const double value = mean(mesh, property.values, is_known, v);
        property.values[v.idx()] = property.is_real() ? value : std::round(value);
      }
    for(const Vertex v : next)
      is_known[v.idx()] = true;
  }
}

} // namespace htloops
