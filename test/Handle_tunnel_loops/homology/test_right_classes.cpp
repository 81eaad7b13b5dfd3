// On surfaces that do not cross themselves all handles bound inside and all tunnels outside,
// whatever basis they are made from.

#include "Loops_of_classes.h"
#include "Number_of_cases.h"
#include "Pure_bases.h"
#include "Quiet_progress.h"
#include "Same_loops.h"
#include "with.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Bounding_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Loop_sides.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Purification.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Search_ground.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_linker.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace test_right_classes {

using namespace CGAL::Handle_tunnel_loops::internal;
namespace params = CGAL::parameters;
using CGAL::Handle_tunnel_loops::Solver_options;

class Embedded_surfaces : public testing::TestWithParam<Recipe>
{
protected:
  const Soup soup = soup_of(GetParam());
  const Mesh mesh = mesh_of(soup);
  const std::size_t genus = generators::genus(soup);
};

INSTANTIATE_TEST_SUITE_P(Generated,
                         Embedded_surfaces,
                         testing::ValuesIn(recipes_of_embedded_surfaces()),
                         name_of_recipe);

TEST_P(Embedded_surfaces, HaveLoopsThatBoundOnTheirSides) {
  expect_pure_answer(mesh, certified_pairs(mesh), genus);
}

TEST_P(Embedded_surfaces, HaveThemForAnyNumberOfThreads) {
  const Certified_pairs one = certified_pairs(mesh);
  const Certified_pairs some = certified_pairs<CGAL::Parallel_if_available_tag>(mesh);
  expect_same(some.pairs, one.pairs);
  expect_same_certificates(some.certificate, one.certificate);
}

TEST_P(Embedded_surfaces, HaveThemWithoutTightening) {
  expect_pure_answer(
      mesh, certified_pairs(mesh, params::solver_options(with(&Solver_options::do_tighten, false))),
      genus);
}

TEST_P(Embedded_surfaces, HaveThemFromEverySeed) {
  Random random(1);
  for(int i = 0; i < 3; ++i) {
    const Mesh::Vertex_index v(static_cast<Mesh::size_type>(random.below(mesh.num_vertices())));
    SCOPED_TRACE(v);
    expect_pure_answer(mesh, certified_pairs(mesh, params::seed_vertex(v)), genus);
  }
}

TEST_P(Embedded_surfaces, HaveThemIfFacesLookInwards) {
  const Mesh flipped = mesh_of(generators::reversed(soup));
  expect_pure_answer(flipped, certified_pairs(flipped), genus);
}

// ---- from any basis

// A connected surface, with bases of loops along its edges.
class Wound_up_surface
{
public:
  explicit Wound_up_surface(const Recipe& recipe)
      : mesh_(mesh_of(recipe))
      , flat_(flat_mesh_of(recipe))
      , answer_(find_loops(mesh_))
      , loops_(crossing_loops(flat_, mesh_, answer_)) {}

  const Flat_mesh& flat() const { return flat_; }

  // Of the answer, in the unit of the flat mesh, which is that of the mesh.
  double length_of_answer() const { return total_length(answer_); }

  std::vector<Flat_pair> wound_up_pairs(Random& random, std::size_t operations) const {
    const std::vector<Crossing_loop> loops =
        combined(flat_, loops_, wound_up(random, loops_.size(), operations, 4));
    std::vector<Flat_pair> pairs;
    for(std::size_t k = 0; k < loops.size() / 2; ++k)
      pairs.push_back({loops[2 * k], loops[2 * k + 1]});
    return pairs;
  }

  // Linking numbers are a matter of classes, so they are those of the walks beside the loops.
  Pairs on_edges(const std::vector<Flat_pair>& pairs) const {
    std::vector<Walk> walks;
    for(const Flat_pair& pair : pairs) {
      walks.push_back(walk_of(mesh_, pair.handle));
      walks.push_back(walk_of(mesh_, pair.tunnel));
    }
    return pairs_of(walks);
  }

  Loop_relations relate(const std::vector<Flat_pair>& flat_pairs) const {
    const Pairs pairs = on_edges(flat_pairs);
    std::vector<const Loop*> loops;
    for(const auto& pair : pairs)
      loops.insert(loops.end(), {&pair.handle(), &pair.tunnel()});
    const auto point = get(CGAL::vertex_point, mesh_);
    const auto index = get(boost::vertex_index, mesh_);
    Loop_linker<Mesh, Loop, decltype(point), decltype(index)> linker(mesh_, point, index);
    linker.set_loops(
        Execution(), loops, [](Mesh::Face_index) { return std::size_t(0); }, 1);
    linker.link(Execution());
    return linker.take_relations();
  }

