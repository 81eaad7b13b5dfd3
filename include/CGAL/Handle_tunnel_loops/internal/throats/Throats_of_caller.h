// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_THROATS_OF_CALLER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_THROATS_OF_CALLER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/Throat.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/find_throats.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The classes of closed curves, by their intersection numbers with the loops of pairs.
class Classes_by_pairs
{
public:
  /// \p loops are handles and tunnels in turn.
  Classes_by_pairs(const Flat_mesh& mesh, const std::vector<Crossing_loop>& loops)
      : index_(mesh, loops) {
    for(const Crossing_loop& loop : loops)
      rows_.push_back(index_.intersections(loop));
  }

  Sparse_numbers of(const Crossing_loop& loop) const { return index_.intersections(loop); }

  /// the loop of this class, or of the opposite one, if there is one.
  std::optional<std::size_t> loop_of_class(const Sparse_numbers& numbers) const {
    for(std::size_t i = 0; i < rows_.size() && !numbers.empty(); ++i)
      if(are_same_or_opposite(rows_[i], numbers))
        return i;
    return {};
  }

private:
  Crossing_index index_;
  std::vector<Sparse_numbers> rows_;
};

/// Throats on the mesh of the caller.
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap>
class Throats_of_caller
{
public:
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  Throats_of_caller(Execution execution,
                    const TriangleMesh& tm,
                    VertexPointMap point,
                    VertexIndexMap index)
      : execution_(execution)
      , tm_(tm)
      , index_(index)
      , surface_(execution, tm, index, point)
      , place_(num_vertices(tm), no_index) {
    for(Index i = 0; i < surface_.vertices.size(); ++i) {
      const std::size_t number = get(index_, surface_.vertices[i]);
      if(number >= place_.size())
        place_.resize(number + 1, no_index);
      place_[number] = i;
    }
  }

  template <typename PairRange, typename GeomTraits, typename OutputIterator>
  OutputIterator find(const PairRange& pairs,
                      const std::vector<Vertex>& through,
                      double least_prominence,
                      const GeomTraits& traits,
                      OutputIterator out) const {
    if(!(least_prominence > 0.))
      throw std::invalid_argument("throats(): the least prominence must be positive");
    const std::vector<Crossing_loop> known = loops_of(pairs);
    Throat_limits limits = {least_prominence, {}};
    for(const Vertex v : through)
      limits.through_vertices.push_back(place_of(v));
    const Classes_by_pairs classes(surface_.mesh, known);
    std::size_t number = 0;
    for(const Flat_throat& flat : find_flat_throats(execution_, surface_.mesh, known, limits)) {
      const auto loop = surface_.converter(traits)(flat.loop, Loop_type::HANDLE, number++);
      Throat<TriangleMesh, Point> throat = in_class(loop, classes.of(flat.loop), classes);
      throat.prominence = surface_.mesh.in_units_of_caller(flat.prominence * flat.length);
      for(const Index v : flat.through)
        throat.through.push_back(surface_.vertices[v]);
      *out++ = std::move(throat);
    }
    return out;
  }

  /// what is known of throats by their classes, for loops that were found elsewhere, and are closed
  /// curves on the surface.
  template <typename PairRange, typename Loop>
  std::vector<Throat<TriangleMesh, Point>> classified(const PairRange& pairs,
                                                      const std::vector<Loop>& loops) const {
    const Classes_by_pairs classes(surface_.mesh, loops_of(pairs));
    std::vector<Throat<TriangleMesh, Point>> throats;
    for(const Loop& loop : loops)
      throats.push_back(in_class(loop, classes.of(beside(loop)), classes));
    return throats;
  }

private:
  template <typename PairRange> std::vector<Crossing_loop> loops_of(const PairRange& pairs) const {
    std::vector<Crossing_loop> loops;
    for(const auto& pair : pairs)
      for(const auto* loop : {&pair.handle(), &pair.tunnel()})
        loops.push_back(beside(*loop));
    if(loops.size() != 2 * surface_.mesh.genus)
      throw std::invalid_argument("throats(): the number of pairs must equal the genus");
    return loops;
  }

  Index place_of(Vertex v) const {
    const std::size_t number = get(index_, v);
    if(number >= place_.size() || place_[number] == no_index)
      throw std::invalid_argument(
          "throats(): a vertex through which a loop is wanted has no faces");
    return place_[number];
  }

  // A loop beside one of the caller: along the nearer ends of the edges that it crosses, of which
  // two that follow each other belong to one face.
  template <typename Loop> Crossing_loop beside(const Loop& loop) const {
    std::vector<Index> walk;
    for(const auto& step : loop.steps())
      walk.push_back(
          place_of(step.ratio < 0.5 ? source(step.halfedge, tm_) : target(step.halfedge, tm_)));
    return loop_along(surface_.mesh, std::move(walk));
  }

  template <typename Loop>
  static Throat<TriangleMesh, Point>
  in_class(const Loop& loop, const Sparse_numbers& numbers, const Classes_by_pairs& classes) {
    Throat<TriangleMesh, Point> throat;
    throat.is_separating = numbers.empty();
    throat.bounds_inside = throat.bounds_outside = true;
    for(const auto& entry : numbers)
      (entry.first % 2 == 0 ? throat.bounds_inside : throat.bounds_outside) = false;
    Loop_type type =
        throat.bounds_outside && !throat.bounds_inside ? Loop_type::TUNNEL : Loop_type::HANDLE;
    if(const auto same = classes.loop_of_class(numbers)) {
      throat.pair = *same / 2;
      type = *same % 2 == 0 ? Loop_type::HANDLE : Loop_type::TUNNEL;
    }
    throat.loop = loop.with_type(type);
    return throat;
  }

  Execution execution_;
  const TriangleMesh& tm_;
  VertexIndexMap index_;
  Prepared_surface<TriangleMesh, VertexPointMap> surface_;
  std::vector<Index> place_; // in the arrays, by number of the caller
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_THROATS_OF_CALLER_H
