// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/surfaces.h"
#include "app/draw/upright.h"
#include "app/draw/view.h"

#include "Meshes_of_soups.h"

#include <gtest/gtest.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace test_htloops_view {

using htloops::best_common_view;
using htloops::best_views;
using htloops::Polyline;
using htloops::unit;
using htloops::upright_direction;
using htloops::Vector;

using Kernel = CGAL::Simple_cartesian<double>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

htl_scene::Surface surface_of(const Soup& soup) {
  htl_scene::Surface surface;
  surface.points.assign(soup.points.begin(), soup.points.end());
  surface.triangles.assign(soup.triangles.begin(), soup.triangles.end());
  return surface;
}

/// A generated mesh with its loops, and rays that tell what of them is seen.
class Looked_at
{
public:
  explicit Looked_at(const Recipe& recipe)
      : soup(soup_of(recipe))
      , surface(surface_of(soup))
      , mesh_(mesh_of(soup))
      , tree_(faces(mesh_).begin(), faces(mesh_).end(), mesh_) {
    for(const auto& pair : find_loops(mesh_)) {
      loops_of_pairs.emplace_back();
      for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
        loops_of_pairs.back().push_back(htloops::coordinates(loop->points()));
        loops.push_back(loops_of_pairs.back().back());
      }
    }
    const auto box = htloops::box_of(surface.points);
    lift_ = 1e-4 * htloops::diagonal_of(box);
  }

  /// the part of the length of lines that is seen from a direction.
  double seen_part(const std::vector<Polyline>& lines, const Vector& direction) const {
    constexpr int per_line = 16;
    const Vector d = unit(direction);
    double whole = 0., seen = 0.;
    for(const Polyline& line : lines) {
      const double length = length_of(line);
      whole += length;
      for(int k = 0; k < per_line; ++k)
        if(is_free(point_at(line, (k + 0.37) / per_line * length), d))
          seen += length / per_line;
    }
    return whole > 0. ? seen / whole : 0.;
  }

  Soup soup;
  htl_scene::Surface surface;
  std::vector<Polyline> loops;
  std::vector<std::vector<Polyline>> loops_of_pairs;

