#ifndef HTL_TEST_WALKS_OF_STEPS_H
#define HTL_TEST_WALKS_OF_STEPS_H

#include <CGAL/Handle_tunnel_loops/internal/homology/Search_mesh.h>

#include <cstddef>
#include <vector>

// Calls `f(from, to)` for the edges along which a step from a vertex leads.
template <typename Function>
void for_each_edge(const CGAL::Handle_tunnel_loops::internal::Search_mesh& mesh,
                   CGAL::Handle_tunnel_loops::internal::Index v,
                   CGAL::Handle_tunnel_loops::internal::Index step,
                   const Function& f) {
  std::vector<CGAL::Handle_tunnel_loops::internal::Index> walk(1, mesh.vertex_of_walks(v));
  mesh.append_walk(v, step, walk);
  for(std::size_t i = 1; i < walk.size(); ++i)
    f(walk[i - 1], walk[i]);
}

#endif // HTL_TEST_WALKS_OF_STEPS_H
