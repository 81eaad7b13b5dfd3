#ifndef HTL_TEST_SOLVER_AGREEMENT_H
#define HTL_TEST_SOLVER_AGREEMENT_H

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

// What any two solvers must have in common. A solver is a tag, the first template parameter of
// handle_tunnel_loops(); if nothing else is said it is compared with the sequential one on the
// host.

struct Solver_answer
{
  Pairs pairs;
  CGAL::Handle_tunnel_loops::Certificate certificate;

  // Whether all handles bound inside, and all tunnels outside.
  bool is_pure() const {
    return certificate.handles_bound_inside == pairs.size() &&
           certificate.tunnels_bound_outside == pairs.size();
  }
};

template <typename ConcurrencyTag> Solver_answer answer_of(const Mesh& mesh) {
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  Solver_answer answer;
  solver.template find_loops<ConcurrencyTag>(std::back_inserter(answer.pairs));
  answer.certificate = solver.certificate();
  return answer;
}

template <typename ConcurrencyTag> Pairs pairs_of(const Mesh& mesh) {
  return answer_of<ConcurrencyTag>(mesh).pairs;
}

// Intersection numbers of the loops of one type with those of another answer.
inline Integer_matrix intersections(const Mesh& mesh,
                                    const Pairs& a,
                                    CGAL::Loop_type type_of_a,
                                    const Pairs& b,
                                    CGAL::Loop_type type_of_b) {
  std::vector<Edge_walk<Mesh>> walks;
  for(const auto& pair : a)
    walks.push_back(walk_beside(mesh, pair.loop(type_of_a)));
  for(const auto& pair : b)
    walks.push_back(walk_beside(mesh, pair.loop(type_of_b)));
  const Integer_matrix all = intersection_matrix(mesh, walks);
  Integer_matrix matrix;
  for(std::size_t i = 0; i < a.size(); ++i)
    matrix.emplace_back(all[i].begin() + static_cast<std::ptrdiff_t>(a.size()), all[i].end());
  return matrix;
}

inline bool is_zero(const Integer_matrix& matrix) {
  return std::all_of(matrix.begin(), matrix.end(), [](const auto& row) {
    return std::all_of(row.begin(), row.end(), [](const Integer& x) { return x == 0; });
  });
}

// Whether the handle loops of both answers span the same classes, and so do the tunnel loops. All
// that bounds inside the surface is a half of the homology, and the loops in it do not cross each
// other; so it must be where both answers are pure: handles bound inside, tunnels bound outside.
inline bool have_same_classes(const Mesh& mesh, const Pairs& a, const Pairs& b) {
  using CGAL::Loop_type;
  return is_zero(intersections(mesh, a, Loop_type::HANDLE, b, Loop_type::HANDLE)) &&
         is_zero(intersections(mesh, a, Loop_type::TUNNEL, b, Loop_type::TUNNEL));
}

// How many meshes with handles were compared, and on how many of them the classes too: where no
// loop of either answer bounds on neither side, by the linking numbers.
struct Compared
{
  int meshes = 0, classes = 0;

  // Otherwise the classes would be compared nowhere if all answers were wrong.
  void expect_classes(double share) const {
    EXPECT_GT(meshes, 0);
    EXPECT_GE(classes, share * meshes) << "of " << meshes << " meshes";
  }
};

// Both answers have as many pairs as there are handles, and are a basis by the definition; the
// tests' own determinant decides which solver is right where they differ. Loops are of the same
// classes wherever the linking numbers do not say of a loop that it bounds on neither side.
template <typename ConcurrencyTag, typename ExpectedTag = CGAL::Sequential_tag>
void expect_agreement(const Mesh& mesh, std::size_t genus, Compared* compared = nullptr) {
  const Solver_answer expected = answer_of<ExpectedTag>(mesh);
  const Solver_answer answer = answer_of<ConcurrencyTag>(mesh);
  {
    SCOPED_TRACE("the solver that it is compared with");
    expect_handle_tunnel_pairs(mesh, expected.pairs, genus);
  }
  SCOPED_TRACE("the solver under test");
  expect_handle_tunnel_pairs(mesh, answer.pairs, genus);
  const bool are_pure = expected.is_pure() && answer.is_pure();
  if(are_pure && !have_same_classes(mesh, answer.pairs, expected.pairs)) {
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh))
        << "only there may all loops bound by their numbers in several classes";
  }
  if(compared != nullptr && genus > 0) {
    ++compared->meshes;
    compared->classes += are_pure;
  }
}

// On surfaces on which it is clear what is inside and what is outside.
template <typename ConcurrencyTag, typename ExpectedTag = CGAL::Sequential_tag>
void expect_same_classes(const Mesh& mesh) {
  EXPECT_TRUE(have_same_classes(mesh, pairs_of<ConcurrencyTag>(mesh), pairs_of<ExpectedTag>(mesh)));
}

// In all, the loops are between `least` and `most` times as long.
template <typename ConcurrencyTag, typename ExpectedTag = CGAL::Sequential_tag>
void expect_similar_lengths(const Mesh& mesh, double least, double most) {
  const double ratio =
      total_length(pairs_of<ConcurrencyTag>(mesh)) / total_length(pairs_of<ExpectedTag>(mesh));
  EXPECT_GE(ratio, least);
  EXPECT_LE(ratio, most);
}

// The progress grows up to one, and whenever the callback says so the computation stops, without an
// answer and without harm to the solver. How often it is asked depends on time.
template <typename ConcurrencyTag> void expect_progress_and_cancellation(const Mesh& mesh) {
  namespace params = CGAL::parameters;
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  std::vector<double> reported;
  Pairs expected;
  solver.template find_loops<ConcurrencyTag>(std::back_inserter(expected),
                                             params::callback([&reported](double progress) {
                                               reported.push_back(progress);
                                               return true;
                                             }));
  ASSERT_GT(reported.size(), 10u);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1.);
  const std::size_t step = are_few_cases_tried() ? 4 : 1;
  for(std::size_t i = 0; i < reported.size(); i += step) {
    const double end = reported[i];
    SCOPED_TRACE(testing::Message() << "stopped at " << end);
    bool is_stopped = false;
    Pairs pairs;
    EXPECT_THROW(solver.template find_loops<ConcurrencyTag>(
                     std::back_inserter(pairs), params::callback([&](double progress) {
                       EXPECT_FALSE(is_stopped) << "asked again";
                       is_stopped = progress >= end;
                       return !is_stopped;
                     })),
                 CGAL::Handle_tunnel_loops::Interrupted_exception);
    EXPECT_TRUE(pairs.empty());
  }
  Pairs pairs;
  solver.template find_loops<ConcurrencyTag>(std::back_inserter(pairs));
  EXPECT_EQ(pairs.size(), expected.size());
}

#endif // HTL_TEST_SOLVER_AGREEMENT_H
