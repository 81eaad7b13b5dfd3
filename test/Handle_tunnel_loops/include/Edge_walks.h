#ifndef HTL_TEST_EDGE_WALKS_H
#define HTL_TEST_EDGE_WALKS_H

#include "Determinant.h"

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <vector>

// Closed walks on the edges of a mesh and their intersection numbers, by brute force.

// Each halfedge begins where the one before it ends; the first follows the last.
template <typename TriangleMesh>
using Edge_walk = std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor>;

// The places of a loop move along their edges to an end. Consecutive ones have a face in common, so
// the loop moves within its homotopy class, and the ends are equal or neighbours.
template <typename TriangleMesh, typename Loop>
Edge_walk<TriangleMesh> walk_beside(const TriangleMesh& tm, const Loop& loop) {
  const auto end_of = [&](const typename Loop::Step& step) {
    return step.ratio == 0. ? source(step.halfedge, tm) : target(step.halfedge, tm);
  };
  Edge_walk<TriangleMesh> walk;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const auto u = end_of(loop.steps()[i]), v = end_of(loop.steps()[(i + 1) % loop.size()]);
    if(u == v)
      continue;
    const auto [h, is_edge] = halfedge(u, v, tm);
    if(!is_edge)
      throw std::logic_error("consecutive steps lie beside vertices that are no neighbours");
    walk.push_back(h);
  }
  return walk;
}

// Pushed off the edges to its left, a walk crosses these halfedges, which leave its vertices.
template <typename TriangleMesh, typename Function>
void for_each_crossed_halfedge(const TriangleMesh& tm,
                               const Edge_walk<TriangleMesh>& walk,
                               const Function& f) {
  for(std::size_t i = 0; i < walk.size(); ++i)
    for(auto h = next(walk[i], tm); h != walk[(i + 1) % walk.size()]; h = next(opposite(h, tm), tm))
      f(h);
}

// Entry (i, j) counts where walk j crosses walk i from right to left, less the other way.
template <typename TriangleMesh>
Integer_matrix intersection_matrix(const TriangleMesh& tm,
                                   const std::vector<Edge_walk<TriangleMesh>>& walks) {
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  std::map<Halfedge, std::map<std::size_t, int>> traversals;
  for(std::size_t j = 0; j < walks.size(); ++j)
    for(const Halfedge& h : walks[j]) {
      ++traversals[h][j];
      --traversals[opposite(h, tm)][j];
    }
  Integer_matrix matrix(walks.size(), std::vector<Integer>(walks.size(), 0));
  for(std::size_t i = 0; i < walks.size(); ++i)
    for_each_crossed_halfedge(tm, walks[i], [&](const Halfedge& h) {
      const auto it = traversals.find(h);
      if(it != traversals.end())
        for(const auto& [j, count] : it->second)
          matrix[i][j] += count;
    });
  return matrix;
}

#endif // HTL_TEST_EDGE_WALKS_H
