// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SURFACE_CURVES_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SURFACE_CURVES_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Cap_hubs.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_walker.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

inline int binary_exponent(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

/// how far most points spread along an axis: half the median distance to the median, or if this is
/// zero half the largest. Of many, some are looked at.
inline double spread_along(int axis, const std::vector<Vector>& points) {
  if(points.empty())
    return 0.;
  constexpr std::size_t enough = 10000;
  std::vector<double> numbers;
  for(std::size_t i = 0; i < points.size(); i += 1 + points.size() / enough)
    numbers.push_back(points[i][axis] / 2.);
  const auto median = [&] {
    const auto middle = numbers.begin() + numbers.size() / 2;
    std::nth_element(numbers.begin(), middle, numbers.end());
    return *middle;
  };
  const double center = median();
  for(double& x : numbers)
    x = std::abs(x - center);
  const double distance = median();
  return distance > 0. ? distance : *std::max_element(numbers.begin(), numbers.end());
}

/// the exponent that is nearest to the wanted one and lets all bits of all coordinates survive.
inline int allowed_exponent(int axis, const std::vector<Vector>& points, int wanted) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity, most = 0.;
  for(const Vector& p : points) {
    const double size = std::abs(p[axis]);
    least = size > 0. ? (std::min)(least, size) : least;
    most = (std::max)(most, size);
  }
  if(most == 0.)
    return 0;
  const int lowest = binary_exponent(least), highest = binary_exponent(most);
  constexpr int largest = 1000, smallest = -960;
  return (std::min)((std::max)(wanted, (std::min)(0, smallest - lowest)),
                    (std::max)(0, largest - highest));
}

/// turns the axes so that z is the one along which most points spread least: seen along it, as
/// little as can be lies behind each other. What turns leave as it is stays the same.
inline void turn_shortest_axis_to_z(std::vector<Vector>& points) {
  int axis = 2, shortest = binary_exponent(spread_along(2, points));
  for(int d : {0, 1})
    if(const int spread = binary_exponent(spread_along(d, points)); spread < shortest) {
      axis = d;
      shortest = spread;
    }
  if(axis != 2)
    for(Vector& p : points)
      p = {p[(axis + 1) % 3], p[(axis + 2) % 3], p[axis]};
}

/// scales the axes of points so that most of them spread about as far along each: what is squeezed
/// to a line, or nearly, is seen from the side then. The axes are scaled by powers of two, and not
/// so far that this is not exact, so that whatever linear maps leave as it is stays the same.
/// Returns the exponents.
inline std::array<int, 3> even_axes(std::vector<Vector>& points) {
  std::array<int, 3> exponents;
  for(int d = 0; d < 3; ++d) {
    const int wanted = -binary_exponent(spread_along(d, points));
    exponents[d] = allowed_exponent(d, points, wanted);
    if(exponents[d] != 0)
      for(Vector& p : points)
        p[d] = std::ldexp(p[d], exponents[d]);
  }
  return exponents;
}

/// turns and scales points so that little lies behind each other, seen along z; linking numbers
/// stay what they are. Returns how far along x and y the view may be inclined: no more than it
/// would be if axes were not scaled, as of what is long, parts far from each other would be seen at
/// the same place.
inline std::array<double, 2> prepare_view(std::vector<Vector>& points) {
  constexpr int least = -10; // walls are seen at an angle, however flat all is
  turn_shortest_axis_to_z(points);
  const std::array<int, 3> exponents = even_axes(points);
  std::array<double, 2> tilts;
  for(int d : {0, 1})
    tilts[d] = std::ldexp(1., (std::min)(0, (std::max)(least, exponents[d] - exponents[2])));
  return tilts;
}

/// The key of an edge of a walk, and the place of that edge in the sequence of all walks.
using Edge_position = std::pair<std::uint64_t, std::size_t>;

void sort_positions(Execution execution, std::vector<Edge_position>& positions);

