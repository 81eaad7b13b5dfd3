#ifndef HTL_TEST_LOOPS_OF_CLASSES_H
#define HTL_TEST_LOOPS_OF_CLASSES_H

#include "Changed_loops.h"
#include "Crossing_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sum.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

// Bases of loops across the edges of a flat mesh, and others of classes that are combined from
// them. Vertices have the same numbers in a mesh and in the flat mesh of one soup.

using Class_coordinates = CGAL::Handle_tunnel_loops::internal::Class_vector;

// The vertices of the walks beside loops, handles and tunnels in turn, without turns.
inline std::vector<Vertex_walk> vertex_walks(const Mesh& mesh, const Pairs& pairs) {
  std::vector<Vertex_walk> walks;
  for(const Walk& walk : walks_beside(mesh, pairs)) {
    walks.emplace_back();
    for(const Mesh::Halfedge_index h : walk)
      walks.back().push_back(mesh.source(h));
    CGAL::Handle_tunnel_loops::internal::remove_spurs(walks.back());
  }
  return walks;
}

inline std::vector<Crossing_loop>
crossing_loops(const Flat_mesh& flat, const Mesh& mesh, const Pairs& pairs) {
  std::vector<Crossing_loop> loops;
  for(const Vertex_walk& walk : vertex_walks(mesh, pairs))
    loops.push_back(CGAL::Handle_tunnel_loops::internal::pushed_left(flat, walk));
  return loops;
}

// Those that are found.
inline std::vector<Crossing_loop> loops_of_basis(const Soup& soup) {
  const Mesh mesh = mesh_of(soup);
  return crossing_loops(flat_mesh_of(soup), mesh, find_loops(mesh));
}

// Along the left ends.
inline Walk walk_of(const Mesh& mesh, const Crossing_loop& loop) {
  Walk walk;
  for(std::size_t i = 0; i < loop.size(); ++i) {
    const Mesh::Vertex_index u(loop[i].left), v(loop[(i + 1) % loop.size()].left);
    if(u != v)
      walk.push_back(mesh.halfedge(u, v));
  }
  return walk;
}

// The rows of a random matrix of determinant 1 or -1: so many operations on rows, but for those
// that lead to larger numbers.
inline std::vector<Class_coordinates>
wound_up(Random& random, std::size_t n, std::size_t operations, std::int64_t largest) {
  std::vector<Class_coordinates> rows;
  for(Index i = 0; i < n; ++i)
    rows.push_back({{i, random.below(2) == 0 ? 1 : -1}});
  for(std::size_t k = 0; k < operations; ++k) {
    const std::size_t i = random.below(n), j = random.below(n);
    const std::int64_t factor = random.below(2) == 0 ? 1 : -1;
    Class_coordinates row = rows[i];
    if(i == j || !CGAL::Handle_tunnel_loops::internal::add_multiple(row, factor, rows[j]))
      continue;
    if(std::all_of(row.begin(), row.end(),
                   [&](const auto& c) { return c.second <= largest && -c.second <= largest; }))
      rows[i] = std::move(row);
  }
  return rows;
}

// A loop for each row of coordinates.
inline std::vector<Crossing_loop> combined(const Flat_mesh& mesh,
                                           const std::vector<Crossing_loop>& loops,
                                           const std::vector<Class_coordinates>& rows) {
  CGAL::Handle_tunnel_loops::internal::Loop_sum sum(mesh, loops);
  std::vector<Crossing_loop> result;
  for(const Class_coordinates& row : rows)
    result.push_back(sum.loop(row));
  return result;
}

// In any order.
inline void expect_same_loops(const std::vector<Crossing_loop>& a,
                              const std::vector<Crossing_loop>& b) {
  const auto sorted = [](const std::vector<Crossing_loop>& loops) {
    std::vector<std::vector<std::tuple<Index, Index, double>>> all;
    for(const Crossing_loop& loop : loops) {
      all.emplace_back();
      for(const Crossing& c : loop)
        all.back().emplace_back(c.left, c.right, c.ratio);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(sorted(a), sorted(b));
}

#endif // HTL_TEST_LOOPS_OF_CLASSES_H
