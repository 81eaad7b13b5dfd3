// The shortest basis, whatever its loops bound, beside the pure one.

#include "Changed_loops.h"
#include "Number_of_cases.h"
#include "Pure_bases.h"
#include "Same_loops.h"
#include "with.h"

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace test_basis_kinds {

namespace params = CGAL::parameters;
using CGAL::Handle_tunnel_loops::name_of;
using CGAL::Handle_tunnel_loops::Solver_options;

// What is left of the promises: a basis in pairs that cross an odd number of times.
void expect_basis_in_odd_pairs(const Mesh& mesh, const Pairs& pairs, std::size_t genus) {
  ASSERT_EQ(pairs.size(), genus);
  for(const auto& pair : pairs) {
    expect_loop(mesh, get(CGAL::vertex_point, mesh), pair.handle());
    expect_loop(mesh, get(CGAL::vertex_point, mesh), pair.tunnel());
  }
  const Integer_matrix matrix = intersection_matrix(mesh, walks_beside(mesh, pairs));
  EXPECT_EQ(determinant(matrix), 1);
  bool crosses_once = true;
  for(std::size_t k = 0; k < genus; ++k) {
    EXPECT_EQ(abs(matrix[2 * k][2 * k + 1]) % 2, 1) << "pair " << k;
    crosses_once = crosses_once && abs(matrix[2 * k][2 * k + 1]) == 1;
  }
  EXPECT_EQ(certify_handle_tunnel_loops(mesh, pairs).pairing, crosses_once);
}

// The certificate holds of the kind that was asked for; of the other kind more is required.
void expect_certified(const Mesh& mesh, const Certified_pairs& answer) {
  const Certificate& c = answer.certificate;
  EXPECT_TRUE(bool(c)) << c.failure;
  EXPECT_TRUE(c.closed_on_surface && c.basis);
  EXPECT_EQ(c.basis_kind, Basis_kind::SHORTEST);
  EXPECT_EQ(c.failure, "");
  expect_same_certificates(
      c, certify_handle_tunnel_loops(mesh, answer.pairs, params::basis_kind(Basis_kind::SHORTEST)));

  Certificate pure = certify_handle_tunnel_loops(mesh, answer.pairs);
  EXPECT_EQ(pure.basis_kind, Basis_kind::PURE);
  EXPECT_EQ(bool(pure), pure.pairing && pure.types);
  EXPECT_EQ(pure.failure.empty(), bool(pure));
  pure.basis_kind = Basis_kind::SHORTEST;
  pure.failure.clear();
  expect_same_certificates(c, pure);
}

class Shortest_bases : public testing::TestWithParam<Recipe>
{
protected:
  const Soup soup = soup_of(GetParam());
  const Mesh mesh = mesh_of(soup);
  const std::size_t genus = generators::genus(soup);
};

std::vector<Recipe> recipes() {
  std::vector<Recipe> recipes = recipes_of_embedded_surfaces();
  for(unsigned seed = 0; seed < 6; ++seed)
    recipes.push_back({"random", {100 + 200 * seed, 1 + seed, seed}});
  return enough_of(recipes);
}

INSTANTIATE_TEST_SUITE_P(Generated, Shortest_bases, testing::ValuesIn(recipes()), name_of_recipe);

TEST_P(Shortest_bases, AreNoLongerThanPureOnes) {
  const Certified_pairs pure = certified_pairs(mesh);
  const Certified_pairs shortest = certified_pairs(mesh, params::basis_kind(Basis_kind::SHORTEST));
  EXPECT_LE(total_length(shortest.pairs), (1. + 1e-12) * total_length(pure.pairs));
  expect_basis_in_odd_pairs(mesh, shortest.pairs, genus);
  expect_certified(mesh, shortest);
  // What is asked for by default.
  EXPECT_EQ(pure.certificate.basis_kind, Basis_kind::PURE);
  expect_same(find_loops(mesh, params::basis_kind(Basis_kind::PURE)), pure.pairs);
}

TEST_P(Shortest_bases, AreFoundByAnyNumberOfThreads) {
  const auto np = params::basis_kind(Basis_kind::SHORTEST);
  const Certified_pairs one = certified_pairs(mesh, np);
  const Certified_pairs some = certified_pairs<CGAL::Parallel_if_available_tag>(mesh, np);
  expect_same(some.pairs, one.pairs);
  expect_same_certificates(some.certificate, one.certificate);
}

// Nothing shortens them then.
TEST_P(Shortest_bases, AreBasesWithoutTightening) {
  const Certified_pairs answer =
      certified_pairs(mesh, params::solver_options(with(&Solver_options::do_tighten, false),
                                                   params::basis_kind(Basis_kind::SHORTEST)));
  expect_basis_in_odd_pairs(mesh, answer.pairs, genus);
  expect_certified(mesh, answer);
}

// Nothing is said of sides then.
TEST_P(Shortest_bases, AreBasesWithoutLinkingNumbers) {
  for(const Basis_kind kind : {Basis_kind::PURE, Basis_kind::SHORTEST}) {
    SCOPED_TRACE(name_of(kind));
    const auto np = params::solver_options(with(&Solver_options::do_compute_linking, false),
                                           params::basis_kind(kind));
    const Certified_pairs answer = certified_pairs(mesh, np);
    expect_basis_in_odd_pairs(mesh, answer.pairs, genus);
    const Certificate& c = answer.certificate;
    EXPECT_TRUE(bool(c)) << c.failure;
    EXPECT_EQ(c.basis_kind, kind);
    EXPECT_TRUE(c.linking.empty());
    EXPECT_FALSE(c.handles_bound_inside || c.tunnels_bound_outside);
    EXPECT_FALSE(c.handles_bound_inside_alone || c.tunnels_bound_outside_alone);
    expect_same_certificates(c, certify_handle_tunnel_loops(mesh, answer.pairs, np));
  }
}

TEST_P(Shortest_bases, AreFoundFromEverySeed) {
  generators::Random random(1);
  for(int i = 0; i < 2; ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(random.below(mesh.num_vertices())));
    const Certified_pairs answer =
        certified_pairs(mesh, params::seed_vertex(v, params::basis_kind(Basis_kind::SHORTEST)));
    expect_basis_in_odd_pairs(mesh, answer.pairs, genus);
    expect_certified(mesh, answer);
  }
}

