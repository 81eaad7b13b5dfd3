// The checker is checked: what is a basis passes however it is written down, everything else is
// refused, and the refusal says what is wrong with which loop.

#include "Changed_loops.h"
#include "Loop_definitions.h"

#include "generators/Random.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace test_certificate {

using CGAL::certify_handle_tunnel_loops;
using CGAL::Handle_tunnel_loops::Certificate;

class Certificate_of_loops : public testing::TestWithParam<Recipe>
{
protected:
  Certificate_of_loops()
      : mesh(mesh_of(GetParam()))
      , pairs(find_loops(mesh))
      , steps(steps_of(pairs))
      , walks(walks_beside(mesh, pairs)) {}

  template <typename Loop_source>
  void expect_accepted(const std::vector<Loop_source>& loops) const {
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(loops));
    EXPECT_TRUE(c.closed_on_surface);
    EXPECT_TRUE(c.basis);
    EXPECT_TRUE(c.pairing);
    if(crosses_itself())
      return;
    EXPECT_TRUE(c.types);
    EXPECT_TRUE(bool(c));
    EXPECT_EQ(c.failure, "");
  }

  // Then linking numbers depend on where in their classes the loops run.
  static bool crosses_itself() { return GetParam().kind == "random"; }

  // A basis, which need not be one of pairs that cross once.
  template <typename Loop_source> void expect_basis(const std::vector<Loop_source>& loops) const {
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(loops));
    EXPECT_TRUE(c.closed_on_surface);
    EXPECT_TRUE(c.basis) << c.failure;
    EXPECT_EQ(bool(c), c.pairing && c.types);
    EXPECT_EQ(bool(c), c.failure.empty());
  }

  // A basis in which something else is wrong.
  template <typename Loop_source>
  void expect_wrong_pairs(const std::vector<Loop_source>& loops, const std::string& reason) const {
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(loops));
    EXPECT_TRUE(c.basis);
    EXPECT_FALSE(bool(c));
    expect_reason(c.failure, reason);
  }

  template <typename Loop_source>
  void expect_not_closed(const std::vector<Loop_source>& loops, const std::string& reason) const {
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(loops));
    EXPECT_FALSE(c.closed_on_surface);
    EXPECT_FALSE(c.basis);
    EXPECT_FALSE(bool(c));
    expect_reason(c.failure, reason);
  }

  template <typename Loop_source>
  void expect_no_basis(const std::vector<Loop_source>& loops, const std::string& reason) const {
    const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(loops));
    EXPECT_TRUE(c.closed_on_surface);
    EXPECT_FALSE(c.basis);
    EXPECT_FALSE(bool(c));
    expect_reason(c.failure, reason);
  }

  static void expect_reason(const std::string& failure, const std::string& reason) {
    EXPECT_NE(failure.find(reason), std::string::npos)
        << "'" << failure << "' does not say '" << reason << "'";
  }

  Mesh::Halfedge_index random_halfedge(generators::Random& random) const {
    return Mesh::Halfedge_index(static_cast<Mesh::size_type>(random.below(mesh.num_halfedges())));
  }

  bool have_common_face(const Loop::Step& a, const Loop::Step& b) const {
    return is_closed_on_surface(mesh, loop_of(Steps{a, b}));
  }

  static std::string name(std::size_t loop) {
    return "pair " + std::to_string(loop / 2) + (loop % 2 == 0 ? ", handle" : ", tunnel");
  }

  const Mesh mesh;
  const Pairs pairs;
  const std::vector<Steps> steps;
  const std::vector<Walk> walks;
};

INSTANTIATE_TEST_SUITE_P(Surfaces,
                         Certificate_of_loops,
                         testing::Values(Recipe{"torus", {400, 1, 0}},
                                         Recipe{"multi-torus", {1500, 3, 0}},
                                         Recipe{"lattice", {3000, 5, 1}},
                                         Recipe{"random", {50, 4, 2}},
                                         Recipe{"random", {600, 12, 3}}),
                         [](const auto& test) {
                           return "Mesh" + std::to_string(test.index) + "_genus" +
                                  std::to_string(test.param.request.genus);
                         });

// ---- a basis, however it is written down

TEST_P(Certificate_of_loops, AcceptsWhatWasFound) { expect_accepted(steps); }

TEST_P(Certificate_of_loops, AcceptsLoopsMovedOntoTheEdges) { expect_accepted(walks); }

TEST_P(Certificate_of_loops, AcceptsLoopsMovedAlongTheirEdges) {
  generators::Random random(5);
  std::vector<Steps> moved = steps;
  for(Steps& loop : moved)
    for(Loop::Step& step : loop)
      if(!step.is_vertex())
        step.ratio = random.below(3) == 0 ? 1. : random.uniform(0., 1.);
  expect_accepted(moved);
}