  Loop_sides sides(const std::vector<Flat_pair>& pairs) const {
    return {std::make_shared<const Loop_classes>(Execution(), flat_, Purification::loops_of(pairs)),
            relate(pairs)};
  }

  void expect_pure(const std::vector<Flat_pair>& pairs) const {
    for(const Flat_pair& pair : pairs) {
      expect_crossing_loop(flat_, pair.handle);
      expect_crossing_loop(flat_, pair.tunnel);
    }
    ::expect_pure(certify_handle_tunnel_loops(mesh_, on_edges(pairs)), loops_.size() / 2);
  }

private:
  Mesh mesh_;
  Flat_mesh flat_;
  Pairs answer_;
  std::vector<Crossing_loop> loops_;
};

bool are_equal(const Crossing_loop& a, const Crossing_loop& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& c, const auto& d) {
    return c.left == d.left && c.right == d.right && c.ratio == d.ratio;
  });
}

const std::vector<Recipe> connected = {
    {"torus", {200, 1, 0}},        {"knot", {300, 1, 0}},     {"multi-torus", {800, 2, 0}},
    {"multi-torus", {1000, 4, 0}}, {"lattice", {1600, 4, 1}}, {"sponge", {300, 5, 0}},
    {"plates", {2000, 3, 0}},      {"bars", {2000, 3, 0}},    {"foam", {3000, 4, 0}}};

TEST(Purification, MakesAnyBasisPure) {
  Random random(2);
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Wound_up_surface surface(recipe);
    for(const std::size_t operations : {0, 3, 10, 40})
      for(const bool do_tighten : {true, false}) {
        const std::vector<Flat_pair> before = surface.wound_up_pairs(random, operations);
        const std::vector<Crossing_loop> loops = Purification::loops_of(before);
        const Loop_relations relations = surface.relate(before);
        std::vector<Flat_pair> pairs = before;
        Quiet_progress progress;
        Purification purification(Execution(), surface.flat(), do_tighten, progress);
        const std::vector<Index> sources = purification.run(pairs, relations);
        EXPECT_EQ(purification.is_pure(), std::vector<char>(pairs.size(), 1));
        surface.expect_pure(pairs);
        ASSERT_EQ(sources.size(), loops.size());
        const std::vector<Crossing_loop> after = Purification::loops_of(pairs);
        for(std::size_t i = 0; i < after.size(); ++i)
          EXPECT_TRUE(sources[i] == no_index || are_equal(after[i], loops[sources[i]]));
        // What bounds inside already is kept.
        const std::vector<char> bounds = relations.bounds_alone(true);
        for(Index i = 0; i < loops.size(); ++i) {
          if(!bounds[i])
            continue;
          bool is_kept = false;
          for(std::size_t k = 0; k < pairs.size(); ++k)
            is_kept = is_kept || sources[2 * k] == i;
          EXPECT_TRUE(is_kept) << "loop " << i;
        }
      }
  }
}

TEST(Purification, ChangesNothingThatIsPure) {
  Random random(3);
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Wound_up_surface surface(recipe);
    std::vector<Flat_pair> pairs = surface.wound_up_pairs(random, 20);
    Quiet_progress progress;
    Purification(Execution(), surface.flat(), true, progress).run(pairs, surface.relate(pairs));
    const std::vector<Crossing_loop> before = Purification::loops_of(pairs);
    const std::vector<Index> sources =
        Purification(Execution(), surface.flat(), true, progress).run(pairs, surface.relate(pairs));
    const std::vector<Crossing_loop> after = Purification::loops_of(pairs);
    for(Index i = 0; i < sources.size(); ++i) {
      EXPECT_EQ(sources[i], i);
      EXPECT_TRUE(are_equal(before[i], after[i]));
    }
  }
}

