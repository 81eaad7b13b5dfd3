// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INNER_CYCLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INNER_CYCLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Linked_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loops_across.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Solid_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Rows of integers that are a part of a basis of all rows of integers, so that as many as a row is
wide have the determinant 1 or -1.

Of the integer vectors that are orthogonal to the rows a basis is kept. One more row belongs to such
a part if its products with these have no common factor. By steps of Euclid's algorithm between the
vectors all products but one become zero; the vector with the last one is left out.
*/
class Independent_rows
{
public:
  explicit Independent_rows(std::size_t width) {
    for(Index i = 0; i < width; ++i)
      orthogonal_.push_back({{{i, 1}}});
  }

  /// adds a row if it is a part of a basis together with the others.
  bool add(const std::vector<int>& row) {
    std::vector<Met> met;
    std::int64_t factor = 0;
    for(std::size_t i = 0; i < orthogonal_.size(); ++i)
      if(const std::int64_t product = orthogonal_[i] * row; product != 0) {
        met.push_back({i, product, {}});
        factor = std::gcd(factor, product);
      }
    if(factor != 1)
      return false;
    for(Met& m : met)
      m.vector = orthogonal_[m.place];
    const std::optional<std::size_t> last = divide(met);
    if(!last)
      return false;
    for(Met& m : met)
      orthogonal_[m.place] = std::move(m.vector);
    orthogonal_.erase(orthogonal_.begin() + static_cast<std::ptrdiff_t>(met[*last].place));
    return true;
  }

private:
  static constexpr std::int64_t largest = 1 << 24; // that is computed with

  /// The entries that are not 0, in order.
  struct Sparse_vector
  {
    std::vector<std::pair<Index, std::int64_t>> entries;

    std::int64_t operator*(const std::vector<int>& row) const {
      std::int64_t sum = 0;
      for(const auto& [i, x] : entries)
        sum += x * row[i];
      return sum;
    }

    // Adds a multiple of another one. Returns whether no number is too large.
    bool add(std::int64_t factor, const Sparse_vector& other) {
      std::vector<std::pair<Index, std::int64_t>> sum;
      bool are_small = std::abs(factor) <= largest;
      auto a = entries.begin();
      for(auto b = other.entries.begin(); are_small && b != other.entries.end(); ++b) {
        for(; a != entries.end() && a->first < b->first; ++a)
          sum.push_back(*a);
        std::int64_t x = factor * b->second;
        if(a != entries.end() && a->first == b->first)
          x += (a++)->second;
        are_small = std::abs(x) <= largest;
        if(x != 0)
          sum.emplace_back(b->first, x);
      }
      sum.insert(sum.end(), a, entries.end());
      entries = std::move(sum);
      return are_small;
    }
  };

  /// A vector that is not orthogonal to a row, as it is changed.
  struct Met
  {
    std::size_t place;
    std::int64_t product;
    Sparse_vector vector;
  };

  // Returns which one is left; nothing if numbers become too large.
  static std::optional<std::size_t> divide(std::vector<Met>& met) {
    for(;;) {
      std::size_t least = met.size(), number = 0;
      for(std::size_t i = 0; i < met.size(); ++i)
        if(met[i].product != 0) {
          ++number;
          if(least == met.size() || std::abs(met[i].product) < std::abs(met[least].product))
            least = i;
        }
      if(number == 1)
        return least;
      for(std::size_t i = 0; i < met.size(); ++i)
        if(const std::int64_t factor = met[i].product / met[least].product; i != least) {
          if(factor != 0 && !met[i].vector.add(-factor, met[least].vector))
            return std::nullopt;
          met[i].product -= factor * met[least].product;
        }
    }
  }

  std::vector<Sparse_vector> orthogonal_;
};

/*!
Chooses cycles of a graph inside a surface that are a basis of the first homology group of the
solid.

Shortest paths from the widest place, where ways through large balls are short, are a tree. An edge
that is not of the tree closes a cycle. Cycles in the order of their lengths are taken as long as
they are independent of those before. What is taken is the union of the paths and the edges that
close them, so that there are exactly so many cycles.
*/
class Inner_cycles
{
public:
  /// \p across are loops on the surface, of which some are the handle loops of a component, and no
  /// others are linked with what is inside.
  Inner_cycles(Execution execution, const Ball_graph& graph, const Loops_across& across)
      : graph_(graph)
      , paths_(graph.balls.size())
      , is_taken_(graph.edges.size(), 0)
      , roots_(across.genus.size(), no_index)
      , linked_(execution, graph, across) {
    find_tree();
    if(!across.loops.empty())
      close_cycles(across.genus);
  }

  /// what the way along an edge costs: the integral of one over the square of the radius, about;
  /// less in the middle of sheets, where radii are alike.
  static double cost(const Ball_graph& graph, Index edge) {
    const auto [a, b] = graph.edges[edge];
    return 0.5 * graph.length(edge) *
           (1. / square_of_width(graph, a) + 1. / square_of_width(graph, b));
  }

