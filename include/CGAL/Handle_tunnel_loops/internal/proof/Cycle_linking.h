// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_CYCLE_LINKING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_CYCLE_LINKING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Integer_lattice.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Flat_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Skeleton_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A closed walk on the edges of a mesh, by its vertices.
using Vertex_walk = std::vector<Index>;

/*!
Linking numbers of cycles of a skeleton with closed walks on the surface that they do not meet: how
often, counted by sense, a cycle is seen to pass over a walk along any direction. It is counted once
for each edge of the skeleton, and added up along cycles. Exact: see `Projected_points`.
*/
class Cycle_linking
{
public:
  /// \p is_wanted tells by edge of the skeleton whether it lies on a cycle that is asked for, and \p
  /// places where the vertices of the mesh are. The skeleton must outlive it.
  Cycle_linking(Execution execution,
                const Flat_skeleton& skeleton,
                const std::vector<char>& is_wanted,
                const std::vector<Vector>& places,
                const std::vector<Vertex_walk>& walks)
      : skeleton_(skeleton)
      , steps_(steps_of(walks))
      , vertices_(vertices(places))
      , tilts_(prepare_view(vertices_))
      , points_(vertices_, direction()) {
    count(execution, is_wanted);
  }

  /// the linking numbers of a cycle, by walk.
  std::vector<Matrix_entry> numbers(const Skeleton_cycles::Cycle& cycle, Index number) const {
    std::vector<Matrix_entry> row;
    for(const auto& [e, sense] : cycle)
      for(std::size_t i = begin_[e]; i < begin_[e + 1]; ++i)
        row.push_back({number, crossings_[i].column, sense * crossings_[i].value});
    add_up(Execution(), row);
    return row;
  }

private:
  using Point = Projected_points::Point;

  struct Step
  {
    Index from, to, walk;
  };

  struct Seen
  {
    Point a, b;
    Box<2> box;
  };

  static std::vector<Step> steps_of(const std::vector<Vertex_walk>& walks) {
    std::vector<Step> steps;
    for(Index w = 0; w < walks.size(); ++w)
      for(std::size_t i = 0; i < walks[w].size(); ++i)
        steps.push_back({walks[w][i], walks[w][i + 1 == walks[w].size() ? 0 : i + 1], w});
    return steps;
  }

  // The points of the skeleton and, after them, the vertices of the walks, whose steps are numbered
  // anew.
  std::vector<Vector> vertices(const std::vector<Vector>& places) {
    std::vector<Index> used;
    for(const Step& step : steps_)
      used.push_back(step.from);
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<Vector> vertices = skeleton_.points;
    const auto number = [&, first = vertices.size()](Index v) {
      return static_cast<Index>(first +
                                (std::lower_bound(used.begin(), used.end(), v) - used.begin()));
    };
    for(Step& step : steps_)
      step = {number(step.from), number(step.to), step.walk};
    for(Index v : used)
      vertices.push_back(places[v]);
    return vertices;
  }

  // The same in each run; one that is not special.
  Projected_points::Direction direction() const {
    std::minstd_rand random;
    const auto next = [&] { return (static_cast<int>(random() % 1024) * 2 - 1023) / 1024.; };
    const double a = next() * tilts_[0];
    return {a, next() * tilts_[1]};
  }

  Seen seen(Index u, Index v) const {
    const Point a = points_.vertex(u), b = points_.vertex(v);
    const double e =
        (std::max)(Projected_points::position_error(a), Projected_points::position_error(b));
    return {a,
            b,
            {{(std::min)(a.x, b.x) - e, (std::min)(a.y, b.y) - e},
             {(std::max)(a.x, b.x) + e, (std::max)(a.y, b.y) + e}}};
  }

  // Steps near each other in the view together. Coordinates are at most 1, and 3 as they are seen.
  std::vector<Step> sorted_steps(Execution execution) const {
    const auto order = space_filling_order(execution, steps_.size(), [this](std::size_t i) {
      const Point p = points_.vertex(steps_[i].from);
      const auto part = [](double x) { return (std::min)((std::max)(x / 6. + 0.5, 0.), 1.); };
      return Vector{part(p.x), part(p.y), 0.};
    });
    std::vector<Step> sorted(steps_.size());
    for(std::size_t i = 0; i < sorted.size(); ++i)
      sorted[i] = steps_[order[i]];
    return sorted;
  }

  void count(Execution execution, const std::vector<char>& is_wanted) {
    steps_ = sorted_steps(execution);
    std::vector<Box<2>> boxes(steps_.size());
    for_each_index(execution, steps_.size(),
                   [&](std::size_t i) { boxes[i] = seen(steps_[i].from, steps_[i].to).box; });
    const Box_tree<2> tree(std::move(boxes));
    crossings_ = collect<Matrix_entry>(
        execution, skeleton_.edges.size(),
        [&](std::size_t begin, std::size_t end) {
          std::vector<Matrix_entry> found;
          for(Index e = static_cast<Index>(begin); e < end; ++e)
            if(is_wanted[e])
              add_crossings(e, tree, found);
          add_up(Execution(), found);
          return found;
        },
        64);
    begin_.assign(skeleton_.edges.size() + 1, 0);
    for(const Matrix_entry& e : crossings_)
      ++begin_[e.row + 1];
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  }

  void add_crossings(Index e, const Box_tree<2>& tree, std::vector<Matrix_entry>& found) const {
    const auto [p, q] = skeleton_.edges[e];
    const Seen edge = seen(p, q);
    tree.for_each_meeting(edge.box, [&](Index i, const Box<2>&) {
      const Point a = points_.vertex(steps_[i].from), b = points_.vertex(steps_[i].to);
      const int sense = points_.crossing_of_moved(edge.a, edge.b, a, b);
      if(sense != 0 && points_.side(edge.a, edge.b, a, b) == sense)
        found.push_back({e, steps_[i].walk, sense});
    });
  }

  const Flat_skeleton& skeleton_;
  std::vector<Step> steps_;
  std::vector<Vector> vertices_;
  std::array<double, 2> tilts_;
  Projected_points points_;
  Sparse_matrix crossings_;        // by edge of the skeleton and walk
  std::vector<std::size_t> begin_; // by edge
};

/// the absolute value of the determinant of a matrix; of one with more columns than rows, the index
/// of the lattice of its columns: the greatest common divisor of all determinants. The columns with
/// the fewest entries come first.
inline Integer_lattice::Integer determinant(const Sparse_matrix& matrix, std::size_t rows) {
  Sparse_matrix entries = matrix;
  for(Matrix_entry& e : entries)
    std::swap(e.row, e.column);
  std::sort(entries.begin(), entries.end());
  std::vector<Integer_lattice::Row> columns;
  for(std::size_t i = 0; i < entries.size(); ++i) {
    if(i == 0 || entries[i].row != entries[i - 1].row)
      columns.emplace_back();
    columns.back().emplace(entries[i].column, entries[i].value);
  }
  std::stable_sort(columns.begin(), columns.end(),
                   [](const auto& a, const auto& b) { return a.size() < b.size(); });
  Integer_lattice lattice(rows);
  for(Integer_lattice::Row& column : columns)
    lattice.add(std::move(column));
  return lattice.index();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_CYCLE_LINKING_H