private:
  static double distance(const Vector& a, const Vector& b) {
    return htloops::length_of_vector(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  static double length_of(const Polyline& line) {
    double length = 0.;
    for(std::size_t i = 0; i < line.size(); ++i)
      length += distance(line[i], line[(i + 1) % line.size()]);
    return length;
  }

  static Vector point_at(const Polyline& line, double at) {
    for(std::size_t i = 0; i < line.size(); ++i) {
      const Vector &a = line[i], &b = line[(i + 1) % line.size()];
      const double step = distance(a, b);
      if(at <= step && step > 0.)
        return {a[0] + at / step * (b[0] - a[0]), a[1] + at / step * (b[1] - a[1]),
                a[2] + at / step * (b[2] - a[2])};
      at -= step;
    }
    return line.front();
  }

  bool is_free(const Vector& p, const Vector& d) const {
    const Kernel::Point_3 eye(p[0] + lift_ * d[0], p[1] + lift_ * d[1], p[2] + lift_ * d[2]);
    return !tree_.do_intersect(Kernel::Ray_3(eye, Kernel::Vector_3(d[0], d[1], d[2])));
  }

  Mesh mesh_;
  Tree tree_;
  double lift_;
};

std::vector<Vector> directions(int count) {
  std::vector<Vector> all;
  for(int i = 0; i < count; ++i) {
    const double height = 1. - (2. * i + 1.) / count, angle = 2.399963 * i + 0.5;
    const double radius = std::sqrt(1. - height * height);
    all.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
  }
  return all;
}

class View : public testing::TestWithParam<Recipe>
{};

TEST_P(View, shows_nearly_as_much_of_the_loops_as_can_be_seen) {
  const Looked_at shown(GetParam());
  ASSERT_FALSE(shown.loops.empty());
  double most = 0.;
  for(const Vector& direction : directions(200))
    most = (std::max)(most, shown.seen_part(shown.loops, direction));
  htloops::View view;
  view.chosen = shown.loops;
  const double seen = shown.seen_part(shown.loops, whole_view(view, shown.surface).from);
  RecordProperty("part_of_most", std::to_string(seen / most));
  EXPECT_GE(seen, 0.7 * most) << "seen " << seen << " of at most " << most;
}

TEST_P(View, of_a_pair_shows_half_of_it_if_that_can_be) {
  const Looked_at shown(GetParam());
  const auto found = best_views(shown.surface, shown.loops_of_pairs, {0., 0., 1.});
  ASSERT_EQ(found.size(), shown.loops_of_pairs.size());
  for(std::size_t i = 0; i < found.size(); ++i) {
    double most = 0.;
    for(const Vector& direction : directions(100))
      most = (std::max)(most, shown.seen_part(shown.loops_of_pairs[i], direction));
    if(found[i]) {
      EXPECT_GE(shown.seen_part(shown.loops_of_pairs[i], *found[i]), 0.4) << i;
      EXPECT_GE(shown.seen_part(shown.loops_of_pairs[i], *found[i]), 0.6 * most) << i;
    } else {
      EXPECT_LT(most, 0.8) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         View,
                         testing::Values(Recipe{"torus", {800, 1, 0}},
                                         Recipe{"knot", {1500, 1, 0}},
                                         Recipe{"multi-torus", {2000, 2, 0}},
                                         Recipe{"multi-torus", {3000, 5, 1}},
                                         Recipe{"multi-torus", {5000, 9, 2}},
                                         Recipe{"lattice", {2000, 3, 0}},
                                         Recipe{"lattice", {3000, 5, 1}},
                                         Recipe{"lattice", {4000, 8, 2}},
                                         Recipe{"lattice", {6000, 12, 3}},
                                         Recipe{"gyroid", {2500, 3, 0}},
                                         Recipe{"gyroid", {4000, 6, 1}},
                                         Recipe{"gyroid", {6000, 10, 2}},
                                         Recipe{"sponge", {1000, 4, 0}},
                                         Recipe{"sponge", {2000, 7, 1}},
                                         Recipe{"sponge", {3000, 11, 2}},
                                         Recipe{"plates", {1500, 5, 0}},
                                         Recipe{"plates", {1500, 8, 1}},
                                         Recipe{"plates", {2500, 12, 2}},
                                         Recipe{"bars", {1500, 5, 0}},
                                         Recipe{"bars", {2000, 8, 1}},
                                         Recipe{"bars", {2500, 12, 2}},
                                         Recipe{"hubs", {1000, 5, 0}},
                                         Recipe{"hubs", {2000, 12, 1}},
                                         Recipe{"chain", {1000, 3, 0}},
                                         Recipe{"chain", {2000, 6, 1}},
                                         Recipe{"torus-link", {2000, 2, 0}},
                                         Recipe{"torus-link", {3000, 3, 1}},
                                         Recipe{"shell", {5000, 3, 0}},
                                         Recipe{"shell", {6000, 5, 1}},
                                         Recipe{"foam", {3000, 3, 0}},
                                         Recipe{"foam", {4000, 5, 1}},
                                         Recipe{"foam", {6000, 8, 2}},
                                         Recipe{"interlaced", {4000, 4, 0}},
                                         Recipe{"interlaced", {6000, 8, 1}},
                                         Recipe{"gyroid", {8000, 14, 3}},
                                         Recipe{"sponge", {4000, 15, 3}},
                                         Recipe{"chair", {20000, 7, 0}},
                                         Recipe{"scan", {31000, 2, 0}},
                                         Recipe{"scan", {31000, 3, 1}},
                                         Recipe{"bores", {6000, 20, 0}}));

class Generated_mesh : public testing::TestWithParam<Recipe>
{};

TEST_P(Generated_mesh, is_upright_along_z) {
  EXPECT_EQ(upright_direction(surface_of(soup_of(GetParam()))), (Vector{0., 0., 1.}));
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Generated_mesh,
                         testing::Values(Recipe{"sphere", {500, 0, 0}},
                                         Recipe{"torus", {800, 1, 0}},
                                         Recipe{"multi-torus", {3000, 5, 1}},
                                         Recipe{"lattice", {3000, 5, 1}},
                                         Recipe{"gyroid", {4000, 6, 1}},
                                         Recipe{"plates", {1500, 5, 0}},
                                         Recipe{"chair", {20000, 7, 0}},
                                         Recipe{"bores", {6000, 20, 0}}));

// A thing that grows from a round foot, and leans to the front: like a person, who has no flat
// back.
htl_scene::Surface figure(std::size_t up) {
  htl_scene::Surface surface;
  constexpr std::uint32_t rings = 40, around = 40;
  for(std::uint32_t i = 0; i <= rings; ++i)
    for(std::uint32_t k = 0; k < around; ++k) {
      const double t = double(i) / rings, angle = 2. * htloops::pi * k / around;
      const double radius = (0.35 - 0.2 * t + 0.12 * std::sin(7. * t)) * (t < 0.98 ? 1. : 0.3);
      Vector p;
      p[up] = 2. * t;
      p[(up + 1) % 3] = radius * std::cos(angle) + 0.1 * std::sin(3. * t);
      p[(up + 2) % 3] = 0.7 * radius * std::sin(angle);
      surface.points.push_back(p);
    }
  const auto at = [](std::uint32_t i, std::uint32_t k) { return i * around + k % around; };
  for(std::uint32_t i = 0; i < rings; ++i)
    for(std::uint32_t k = 0; k < around; ++k) {
      surface.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      surface.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  for(std::uint32_t k = 1; k + 1 < around; ++k)
    surface.triangles.push_back({0, k + 1, k});
  for(std::uint32_t k = 1; k + 1 < around; ++k)
    surface.triangles.push_back({at(rings, 0), at(rings, k), at(rings, k + 1)});
  return surface;
}

TEST(Upright, is_where_a_figure_stands) {
  EXPECT_EQ(upright_direction(figure(1)), (Vector{0., 1., 0.}));
  EXPECT_EQ(upright_direction(figure(2)), (Vector{0., 0., 1.}));
}

TEST(Upright, does_not_depend_on_the_unit) {
  for(const double unit : {1e-200, 1e200}) {
    htl_scene::Surface surface = figure(1);
    for(Vector& p : surface.points)
      for(double& t : p)
        t *= unit;
    EXPECT_EQ(upright_direction(surface), (Vector{0., 1., 0.}));
  }
}

TEST(Upright, is_z_of_what_has_no_points) {
  EXPECT_EQ(upright_direction({}), (Vector{0., 0., 1.}));
  EXPECT_EQ(upright_direction({"", {{1., 2., 3.}}, {{0, 0, 0}}, {}, {}}), (Vector{0., 0., 1.}));
}

// A box of these extents.
htl_scene::Surface box(const Vector& extents) {
  htl_scene::Surface surface;
  for(int i = 0; i < 8; ++i)
    surface.points.push_back(
        {extents[0] * (i & 1), extents[1] * ((i >> 1) & 1), extents[2] * ((i >> 2) & 1)});
  surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return surface;
}

TEST(View_of_a_plate, shows_a_loop_on_its_lower_side_from_below) {
  // A plate of thickness 1e-4, with a loop on its lower side.
  const htl_scene::Surface plate = box({1., 1., 1e-4});
  const Polyline below = {{0.3, 0.3, 0.}, {0.6, 0.35, 0.}, {0.5, 0.7, 0.}};
  htloops::View view;
  view.up = {0., 0., 1.};
  view.chosen = {below};
  EXPECT_LT(whole_view(view, plate).from[2], 0.);
  const auto found =
      best_views(plate, {{below}, {{{0.5, 0.5, 0.5e-4}, {0.6, 0.5, 0.5e-4}}}}, {0., 0., 1.});
  ASSERT_TRUE(found[0]);
  EXPECT_LT((*found[0])[2], 0.);
}

// A cross in a plate, in each plane of two axes.
TEST(View_through, looks_at_the_broad_side_of_what_is_flat) {
  for(const std::size_t axis : {0, 1, 2}) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Vector extents = {3., 3., 3.};
    extents[axis] = 0.3;
    const Vector middle = {extents[0] / 2., extents[1] / 2., extents[2] / 2.};
    Vector left = middle, right = middle, low = middle, high = middle;
    left[u] = low[v] = 0.1;
    right[u] = high[v] = 2.9;
    htloops::View given;
    given.up = {0., 0., 1.};
    const Vector from = unit(view_through(given, box(extents), {{left, right}, {low, high}}).from);
    EXPECT_GT(std::abs(from[axis]), axis == 2 ? 0.6 : 0.75) << axis;
  }
}

// Two rods beside each other: along x all else is alike.
TEST(View_through, has_no_line_before_another) {
  const htl_scene::Surface cube = box({2., 2., 2.});
  const std::vector<Polyline> rods = {{{0.5, 1., 0.2}, {0.5, 1., 1.8}},
                                      {{1.5, 1., 0.2}, {1.5, 1., 1.8}}};
  htloops::View given;
  given.up = {0., 0., 1.};
  const Vector from = unit(view_through(given, cube, rods).from);
  EXPECT_LT(std::abs(from[0]), 0.95);
  EXPECT_LT(std::abs(from[2]), 0.8) << "where they are short";
}

TEST(View_through, is_the_one_that_was_given) {
  htloops::View given;
  given.from = {1., 2., 3.};
  given.up = {0., 1., 0.};
  const auto view = view_through(given, box({1., 2., 3.}), {});
  EXPECT_EQ(view.from, (Vector{1., 2., 3.}));
  EXPECT_EQ(view.up, (Vector{0., 1., 0.}));
  EXPECT_NE(htloops::view_through({}, {}, {}).from, Vector{}) << "of nothing";
}

// A mark on one side of a cube, and one on the next side of another cube.
TEST(Common_view, shows_what_is_on_each_surface) {
  const htl_scene::Surface cube = box({1., 1., 1.});
  const Polyline on_x = {{1., 0.4, 0.4}, {1., 0.6, 0.4}, {1., 0.5, 0.6}},
                 below_y = {{0.4, 0., 0.4}, {0.6, 0., 0.4}, {0.5, 0., 0.6}};
  const Vector from = best_common_view({{cube, {on_x}}, {cube, {below_y}}}, {0., 0., 1.});
  EXPECT_GT(from[0], 0.1);
  EXPECT_LT(from[1], -0.1);
}

TEST(Views, do_not_depend_on_the_number_of_threads) {
  const Looked_at shown({"gyroid", {6000, 10, 2}});
  htloops::View given;
  given.number_of_threads = 1;
  const htloops::Views one = views_of(given, shown.surface, shown.loops_of_pairs);
  const auto through_by_one = view_through(given, shown.surface, shown.loops);
  given.number_of_threads = 4;
  const htloops::Views four = views_of(given, shown.surface, shown.loops_of_pairs);
  EXPECT_EQ(one.whole.from, four.whole.from);
  EXPECT_EQ(one.whole.up, four.whole.up);
  EXPECT_EQ(one.of_groups, four.of_groups);
  EXPECT_EQ(through_by_one.from, view_through(given, shown.surface, shown.loops).from);
}

} // namespace test_htloops_view