  const std::vector<char>& is_taken() const { return is_taken_; }
  /// the balls in the widest places, by component.
  const std::vector<Index>& roots() const { return roots_; }
  /// numbers of edges that add up along closed ways to a number of their class, 0 - that of the
  /// same way back; of different classes different ones, almost surely. Those of edges are for the
  /// way from the smaller end.
  const std::vector<std::uint64_t>& names() const { return linked_.names(); }
  /// the number of loops of which no cycle could be found.
  std::size_t number_of_missing_cycles() const { return missing_; }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index; // to the ball before
  };

  static double square_of_width(const Ball_graph& graph, Index ball) {
    constexpr double least = 1e-100;
    const double radius = (std::max)(graph.balls[ball].radius, least),
                 breadth = (std::max)(graph.breadth(ball), least);
    return radius * std::sqrt(radius * std::sqrt(radius * breadth));
  }

  Index before(Index ball) const { return graph_.other_end(paths_[ball].edge, ball); }

  void find_tree() {
    for(Index b = 0; b < graph_.balls.size(); ++b) {
      Index& root = roots_[graph_.component[b]];
      if(graph_.is_inlet[b] == 0 && // which is a leaf
         (root == no_index || square_of_width(graph_, b) > square_of_width(graph_, root)))
        root = b;
    }
    for(Index root : roots_)
      if(root != no_index)
        paths_.reach(root, {0., no_index});
    graph_.grow(
        paths_, [this](Index e) { return cost(graph_, e); },
        [](const Label&, double distance, Index e) {
          return Label{distance, e};
        });
  }

  // ---- cycles

  // Closes a cycle of a certain class, which is a number that is different for other classes but
  // for its sign, almost surely.
  struct Closing_edge
  {
    double length;
    Index edge;
    std::uint64_t name;
  };

  void close_cycles(const std::vector<std::size_t>& genus) {
    const std::vector<Closing_edge> closing = closing_edges();
    auto begin = closing.begin();
    for(Index c = 0; c < genus.size(); ++c) {
      const auto end = std::find_if(begin, closing.end(), [&](const Closing_edge& e) {
        return graph_.component[graph_.edges[e.edge][0]] != c;
      });
      take_basis({begin, end}, c, genus[c]);
      begin = end;
    }
  }

  // Component by component, the shortest first.
  std::vector<Closing_edge> closing_edges() const {
    std::vector<std::uint64_t> name(graph_.balls.size(), 0);
    for(Index b : down_the_tree()) {
      const Index e = paths_[b].edge;
      name[b] = name[before(b)] + linked_.name_from(before(b), e);
    }
    std::vector<Closing_edge> closing;
    for(Index e = 0; e < graph_.edges.size(); ++e) {
      const auto [a, b] = graph_.edges[e];
      if(paths_[a].edge == e || paths_[b].edge == e || !paths_.is_reached(a))
        continue;
      const std::uint64_t n = name[a] + linked_.names()[e] - name[b];
      if(n != 0)
        closing.push_back(
            {paths_[a].distance + paths_[b].distance + cost(graph_, e), e, (std::min)(n, 0 - n)});
    }
    const auto component = [this](const Closing_edge& c) {
      return graph_.component[graph_.edges[c.edge][0]];
    };
    std::sort(closing.begin(), closing.end(), [&](const Closing_edge& a, const Closing_edge& b) {
      return std::make_tuple(component(a), a.length, a.edge) <
             std::make_tuple(component(b), b.length, b.edge);
    });
    std::unordered_set<std::uint64_t> known;
    closing.erase(
        std::remove_if(closing.begin(), closing.end(),
                       [&](const Closing_edge& c) { return !known.insert(c.name).second; }),
        closing.end());
    return closing;
  }

  // The balls that are reached but for the roots, each behind the one before it.
  std::vector<Index> down_the_tree() const {
    std::vector<Index> order, way;
    std::vector<char> is_listed(graph_.balls.size(), 0);
    for(Index b : paths_.reached()) {
      for(; is_listed[b] == 0 && paths_[b].edge != no_index; b = before(b)) {
        is_listed[b] = 1;
        way.push_back(b);
      }
      order.insert(order.end(), way.rbegin(), way.rend());
      way.clear();
    }
    return order;
  }

  void take_basis(const std::vector<Closing_edge>& closing, Index component, std::size_t number) {
    Independent_rows rows(linked_.width(component));
    std::size_t taken = 0;
    for(const Closing_edge& c : closing) {
      if(taken == number)
        break;
      if(rows.add(linking_numbers(c.edge, component))) {
        ++taken;
        take(c.edge);
      }
    }
    missing_ += number - taken;
  }

  std::vector<int> linking_numbers(Index edge, Index component) const {
    std::vector<int> row(linked_.width(component), 0);
    const auto [a, b] = graph_.edges[edge];
    linked_.add(a, edge, 1, row);
    graph_.for_each_back(paths_, a, [&](Index from, Index e) { linked_.add(from, e, 1, row); });
    graph_.for_each_back(paths_, b, [&](Index from, Index e) { linked_.add(from, e, -1, row); });
    return row;
  }

  void take(Index edge) {
    is_taken_[edge] = 1;
    for(Index b : graph_.edges[edge])
      for(; paths_[b].edge != no_index && !is_taken_[paths_[b].edge]; b = before(b))
        is_taken_[paths_[b].edge] = 1;
  }

  const Ball_graph& graph_;
  Shortest_paths<Label> paths_;
  std::vector<char> is_taken_; // by edge
  std::vector<Index> roots_;   // by component
  Linked_edges linked_;
  std::size_t missing_ = 0;
};

/// adds ways along the wall to a graph of balls as long as `choose()`, which returns how many of
/// the cycles of the solid it misses there, misses some.
template <typename Choose>
void add_missing_ways(const Solid_balls& solid, Ball_graph& graph, const Choose& choose) {
  if(choose() > 0) { // holes that are small against the balls around them
    solid.add_ways_along_wall(graph);
    if(choose() > 0) { // walls that are thin everywhere against the distance of the balls
      solid.join_along_wall(graph);
      choose();
    }
  }
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INNER_CYCLES_H
