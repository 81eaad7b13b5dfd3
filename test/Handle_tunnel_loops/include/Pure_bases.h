#ifndef HTL_TEST_PURE_BASES_H
#define HTL_TEST_PURE_BASES_H

#include "Loop_definitions.h"
#include "Meshes_of_soups.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

// Surfaces that do not cross themselves, and what is known of their bases.

using CGAL::Handle_tunnel_loops::Basis_kind;
using CGAL::Handle_tunnel_loops::Certificate;

inline std::vector<Recipe> recipes_of_embedded_surfaces() {
  std::vector<Recipe> recipes = {
      {"torus", {400, 1, 0}},       {"knot", {600, 1, 0}},        {"multi-torus", {1000, 3, 0}},
      {"lattice", {1600, 4, 1}},    {"gyroid", {3000, 4, 0}},     {"sponge", {300, 5, 0}},
      {"plates", {2000, 3, 0}},     {"bars", {2000, 3, 0}},       {"chain", {1500, 3, 0}},
      {"torus-link", {2000, 1, 0}}, {"torus-link", {3000, 2, 0}}, {"ladder", {13000, 1, 0}},
      {"shell", {3400, 4, 0}},      {"foam", {3000, 4, 0}},       {"interlaced", {2600, 4, 0}},
      {"waves", {4200, 0, 0}}};
  recipes.back().request.frequency = 2;
  return recipes;
}

inline std::string name_of_recipe(const testing::TestParamInfo<Recipe>& info) {
  std::string name = info.param.kind + "_" + std::to_string(info.index);
  for(char& c : name)
    if(c == '-')
      c = '_';
  return name;
}

// The answer and its certificate.
struct Certified_pairs
{
  Pairs pairs;
  Certificate certificate;
};

template <typename ConcurrencyTag = CGAL::Sequential_tag,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Certified_pairs certified_pairs(const Mesh& mesh,
                                const NamedParameters& np = CGAL::parameters::default_values()) {
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  Certified_pairs answer;
  solver.find_loops<ConcurrencyTag>(std::back_inserter(answer.pairs), np);
  answer.certificate = solver.certificate();
  return answer;
}

inline void expect_same_certificates(const Certificate& a, const Certificate& b) {
  EXPECT_EQ(a.closed_on_surface, b.closed_on_surface);
  EXPECT_EQ(a.basis, b.basis);
  EXPECT_EQ(a.pairing, b.pairing);
  EXPECT_EQ(a.types, b.types);
  EXPECT_EQ(a.handles_bound_inside, b.handles_bound_inside);
  EXPECT_EQ(a.tunnels_bound_outside, b.tunnels_bound_outside);
  EXPECT_EQ(a.handles_bound_inside_alone, b.handles_bound_inside_alone);
  EXPECT_EQ(a.tunnels_bound_outside_alone, b.tunnels_bound_outside_alone);
  EXPECT_EQ(a.basis_kind, b.basis_kind);
  EXPECT_EQ(a.failure, b.failure);
  ASSERT_EQ(a.linking.size(), b.linking.size());
  for(std::size_t i = 0; i < a.linking.size(); ++i) {
    SCOPED_TRACE(testing::Message() << "loop " << i);
    EXPECT_EQ(a.linking[i].row, b.linking[i].row);
    EXPECT_EQ(a.linking[i].column, b.linking[i].column);
    EXPECT_EQ(a.linking[i].problem, b.linking[i].problem);
    EXPECT_EQ(a.linking[i].bounds_inside_component, b.linking[i].bounds_inside_component);
    EXPECT_EQ(a.linking[i].bounds_outside_component, b.linking[i].bounds_outside_component);
    EXPECT_EQ(a.linking[i].bounds_inside(), b.linking[i].bounds_inside());
    EXPECT_EQ(a.linking[i].bounds_outside(), b.linking[i].bounds_outside());
  }
}

// All handles bound inside and all tunnels outside, each component alone.
inline void expect_pure(const Certificate& c, std::size_t genus) {
  EXPECT_TRUE(bool(c)) << c.failure;
  EXPECT_TRUE(c.pairing && c.types);
  EXPECT_EQ(c.handles_bound_inside_alone, genus);
  EXPECT_EQ(c.tunnels_bound_outside_alone, genus);
  ASSERT_EQ(c.linking.size(), 2 * genus);
  for(std::size_t i = 0; i < c.linking.size(); ++i) {
    EXPECT_EQ(c.linking[i].problem, "") << "loop " << i;
    EXPECT_EQ(c.linking[i].bounds_inside_component, i % 2 == 0) << "loop " << i;
    EXPECT_EQ(c.linking[i].bounds_outside_component, i % 2 == 1) << "loop " << i;
  }
}

// That, and what is promised of all answers; the certificate is the one that is found anew.
inline void expect_pure_answer(const Mesh& mesh, const Certified_pairs& answer, std::size_t genus) {
  expect_pure(answer.certificate, genus);
  expect_handle_tunnel_pairs(mesh, answer.pairs, genus);
  expect_same_certificates(answer.certificate, certify_handle_tunnel_loops(mesh, answer.pairs));
}

#endif // HTL_TEST_PURE_BASES_H