// The loops are much longer at first, and short again afterwards.
TEST(Right_classes, AreFoundFromAnyBasis) {
  Random random(4);
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Wound_up_surface surface(recipe);
    const Relate_pairs relate = [&](const std::vector<Flat_pair>& p, const Known_relations*) {
      return surface.relate(p);
    };
    for(const std::size_t operations : {3, 20}) {
      std::vector<Flat_pair> pairs = surface.wound_up_pairs(random, operations);
      for(Flat_pair& pair : pairs) // loops of passes are tight
        for(Crossing_loop* loop : {&pair.handle, &pair.tunnel})
          Loop_tightening(surface.flat()).tighten(*loop);
      Quiet_progress progress;
      const std::optional<Loop_relations> relations =
          find_right_classes(Execution(), surface.flat(), {}, relate, pairs, progress);
      surface.expect_pure(pairs);
      ASSERT_TRUE(relations);
      EXPECT_EQ(relations->bounds_alone(true), surface.relate(pairs).bounds_alone(true));
      EXPECT_EQ(relations->bounds_alone(false), surface.relate(pairs).bounds_alone(false));
      double sum = 0.;
      for(const Crossing_loop& loop : Purification::loops_of(pairs))
        sum += length(surface.flat(), loop);
      EXPECT_LE(sum, 1.1 * surface.length_of_answer());
    }
  }
}

std::vector<Class_vector> coordinates_of(const std::vector<Crossing_loop>& loops,
                                         const Loop_classes& classes) {
  std::vector<Class_vector> coordinates;
  for(const Crossing_loop& loop : loops)
    coordinates.push_back(*classes.class_with(classes.numbers(loop)));
  return coordinates;
}

void expect_same_sides(const Loop_sides& a, const Loop_sides& b, std::size_t number) {
  for(Index i = 0; i < number; ++i) {
    EXPECT_EQ(a.is_decided(i), b.is_decided(i));
    EXPECT_EQ(a.bounds_inside(i), b.bounds_inside(i));
    EXPECT_EQ(a.bounds_outside(i), b.bounds_outside(i));
    for(const bool inside : {true, false})
      EXPECT_EQ(a.numbers_of_part(i, inside), b.numbers_of_part(i, inside));
  }
}

TEST(Loop_sides, AreThoseOfAnyOtherBasis) {
  Random random(8);
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Wound_up_surface surface(recipe);
    const std::vector<Flat_pair> first = surface.wound_up_pairs(random, 6),
                                 second = surface.wound_up_pairs(random, 12);
    const std::vector<Crossing_loop> loops = Purification::loops_of(second);
    const Loop_sides known = surface.sides(first), other = surface.sides(second);
    const std::optional<Loop_sides> sides =
        known.of_basis(coordinates_of(loops, known.classes()),
                       std::make_shared<const Loop_classes>(Execution(), surface.flat(), loops));
    ASSERT_TRUE(sides);
    expect_same_sides(*sides, other, loops.size());
  }
}

// The level of a ground is made ready as by whoever has it searched.
struct Prepared_ground
{
  explicit Prepared_ground(const Flat_mesh& mesh)
      : ground(mesh) {
    ground.levels().prepare(Execution(), 1e9);
  }

  Search_ground ground;
};

// Loops in the place of others bound, are shorter, and leave a basis, of which the sides are known.
TEST(Bounding_loops, TakeThePlaceOfLongerOnes) {
  Random random(9);
  std::size_t number_of_surfaces = 0;
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Wound_up_surface surface(recipe);
    std::vector<Flat_pair> pairs = surface.wound_up_pairs(random, 4);
    const std::vector<Crossing_loop> before = Purification::loops_of(pairs);
    std::vector<Crossing_loop> loops = before;
    std::vector<Index> sources(loops.size());
    std::iota(sources.begin(), sources.end(), Index(0));
    Prepared_ground prepared(surface.flat());
    Quiet_progress progress;
    const std::optional<Loop_sides> sides =
        Bounding_loops(Execution(), surface.flat(), prepared.ground, progress)
            .take(loops, surface.sides(pairs), sources);
    for(std::size_t k = 0; k < pairs.size(); ++k)
      pairs[k] = {loops[2 * k], loops[2 * k + 1]};
    const Loop_sides known = surface.sides(pairs); // asserts that they are a basis
    if(sides)
      expect_same_sides(*sides, known, loops.size());
    std::size_t number_of_new = 0;
    for(Index i = 0; i < loops.size(); ++i)
      if(sources[i] == no_index) {
        ++number_of_new;
        EXPECT_NE(known.bounds_inside(i), known.bounds_outside(i));
        EXPECT_LT(length(surface.flat(), loops[i]), length(surface.flat(), before[i]));
      } else {
        EXPECT_EQ(sources[i], i);
        EXPECT_TRUE(are_equal(loops[i], before[i]));
      }
    EXPECT_EQ(number_of_new != 0, sides.has_value());
    number_of_surfaces += sides.has_value();
  }
  EXPECT_GE(number_of_surfaces, 4u); // of nine; where loops are large, none is near enough
}

