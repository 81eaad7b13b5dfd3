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

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Rows of integers that are independent modulo some small primes.
class Independent_rows
{
public:
  explicit Independent_rows(std::size_t width) {
    for(Modulo& m : modulo_)
      m.with_pivot.resize(width);
  }

  /// adds a row if it is independent of the others, whichever the prime.
  bool add(const std::vector<int>& integers) {
    std::array<Row, number_of_primes> rows;
    std::array<std::size_t, number_of_primes> pivots;
    for(std::size_t i = 0; i < number_of_primes; ++i) {
      rows[i] = residues(integers, modulo_[i].prime);
      pivots[i] = reduce(modulo_[i], rows[i]);
      if(pivots[i] == integers.size())
        return false;
    }
    for(std::size_t i = 0; i < number_of_primes; ++i)
      modulo_[i].with_pivot[pivots[i]] = std::move(rows[i]);
    return true;
  }

private:
  using Row = std::vector<std::uint8_t>;

  struct Modulo
  {
    int prime;
    std::vector<Row> with_pivot; // 1 there, nothing before
  };

  static constexpr std::size_t number_of_primes = 2;

  static Row residues(const std::vector<int>& integers, int prime) {
    Row row(integers.size());
    for(std::size_t i = 0; i < row.size(); ++i)
      row[i] = static_cast<std::uint8_t>((integers[i] % prime + prime) % prime);
    return row;
  }

  // Leaves what is independent of the others, and returns where it begins, with a 1.
  static std::size_t reduce(const Modulo& m, Row& row) {
    for(std::size_t i = 0; i < row.size(); ++i) {
      if(row[i] == 0)
        continue;
      const Row& other = m.with_pivot[i];
      if(other.empty()) {
        const int factor = row[i]; // modulo 2 and 3, a number is its own inverse
        for(std::size_t k = i; k < row.size(); ++k)
          row[k] = static_cast<std::uint8_t>(row[k] * factor % m.prime);
        return i;
      }
      const int factor = m.prime - row[i];
      for(std::size_t k = i; k < row.size(); ++k)
        row[k] = static_cast<std::uint8_t>((row[k] + factor * other[k]) % m.prime);
    }
    return row.size();
  }

  std::array<Modulo, number_of_primes> modulo_ = {{{2, {}}, {3, {}}}};
};

/*!
Chooses cycles of a graph inside a surface that are a basis of the first homology group of the
solid.

Shortest paths from the largest ball, where ways through large balls are short, are a tree. An edge
that is not of the tree closes a cycle. Cycles in the order of their lengths are taken as long as
they are independent of those before. What is taken is the union of the paths and the edges that
close them, so that there are exactly so many cycles.
*/
class Inner_cycles
{
public:
  /// \p loops are loops on the surface, of which some are the handle loops of a component, and no
  /// others are linked with what is inside; those of a component one after the other.
  Inner_cycles(Execution execution,
               const Ball_graph& graph,
               const std::vector<std::vector<Vector>>& loops,
               const std::vector<Index>& component_of_loop,
               const std::vector<std::size_t>& genus)
      : graph_(graph)
      , paths_(graph.balls.size())
      , is_taken_(graph.edges.size(), 0)
      , genus_(genus)
      , roots_(genus.size(), no_index)
      , names_(graph.edges.size(), 0) {
    find_tree();
    if(!loops.empty())
      close_cycles(execution, loops, component_of_loop);
  }

  /// what the way along an edge costs: the integral of one over the square of the radius, about.
  static double cost(const Ball_graph& graph, Index edge) {
    constexpr double least = 1e-100;
    double sum = 0.;
    for(Index b : graph.edges[edge]) {
      const double radius = (std::max)(graph.balls[b].radius, least);
      sum += 0.5 / (radius * radius);
    }
    return graph.length(edge) * sum;
  }