TEST_P(Certificate_of_loops, AcceptsAnotherStartAndDirection) {
  std::vector<Steps> changed = steps;
  for(std::size_t i = 0; i < changed.size(); ++i) {
    std::rotate(changed[i].begin(), changed[i].begin() + 1 + i % 2, changed[i].end());
    if(i % 3 != 0)
      std::reverse(changed[i].begin(), changed[i].end());
  }
  expect_accepted(changed);
}

TEST_P(Certificate_of_loops, AcceptsTheOtherHalfedges) {
  std::vector<Steps> changed = steps;
  for(Steps& loop : changed)
    for(Loop::Step& step : loop)
      step = {mesh.opposite(step.halfedge), 1. - step.ratio};
  expect_accepted(changed);
}

// A way there and back between two steps.
TEST_P(Certificate_of_loops, AcceptsSpurs) {
  std::vector<Walk> changed = walks;
  for(Walk& walk : changed) {
    const auto h = mesh.next(walk.front());
    walk.insert(walk.begin() + 1, {h, mesh.opposite(h)});
  }
  expect_accepted(changed);
}

TEST_P(Certificate_of_loops, AcceptsTheSameStepTwice) {
  std::vector<Steps> changed = steps;
  for(Steps& loop : changed)
    loop.insert(loop.begin(), loop.front());
  expect_accepted(changed);
}

TEST_P(Certificate_of_loops, AcceptsHomotopicLoops) {
  std::vector<Walk> changed = walks;
  for(std::size_t i = 0; i < changed.size(); ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(i % mesh.num_vertices()));
    changed[i] = sum(mesh, changed[i], ring_around(mesh, v));
  }
  expect_accepted(changed);
}

// Adding an element of a basis to another gives a basis.
TEST_P(Certificate_of_loops, AcceptsOtherBases) {
  generators::Random random(6);
  std::vector<Walk> changed = walks;
  for(int i = 0; i < 5; ++i) {
    const std::size_t a = random.below(changed.size()), b = random.below(changed.size());
    if(a != b)
      changed[a] = sum(mesh, changed[a], random.below(2) ? changed[b] : reversed(mesh, changed[b]));
  }
  expect_basis(changed);
}

// Whether loops are a basis has nothing to do with which loop belongs to which.
TEST_P(Certificate_of_loops, IsOneOfAllLoopsTogether) {
  std::vector<Steps> permuted = steps;
  std::rotate(permuted.begin(), permuted.begin() + 1, permuted.end());
  expect_basis(permuted);
  std::swap(permuted.front(), permuted.back());
  expect_basis(permuted);
}

TEST_P(Certificate_of_loops, AcceptsThePairsInAnotherOrder) {
  std::vector<Steps> permuted = steps;
  std::rotate(permuted.begin(), permuted.begin() + 2, permuted.end());
  expect_accepted(permuted);
}

// ---- loops that are none

TEST_P(Certificate_of_loops, RefusesARatioOutOfRange) {
  for(const double ratio : {-1e-9, 1. + 1e-9, 2., std::numeric_limits<double>::quiet_NaN(),
                            -std::numeric_limits<double>::infinity()})
  {
    std::vector<Steps> changed = steps;
    changed[1][2].ratio = ratio;
    SCOPED_TRACE(ratio);
    expect_not_closed(changed, "pair 0, tunnel, step 2: the ratio is not in [0, 1]");
  }
}

TEST_P(Certificate_of_loops, RefusesAStepThatLiesElsewhere) {
  generators::Random random(7);
  int number_of_changes = 0;
  for(int i = 0; i < 200; ++i) {
    std::vector<Steps> changed = steps;
    const std::size_t loop = random.below(changed.size());
    const std::size_t step = random.below(changed[loop].size() - 1);
    changed[loop][step + 1] = {random_halfedge(random), 0.5};
    if(have_common_face(changed[loop][step], changed[loop][step + 1]))
      continue;
    ++number_of_changes;
    expect_not_closed(changed, name(loop) + ", step " + std::to_string(step) +
                                   ": this step and the next lie on no common face");
  }
  EXPECT_GT(number_of_changes, 20);
}

