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

#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Contact_search.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Face_planes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Placed_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangle_contact.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/near_pairs.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/triangles_apart.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace test_htloops_check {

using namespace htloops;
using CGAL::Handle_tunnel_loops::generators::Soup;
using htloops::Mesh;
using htloops::Pairs;

bool touches_itself_by_cgal(const Soup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  return CGAL::Polygon_mesh_processing::does_self_intersect(
      ::mesh_of<CGAL::Surface_mesh<Point>>(soup));
}

using Loop_pairs = std::vector<std::pair<const Loop*, const Loop*>>;

std::vector<std::size_t> pairs_of_different_class(const Mesh& mesh, const Loop_pairs& pairs) {
  using namespace CGAL::Handle_tunnel_loops::internal;
  const auto face_index = get(boost::face_index, mesh);
  const Triangle_reader<Mesh, std::decay_t<decltype(face_index)>> reader(mesh, face_index);
  std::vector<Listed_loop> loops;
  for(const auto& [a, b] : pairs)
    loops.insert(loops.end(), {reader.listed(*a), reader.listed(*b)});
  return CGAL::Handle_tunnel_loops::internal::pairs_of_different_class(
      {}, reader.read({}, get(boost::vertex_index, mesh), get(CGAL::vertex_point, mesh)), loops);
}

Mesh mesh_with_holes(std::size_t genus, std::size_t holes, unsigned seed) {
  return ::mesh_of<Mesh>(generators::with_holes(soup_of(Recipe{"multi-torus", {2000, genus, seed}}),
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
    EXPECT_EQ(touches_itself(::mesh_of<Mesh>(soup)), touches) << "seed " << seed;
    number_that_touch += touches ? 1 : 0;
  }
  EXPECT_GT(number_that_touch, number / 10);
  EXPECT_LT(number_that_touch, number * 9 / 10 + 1);
}

namespace internal = CGAL::Handle_tunnel_loops::internal;

internal::Contact_search contact_search(const Soup& soup) {
  std::vector<internal::Contact_search::Triangle> triangles;
  for(const auto& t : soup.triangles)
    triangles.push_back({t, {soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]}});
  return internal::Contact_search(std::move(triangles));
}

struct Search_result
{
  bool has_contact = false;
  std::size_t candidates = 0, work = 0;
};

internal::Placed_triangle placed(const Soup& soup, std::size_t i) {
  internal::Placed_triangle t;
  t.vertices = soup.triangles[i];
  for(std::size_t k = 0; k < 3; ++k) {
    const auto& p = soup.points[t.vertices[k]];
    t.points[k] = {p[0], p[1], p[2]};
  }
  return t;
}

Search_result search(const Soup& soup) {
  const internal::Contact_search contacts = contact_search(soup);
  Search_result result;
  contacts.for_each_candidate({}, [&](internal::Index i, internal::Index j) {
    EXPECT_NE(i, j);
    ++result.candidates;
    result.has_contact =
        result.has_contact || internal::are_in_contact(placed(soup, i), placed(soup, j));
  });
  result.work = contacts.work();
  return result;
}

// Poles of so many faces, and rings of long ones between them.
Soup sphere_with_hubs(std::uint32_t valence, std::uint32_t rings) {
  Soup soup;
  soup.points = {{0., 0., 1.}, {0., 0., -1.}};
  const double pi = 3.14159265358979;
  for(std::uint32_t r = 0; r < rings; ++r)
    for(std::uint32_t i = 0; i < valence; ++i) {
      const double b = pi * (r + 1) / (rings + 1), a = 2. * pi * i / valence + 0.1;
      soup.points.push_back({std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)});
    }
  for(std::uint32_t i = 0; i < valence; ++i) {
    const std::uint32_t j = (i + 1) % valence, last = 2 + (rings - 1) * valence;
    soup.triangles.push_back({0, 2 + i, 2 + j});
    soup.triangles.push_back({1, last + j, last + i});
    for(std::uint32_t v = 2; v < last; v += valence) {
      soup.triangles.push_back({v + i, v + valence + i, v + valence + j});
      soup.triangles.push_back({v + i, v + valence + j, v + j});
    }
  }
  return soup;
}

