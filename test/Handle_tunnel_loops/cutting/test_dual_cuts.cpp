// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dual cuts: closed but for the boundary, and each crosses its own loop once and no other.

#include "Caps_on_holes.h"
#include "Edge_walks.h"
#include "Meshes_of_soups.h"

#include "generators/Random.h"
#include "generators/generators.h"

#include <CGAL/boundary_loops.h>
#include <CGAL/dual_cuts.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace test_dual_cuts {

using generators::Random;
using Halfedge = Mesh::Halfedge_index;
using Cut = std::vector<std::pair<Halfedge, std::int64_t>>;

std::vector<Cut> cuts_of(const Mesh& mesh, const Pairs& pairs) {
  std::vector<Cut> cuts;
  CGAL::dual_cuts(mesh, pairs, std::back_inserter(cuts));
  return cuts;
}

// Of a connected mesh.
std::vector<Edge_walk<Mesh>> basis_of(const Mesh& mesh, const Pairs& pairs) {
  std::vector<Edge_walk<Mesh>> basis;
  for(const auto& pair : pairs) {
    basis.push_back(walk_beside(mesh, pair.handle()));
    basis.push_back(walk_beside(mesh, pair.tunnel()));
  }
  std::vector<CGAL::Loop_on_surface<Mesh>> curves;
  CGAL::boundary_loops(mesh, std::back_inserter(curves));
  for(std::size_t i = 0; i + 1 < curves.size(); ++i)
    basis.push_back(walk_beside(mesh, curves[i]));
  return basis;
}

// What a cut adds to each halfedge; where it ends on the boundary it goes on to the middle of the
// cap.
std::map<Halfedge, std::int64_t> jumps(const Mesh& mesh, const Mesh& capped, const Cut& cut) {
  std::map<Halfedge, std::int64_t> jump;
  std::map<Mesh::Vertex_index, std::int64_t> arriving;
  const auto add = [&](Halfedge h, std::int64_t times) {
    jump[h] += times;
    jump[capped.opposite(h)] -= times;
  };
  for(const auto& [h, times] : cut) {
    EXPECT_GT(times, 0);
    add(h, times);
    arriving[mesh.target(h)] += times;
    arriving[mesh.source(h)] -= times;
  }
  for(const auto& [v, times] : arriving) {
    if(times == 0)
      continue;
    EXPECT_TRUE(mesh.is_border(v)) << "a cut ends within the surface, at " << v;
    for(const Halfedge h : CGAL::halfedges_around_source(v, capped))
      if(capped.target(h).idx() >= mesh.number_of_vertices())
        add(h, times);
  }
  return jump;
}

void expect_dual(const Mesh& mesh, const Pairs& pairs) {
  const std::vector<Cut> cuts = cuts_of(mesh, pairs);
  const std::vector<Edge_walk<Mesh>> basis = basis_of(mesh, pairs);
  const Mesh capped = with_caps(mesh);
  ASSERT_EQ(cuts.size(), basis.size());
  for(std::size_t i = 0; i < cuts.size(); ++i) {
    const auto jump = jumps(mesh, capped, cuts[i]);
    for(std::size_t j = 0; j < basis.size(); ++j) {
      std::int64_t sum = 0;
      for_each_crossed_halfedge(capped, basis[j], [&](Halfedge h) {
        const auto it = jump.find(h);
        sum += it == jump.end() ? 0 : it->second;
      });
      // From the right of the cut to its left.
      ASSERT_EQ(sum, i == j ? -1 : 0) << "cut " << i << ", loop " << j;
    }
  }
}

TEST(Dual_cuts, CrossOneLoopEach) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 2)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    expect_dual(mesh, find_loops(mesh));
  }
}

TEST(Dual_cuts, LeadFromBoundaryToBoundary) {
  Random random(1);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 2))
    for(const std::size_t number : {1, 2, 9}) {
      SCOPED_TRACE(testing::Message() << recipe << ", " << number << " holes");
      generators::Hole_request holes;
      holes.number = number;
      holes.faces = 1 + random.below(40);
      holes.seed = static_cast<unsigned>(random.next());
      holes.may_be_fewer = true;
      const Mesh mesh = mesh_of(generators::with_holes(soup_of(recipe), holes));
      expect_dual(mesh, find_loops(mesh));
    }
}

// What is not dual is refuted, whatever it is.
TEST(Dual_cuts, AreCertified) {
  Random random(2);
  const Mesh mesh =
      mesh_of(generators::with_holes(soup_of({"multi-torus", {2000, 2, 0}}), {3, 20}));
  const Pairs pairs = find_loops(mesh);
  const std::vector<Cut> cuts = cuts_of(mesh, pairs);
  const auto index = get(boost::vertex_index, mesh);
  using Check = CGAL::Handle_tunnel_loops::internal::Dual_cut_check<Mesh, decltype(index)>;
  std::vector<Check::Walk> loops;
  for(const auto& walk : basis_of(mesh, pairs)) {
    loops.emplace_back();
    for(const Halfedge h : walk)
      loops.back().push_back(mesh.source(h));
  }
  EXPECT_EQ(Check(mesh, index, cuts).failure(loops), "");
  const auto expect_refuted = [&](const std::vector<Cut>& wrong) {
    EXPECT_NE(Check(mesh, index, wrong).failure(loops), "");
  };
  for(std::size_t i = 0; i < cuts.size(); ++i) {
    std::vector<Cut> wrong = cuts;
    wrong[i].erase(wrong[i].begin() + random.below(wrong[i].size()));
    expect_refuted(wrong);
    wrong = cuts;
    std::swap(wrong[i], wrong[(i + 1) % wrong.size()]);
    expect_refuted(wrong);
    wrong = cuts;
    for(auto& edge : wrong[i])
      edge.first = mesh.opposite(edge.first);
    expect_refuted(wrong);
    wrong = cuts;
    wrong[i].insert(wrong[i].end(), cuts[(i + 1) % cuts.size()].begin(),
                    cuts[(i + 1) % cuts.size()].end());
    expect_refuted(wrong);
  }
}

TEST(Dual_cuts, AskForABasis) {
  const Mesh mesh = mesh_of({"multi-torus", {2000, 2, 0}});
  Pairs pairs = find_loops(mesh);
  pairs[1] = pairs[0];
  EXPECT_THROW(cuts_of(mesh, pairs), std::invalid_argument);
  pairs.pop_back();
  EXPECT_THROW(cuts_of(mesh, pairs), std::invalid_argument);
}

} // namespace test_dual_cuts