// Nothing bounds where it is not known what does.
TEST(Bounding_loops, TakeNoPlaceWhereNoSideIsKnown) {
  Random random(10);
  const Wound_up_surface surface(Recipe{"multi-torus", {1000, 4, 0}});
  const std::vector<Flat_pair> pairs = surface.wound_up_pairs(random, 20);
  Loop_relations relations = surface.relate(pairs);
  relations.problems.emplace(3, "a problem");
  std::vector<Crossing_loop> loops = Purification::loops_of(pairs);
  const Loop_sides sides(std::make_shared<const Loop_classes>(Execution(), surface.flat(), loops),
                         relations);
  std::vector<Index> sources(loops.size(), 0);
  Prepared_ground prepared(surface.flat());
  Quiet_progress progress;
  EXPECT_FALSE(Bounding_loops(Execution(), surface.flat(), prepared.ground, progress)
                   .take(loops, sides, sources));
  EXPECT_EQ(sources, std::vector<Index>(loops.size(), 0));
}

// There are so many loops that short ones that bound come first.
TEST(Right_classes, AreFoundFromVeryLongLoops) {
  Random random(6);
  const Wound_up_surface surface(Recipe{"bars", {4000, 100, 0}});
  const Relate_pairs relate = [&](const std::vector<Flat_pair>& p, const Known_relations*) {
    return surface.relate(p);
  };
  const std::vector<Flat_pair> wound_up = surface.wound_up_pairs(random, 500);
  Quiet_progress progress;
  std::vector<Crossing_loop> loops = Purification::loops_of(wound_up);
  std::vector<Index> sources(loops.size(), 0);
  Prepared_ground prepared(surface.flat());
  EXPECT_TRUE(Bounding_loops(Execution(), surface.flat(), prepared.ground, progress)
                  .take(loops, surface.sides(wound_up), sources));
  std::vector<std::vector<Crossing_loop>> answers;
  for(const Execution execution : {Execution(), Execution::parallel()}) {
    std::vector<Flat_pair> pairs = wound_up;
    const std::optional<Loop_relations> relations =
        find_right_classes(execution, surface.flat(), {}, relate, pairs, progress);
    surface.expect_pure(pairs);
    ASSERT_TRUE(relations);
    EXPECT_EQ(relations->bounds_alone(true), surface.relate(pairs).bounds_alone(true));
    answers.push_back(Purification::loops_of(pairs));
  }
  double sum = 0.;
  for(std::size_t i = 0; i < answers[0].size(); ++i) {
    sum += length(surface.flat(), answers[0][i]);
    EXPECT_TRUE(are_equal(answers[0][i], answers[1][i]));
  }
  EXPECT_LE(sum, 1.1 * surface.length_of_answer());
}

// What stays of the first loops keeps its name, so that its relations need not be found again.
TEST(Right_classes, NameTheLoopsThatStay) {
  Random random(6);
  const Wound_up_surface surface(Recipe{"bars", {4000, 100, 0}});
  const std::vector<Flat_pair> wound_up = surface.wound_up_pairs(random, 500);
  const std::vector<Crossing_loop> first = Purification::loops_of(wound_up);
  bool is_any_known = false;
  const Relate_pairs relate = [&](const std::vector<Flat_pair>& p, const Known_relations* known) {
    const std::vector<Crossing_loop> loops = Purification::loops_of(p);
    for(std::size_t i = 0; known != nullptr && i < loops.size(); ++i)
      if(known->before[i] != no_index) {
        is_any_known = true;
        EXPECT_TRUE(are_equal(loops[i], first[known->before[i]]));
      }
    return surface.relate(p);
  };
  std::vector<Flat_pair> pairs = wound_up;
  Quiet_progress progress;
  find_right_classes(Execution(), surface.flat(), {}, relate, pairs, progress);
  EXPECT_TRUE(is_any_known);
}