// Coarse tori, one around the other.
Soup layers(std::uint32_t number) {
  Soup soup;
  constexpr std::uint32_t n = 6, m = 4;
  for(std::uint32_t s = 0; s < number; ++s) {
    const double radius = 0.4 + 0.5 * s / number;
    for(std::uint32_t i = 0; i < n; ++i)
      for(std::uint32_t j = 0; j < m; ++j) {
        const double a = 6.28318530717958 * i / n + 0.05, b = 6.28318530717958 * j / m + 0.3;
        const double x = 3. + radius * std::cos(b);
        soup.points.push_back({x * std::cos(a), x * std::sin(a), radius * std::sin(b)});
        const auto at = [&](std::uint32_t k, std::uint32_t l) {
          return n * m * s + k % n * m + l % m;
        };
        soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return soup;
}

TEST(Contact_search, is_what_cgal_says) {
  std::size_t number_that_touch = 0;
  const std::size_t number = number_of_cases(150);
  for(unsigned seed = 0; seed < number; ++seed) {
    generators::Random random(seed);
    Soup soup = seed % 12 == 0  ? soup_of(Recipe{"fan", {200, 0, seed}})
                : seed % 3 == 0 ? sphere_with_hubs(70 + seed, 1 + seed % 4)
                : seed % 3 == 1 ? layers(5 + seed % 40)
                                : soup_of(Recipe{"multi-torus", {900, 1 + seed % 3, seed}});
    const std::size_t number_moved = seed % 4; // some of the points, by a little
    for(std::size_t k = 0; k < number_moved; ++k)
      for(double& x : soup.points[random.below(soup.points.size())])
        x += random.uniform(-0.05, 0.05);
    const bool touches = touches_itself_by_cgal(soup);
    EXPECT_EQ(search(soup).has_contact, touches) << "seed " << seed;
    EXPECT_EQ(touches_itself(::mesh_of<Mesh>(soup)), touches) << "seed " << seed;
    number_that_touch += touches ? 1 : 0;
  }
  EXPECT_GT(number_that_touch, number / 10);
  EXPECT_LT(number_that_touch, number * 9 / 10 + 1);
}

// Layers are told apart as a rule, unless they are very small or large; what meets, never.
TEST(Face_planes, tell_triangles_apart_that_do_not_meet) {
  constexpr std::size_t number = 4;
  generators::Random random(1);
  for(const double scale : {1e-280, 1e-20, 1., 1e120, 1e306})
    for(int round = 0; round < 6; ++round) {
      Soup soup = layers(number);
      for(auto& point : soup.points)
        for(double& x : point)
          x = scale * (x + random.uniform(-0.1, 0.1) * (round / 2) + 100. * (round % 2));
      const std::size_t n = soup.triangles.size();
      const internal::Face_planes planes({}, n, [&](std::size_t i) { return placed(soup, i); });
      std::size_t number_seen = 0;
      for(std::size_t i = 0; i < n; ++i)
        for(std::size_t j = 0; j < n; ++j) {
          const auto s = placed(soup, i), t = placed(soup, j);
          const bool is_beside = planes.is_beside(t, i);
          const bool shares =
              std::find_first_of(s.vertices.begin(), s.vertices.end(), t.vertices.begin(),
                                 t.vertices.end()) != s.vertices.end();
          ASSERT_FALSE(is_beside && (shares || internal::are_in_contact(s, t)));
          number_seen += is_beside;
        }
      EXPECT_EQ(number_seen > n * n / 3, scale > 1e-150 && scale < 1e300)
          << scale << ' ' << round << ' ' << double(number_seen) / double(n * n);
    }
}

// At a hub, faces are compared by directions alone.
TEST(Contact_search, sees_folds_at_hubs) {
  for(const std::uint32_t i : {5u, 700u, 1999u}) {
    Soup soup = sphere_with_hubs(2000, 2);
    EXPECT_FALSE(search(soup).has_contact);
    std::swap(soup.points[2 + i], soup.points[2 + (i + 1000) % 2000]);
    EXPECT_TRUE(search(soup).has_contact) << i;
  }
}

// A disc around a hub, of which one triangle has an angle of nearly 180 degrees there, and one of
// the others comes up through it or not.
TEST(Contact_search, sees_folds_through_flat_angles_at_hubs) {
  constexpr std::uint32_t n = 200;
  for(const double opening : {1e-2, 1e-4, 1e-7})
    for(const bool is_folded : {false, true}) {
      Soup soup;
      soup.points = {{0., 0., 0.}, {1., 0., 0.}, {-1., opening, 0.}};
      for(std::uint32_t i = 1; i < n; ++i) {
        const double angle = CGAL_PI * (1. + double(i) / n);
        soup.points.push_back({std::cos(angle), 0.1 * std::sin(CGAL_PI * i / n), std::sin(angle)});
      }
      if(is_folded)
        soup.points[2 + n / 2] = {0.02, 1., 0.5};
      for(std::uint32_t i = 1; i <= n; ++i)
        soup.triangles.push_back({0, i, i + 1});
      soup.triangles.push_back({0, n + 1, 1});
      EXPECT_EQ(search(soup).has_contact, is_folded) << opening;
    }
}

TEST(Placed_boxes, ends_soon_after_what_is_looked_for) {
  constexpr std::size_t n = 4000;
  const auto box = [](std::size_t i) {
    return internal::Box<3>{{double(i), 0., 0.}, {double(i) + 1., 1., 1.}}; // in a row
  };
  const internal::Placed_boxes row({}, n, box);
  std::size_t number_asked = 0;
  const auto count = [&](std::size_t wanted) {
    number_asked = 0;
    return row.any_meeting(row, box, box, [&](internal::Index i, internal::Index j, std::size_t) {
      ++number_asked;
      return i + 1 == j && (wanted == n || i == wanted);
    });
  };
  EXPECT_TRUE(count(n));
  EXPECT_LT(number_asked, 100u);
  EXPECT_TRUE(count(n / 2));
  EXPECT_FALSE(count(n + 1));
  EXPECT_EQ(number_asked, 3 * n - 2);
  const auto one = [](internal::Index, internal::Index) { return 1.; };
  const auto half = [](internal::Index, internal::Index) { return 0.5; };
  EXPECT_NEAR(row.crowding(box, 10., one), 3., 0.1);
  EXPECT_NEAR(row.crowding(box, 10., half), 1.5, 0.05);
  const auto everywhere = [](std::size_t) { return internal::Box<3>{{0., 0., 0.}, {1., 1., 1.}}; };
  EXPECT_GT(internal::Placed_boxes({}, n, everywhere).crowding(everywhere, 10., one), 10.);
}

TEST(Contact_search, ends_soon_after_what_is_looked_for) {
  const internal::Contact_search contacts = contact_search(sphere_with_hubs(2000, 2));
  EXPECT_TRUE(contacts.any_candidate({}, [](internal::Index, internal::Index) { return true; }));
  const std::size_t work = contacts.work();
  EXPECT_FALSE(contacts.any_candidate({}, [](internal::Index, internal::Index) { return false; }));
  EXPECT_LT(2 * work, contacts.work());
}

// Layers have little near each other but what has a vertex in common.
TEST(Contact_search, tells_layers_apart) {
  const Soup soup = layers(100);
  std::size_t beside = 0;
  contact_search(soup).for_each_candidate({}, [&](internal::Index i, internal::Index j) {
    const auto &s = soup.triangles[i], &t = soup.triangles[j];
    beside += std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end() ? 1 : 0;
  });
  EXPECT_LT(search(soup).candidates, beside + beside / 20);
}

TEST(Triangles_apart, takes_any_direction_at_its_word) {
  const internal::Corner_points s = {{{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}}};
  const auto moved = [&](double x, double z) {
    internal::Corner_points t = s;
    for(internal::Vector& p : t) {
      p[0] += x;
      p[2] += z;
    }
    return t;
  };
  EXPECT_TRUE(internal::are_seen_apart(s, moved(0., 1e-9)));   // above
  EXPECT_TRUE(internal::are_seen_apart(s, moved(1.1, 0.)));    // in its plane
  EXPECT_FALSE(internal::are_seen_apart(s, moved(1., 0.)));    // at a corner
  EXPECT_FALSE(internal::are_seen_apart(s, moved(0., 1e-15))); // for all that rounding tells
  const internal::Vector nowhere = {0., 0., 0.};
  const internal::Corner_points point = {nowhere, nowhere, nowhere};
  EXPECT_FALSE(internal::are_seen_apart(point, point));
}

// A corner of one is on the other, or on a side of it, but for rounding. What is too large or too
// small for products of four coordinates is not said to be apart.
TEST(Triangles_apart, are_never_in_contact) {
  using Point = internal::Surgery_mesh::Point;
  generators::Random random(2);
  for(const double scale : {1e-310, 1e-140, 1e-97, 1e-73, 1., 1e72, 1e96, 1e140, 1e305}) {
    std::size_t number_apart = 0, number_of_contacts = 0;
    constexpr std::size_t number = 4000;
    for(std::size_t i = 0; i < number; ++i) {
      const double height = i % 2 == 0 ? 0. : scale, shift = i % 4 < 2 ? 0. : 100. * scale;
      const auto anywhere = [&] {
        const double x = shift + scale * random.uniform(-1., 1.),
                     y = shift + scale * random.uniform(-1., 1.);
        return Point(x, y, height * random.uniform(-1., 1.));
      };
      internal::Placed_triangle s{{0, 1, 2}, {anywhere(), anywhere(), anywhere()}},
          t{{3, 4, 5}, {anywhere(), anywhere(), anywhere()}};
      if(i % 8 < 4)
        t.points[0] = CGAL::barycenter(s.points[0], random.uniform(0., 1.), s.points[1]);
      const bool is_apart = internal::are_seen_apart(s.corners(), t.corners());
      const bool is_contact = CGAL::do_intersect(s.triangle(), t.triangle());
      number_apart += is_apart;
      number_of_contacts += is_contact;
      ASSERT_FALSE(is_apart && is_contact) << scale << ' ' << i;
    }
    EXPECT_GT(number_of_contacts, number / 8);
    EXPECT_EQ(number_apart > number / 8, scale > 1e-90 && scale < 1e90) << scale;
  }
}

// By the number of boxes that are compared, not by a clock.
TEST(Contact_search, takes_near_linear_time) {
  const auto hubs = [](std::uint32_t n) { return sphere_with_hubs(n, 2); };
  const auto fans = [](std::uint32_t n) { return soup_of(Recipe{"fan", {n, 0, 0}}); };
  const std::function<Soup(std::uint32_t)> families[] = {hubs, layers, fans};
  const std::uint32_t sizes[] = {1000, 100, 1000};
  const std::size_t most[] = {12, 12, 16}, most_of_each[] = {30, 48 * 40, 30};
  for(std::size_t k = 0; k < 3; ++k) {
    const Search_result few = search(families[k](sizes[k])),
                        many = search(families[k](8 * sizes[k]));
    EXPECT_FALSE(few.has_contact || many.has_contact);
    EXPECT_LT(many.work, most[k] * few.work) << k;
    EXPECT_LT(many.candidates, most[k] * few.candidates) << k;
    EXPECT_LT(many.work, most_of_each[k] * 8 * sizes[k]) << k; // of 48 faces, if layers
  }
}

// All faces are in one place of a grid over the whole.
TEST(Self_contact, is_found_beside_a_vertex_far_away) {
  Soup soup = soup_of(Recipe{"sphere", {20480, 0, 0}});
  generators::Random random(1);
  for(std::size_t i = soup.triangles.size(); i > 1; --i)
    std::swap(soup.triangles[i - 1], soup.triangles[random.below(i)]);
  EXPECT_FALSE(touches_itself(::mesh_of<Mesh>(soup)));
  for(double& x : soup.points.front())
    x *= 1e200;
  EXPECT_EQ(touches_itself(::mesh_of<Mesh>(soup)), touches_itself_by_cgal(soup));
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
