// The header that is all of the library, in a second file of a program.
#include "handle_tunnel_loops_single.hpp"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <iterator>
#include <vector>

namespace {

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST(SingleHeader, FindsLoops) {
  Mesh torus;
  std::vector<Mesh::Vertex_index> v;
  for(int i = 0; i < 9; ++i)
    v.push_back(torus.add_vertex({i % 3 - 1., i / 3 - 1., (i * i) % 5 - 2.}));
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j) {
      const int right = (i + 1) % 3, up = (j + 1) % 3;
      torus.add_face(v[i + 3 * j], v[right + 3 * j], v[right + 3 * up]);
      torus.add_face(v[i + 3 * j], v[right + 3 * up], v[i + 3 * up]);
    }
  std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
  CGAL::handle_tunnel_loops(torus, std::back_inserter(pairs));
  EXPECT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(bool(CGAL::certify_handle_tunnel_loops(torus, pairs)));
}

} // namespace