// What bounds outside of a trefoil winds around it three times on its way along it.
TEST(Knot, HasAShortestBasisThatIsNotPure) {
  for(unsigned seed = 0; seed < 4; ++seed) {
    const Mesh mesh = mesh_of({"knot", {400 + 400 * seed, 1, seed}});
    const Certified_pairs pure = certified_pairs(mesh);
    const Certified_pairs shortest =
        certified_pairs(mesh, params::basis_kind(Basis_kind::SHORTEST));
    expect_pure(pure.certificate, 1);
    EXPECT_LT(total_length(shortest.pairs), 0.999 * total_length(pure.pairs));
    EXPECT_EQ(shortest.certificate.tunnels_bound_outside, 0u);
    // The short loop around the tube bounds inside in both.
    EXPECT_EQ(shortest.certificate.handles_bound_inside, 1u);
  }
}

TEST(Sphere, HasAnEmptyBasisOfAnyKind) {
  const Mesh mesh = mesh_of({"sphere", {200, 0, 0}});
  for(const Basis_kind kind : {Basis_kind::PURE, Basis_kind::SHORTEST}) {
    const Certified_pairs answer = certified_pairs(mesh, params::basis_kind(kind));
    EXPECT_TRUE(answer.pairs.empty());
    EXPECT_TRUE(bool(answer.certificate));
    EXPECT_EQ(answer.certificate.basis_kind, kind);
    EXPECT_EQ(answer.certificate.handles_bound_inside_alone, 0u);
    EXPECT_EQ(answer.certificate.tunnels_bound_outside_alone, 0u);
  }
}

// The solver does not remember what was asked for before.
TEST(Solver, FindsBasesOfEitherKind) {
  const Mesh mesh = mesh_of({"knot", {600, 1, 0}});
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  for(const Basis_kind kind : {Basis_kind::SHORTEST, Basis_kind::PURE, Basis_kind::SHORTEST}) {
    Pairs pairs;
    solver.find_loops(std::back_inserter(pairs), params::basis_kind(kind));
    EXPECT_EQ(solver.certificate().basis_kind, kind);
    expect_same(pairs, find_loops(mesh, params::basis_kind(kind)));
  }
}

} // namespace test_basis_kinds
