// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/certificate/homology_classes.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Integer_lattice.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Decides whether loops bound, and whether their classes are a basis; see `Loop_certifier`.
class Homology_classes
{
  using Row = std::vector<std::pair<std::size_t, std::int64_t>>; // by column; no zeros

public:
  Homology_classes(std::size_t number_of_loops,
                   const std::vector<Chain_entry>& chains,
                   const std::vector<Used_edge>& edges)
      : number_of_loops_(number_of_loops)
      , chains_(chains)
      , edges_(edges) {
    find_potentials();
  }

  std::set<std::size_t> loops_that_do_not_bound() const {
    std::set<std::size_t> loops;
    for(const Row& row : rows_of_generators())
      for(const auto& loop_and_value : row)
        loops.insert(loop_and_value.first);
    return loops;
  }

  /// in words.
  std::vector<std::string> why_no_basis() {
    span_everything();
    return std::move(failures_);
  }

private:
  void fail(const std::string& message) { failures_.push_back(message); }

  // ---- a tree over the pieces, and what a curve along it meets on its way to each of them

  // Breadth first, so that the ways are short.
  void find_potentials() {
    Sparse_sum<std::int64_t> sum;
    std::map<Index, std::vector<const Used_edge*>> edges_at;
    for(const Used_edge& e : edges_) {
      edges_at[e.left].push_back(&e);
      edges_at[e.right].push_back(&e);
    }
    for(const auto& piece_and_edges : edges_at) {
      if(!potential_.emplace(piece_and_edges.first, Row()).second)
        continue;
      std::vector<Index> queue(1, piece_and_edges.first);
      for(std::size_t q = 0; q < queue.size(); ++q)
        for(const Used_edge* e : edges_at[queue[q]]) {
          const bool from_left = e->left == queue[q];
          const Index to = from_left ? e->right : e->left;
          if(potential_.count(to) != 0)
            continue;
          add(potential_.at(queue[q]), 1, sum);
          add_edge(*e, from_left ? 1 : -1, sum);
          potential_.emplace(to, row_of(sum));
          queue.push_back(to);
        }
    }
  }

  // No sum is too large: a value has 32 bits, and there are not as many edges as that.
  void add_edge(const Used_edge& e, int sign, Sparse_sum<std::int64_t>& sum) const {
    for(std::size_t i = e.first; i < e.last; ++i)
      sum.add(chains_[i].loop, sign * std::int64_t(chains_[i].value));
  }

  static void add(const Row& row, int sign, Sparse_sum<std::int64_t>& sum) {
    for(const auto& [column, value] : row)
      sum.add(static_cast<Index>(column), sign * value);
  }

  static Row row_of(Sparse_sum<std::int64_t>& sum) {
    Row row;
    sum.take([&](Index column, std::int64_t value) { row.emplace_back(column, value); });
    return row;
  }

  // ---- the intersection numbers span all integer vectors

  // The intersection numbers of the loops with the generators, short ones first; each vector once.
  std::vector<Row> rows_of_generators() const {
    std::vector<Row> rows;
    Sparse_sum<std::int64_t> sum;
    for(const Used_edge& e : edges_) {
      add_edge(e, 1, sum);
      add(potential_.at(e.left), 1, sum);
      add(potential_.at(e.right), -1, sum);
      if(Row row = row_of(sum); !row.empty())
        rows.push_back(std::move(row));
    }
    std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
      return a.size() != b.size() ? a.size() < b.size() : a < b;
    });
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
  }

  void span_everything() {
    Integer_lattice lattice(number_of_loops_);
    const std::vector<Row> rows = rows_of_generators();
    for(auto row = rows.begin(); row != rows.end() && !lattice.is_full(); ++row)
      lattice.add({row->begin(), row->end()});
    if(lattice.is_full())
      return;
    fail("the loops are not a basis of the first homology group: their classes have determinant " +
         lattice.index().str() + "; " + name_of_loop(lattice.first_defect()) +
         " depends on the others");
    explain(rows);
  }

  // The entries of a loop in all rows are the coordinates of its class, hence tell what it is.
  void explain(const std::vector<Row>& rows) {
    std::vector<Row> classes(number_of_loops_);
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(const auto& [loop, value] : rows[i])
        classes[loop].emplace_back(i, value);
    std::map<Row, std::size_t> first_of_class;
    for(std::size_t loop = 0; loop < number_of_loops_; ++loop) {
      if(classes[loop].empty()) {
        fail(name_of_loop(loop) + ": the loop bounds a part of the surface");
        continue;
      }
      const std::int64_t factor = divide_by_common_factor(classes[loop]);
      const auto [it, is_new] = first_of_class.emplace(classes[loop], loop);
      if(factor != 1)
        fail(name_of_loop(loop) + ": the loop goes around " + std::to_string(factor) +
             " times, up to homology");
      if(!is_new)
        fail(name_of_loop(loop) + ": up to multiples the loop is homologous to " +
             name_of_loop(it->second));
    }
  }

  // The first entry becomes positive.
  static std::int64_t divide_by_common_factor(Row& row) {
    std::int64_t factor = 0;
    for(const auto& column_and_value : row)
      factor = std::gcd(factor, column_and_value.second);
    const int sign = row.begin()->second < 0 ? -1 : 1;
    for(auto& column_and_value : row)
      column_and_value.second /= sign * factor;
    return factor;
  }

  std::size_t number_of_loops_;
  const std::vector<Chain_entry>& chains_;
  const std::vector<Used_edge>& edges_;
  std::map<Index, Row> potential_; // by piece
  std::vector<std::string> failures_;
};

