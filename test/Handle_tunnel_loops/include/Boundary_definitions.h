// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is promised of a surface with boundary: loops stay on it, and are a basis of its first
// homology group together with all boundary curves but one.

#ifndef HTL_TEST_BOUNDARY_DEFINITIONS_H
#define HTL_TEST_BOUNDARY_DEFINITIONS_H

#include "Caps_on_holes.h"
#include "Determinant.h"
#include "Edge_walks.h"
#include "Homology_by_collapse.h"
#include "Loop_definitions.h"

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <vector>

template <typename TriangleMesh>
std::vector<Edge_walk<TriangleMesh>> boundary_walks(const TriangleMesh& mesh) {
  std::vector<Edge_walk<TriangleMesh>> walks;
  std::set<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> seen;
  for(const auto first : halfedges(mesh))
    if(is_border(first, mesh) && seen.count(first) == 0) {
      walks.emplace_back();
      for(auto h = first; walks.back().empty() || h != first; h = next(h, mesh)) {
        seen.insert(h);
        walks.back().push_back(h);
      }
    }
  return walks;
}

// Of a connected surface with boundary.
template <typename TriangleMesh, typename PairRange>
void expect_basis_with_boundaries(const TriangleMesh& mesh, const PairRange& pairs) {
  const Homology_by_collapse<TriangleMesh> homology(mesh);
  std::vector<Edge_walk<TriangleMesh>> walks = boundary_walks(mesh);
  ASSERT_FALSE(walks.empty());
  walks.pop_back();
  for(const auto& pair : pairs) {
    walks.push_back(walk_beside(mesh, pair.handle()));
    walks.push_back(walk_beside(mesh, pair.tunnel()));
  }
  Integer_matrix matrix;
  for(const auto& walk : walks)
    matrix.push_back(homology.coordinates(walk));
  ASSERT_EQ(walks.size(), homology.rank());
  EXPECT_EQ(abs(determinant(matrix)), 1);
}

// All that is promised of the pairs of a connected surface with boundary.
template <typename TriangleMesh, typename PairRange>
void expect_pairs_with_boundaries(const TriangleMesh& mesh,
                                  const PairRange& pairs,
                                  std::size_t genus) {
  expect_handle_tunnel_pairs(with_caps(mesh), pairs, genus);
  for(const auto& pair : pairs)
    for(const auto* loop : {&pair.handle(), &pair.tunnel()})
      expect_loop(mesh, get(CGAL::vertex_point, mesh), *loop);
  if(!::testing::Test::HasFatalFailure())
    expect_basis_with_boundaries(mesh, pairs);
}

#endif // HTL_TEST_BOUNDARY_DEFINITIONS_H
