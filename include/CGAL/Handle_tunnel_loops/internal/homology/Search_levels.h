// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_LEVELS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_LEVELS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Search_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A mesh to search for loops on and, where it pays, coarser ones for longer loops: on level k
/// places to search from are 2^k times as far apart as the vertices are.
class Search_levels
{
public:
  explicit Search_levels(const Flat_mesh& mesh)
      : mesh_(mesh)
      , base_(mesh) {}

  /// divides edges until they are short beside all loops that are to be searched for.
  void refine(double shortest_loop) {
    base_.refine((std::min)(even, 16 * mesh_.number_of_vertices()),
                 shortest_loop / steps_around_shortest);
    steps_around_ = refined_steps_around;
  }

  /// makes ready for so many visits of vertices in all.
  void prepare(Execution execution, double visits) {
    if(visits > double(mesh_.number_of_vertices())) {
      base_.measure(execution);
      const double area = base_.area(execution);
      if(area > 0.)
        density_ = double(base_.number_of_vertices()) / area;
    }
    if(visits > visits_worth_levels * double(base_.number_of_vertices()) && density_ > 0.)
      spacing_ = std::sqrt(1.15 / density_);
  }

  /// the level for loops of about this length.
  int level(double length) const {
    if(spacing_ == 0.)
      return 0;
    const double steps = length / (steps_around_ * spacing_);
    return steps < 2. ? 0 : (std::min)(std::ilogb(steps), largest_level);
  }

  /// the mesh of a level, which has been counted.
  const Search_mesh& operator[](int k) const { return k == 0 ? base_ : *coarser_.at(k); }

  /// About how many vertices of a level are within half the length of a loop: by how densely they
  /// lie, or because a geodesic crosses two edges on an edge length.
  double vertices_around(int k, double length, double number_of_crossings) const {
    const double by_density = density(k) * length * length;
    if(k > 0)
      return by_density;
    return (std::min)((std::max)(by_density, 0.3 * number_of_crossings * number_of_crossings),
                      double(base_.number_of_vertices()));
  }

  /// makes those levels that are not there, of all that are to be used, and counts.
  void count(Execution execution, const std::set<int>& levels, const Edge_classes& edge_classes) {
    base_.count(edge_classes);
    std::vector<std::pair<int, std::unique_ptr<Search_mesh>*>> wanted;
    for(int k : levels)
      if(k > 0)
        wanted.emplace_back(k, &coarser_[k]);
    for_each_index(
        execution, wanted.size(),
        [&](std::size_t i) {
          const auto& [k, mesh] = wanted[i];
          if(*mesh == nullptr)
            *mesh = std::make_unique<Search_mesh>(base_, std::ldexp(spacing_, k));
          (*mesh)->count(edge_classes);
        },
        1);
  }

  /// gives away the coarser meshes; they are made again when they are to be used.
  void forget_coarser() { coarser_.clear(); }

private:
  static constexpr std::size_t even = 5000; // vertices

  // Of a larger mesh, with fewer visits, coarser ones would take too many of them.
  static constexpr double visits_worth_levels = 4.;
  // A loop, at least; ways along the edges of a finer triangulation are better.
  static constexpr double steps_around = 24., refined_steps_around = 20.;
  static constexpr double steps_around_shortest = 10.;
  static constexpr int largest_level = 20;
  static constexpr double nodes_by_square = 0.7; // of the spacing

  double density(int k) const {
    const double spacing = std::ldexp(spacing_, k);
    return k == 0 ? density_ : nodes_by_square / (spacing * spacing);
  }

  const Flat_mesh& mesh_;
  Search_mesh base_; // level 0
  std::map<int, std::unique_ptr<Search_mesh>> coarser_;
  double density_ = 0.; // vertices by area, if many of them are visited
  double spacing_ = 0.; // of the vertices, if there are levels
  double steps_around_ = steps_around;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_LEVELS_H
