#ifndef HTL_TEST_LOWER_COMPONENTS_H
#define HTL_TEST_LOWER_COMPONENTS_H

#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>

#include <algorithm>
#include <vector>

// The number of components of the lower link of a vertex.
inline CGAL::Handle_tunnel_loops::internal::Index
number_of_lower_components(const CGAL::Handle_tunnel_loops::internal::Flat_mesh& mesh,
                           const std::vector<CGAL::Handle_tunnel_loops::internal::Time>& times,
                           CGAL::Handle_tunnel_loops::internal::Index v) {
  using namespace CGAL::Handle_tunnel_loops::internal;
  const Arrival_order order(times);
  return count_lower_components(mesh.ring(v), [&](Index u) { return order.is_earlier(u, v); });
}

// The largest such number on a mesh.
inline CGAL::Handle_tunnel_loops::internal::Index
most_lower_components(const CGAL::Handle_tunnel_loops::internal::Flat_mesh& mesh,
                      const std::vector<CGAL::Handle_tunnel_loops::internal::Time>& times) {
  using namespace CGAL::Handle_tunnel_loops::internal;
  Index most = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    most = (std::max)(most, number_of_lower_components(mesh, times, v));
  return most;
}

#endif // HTL_TEST_LOWER_COMPONENTS_H
