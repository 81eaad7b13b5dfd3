// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_REQUEST_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_REQUEST_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/shortest_walk_beside.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Turns what a caller wants of a cut, in terms of the mesh, into a `Cut_problem`.
template <typename TriangleMesh, typename VertexIndexMap> class Cut_request
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  /// The surface must outlive it.
  template <typename VertexPointMap>
  Cut_request(Execution execution,
              VertexIndexMap index,
              const Prepared_surface<TriangleMesh, VertexPointMap>& surface)
      : execution_(execution)
      , tm_(surface.tm)
      , index_(index)
      , vertices_(surface.vertices)
      , problem_(execution, surface.mesh)
      , flat_index_(bound(surface.mesh), no_index) {
    for_each_index(execution, vertices_.size(), [&](std::size_t i) {
      flat_index_[surface.mesh.original[i]] = static_cast<Index>(i);
    });
  }

  void use_lengths() {
    problem_.weight.resize(problem_.halfedges.size());
    for_each_index(execution_, problem_.weight.size(), [&](std::size_t h) {
      const Index i = static_cast<Index>(h);
      problem_.weight[h] =
          problem_.mesh.edge_length(problem_.halfedges.source(i), problem_.halfedges.target(i));
    });
  }

  template <typename EdgeWeightMap> void use_weights(const EdgeWeightMap& weights) {
    problem_.weight.resize(problem_.halfedges.size());
    for(const edge_descriptor e : edges(tm_)) {
      const Index h = halfedge_of(e);
      const double weight = CGAL::to_double(get(weights, e));
      if(!(weight >= 0.))
        throw std::invalid_argument("the weight of an edge is negative or not a number: " +
                                    name_of(e));
      problem_.weight[h] = problem_.weight[problem_.halfedges.twin(h)] = weight;
      if(std::isinf(weight))
        set_rule(h, Edge_rule::AVOID);
    }
  }

  /// after the weights.
  template <typename EdgeMarkMap> void keep_edges(const EdgeMarkMap& marks) {
    for(const edge_descriptor e : edges(tm_))
      if(get(marks, e)) {
        const Index h = halfedge_of(e);
        if(problem_.is_avoided(h))
          throw No_cut_exception("an edge is both kept and avoided: " + name_of(e));
        set_rule(h, Edge_rule::KEEP);
      }
  }

  template <typename VertexMarkMap> void add_cones(const VertexMarkMap& marks) {
    problem_.cones.resize(problem_.mesh.number_of_vertices(), 0);
    for(const vertex_descriptor v : vertices(tm_))
      if(get(marks, v)) {
        const Index i = index_of(v);
        if(i == no_index || vertices_[i] != v)
          throw std::invalid_argument("a cone belongs to no face");
        problem_.cones[i] = 1;
      }
  }

  /// to be called last. The boundary is open, whatever the rules say of its edges.
  void open_at_boundaries() {
    const Flat_mesh& mesh = problem_.mesh;
    const Flat_halfedges& halfedges = problem_.halfedges;
    if(mesh.number_of_hubs == 0)
      return;
    problem_.rules.resize(halfedges.size(), Edge_rule::FREE);
    problem_.cones.resize(mesh.number_of_vertices(), 0);
    for(Index hub = mesh.first_hub; hub < mesh.number_of_vertices(); ++hub) {
      problem_.cones[hub] = 1;
      for(Index h = halfedges.begin(hub); h < halfedges.end(hub); ++h) {
        problem_.weight[h] = problem_.weight[halfedges.twin(h)] = 0.;
        const Index side = halfedges.next(h);
        problem_.rules[side] = problem_.rules[halfedges.twin(side)] = Edge_rule::AVOID;
      }
    }
  }

  void cut_spheres(bool do_cut) { problem_.do_cut_spheres = do_cut; }

  template <typename Loop> void add_loop(const Loop& loop) {
    std::vector<Index> walk = shortest_walk_beside(
        ends_beside(loop, tm_, [this](vertex_descriptor v) { return index_of(v); }),
        [this](Index u, Index v) { return problem_.mesh.edge_length(u, v); });
    if(walk.size() > 1)
      problem_.walks.push_back(std::move(walk));
  }

  const Cut_problem& problem() const { return problem_; }

  halfedge_descriptor halfedge_of_caller(Index h) const {
    const vertex_descriptor u = vertices_[problem_.halfedges.source(h)];
    return halfedge(u, vertices_[problem_.halfedges.target(h)], tm_).first;
  }

private:
  static std::size_t bound(const Flat_mesh& mesh) {
    Index bound = 0;
    for(const Index i : mesh.original)
      bound = (std::max)(bound, i + 1);
    return bound;
  }

  Index index_of(vertex_descriptor v) const {
    const std::size_t i = static_cast<std::size_t>(get(index_, v));
    return i < flat_index_.size() ? flat_index_[i] : no_index;
  }

  void set_rule(Index h, Edge_rule rule) {
    problem_.has_rules_of_caller = true;
    problem_.rules.resize(problem_.halfedges.size(), Edge_rule::FREE);
    problem_.rules[h] = problem_.rules[problem_.halfedges.twin(h)] = rule;
  }

  Index halfedge_of(edge_descriptor e) const {
    return problem_.halfedges.between(index_of(source(e, tm_)), index_of(target(e, tm_)));
  }

  std::string name_of(edge_descriptor e) const {
    return "edge " + std::to_string(get(index_, source(e, tm_))) + " - " +
           std::to_string(get(index_, target(e, tm_)));
  }

  Execution execution_;
  const TriangleMesh& tm_;
  VertexIndexMap index_;
  const std::vector<vertex_descriptor>& vertices_;
  Cut_problem problem_;
  std::vector<Index> flat_index_; // by caller's index
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CUTTING_CUT_REQUEST_H
