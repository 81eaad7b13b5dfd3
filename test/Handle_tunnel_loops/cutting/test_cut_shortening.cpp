// What makes cuts short in little time: the boundary is counted without going along it, and the
// shortest chord is found without looking at all of them.

#include "Meshes_of_soups.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/internal/cutting/Arc_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Boundary_tour.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Chord_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_start.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Disk_boundary.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
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

// The length of the shortest path that may take the place of an arc, by definition: from a corner
// on one side of the annulus that there is without the arc to one on the other, through vertices
// that are not on the cut, or are within the arc.
double shortest_instead(const Cut_problem& problem,
                        const Cut_graph& cut,
                        const Disk_boundary& boundary,
                        const std::vector<Index>& place,
                        const Cut_arc& arc) {
  const Flat_halfedges& halfedges = problem.halfedges;
  const Sides_of_arc sides{boundary, arc};
  std::vector<char> is_free(problem.mesh.number_of_vertices(), 1);
  for(Index k = 0; k < boundary.size(); ++k)
    is_free[boundary.vertex(k)] = 0;
  for(Index k = boundary.next(arc.first); k != arc.last; k = boundary.next(k))
    is_free[boundary.vertex(k)] = 1;
  const auto is_on_side = [&](Index h, int side) { // where a halfedge begins
    return !is_free[halfedges.source(h)] && sides.of(place[h]) == side;
  };
  using Step = std::pair<double, Index>; // the halfedge that is gone along
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  const auto passes = [&](Index h) {
    return !cut.contains(h) || is_free[halfedges.source(h)] || is_free[halfedges.target(h)];
  };
  for(Index h = 0; h < halfedges.size(); ++h)
    if(passes(h) && is_on_side(h, 1))
      open.push({problem.weight[h], h});
  while(!open.empty()) {
    const auto [length, h] = open.top();
    open.pop();
    const Index v = halfedges.target(h);
    if(is_on_side(halfedges.twin(h), 2))
      return length;
    if(is_free[v] != 1)
      continue;
    is_free[v] = 2; // and done
    for(Index next = halfedges.begin(v); next < halfedges.end(v); ++next)
      if(passes(next))
        open.push({length + problem.weight[next], next});
  }
  return std::numeric_limits<double>::infinity();
}

// Of all arcs, and then, as those without a shorter way are settled, of the others.
TEST(Arc_exchange, FindsTheShortestPaths) {
  std::size_t number_shorter = 0, number_settled = 0;
  for(int seed = 0; seed < 12; ++seed) {
    Random random(seed);
    const std::size_t genus = 2 + seed % 4;
    const Flat_mesh mesh = flat_mesh_of(Recipe{"multi-torus", {1200, genus, unsigned(seed)}});
    const Cut_problem problem = random_problem(random, mesh);
    Cut_graph cut = Cut_start(problem).find();
    const Disk_boundary boundary(problem, cut, halfedges_of(problem, cut).front());
    std::vector<Index> place(problem.halfedges.size(), no_index);
    for(Index k = 0; k < boundary.size(); ++k)
      boundary.for_each_in_corner(k, [&](Index h) { place[h] = k; });
    Arc_exchange exchange(problem, cut);
    for(int round = 0; round < 2; ++round) {
      std::map<std::size_t, double> gains;
      for(const Arc_proposal& proposal : exchange.find(boundary))
        gains[proposal.arc] = proposal.gain;
      for(std::size_t a = 0; a < exchange.arcs().size(); ++a) {
        const Cut_arc& arc = exchange.arcs()[a];
        const double gain = arc.length - shortest_instead(problem, cut, boundary, place, arc);
        EXPECT_NEAR(gains.count(a) == 0 ? 0. : gains[a], (std::max)(gain, 0.), 1e-9)
            << seed << ", arc " << a << ", round " << round;
      }
      number_shorter += gains.size();
      number_settled += exchange.arcs().size() - gains.size();
    }
  }
  EXPECT_GT(number_shorter, 50U);
  EXPECT_GT(number_settled, 20U);
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
