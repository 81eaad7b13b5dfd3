#ifndef HTL_TEST_FLAT_MESH_OF_SOUP_H
#define HTL_TEST_FLAT_MESH_OF_SOUP_H

#include "Generated_soups.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <map>
#include <utility>
#include <vector>

using CGAL::Handle_tunnel_loops::internal::Flat_mesh;
using CGAL::Handle_tunnel_loops::internal::Index;

// The arrays of a closed connected surface, in the order of the soup and in its unit.
inline Flat_mesh flat_mesh_of(const Soup& soup) {
  std::map<std::pair<Index, Index>, Index> third; // of the triangle to the left of an edge
  std::map<Index, Index> some_neighbor;
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i) {
      third[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
      some_neighbor[t[i]] = t[(i + 1) % 3];
    }
  Flat_mesh mesh;
  mesh.points.assign(soup.points.begin(), soup.points.end());
  const Index n = static_cast<Index>(soup.points.size());
  for(Index v = 0; v < n; ++v) {
    mesh.original.push_back(v);
    mesh.row_begin.push_back(static_cast<Index>(mesh.neighbor.size()));
    Index u = some_neighbor.at(v);
    do {
      mesh.neighbor.push_back(u);
      u = third.at({v, u});
    } while(u != some_neighbor.at(v));
  }
  mesh.row_begin.push_back(static_cast<Index>(mesh.neighbor.size()));
  mesh.first_hub = n;
  mesh.seeds = {0};
  mesh.component.assign(n, 0);
  mesh.genus = static_cast<std::size_t>(2 - generators::euler_characteristic(soup)) / 2;
  return mesh;
}

inline Flat_mesh flat_mesh_of(const Recipe& recipe) { return flat_mesh_of(soup_of(recipe)); }

// The torus with seven vertices, each of which is joined to all others.
inline Soup smallest_torus() {
  Soup soup;
  for(Index i = 0; i < 7; ++i) {
    soup.points.push_back({double(i), double(i * i % 7), double(i * i * i % 7)});
    soup.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    soup.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return soup;
}

#endif // HTL_TEST_FLAT_MESH_OF_SOUP_H
