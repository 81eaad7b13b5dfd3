// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// What `htloops check` asks of surfaces, and of what goes around their boundaries.

#include "Deformations.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"

#include "app/solve/boundaries.h"
#include "app/solve/certification.h"
#include "generators/generators.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <utility>

namespace test_htloops_check {

using namespace htloops;

bool touches_itself_by_cgal(const Soup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  return CGAL::Polygon_mesh_processing::does_self_intersect(
      ::mesh_of<CGAL::Surface_mesh<Point>>(soup));
}

using Loop_pairs = std::vector<std::pair<const Loop*, const Loop*>>;

std::vector<std::size_t> pairs_of_different_class(const Mesh& mesh, const Loop_pairs& pairs) {
  std::vector<const Loop*> loops;
  for(const auto& [a, b] : pairs)
    loops.insert(loops.end(), {a, b});
  CGAL::Handle_tunnel_loops::internal::Loop_certifier certifier(
      mesh, get(boost::vertex_index, mesh), get(boost::face_index, mesh));
  certifier.set_loops({}, loops);
  return certifier.pairs_of_different_class({});
}

Mesh mesh_with_holes(std::size_t genus, std::size_t holes, unsigned seed) {
  return ::mesh_of(generators::with_holes(soup_of(Recipe{"multi-torus", {2000, genus, seed}}),
                                          {holes, 12, seed % 2 == 0}));
}

TEST(Self_contact, is_what_cgal_says) {
  std::size_t number_that_touch = 0;
  const std::size_t number = number_of_cases(300);
  for(unsigned seed = 0; seed < number; ++seed) {
    generators::Random random(seed);
    const char* kind = seed % 4 == 0 ? "random" : "multi-torus";
    Soup soup = soup_of(Recipe{kind, {900 + 20 * (seed % 7), 1 + seed % 3, seed}});
    if(seed % 4 == 1)
      jitter(soup.points, random);
    else if(seed % 4 == 2)
      deform(soup, random);
    const bool touches = touches_itself_by_cgal(soup);
    EXPECT_EQ(touches_itself(::mesh_of(soup)), touches) << "seed " << seed;
    number_that_touch += touches ? 1 : 0;
  }
  EXPECT_GT(number_that_touch, number / 10);
  EXPECT_LT(number_that_touch, number * 9 / 10 + 1);
}

// All faces are in one place of a grid over the whole.
TEST(Self_contact, is_found_beside_a_vertex_far_away) {
  Soup soup = soup_of(Recipe{"sphere", {20480, 0, 0}});
  generators::Random random(1);
  for(std::size_t i = soup.triangles.size(); i > 1; --i)
    std::swap(soup.triangles[i - 1], soup.triangles[random.below(i)]);
  EXPECT_FALSE(touches_itself(::mesh_of(soup)));
  for(double& x : soup.points.front())
    x *= 1e200;
  EXPECT_EQ(touches_itself(::mesh_of(soup)), touches_itself_by_cgal(soup));
}

TEST(Boundaries_to_check, are_right_as_they_are_found) {
  for(unsigned seed = 0; seed < static_cast<unsigned>(number_of_cases(30)); ++seed) {
    const Mesh mesh = mesh_with_holes(seed % 3 + 1, seed % 5 + 1, seed);
    const Boundaries found = find_boundaries(mesh, true);
    EXPECT_EQ(problems_of_boundaries(mesh, found.curves, found.waists), std::vector<std::string>())
        << "seed " << seed;
  }
}

// Of several boundary curves of a component, each is of a class of its own.
TEST(Boundaries_to_check, are_of_different_classes) {
  const Mesh mesh = mesh_with_holes(2, 4, 0);
  const Boundaries found = find_boundaries(mesh, true);
  Loop_pairs pairs;
  std::vector<std::size_t> different;
  for(const Loop& curve : found.curves)
    for(const Loop& waist : found.waists) {
      if(curve.pair_index() != waist.pair_index())
        different.push_back(pairs.size());
      pairs.emplace_back(&curve, &waist);
    }
  EXPECT_EQ(pairs.size(), 16u);
  EXPECT_EQ(pairs_of_different_class(mesh, pairs), different);
}

// The only one of its component bounds, and so does a loop around a face; a handle does not.
TEST(Boundaries_to_check, may_bound) {
  const Mesh mesh = mesh_with_holes(1, 1, 1);
  const Boundaries found = find_boundaries(mesh, false);
  const Mesh::Halfedge_index h = mesh.halfedge(Mesh::Face_index(0));
  const Loop around_face({{h, 0.}, {mesh.next(h), 0.}, {mesh.next(mesh.next(h)), 0.}}, {}, 0.,
                         CGAL::Loop_type::BOUNDARY, 0);
  const Pairs loops = find_loops(mesh);
  const auto are_different = [&](const Loop& a, const Loop& b) {
    return !pairs_of_different_class(mesh, {{&a, &b}}).empty();
  };
  EXPECT_FALSE(are_different(found.curves[0], around_face));
  EXPECT_TRUE(are_different(found.curves[0], loops[0].handle()));
  EXPECT_TRUE(are_different(loops[0].handle(), loops[0].tunnel()));
  EXPECT_FALSE(are_different(loops[0].handle(), loops[0].handle()));
}

} // namespace test_htloops_check