/// Turns closed walks on the edges of a mesh into `Surface_curves`. Linear in their length, but for
/// a sort of their edges and an array of numbers of the vertices of the mesh.
///
/// A copy passes each vertex on the left, or on the right if there is a cap on the left, so that it
/// enters none. Between two vertices that it does not pass on the same side it crosses the edge of
/// its own walk.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
class Surface_curves_builder
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;

public:
  using Walk = std::vector<halfedge_descriptor>;

  /// \p hubs must outlive it.
  Surface_curves_builder(const TriangleMesh& tm,
                         VertexPointMap point,
                         VertexIndexMap vertex_index,
                         const Cap_hubs& hubs)
      : tm_(tm)
      , point_(point)
      , vertex_index_(vertex_index)
      , hubs_(hubs) {}

  /// \p outward is 1 or -1 for each walk, as in `Surface_curves`.
  Surface_curves
  build(Execution execution, const std::vector<Walk>& walks, std::vector<int> outward) {
    std::vector<Piece> pieces(walks.size());
    for_each_loop(execution, walks, [&](std::size_t i) {
      pieces[i].entered = entered_halfedges(walks[i]);
      pieces[i].index_bound = index_bound(walks[i], pieces[i].entered);
    });
    number_vertices(execution, walks, pieces);
    curves_.tilts = prepare_view(curves_.vertices);
    number_edges(execution, walks);
    for_each_loop(execution, walks, [&](std::size_t i) {
      add_steps(walks[i], pieces[i]);
      add_copy(pieces[i].entered, static_cast<Index>(i), pieces[i]);
    });
    join(execution, pieces);
    curves_.outward = std::move(outward);
    return std::move(curves_);
  }

