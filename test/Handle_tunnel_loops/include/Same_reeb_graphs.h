#ifndef HTL_TEST_SAME_REEB_GRAPHS_H
#define HTL_TEST_SAME_REEB_GRAPHS_H

#include "Meshes_of_soups.h"

#include <CGAL/reeb_graph.h>

#include <gtest/gtest.h>

// Reeb graphs that are the same to the last bit.

using Reeb_graph_of_mesh = CGAL::Reeb_graph<Mesh>;

inline void expect_same(const Reeb_graph_of_mesh& found, const Reeb_graph_of_mesh& expected) {
  ASSERT_EQ(num_vertices(found), num_vertices(expected));
  ASSERT_EQ(num_edges(found), num_edges(expected));
  for(const auto v : CGAL::make_range(vertices(expected))) {
    EXPECT_EQ(found[v].vertex, expected[v].vertex);
    EXPECT_EQ(found[v].type, expected[v].type);
    EXPECT_EQ(found[v].point, expected[v].point);
    EXPECT_EQ(found[v].value, expected[v].value);
  }
  for(auto a = edges(found).first, b = edges(expected).first; b != edges(expected).second; ++a, ++b)
  {
    EXPECT_EQ(source(*a, found), source(*b, expected));
    EXPECT_EQ(target(*a, found), target(*b, expected));
    EXPECT_EQ(found[*a].vertices, expected[*b].vertices);
    EXPECT_EQ(found[*a].polyline, expected[*b].polyline);
  }
}

#endif // HTL_TEST_SAME_REEB_GRAPHS_H
