#ifndef HTL_TEST_CHANGED_LOOPS_H
#define HTL_TEST_CHANGED_LOOPS_H

#include "Edge_walks.h"
#include "Meshes_of_soups.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// Loops made from other loops, to test what checks them. Points and lengths are not kept.

using Loop = Pairs::value_type::Loop;
using Steps = std::vector<Loop::Step>;
using Walk = Edge_walk<Mesh>;

inline Loop loop_of(Steps steps) {
  return Loop(std::move(steps), {}, 0., CGAL::Loop_type::HANDLE, 0);
}

// Along the edges, from vertex to vertex.
inline Loop loop_of(const Walk& walk) {
  Steps steps;
  for(const Mesh::Halfedge_index h : walk)
    steps.push_back({h, 0.});
  return loop_of(std::move(steps));
}

inline std::vector<Walk> walks_beside(const Mesh& mesh, const Pairs& pairs) {
  std::vector<Walk> walks;
  for(const auto& pair : pairs) {
    walks.push_back(walk_beside(mesh, pair.handle()));
    walks.push_back(walk_beside(mesh, pair.tunnel()));
  }
  return walks;
}

// Loops 2k and 2k + 1 make pair k.
template <typename Loop_source> Pairs pairs_of(const std::vector<Loop_source>& loops) {
  Pairs pairs;
  for(std::size_t i = 0; i + 1 < loops.size(); i += 2)
    pairs.emplace_back(loop_of(loops[i]), loop_of(loops[i + 1]));
  return pairs;
}

inline std::vector<Steps> steps_of(const Pairs& pairs) {
  std::vector<Steps> steps;
  for(const auto& pair : pairs) {
    steps.push_back(pair.handle().steps());
    steps.push_back(pair.tunnel().steps());
  }
  return steps;
}

inline Walk reversed(const Mesh& mesh, const Walk& walk) {
  Walk result;
  for(auto h = walk.rbegin(); h != walk.rend(); ++h)
    result.push_back(mesh.opposite(*h));
  return result;
}

// The link of a vertex, which bounds a disc.
inline Walk ring_around(const Mesh& mesh, Mesh::Vertex_index v) {
  Walk ring;
  for(const Mesh::Halfedge_index h : CGAL::halfedges_around_target(v, mesh))
    ring.push_back(mesh.prev(h));
  std::reverse(ring.begin(), ring.end());
  return ring;
}

// A walk along the fewest edges from a vertex to another.
inline Walk path(const Mesh& mesh, Mesh::Vertex_index from, Mesh::Vertex_index to) {
  std::vector<Mesh::Halfedge_index> arrival(mesh.num_vertices(), Mesh::null_halfedge());
  std::vector<Mesh::Vertex_index> queue(1, from);
  for(std::size_t q = 0; q < queue.size(); ++q)
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_source(queue[q], mesh))
      if(mesh.target(h) != from && arrival[mesh.target(h)] == Mesh::null_halfedge()) {
        arrival[mesh.target(h)] = h;
        queue.push_back(mesh.target(h));
      }
  Walk walk;
  for(Mesh::Vertex_index v = to; v != from; v = mesh.source(arrival[v]))
    walk.push_back(arrival[v]);
  std::reverse(walk.begin(), walk.end());
  return walk;
}

// The sum of two classes: walk a, a path to walk b, walk b, and the path back.
inline Walk sum(const Mesh& mesh, const Walk& a, const Walk& b) {
  const Walk there = path(mesh, mesh.source(a.front()), mesh.source(b.front()));
  Walk result = a;
  for(const Walk& part : {there, b, reversed(mesh, there)})
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

#endif // HTL_TEST_CHANGED_LOOPS_H