TEST_P(Certificate_of_loops, RefusesAGap) {
  int number_of_gaps = 0;
  for(std::size_t i = 0; i < steps.size(); ++i)
    for(std::size_t j = 1; j < steps[i].size(); ++j) {
      std::vector<Steps> changed = steps;
      changed[i].erase(changed[i].begin() + static_cast<std::ptrdiff_t>(j));
      if(is_closed_on_surface(mesh, loop_of(changed[i])))
        continue;
      ++number_of_gaps;
      expect_not_closed(changed, name(i) + ", step " + std::to_string(j - 1) +
                                     ": this step and the next lie on no common face");
    }
  EXPECT_GT(number_of_gaps, 0);
}

TEST_P(Certificate_of_loops, RefusesALoopWithoutSteps) {
  std::vector<Steps> changed = steps;
  changed[0].clear();
  expect_not_closed(changed, "pair 0, handle has fewer than two steps");
}

TEST_P(Certificate_of_loops, NamesTheFirstFailure) {
  std::vector<Steps> changed = steps;
  changed[0][1].ratio = changed[1][0].ratio = -1.;
  expect_not_closed(changed, "pair 0, handle, step 1");
}

// ---- a basis of pairs that are none

TEST_P(Certificate_of_loops, RefusesHandlesOfOtherPairs) {
  for(std::size_t i = 2; i < steps.size(); i += 2) {
    std::vector<Steps> changed = steps;
    std::swap(changed[0], changed[i]);
    const Integer_matrix crossings = intersection_matrix(mesh, walks);
    if(abs(crossings[i][1]) != 1)
      expect_wrong_pairs(changed, "pair 0: the loops cross " + Integer(abs(crossings[i][1])).str() +
                                      " times, counted with sign, instead of once");
  }
}

// Only where inside and outside are known.
TEST_P(Certificate_of_loops, RefusesNamesThatAreExchanged) {
  const Certificate right = certify_handle_tunnel_loops(mesh, pairs);
  int number_of_changes = 0;
  for(std::size_t k = 0; k < pairs.size(); ++k) {
    if(!right.linking[2 * k].bounds_inside() && !right.linking[2 * k + 1].bounds_outside())
      continue;
    ++number_of_changes;
    std::vector<Steps> changed = steps;
    std::swap(changed[2 * k], changed[2 * k + 1]);
    expect_wrong_pairs(changed, "pair " + std::to_string(k) +
                                    ": the handle and the tunnel loop are swapped");
  }
  EXPECT_TRUE(number_of_changes > 0 || crosses_itself());
}

// ---- loops that are no basis

TEST_P(Certificate_of_loops, RefusesALoopThatIsThereTwice) {
  for(std::size_t i = 1; i < steps.size(); ++i) {
    std::vector<Steps> changed = steps;
    changed[i] = changed[0];
    expect_no_basis(changed, "determinant 0");
    expect_no_basis(changed, name(i) + ": up to multiples the loop is homologous to " + name(0));
  }
}

TEST_P(Certificate_of_loops, RefusesALoopThatBoundsADisc) {
  for(std::size_t i = 0; i < walks.size(); ++i) {
    std::vector<Walk> changed = walks;
    changed[i] = ring_around(mesh, Mesh::Vertex_index(0));
    expect_no_basis(changed, "determinant 0; " + name(i));
    expect_no_basis(changed, name(i) + ": the loop bounds a part of the surface");
  }
}

TEST_P(Certificate_of_loops, RefusesAPointAsALoop) {
  std::vector<Steps> changed = steps;
  changed[0] = Steps(4, changed[0].front());
  expect_no_basis(changed, "determinant 0; pair 0, handle");
}

TEST_P(Certificate_of_loops, RefusesALoopAndItsReverse) {
  std::vector<Walk> changed = walks;
  changed[1] = reversed(mesh, changed[0]);
  expect_no_basis(changed, "determinant 0");
}

TEST_P(Certificate_of_loops, RefusesALoopThatIsTraversedTwice) {
  for(std::size_t i = 0; i < steps.size(); ++i) {
    std::vector<Steps> changed = steps;
    changed[i].insert(changed[i].end(), steps[i].begin(), steps[i].end());
    expect_no_basis(changed, "determinant 2");
    expect_no_basis(changed, name(i) + ": the loop goes around 2 times");
  }
}

TEST_P(Certificate_of_loops, RefusesALoopThatIsTheSumOfTheOthers) {
  std::vector<Walk> changed = walks;
  changed[0] = walks[1];
  for(std::size_t i = 2; i < walks.size(); ++i)
    changed[0] = sum(mesh, changed[0], walks[i]);
  expect_no_basis(changed, "determinant 0");
}

TEST_P(Certificate_of_loops, RefusesAMissingPair) {
  std::vector<Steps> changed = steps;
  changed.resize(changed.size() - 2);
  expect_no_basis(changed, "there are " + std::to_string(changed.size()) + " loops instead of " +
                               std::to_string(steps.size()));
}