/// compares what `keep_distinct_edges()` does not keep apart.
class Edge_order
{
public:
  explicit Edge_order(const std::vector<Chain_entry>& chains)
      : chains_(chains) {}

  bool operator()(const Used_edge& a, const Used_edge& b) const {
    const auto sizes_and_pieces = [](const Used_edge& e) {
      return std::make_tuple(e.last - e.first, e.left, e.right);
    };
    if(sizes_and_pieces(a) != sizes_and_pieces(b))
      return sizes_and_pieces(a) < sizes_and_pieces(b);
    return std::lexicographical_compare(
        chains_.begin() + a.first, chains_.begin() + a.last, chains_.begin() + b.first,
        chains_.begin() + b.last, [](const Chain_entry& x, const Chain_entry& y) {
          return std::tie(x.loop, x.value) < std::tie(y.loop, y.value);
        });
  }

private:
  const std::vector<Chain_entry>& chains_;
};

std::vector<Used_edge> add_up_chains(Execution execution, std::vector<Chain_entry>& chains) {
  sort(execution, chains.begin(), chains.end(), std::less<Chain_entry>());
  std::size_t kept = 0;
  for(std::size_t i = 0; i < chains.size();) {
    Chain_entry sum = chains[i];
    for(++i; i < chains.size() && chains[i].edge == sum.edge && chains[i].loop == sum.loop; ++i)
      sum.value += chains[i].value;
    if(sum.value != 0)
      chains[kept++] = sum;
  }
  chains.resize(kept);
  std::vector<Used_edge> edges;
  for(std::size_t i = 0; i < kept; ++i)
    if(i == 0 || chains[i].edge != chains[i - 1].edge)
      edges.push_back({chains[i].edge, i, i + 1, 0, 0});
    else
      edges.back().last = i + 1;
  return edges;
}

void keep_distinct_edges(Execution execution,
                         const std::vector<Chain_entry>& chains,
                         std::vector<Used_edge>& edges) {
  const Edge_order is_before(chains);
  sort(execution, edges.begin(), edges.end(), is_before);
  edges.erase(std::unique(edges.begin(), edges.end(),
                          [&](const Used_edge& a, const Used_edge& b) {
                            return !is_before(a, b) && !is_before(b, a);
                          }),
              edges.end());
}

std::vector<std::size_t> loops_that_do_not_bound(std::size_t number_of_loops,
                                                 const std::vector<Chain_entry>& chains,
                                                 const std::vector<Used_edge>& edges) {
  const std::set<std::size_t> loops =
      Homology_classes(number_of_loops, chains, edges).loops_that_do_not_bound();
  return {loops.begin(), loops.end()};
}

std::vector<std::string> why_no_basis(std::size_t number_of_loops,
                                      const std::vector<Chain_entry>& chains,
                                      const std::vector<Used_edge>& edges) {
  return Homology_classes(number_of_loops, chains, edges).why_no_basis();
}

} // namespace CGAL::Handle_tunnel_loops::internal
