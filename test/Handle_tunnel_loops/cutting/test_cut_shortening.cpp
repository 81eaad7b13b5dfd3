// What makes cuts short in little time: the boundary is counted without going along it, and the
// shortest chord is found without looking at all of them.

#include "Meshes_of_soups.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/internal/cutting/Boundary_tour.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Chord_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_start.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Disk_boundary.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace test_cut_shortening {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;

Index random_index(Random& random, std::size_t end) {
  return static_cast<Index>(random.below(end));
}

Cut_problem random_problem(Random& random, const Flat_mesh& mesh) {
  Cut_problem problem(Execution(), mesh);
  problem.weight.resize(problem.halfedges.size());
  for(Index h = 0; h < problem.weight.size(); ++h)
    problem.weight[h] = problem.weight[problem.halfedges.twin(h)] =
        1. + static_cast<double>(random.below(100));
  return problem;
}

std::vector<Index> halfedges_of(const Cut_problem& problem, const Cut_graph& cut) {
  std::vector<Index> all;
  for(Index h = 0; h < problem.halfedges.size(); ++h)
    if(cut.contains(h))
      all.push_back(h);
  return all;
}

void flip(Cut_graph& cut, Index h, Boundary_tour& tour) {
  if(cut.contains(h))
    cut.erase(h);
  else
    cut.insert(h);
  tour.note_change(h);
}

TEST(Boundary_tour, CountsWhatAWalkCounts) {
  std::size_t cycles = 0, others = 0;
  for(int seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Flat_mesh mesh = flat_mesh_of(random_recipe(random, 4));
    const Cut_problem problem = random_problem(random, mesh);
    Cut_graph cut = Cut_start(problem).find();
    std::vector<Index> in_cut = halfedges_of(problem, cut);
    if(in_cut.empty() || mesh.seeds.size() > 1)
      continue;
    Boundary_tour tour(problem, cut);
    tour.set(cut.boundary_from(in_cut.front()));
    for(int step = 0; step < 300 && !in_cut.empty(); ++step) {
      // Edges at the cut leave one cycle more often than others.
      const Index at = in_cut[random_index(random, in_cut.size())];
      const Index change = random.below(4) == 0   ? random_index(random, problem.halfedges.size())
                           : random.below(3) == 0 ? at
                                                  : problem.halfedges.after(at);
      tour.begin_change();
      flip(cut, change, tour);
      in_cut = halfedges_of(problem, cut);
      if(in_cut.empty())
        break;
      const Index begin = in_cut[random_index(random, in_cut.size())];
      const bool is_cycle = cut.boundary_from(begin).size() == in_cut.size();
      ASSERT_EQ(tour.is_cycle(begin, in_cut.size()), is_cycle) << seed << ", step " << step;
      ++(is_cycle ? cycles : others);
      if(!is_cycle && random.below(8) != 0) {
        flip(cut, change, tour);
        tour.take_change_back();
        in_cut = halfedges_of(problem, cut);
      }
    }
  }
  EXPECT_GT(cycles, 500U);
  EXPECT_GT(others, 500U);
}

TEST(Chord_tree, FindsTheShortestOfAll) {
  std::size_t found = 0;
  for(int seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Flat_mesh mesh = flat_mesh_of(random_recipe(random, 4));
    const Cut_problem problem = random_problem(random, mesh);
    const Cut_graph cut = Cut_start(problem).find();
    const std::vector<Index> in_cut = halfedges_of(problem, cut);
    if(in_cut.empty() || mesh.seeds.size() > 1)
      continue;
    const Disk_boundary boundary(problem, cut, in_cut.front());
    std::vector<Index> place(problem.halfedges.size(), no_index);
    for(Index k = 0; k < boundary.size(); ++k)
      place[boundary[k]] = k;
    std::vector<Chord> chords(random.below(300));
    for(Index i = 0; i < chords.size(); ++i)
      chords[i] = {static_cast<double>(random.below(50)), i, random_index(random, boundary.size()),
                   random_index(random, boundary.size())};
    const Chord_tree tree(chords);
    std::sort(chords.begin(), chords.end());
    for(const Cut_arc& arc : boundary.arcs([&](Index h) { return place[h]; })) {
      const Sides_of_arc sides{boundary, arc};
      const double most = static_cast<double>(random.below(50));
      const auto wanted = std::find_if(chords.begin(), chords.end(), [&](const Chord& c) {
        return c.length < most && sides.of(c.from) * sides.of(c.to) == 2;
      });
      const Chord* chord = tree.shortest(most, sides);
      ASSERT_EQ(chord != nullptr, wanted != chords.end()) << seed;
      if(chord != nullptr) {
        EXPECT_EQ(chord->halfedge, wanted->halfedge) << seed;
        ++found;
      }
    }
  }
  EXPECT_GT(found, 100U);
}

} // namespace test_cut_shortening