// If the loops found then are not pure, the first pairs take their places again.
TEST(Right_classes, AreTakenBackIfTheyAreNotPureInTheEnd) {
  Random random(6);
  const std::size_t genus = are_few_cases_tried() ? 40 : 100;
  const Wound_up_surface surface(Recipe{"bars", {40 * genus, genus, 0}});
  const std::vector<Flat_pair> wound_up = surface.wound_up_pairs(random, 5 * genus);
  int calls = 0;
  const Relate_pairs relate = [&](const std::vector<Flat_pair>& p, const Known_relations*) {
    Loop_relations relations = surface.relate(p);
    if(++calls == 2)
      relations.problems.emplace(0, "a problem");
    return relations;
  };
  std::vector<Flat_pair> pairs = wound_up;
  Quiet_progress progress;
  const std::optional<Loop_relations> relations =
      find_right_classes(Execution(), surface.flat(), {}, relate, pairs, progress);
  EXPECT_EQ(calls, 2);
  EXPECT_FALSE(relations); // they are to be related once more
  const Loop_classes classes(Execution(), surface.flat(), Purification::loops_of(wound_up));
  const std::vector<Crossing_loop> after = Purification::loops_of(pairs);
  for(Index i = 0; i < after.size(); ++i) // they may have been tightened
    EXPECT_EQ(classes.class_with(classes.numbers(after[i])), (Class_vector{{i, 1}}));
}

// Of the shortest basis no sides are asked for.
TEST(Right_classes, AreABasisWithoutSides) {
  Random random(5);
  for(const Recipe& recipe : connected) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Wound_up_surface surface(recipe);
    const Relate_pairs relate = [&](const std::vector<Flat_pair>& p, const Known_relations*) {
      return surface.relate(p);
    };
    for(const bool do_shorten : {true, false}) {
      std::vector<Flat_pair> pairs = surface.wound_up_pairs(random, 10);
      Quiet_progress progress;
      find_right_classes(Execution(), surface.flat(), {Basis_kind::SHORTEST, false, do_shorten},
                         relate, pairs, progress);
      const std::vector<Crossing_loop> loops = Purification::loops_of(pairs);
      const Integer_matrix numbers =
          intersection_matrix(loops, Crossing_index(surface.flat(), loops), loops.size());
      EXPECT_EQ(determinant(numbers), 1);
      for(std::size_t k = 0; k < pairs.size(); ++k)
        EXPECT_EQ(abs(numbers[2 * k][2 * k + 1]) % 2, 1);
    }
  }
}

// A tube around a circle whose cross section is a figure eight, which turns about itself so many
// times on its way: it crosses itself along a closed curve, and no linking number tells that. The
// more it turns, the fewer classes bound.
Soup turning_figure_eight(int turns) {
  constexpr Index around = 24, along = 60;
  constexpr double pi = 3.14159265358979323846;
  Soup soup;
  for(Index j = 0; j < along; ++j)
    for(Index i = 0; i < around; ++i) {
      const double u = 2. * pi * (i + 0.37) / around, v = 2. * pi * j / along, a = turns * v + 0.3;
      const double x = std::sin(u) + 0.01 * std::cos(u), y = 0.7 * std::sin(2. * u);
      const double r = 3. + x * std::cos(a) - y * std::sin(a);
      soup.points.push_back({r * std::cos(v), r * std::sin(v), x * std::sin(a) + y * std::cos(a)});
      const Index p = j * around + i, q = j * around + (i + 1) % around;
      const Index r_next = (p + around) % (around * along),
                  s_next = (q + around) % (around * along);
      soup.triangles.push_back({p, q, s_next});
      soup.triangles.push_back({p, s_next, r_next});
    }
  return soup;
}

TEST(Right_classes, AreNotForcedUponSurfacesThatCrossThemselves) {
  for(const int turns : {0, 1, 2, 3, -2}) {
    SCOPED_TRACE(turns);
    const Mesh mesh = mesh_of(turning_figure_eight(turns));
    const Certified_pairs answer = certified_pairs(mesh);
    EXPECT_EQ(answer.pairs.size(), 1u);
    EXPECT_TRUE(answer.certificate);
  }
}

// What crosses itself is no reason to give up on another component.
TEST(Right_classes, AreFoundBesideSurfacesThatCrossThemselves) {
  const Soup torus = soup_of(Recipe{"multi-torus", {800, 2, 0}});
  const Certified_pairs answer =
      certified_pairs(mesh_of(generators::disjoint_union({turning_figure_eight(1), torus})));
  EXPECT_TRUE(answer.certificate);
  ASSERT_EQ(answer.pairs.size(), 3u);
  EXPECT_GE(answer.certificate.handles_bound_inside_alone, 2u);
  EXPECT_GE(answer.certificate.tunnels_bound_outside_alone, 2u);
}

} // namespace test_right_classes