private:
  // What is found of each loop by itself.
  struct Piece
  {
    Walk entered; // the halfedges by which the copy passes into faces
    std::size_t index_bound = 0;
    std::vector<vertex_descriptor> vertices; // seen here first
    std::vector<Surface_curves::Corner> corners;
    std::vector<std::pair<Index, int>> steps, crossings; // edges, and the sense
  };

  template <typename Function>
  static void
  for_each_loop(Execution execution, const std::vector<Walk>& walks, const Function& f) {
    for_each_index(execution, walks.size(), f, 1);
  }

  Index index(vertex_descriptor v) const { return static_cast<Index>(get(vertex_index_, v)); }

  vertex_descriptor apex(halfedge_descriptor h) const { return target(next(h, tm_), tm_); }

  // The copy of a walk, by the halfedges into whose faces it passes.
  Walk entered_halfedges(const Walk& walk) const {
    Walk entered;
    if(walk.empty())
      return entered;
    bool was_left = is_free_on_left(walk.back(), walk.front());
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const halfedge_descriptor in = walk[i], out = walk[i + 1 == walk.size() ? 0 : i + 1];
      CGAL_precondition_msg(source(out, tm_) == target(in, tm_), "walks are closed");
      const bool is_left = is_free_on_left(in, out);
      if(is_left != was_left)
        entered.push_back(is_left ? in : opposite(in, tm_));
      if(is_left)
        pass_on_left(in, out, entered);
      else
        pass_on_right(in, out, entered);
      was_left = is_left;
    }
    return entered;
  }

  // Whether no cap is to the left between two edges that follow each other. A vertex is on one
  // boundary curve at most, so there is none on the other side then.
  bool is_free_on_left(halfedge_descriptor in, halfedge_descriptor out) const {
    for(halfedge_descriptor h = next(in, tm_); h != out; h = next(opposite(h, tm_), tm_))
      if(hubs_.contain(index(target(h, tm_))))
        return false;
    return true;
  }

  void pass_on_left(halfedge_descriptor in, halfedge_descriptor out, Walk& entered) const {
    for(halfedge_descriptor h = next(in, tm_); h != out; h = next(opposite(h, tm_), tm_))
      entered.push_back(opposite(h, tm_));
  }

  void pass_on_right(halfedge_descriptor in, halfedge_descriptor out, Walk& entered) const {
    halfedge_descriptor h = opposite(in, tm_);
    while(h != out) {
      h = opposite(prev(h, tm_), tm_);
      if(h != out)
        entered.push_back(h);
    }
  }

  // ---- vertices

  // calls `f(v)` for all vertices that a walk and its copy need.
  template <typename Function>
  void for_each_vertex(const Walk& walk, const Walk& entered, const Function& f) const {
    for(halfedge_descriptor h : walk) {
      f(source(h, tm_));
      f(apex(h));
      f(apex(opposite(h, tm_)));
    }
    for(halfedge_descriptor h : entered) {
      f(source(h, tm_));
      f(target(h, tm_));
      f(apex(h));
    }
  }

  std::size_t index_bound(const Walk& walk, const Walk& entered) const {
    std::size_t bound = 0;
    for_each_vertex(walk, entered, [&](vertex_descriptor v) {
      bound = (std::max)(bound, std::size_t(index(v)) + 1);
    });
    return bound;
  }

  // In the order of their indices.
  void
  number_vertices(Execution execution, const std::vector<Walk>& walks, std::vector<Piece>& pieces) {
    std::size_t bound = 0;
    for(const Piece& piece : pieces)
      bound = (std::max)(bound, piece.index_bound);
    numbers_.reset(new std::atomic<Index>[bound]);
    for_each_index(execution, bound, [this](std::size_t i) { set_number(i, no_index); });
    for_each_loop(execution, walks, [&](std::size_t i) {
      for_each_vertex(walks[i], pieces[i].entered, [&](vertex_descriptor v) {
        std::atomic<Index>& number = numbers_[index(v)];
        if(number.load(std::memory_order_relaxed) == no_index &&
           number.exchange(0, std::memory_order_relaxed) == no_index)
          pieces[i].vertices.push_back(v);
      });
    });
    curves_.originals =
        collect<Index>(execution, bound, [this](std::size_t begin, std::size_t end) {
          std::vector<Index> seen;
          for(std::size_t i = begin; i < end; ++i)
            if(numbers_[i].load(std::memory_order_relaxed) != no_index)
              seen.push_back(static_cast<Index>(i));
          return seen;
        });
    for_each_index(execution, curves_.originals.size(), [this](std::size_t n) {
      set_number(curves_.originals[n], static_cast<Index>(n));
    });
    curves_.vertices.resize(curves_.originals.size());
    for_each_loop(execution, walks, [&](std::size_t i) {
      for(vertex_descriptor v : pieces[i].vertices)
        curves_.vertices[number_of(v)] = coordinates(point_, v);
    });
  }

  Index number_of(vertex_descriptor v) const {
    return numbers_[index(v)].load(std::memory_order_relaxed);
  }

  void set_number(std::size_t i, Index number) {
    numbers_[i].store(number, std::memory_order_relaxed);
  }

  // ---- edges

  // Each edge is known by one of its halfedges, which leads to the larger number; a walk along the
  // other counts as negative.
  bool is_reversed(halfedge_descriptor h) const {
    return number_of(target(h, tm_)) < number_of(source(h, tm_));
  }

  std::uint64_t key(halfedge_descriptor h) const {
    return edge_key(number_of(source(h, tm_)), number_of(target(h, tm_)));
  }

  // In the order in which the walks pass them first.
  void number_edges(Execution execution, const std::vector<Walk>& walks) {
    Walk all;
    for(const Walk& walk : walks)
      all.insert(all.end(), walk.begin(), walk.end());
    std::vector<Edge_position> places(all.size());
    for_each_index(execution, all.size(), [&](std::size_t i) { places[i] = {key(all[i]), i}; });
    sort_positions(execution, places);
    std::vector<Index> number(all.size(), no_index); // of edges, by the first place of each
    for(std::size_t i = 0; i < places.size(); ++i)
      if(i == 0 || places[i].first != places[i - 1].first)
        number[places[i].second] = 0;
    for(std::size_t i = 0; i < all.size(); ++i)
      if(number[i] != no_index) {
        number[i] = static_cast<Index>(firsts_.size());
        firsts_.push_back(all[i]);
      }
    note_edges(places, number);
    curves_.edges.resize(firsts_.size());
    for_each_index(execution, firsts_.size(), [this](std::size_t e) {
      const halfedge_descriptor h =
          is_reversed(firsts_[e]) ? opposite(firsts_[e], tm_) : firsts_[e];
      curves_.edges[e] = {number_of(source(h, tm_)), number_of(target(h, tm_)), number_of(apex(h)),
                          number_of(apex(opposite(h, tm_)))};
    });
  }

  // Lists the edges by the vertices at which they begin.
  void note_edges(const std::vector<Edge_position>& places, const std::vector<Index>& number) {
    first_at_.assign(curves_.originals.size() + 1, 0);
    for(std::size_t i = 0; i < places.size(); ++i)
      if(i == 0 || places[i].first != places[i - 1].first) {
        ++first_at_[(places[i].first >> 32) + 1];
        edges_.emplace_back(static_cast<Index>(places[i].first), number[places[i].second]);
      }
    std::partial_sum(first_at_.begin(), first_at_.end(), first_at_.begin());
  }

  // The number of an edge, or none.
  Index find_edge(halfedge_descriptor h) const {
    const std::uint64_t k = key(h);
    for(Index i = first_at_[k >> 32]; i < first_at_[(k >> 32) + 1]; ++i)
      if(edges_[i].first == static_cast<Index>(k))
        return edges_[i].second;
    return no_index;
  }

  void add_steps(const Walk& walk, Piece& piece) const {
    for(halfedge_descriptor h : walk) {
      piece.steps.emplace_back(find_edge(h), is_reversed(h) ? -1 : 1);
      CGAL_assertion_msg(piece.steps.back().first != no_index,
                         "the edges of the walks are numbered");
    }
  }

  // ---- copies

  void add_copy(const Walk& entered, Index loop, Piece& piece) const {
    for(std::size_t i = 0; i < entered.size(); ++i) {
      const Index edge = find_edge(entered[i]);
      if(edge != no_index)
        piece.crossings.emplace_back(edge, is_reversed(entered[i]) ? -1 : 1);
      const halfedge_descriptor left = opposite(entered[i + 1 == entered.size() ? 0 : i + 1], tm_);
      // If the copy leaves a face where it has entered it, it has not been in it.
      if(left == next(entered[i], tm_))
        piece.corners.push_back(
            corner(source(left, tm_), source(entered[i], tm_), target(left, tm_), loop));
      else if(left != entered[i])
        piece.corners.push_back(
            corner(source(entered[i], tm_), target(entered[i], tm_), source(left, tm_), loop));
    }
  }

  Surface_curves::Corner
  corner(vertex_descriptor apex, vertex_descriptor from, vertex_descriptor to, Index loop) const {
    return {number_of(apex), number_of(from), number_of(to), loop};
  }

  // Puts the loops together in their order.
  void join(Execution execution, const std::vector<Piece>& pieces) {
    for(std::size_t i = 0; i < pieces.size(); ++i) {
      const auto loop = static_cast<Index>(i);
      for(const auto& [edge, sense] : pieces[i].steps)
        curves_.walks.add(edge, loop, sense);
      for(const auto& [edge, sense] : pieces[i].crossings)
        curves_.crossings.add(edge, loop, sense);
      curves_.corners.insert(curves_.corners.end(), pieces[i].corners.begin(),
                             pieces[i].corners.end());
    }
    curves_.walks.finish(execution, curves_.edges.size());
    curves_.crossings.finish(execution, curves_.edges.size());
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  VertexIndexMap vertex_index_;
  const Cap_hubs& hubs_;
  Surface_curves curves_;
  std::unique_ptr<std::atomic<Index>[]> numbers_; // of vertices, by index in the mesh
  Walk firsts_;                                   // by edge: how it was passed first
  std::vector<std::pair<Index, Index>> edges_;    // the end, and the number
  std::vector<Index> first_at_;                   // by vertex: where its edges are in edges_
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_SURFACE_CURVES_BUILDER_H
