// Which handles can be replaced is what the definition says: those with which the loops remain a
// basis of the homology.

#include "Crossing_loops.h"
#include "Quiet_progress.h"

#include <CGAL/Handle_tunnel_loops/internal/passes/Basis_exchange.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace test_basis_exchange {

using namespace CGAL::Handle_tunnel_loops;
using namespace CGAL::Handle_tunnel_loops::internal;

// A surface with the loops before the refinement.
class Surface_with_basis
{
public:
  explicit Surface_with_basis(const Recipe& recipe)
      : mesh(flat_mesh_of(recipe)) {
    Pass_options options;
    options.do_refine_handles = false;
    options.do_tighten = false;
    Quiet_progress progress;
    Statistics statistics;
    const auto passes = Passes_of_tag<CGAL::Sequential_tag>::make(mesh, mesh.seeds, options);
    for(Flat_pair& pair : run_passes(*passes, options, progress, statistics)) {
      handles.push_back(std::move(pair.handle));
      tunnels.push_back(std::move(pair.tunnel));
    }
    handle_index = Crossing_index(mesh, handles);
    tunnel_index = Crossing_index(mesh, tunnels);
  }

  Basis_exchange exchange() const { return {tunnels, handle_index, tunnel_index}; }

  std::vector<Crossing_loop> basis() const {
    std::vector<Crossing_loop> loops = handles;
    loops.insert(loops.end(), tunnels.begin(), tunnels.end());
    return loops;
  }

  // With the basis, by which classes are told apart.
  Integer_matrix intersections(const std::vector<Crossing_loop>& loops) const {
    return intersection_matrix(loops, Crossing_index(mesh, basis()), 2 * handles.size());
  }

  Flat_mesh mesh;
  std::vector<Crossing_loop> handles, tunnels;
  Crossing_index handle_index{mesh, {}}, tunnel_index{mesh, {}};
};

class Basis_exchange_test : public testing::TestWithParam<Recipe>
{
protected:
  Surface_with_basis surface{GetParam()};
  std::size_t genus = surface.handles.size();
  Random random{17};
};

INSTANTIATE_TEST_SUITE_P(Of_all_kinds,
                         Basis_exchange_test,
                         testing::ValuesIn(recipes_of_all_kinds({1, 3, 10}, 1)));

// By Cramer's rule.
TEST_P(Basis_exchange_test, TellsTheClassesOfLoopsAtTheHandles) {
  const Basis_exchange exchange = surface.exchange();
  const Integer_matrix matrix = surface.intersections(surface.basis());
  const Integer all = determinant(matrix);
  ASSERT_EQ(abs(all), 1);
  for(const Crossing_loop& loop : random_loops(surface.mesh, random, 5)) {
    Basis_exchange::Row expected;
    for(Index i = 0; i < genus; ++i) {
      Integer_matrix replaced = matrix;
      replaced[i] = surface.intersections({loop}).front();
      const Integer coefficient = determinant(replaced) / all;
      if(coefficient != 0)
        expected.emplace_back(i, static_cast<std::int64_t>(coefficient));
    }
    EXPECT_EQ(exchange.handle_part(loop), expected);
  }
}

TEST_P(Basis_exchange_test, AcceptsWhatLeavesABasis) {
  for(int round = 0; round < 5; ++round) {
    Basis_exchange exchange = surface.exchange();
    std::vector<Crossing_loop> loops = surface.basis();
    for(Index k = 0; k < genus; ++k)
      for(const Crossing_loop& loop : random_loops(surface.mesh, random, 3)) {
        std::vector<Crossing_loop> others = loops;
        others[k] = loop;
        const bool is_basis = abs(determinant(surface.intersections(others))) == 1;
        ASSERT_EQ(exchange.accept(k, *exchange.handle_part(loop)), is_basis) << "handle " << k;
        if(!is_basis)
          continue;
        loops = others;
        break;
      }
  }
}

} // namespace test_basis_exchange
