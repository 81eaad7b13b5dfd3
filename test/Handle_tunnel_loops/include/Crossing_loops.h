#ifndef HTL_TEST_CROSSING_LOOPS_H
#define HTL_TEST_CROSSING_LOOPS_H

#include "Determinant.h"
#include "Flat_mesh_of_soup.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// Loops across the edges of a flat mesh: what they are by definition, and random ones.

using CGAL::Handle_tunnel_loops::internal::Crossing;
using CGAL::Handle_tunnel_loops::internal::Crossing_index;
using CGAL::Handle_tunnel_loops::internal::Crossing_loop;
using CGAL::Handle_tunnel_loops::internal::Sparse_numbers;
using generators::Random;
using Vertex_walk = std::vector<Index>;

// Each crossing is of an edge, and leads into a triangle that the next one leaves.
inline void expect_crossing_loop(const Flat_mesh& mesh, const Crossing_loop& loop) {
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const Crossing &c = loop[i], &next = loop[(i + 1) % loop.size()];
    ASSERT_TRUE(c.ratio >= 0. && c.ratio <= 1.) << c.ratio;
    const auto ring = mesh.ring(c.left);
    const Index position = ring.position(c.right);
    ASSERT_LT(position, ring.size()) << "crossing " << i << " is of no edge";
    const Index apex = ring[ring.next(position)];
    const bool turns_left = next.left == c.left && next.right == apex;
    const bool turns_right = next.left == apex && next.right == c.right;
    ASSERT_TRUE(turns_left || turns_right) << "crossing " << i;
  }
}

inline Crossing_loop reversed(const Crossing_loop& loop) {
  Crossing_loop result;
  for(auto c = loop.rbegin(); c != loop.rend(); ++c)
    result.push_back({c->right, c->left, 1. - c->ratio});
  return result;
}

// The vertices of a path along the fewest edges, without the last.
inline Vertex_walk path(const Flat_mesh& mesh, Index from, Index to) {
  std::vector<Index> previous(mesh.number_of_vertices(), Index(-1)), queue(1, to);
  previous[to] = to;
  for(std::size_t q = 0; q < queue.size(); ++q)
    for(const Index u : mesh.ring(queue[q]))
      if(previous[u] == Index(-1)) {
        previous[u] = queue[q];
        queue.push_back(u);
      }
  Vertex_walk walk;
  for(Index v = from; v != to; v = previous[v])
    walk.push_back(v);
  return walk;
}

// A closed walk at random: between a few places along few edges, or step by step and back again.
inline Vertex_walk random_walk(const Flat_mesh& mesh, Random& random) {
  const auto random_vertex = [&] {
    return static_cast<Index>(random.below(mesh.number_of_vertices()));
  };
  const auto append_path = [&](Vertex_walk& walk, Index from, Index to) {
    const Vertex_walk part = path(mesh, from, to);
    walk.insert(walk.end(), part.begin(), part.end());
  };
  const Index first = random_vertex();
  Index last = first;
  Vertex_walk walk;
  for(std::size_t i = random.below(5); i > 0; --i) {
    const Index next = random_vertex();
    append_path(walk, last, next);
    last = next;
  }
  for(std::size_t i = random.below(30); i > 0; --i) {
    walk.push_back(last);
    const auto ring = mesh.ring(last);
    last = ring[static_cast<Index>(random.below(ring.size()))];
  }
  append_path(walk, last, first);
  return walk;
}

// A closed walk without turns that is no point.
inline Vertex_walk random_walk_without_spurs(const Flat_mesh& mesh, Random& random) {
  Vertex_walk walk;
  while(walk.size() < 3) {
    walk = random_walk(mesh, random);
    CGAL::Handle_tunnel_loops::internal::remove_spurs(walk);
  }
  return walk;
}

inline std::vector<Crossing_loop> random_loops(const Flat_mesh& mesh, Random& random, int number) {
  std::vector<Crossing_loop> loops;
  for(int i = 0; i < number; ++i)
    loops.push_back(CGAL::Handle_tunnel_loops::internal::pushed_left(
        mesh, random_walk_without_spurs(mesh, random)));
  return loops;
}

// Row i holds the intersection numbers of loop i with the loops of the index.
inline Integer_matrix intersection_matrix(const std::vector<Crossing_loop>& loops,
                                          const Crossing_index& index,
                                          std::size_t number_of_columns) {
  Integer_matrix matrix(loops.size(), std::vector<Integer>(number_of_columns, 0));
  for(std::size_t i = 0; i < loops.size(); ++i)
    for(const auto& [j, number] : index.intersections(loops[i]))
      matrix[i][j] = number;
  return matrix;
}

#endif // HTL_TEST_CROSSING_LOOPS_H