TEST_P(Certificate_of_loops, RefusesAnExtraPair) {
  std::vector<Steps> changed = steps;
  changed.insert(changed.end(), {steps[0], steps[1]});
  expect_no_basis(changed, "there are " + std::to_string(changed.size()) + " loops instead of " +
                               std::to_string(steps.size()));
  // Nothing more is found out about them, which might be very many.
  const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(changed));
  EXPECT_FALSE(c.pairing);
  EXPECT_TRUE(c.linking.empty());
}

// Integer combinations of the loops, most of them no basis: the certificate and the determinant of
// the intersection matrix agree, and so do the numbers.
TEST_P(Certificate_of_loops, AgreesWithTheIntersectionMatrix) {
  generators::Random random(8);
  int number_of_bases = 0;
  constexpr int number_of_rounds = 40;
  for(int round = 0; round < number_of_rounds; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    std::vector<Walk> changed = walks;
    for(std::size_t i = random.below(5); i > 0; --i) {
      const std::size_t a = random.below(walks.size()), b = random.below(walks.size());
      changed[a] = sum(mesh, changed[a], random.below(2) ? walks[b] : reversed(mesh, walks[b]));
    }
    const Integer gram = determinant(intersection_matrix(mesh, changed));
    const Integer root = sqrt(gram);
    ASSERT_EQ(root * root, gram);
    if(root == 1) {
      ++number_of_bases;
      expect_basis(changed);
    } else
      expect_no_basis(changed, "determinant " + root.str() + ";");
  }
  EXPECT_GT(number_of_bases, 0);
  EXPECT_LT(number_of_bases, number_of_rounds);
}

// ---- the surface

TEST(Certificate, HoldsForNoLoopsOnASphere) {
  const Certificate c = certify_handle_tunnel_loops(mesh_of({"sphere", {100, 0, 0}}), Pairs());
  EXPECT_TRUE(bool(c)) << c.failure;
}

TEST(Certificate, RefusesNoLoopsOnATorus) {
  const Certificate c = certify_handle_tunnel_loops(mesh_of({"torus", {100, 1, 0}}), Pairs());
  EXPECT_FALSE(c.basis);
  EXPECT_EQ(c.failure, "there are 0 loops instead of 2");
}

// Without a face, a loop that ran across it is not on the surface.
TEST(Certificate, SeesThatALoopLeavesTheSurface) {
  Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  const Pairs pairs = find_loops(mesh);
  const auto& steps = pairs[0].handle().steps();
  const auto inner =
      std::find_if(steps.begin(), steps.end(), [](const auto& step) { return !step.is_vertex(); });
  ASSERT_NE(inner, steps.end());
  EXPECT_TRUE(certify_handle_tunnel_loops(mesh, pairs));
  CGAL::Euler::remove_face(inner->halfedge, mesh);
  EXPECT_FALSE(certify_handle_tunnel_loops(mesh, pairs).closed_on_surface);
}

TEST(Certificate, RefusesAMeshThatIsNotTriangulated) {
  Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  const Pairs pairs = find_loops(mesh);
  CGAL::Euler::join_face(*halfedges(mesh).begin(), mesh);
  EXPECT_THROW(certify_handle_tunnel_loops(mesh, pairs),
               CGAL::Handle_tunnel_loops::Invalid_mesh_exception);
}

TEST(Certificate, RefusesAStepOnNoEdge) {
  const Mesh mesh = mesh_of({"torus", {200, 1, 0}});
  std::vector<Steps> steps = steps_of(find_loops(mesh));
  steps[1][0].halfedge = Mesh::null_halfedge();
  const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(steps));
  EXPECT_FALSE(c.closed_on_surface);
  EXPECT_EQ(c.failure.find("pair 0, tunnel, step 0: this step or the next does not lie on an edge"),
            0u);
}

TEST(Certificate, NeedsTheLoopsOfEveryComponent) {
  const Soup torus = soup_of({"torus", {200, 1, 0}});
  const Mesh mesh = mesh_of(generators::disjoint_union({torus, torus}));
  std::vector<Steps> steps = steps_of(find_loops(mesh));
  EXPECT_TRUE(bool(certify_handle_tunnel_loops(mesh, pairs_of(steps))));
  steps[2] = steps[0];
  steps[3] = steps[1];
  const Certificate c = certify_handle_tunnel_loops(mesh, pairs_of(steps));
  EXPECT_TRUE(c.closed_on_surface);
  EXPECT_FALSE(c.basis);
  EXPECT_NE(c.failure.find("determinant 0"), std::string::npos) << c.failure;
}

} // namespace test_certificate