  const std::vector<char>& is_taken() const { return is_taken_; }
  /// the largest balls, by component.
  const std::vector<Index>& roots() const { return roots_; }
  /// numbers of edges that add up along closed ways to a number of their class, 0 - that of the
  /// same way back; of different classes different ones, almost surely. Those of edges are for the
  /// way from the smaller end.
  const std::vector<std::uint64_t>& names() const { return names_; }
  /// the number of loops of which no cycle could be found.
  std::size_t number_of_missing_cycles() const { return missing_; }

private:
  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index edge = no_index; // to the ball before
  };

  Index before(Index ball) const { return graph_.other_end(paths_[ball].edge, ball); }

  void find_tree() {
    for(Index b = 0; b < graph_.balls.size(); ++b) {
      Index& root = roots_[graph_.component[b]];
      if(root == no_index || graph_.balls[b].radius > graph_.balls[root].radius)
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

  using Passage = Loop_curtains::Passage;

  // Closes a cycle of a certain class, which is a number that is different for other classes but
  // for its sign, almost surely.
  struct Closing_edge
  {
    double length;
    Index edge;
    std::uint64_t name;
  };

  void close_cycles(Execution execution,
                    const std::vector<std::vector<Vector>>& loops,
                    const std::vector<Index>& component_of_loop) {
    const Loop_curtains curtains(execution, loops);
    passages_.resize(graph_.edges.size());
    for_each_index(
        execution, graph_.edges.size(),
        [&](std::size_t e) {
          const auto [a, b] = graph_.edges[e];
          curtains.for_each_passage(graph_.balls[a].centre, graph_.balls[b].centre,
                                    [&](const Passage& p) {
                                      if(component_of_loop[p.loop] == graph_.component[a])
                                        passages_[e].push_back(p);
                                    });
        },
        1024);
    std::size_t first = 0;
    find_names(loops.size());
    const std::vector<Closing_edge> closing = closing_edges();
    for(std::size_t l = 1; l <= loops.size(); ++l)
      if(l == loops.size() || component_of_loop[l] != component_of_loop[first]) {
        take_basis(closing, component_of_loop[first], first, l);
        first = l;
      }
  }

  void find_names(std::size_t number_of_loops) {
    std::mt19937_64 random;
    std::vector<std::uint64_t> key(number_of_loops);
    for(std::uint64_t& k : key)
      k = random();
    for(Index e = 0; e < names_.size(); ++e)
      for(const Passage& p : passages_[e])
        names_[e] += p.sign > 0 ? key[p.loop] : 0 - key[p.loop];
  }

  std::vector<Closing_edge> closing_edges() const {
    std::vector<std::uint64_t> name(graph_.balls.size(), 0);
    for(Index b : down_the_tree()) {
      const Index e = paths_[b].edge;
      name[b] = name[before(b)] + (graph_.edges[e][1] == b ? names_[e] : 0 - names_[e]);
    }
    std::vector<Closing_edge> closing;
    for(Index e = 0; e < graph_.edges.size(); ++e) {
      const auto [a, b] = graph_.edges[e];
      if(paths_[a].edge == e || paths_[b].edge == e || !paths_.is_reached(a))
        continue;
      const std::uint64_t n = name[a] + names_[e] - name[b];
      if(n != 0)
        closing.push_back(
            {paths_[a].distance + paths_[b].distance + cost(graph_, e), e, (std::min)(n, 0 - n)});
    }
    std::sort(closing.begin(), closing.end(), [](const Closing_edge& a, const Closing_edge& b) {
      return std::tie(a.length, a.edge) < std::tie(b.length, b.edge);
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

  void take_basis(const std::vector<Closing_edge>& closing,
                  Index component,
                  std::size_t first,
                  std::size_t end) {
    const std::size_t width = end - first, number = genus_[component];
    Independent_rows rows(width);
    std::size_t taken = 0;
    for(const Closing_edge& c : closing) {
      if(taken == number)
        break;
      if(graph_.component[graph_.edges[c.edge][0]] != component)
        continue;
      if(rows.add(linking_numbers(c.edge, first, width))) {
        ++taken;
        take(c.edge);
      }
    }
    missing_ += number - taken;
  }

  std::vector<int> linking_numbers(Index edge, std::size_t first, std::size_t width) const {
    std::vector<int> row(width, 0);
    const auto add = [&](Index e, int sign) {
      for(const Passage& p : passages_[e])
        row[p.loop - first] += sign * p.sign;
    };
    add(edge, 1);
    for(int k = 0; k < 2; ++k)
      for(Index b = graph_.edges[edge][k]; paths_[b].edge != no_index; b = before(b)) {
        const Index e = paths_[b].edge;
        add(e, (graph_.edges[e][1] == b) == (k == 0) ? 1 : -1);
      }
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
  std::vector<char> is_taken_;     // by edge
  std::vector<std::size_t> genus_; // by component
  std::vector<Index> roots_;       // by component
  std::vector<std::vector<Passage>> passages_;
  std::vector<std::uint64_t> names_; // by edge
  std::size_t missing_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_INNER_CYCLES_H
