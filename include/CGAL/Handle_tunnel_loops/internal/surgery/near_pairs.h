// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_NEAR_PAIRS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_NEAR_PAIRS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Contact_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// how many boxes each of some boxes may meet, on average, before a closer look pays: a dozen is
/// usual.
constexpr double largest_crowding = 128.;

/// `triangle(i)` is the i-th of n, the first of which may be compared with the others alone.
template <typename Triangle_of>
Contact_search contact_search(Execution execution,
                              std::size_t n,
                              const Triangle_of& triangle,
                              std::size_t number_of_first = 0) {
  std::vector<Contact_search::Triangle> triangles(n);
  for_each_index(execution, n, [&](std::size_t i) {
    const Placed_triangle t = triangle(i);
    triangles[i].vertices = t.vertices;
    for(std::size_t k = 0; k < 3; ++k)
      triangles[i].points[k] = {t.points[k].x(), t.points[k].y(), t.points[k].z()};
  });
  return Contact_search(std::move(triangles), number_of_first);
}

/// How many pairs of triangles are looked at because their boxes meet, before a closer look at the
/// triangles is cheaper: it takes as long as some pairs of each of them. Spent is the budget when
/// it would not do for the rest, if that goes on as what is done.
class Pair_budget
{
public:
  /// of so many triangles, of which each is done after the other, or some at once.
  explicit Pair_budget(std::size_t number_of_triangles)
      : to_do_(double((std::max)(number_of_triangles, std::size_t(1))))
      , size_(to_do_) {}

  static Pair_budget unlimited() {
    Pair_budget budget(0);
    budget.at_first_ = std::numeric_limits<double>::infinity();
    return budget;
  }

  /// to be called for each pair, with how many triangles are done once those of the pair are:
  /// whether there were enough pairs.
  bool is_spent(std::size_t done) {
    const double part = (std::min)(1., double(done) / to_do_);
    is_over_ = number_ >= at_first_ + largest_crowding * size_ * part;
    ++number_;
    return is_over_;
  }

  /// whether a pair was too much.
  bool is_over() const { return is_over_; }

  /// goes on, as a closer look is at so many triangles more.
  void extend(std::size_t number_of_triangles) {
    size_ += double(number_of_triangles);
    is_over_ = false;
  }

private:
  double to_do_, size_, at_first_ = largest_crowding * 256., number_ = 0.;
  bool is_over_ = false;
};

/// Which of some triangles a closer look than by boxes finds near each other: each pair once, the
/// later one first; or, if \p number_of_first is not 0, pairs of one of the first and one of the
/// others. Not known if one has no area.
inline std::optional<std::vector<std::pair<Index, Index>>>
near_pairs(std::vector<Placed_triangle> triangles, std::size_t number_of_first = 0) {
  std::vector<Index> vertices;
  for(const Placed_triangle& t : triangles) {
    if(t.is_degenerate())
      return std::nullopt;
    vertices.insert(vertices.end(), t.vertices.begin(), t.vertices.end());
  }
  make_set(vertices);
  for(Placed_triangle& t : triangles)
    for(Index& v : t.vertices) // without gaps
      v = static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                             vertices.begin());
  std::vector<std::pair<Index, Index>> pairs;
  const auto triangle = [&](std::size_t i) { return triangles[i]; };
  contact_search(Execution(), triangles.size(), triangle, number_of_first)
      .for_each_candidate(Execution(), [&](Index i, Index j) {
        pairs.push_back({(std::max)(i, j), (std::min)(i, j)});
      });
  make_set(pairs);
  return pairs;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_NEAR_PAIRS_H
