// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/gltf.h"
#include "app/draw/layers.h"
#include "app/draw/surfaces.h"
#include "app/draw/view.h"
#include "app/solve/backends.h"
#include "app/solve/reeb_solver.h"

#include "Meshes_of_soups.h"

#include <gtest/gtest.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_htloops_drawing {

using htloops::Arc_surface;
using htloops::cross;
using htloops::dot;
using htloops::Mesh;
using htloops::Reeb_answer;
using htloops::Vector;

using Edge = std::pair<std::uint32_t, std::uint32_t>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double area(const std::vector<Vector>& points, const Triangles& triangles) {
  double sum = 0.;
  for(const auto& [a, b, c] : triangles) {
    const Vector n = cross(difference(points[b], points[a]), difference(points[c], points[a]));
    sum += std::sqrt(dot(n, n)) / 2.;
  }
  return sum;
}

// How often each edge is passed in each direction.
std::map<Edge, int> passes(const Triangles& triangles) {
  std::map<Edge, int> passes;
  for(const auto& t : triangles)
    for(int i = 0; i < 3; ++i)
      ++passes[{t[i], t[(i + 1) % 3]}];
  return passes;
}

std::size_t number_of_open_edges(const Triangles& triangles) {
  const std::map<Edge, int> all = passes(triangles);
  std::size_t open = 0;
  for(const auto& [edge, count] : all) {
    EXPECT_EQ(count, 1);
    open += all.count({edge.second, edge.first}) == 0;
  }
  return open;
}

// The height is linear, so that it is known of all points, those of cuts, too.
constexpr Vector upwards = {0.31, 0.17, 0.93};

Reeb_answer reeb_graph_of_height(const Mesh& mesh, double threshold) {
  htloops::Reeb_options options;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    options.values.push_back(dot(upwards, {p.x(), p.y(), p.z()}));
  }
  options.threshold = threshold;
  htloops::Progress told;
  return htloops::find_reeb_graph(mesh, options, told);
}

// Lengths of the borders between arcs: of all, and of what is not level.
struct Borders
{
  double length = 0., sloping = 0.;
};

Borders borders_of(const Arc_surface& surface) {
  std::map<Edge, std::uint32_t> arc_of;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    for(int i = 0; i < 3; ++i)
      arc_of[{surface.triangles[t][i], surface.triangles[t][(i + 1) % 3]}] =
          surface.triangle_arcs[t];
  Borders borders;
  for(const auto& [edge, arc] : arc_of) {
    const auto other = arc_of.find({edge.second, edge.first});
    if(other == arc_of.end() || other->second == arc)
      continue;
    const Vector along = difference(surface.points[edge.second], surface.points[edge.first]);
    borders.length += std::sqrt(dot(along, along));
    if(std::abs(dot(upwards, along)) > 1e-9)
      borders.sloping += std::sqrt(dot(along, along));
  }
  return borders;
}

class Arc_surfaces : public testing::TestWithParam<Recipe>
{
protected:
  const Mesh mesh_ = mesh_of<Mesh>(GetParam());
};

TEST_P(Arc_surfaces, are_the_surface_itself_cut) {
  for(const double threshold : {0., 0.05}) {
    const Arc_surface surface = arc_surface(mesh_, reeb_graph_of_height(mesh_, threshold));
    EXPECT_EQ(surface.triangles.size(), surface.triangle_arcs.size());
    EXPECT_NEAR(area(surface.points, surface.triangles) /
                    CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh_)),
                1., 1e-9);
    EXPECT_EQ(number_of_open_edges(surface.triangles), 0u);
  }
}

TEST_P(Arc_surfaces, have_borders_along_contours) {
  const Borders exact = borders_of(arc_surface(mesh_, reeb_graph_of_height(mesh_, 0.)));
  EXPECT_GT(exact.length, 0.);
  // Where arcs end within one face, the sides of that face do not always tell the same.
  EXPECT_LT(exact.sloping, 0.1 * exact.length);
  // What the simplification does to the graph it does not do to the surface.
  const Borders simplified = borders_of(arc_surface(mesh_, reeb_graph_of_height(mesh_, 0.05)));
  EXPECT_LT(simplified.sloping, 0.2 * simplified.length);
}

TEST_P(Arc_surfaces, show_all_arcs_that_have_vertices) {
  const Reeb_answer answer = reeb_graph_of_height(mesh_, 0.05);
  const Arc_surface surface = arc_surface(mesh_, answer);
  const std::set<std::size_t> wanted(answer.vertex_arc.begin(), answer.vertex_arc.end());
  const std::set<std::size_t> shown(surface.triangle_arcs.begin(), surface.triangle_arcs.end());
  EXPECT_TRUE(std::includes(shown.begin(), shown.end(), wanted.begin(), wanted.end()));
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Arc_surfaces,
                         testing::Values(Recipe{"torus", {2000, 1, 0}},
                                         Recipe{"multi-torus", {6000, 4, 0}},
                                         Recipe{"gyroid", {9000, 9, 1}},
                                         Recipe{"chair", {20000, 7, 0}}));

using Colour = std::array<unsigned char, 3>;

class Grown : public testing::TestWithParam<Recipe>
{
protected:
  htloops::Answer solved() const {
    htloops::Solve_options options;
    options.do_find_layers = options.do_log_fronts = true;
    options.do_tighten = false;
    htloops::Progress told;
    return htloops::host_backend.solve(mesh_, options, told);
  }

  // How many layers have begun and not ended.
  std::size_t number_of_fronts_at(double time) const {
    std::size_t number = 1;
    for(const auto& event : answer_.statistics.front_events)
      if(answer_.vertex_layers.times[event.vertex] <= time)
        number = number + event.after.size() - event.before.size();
    return number;
  }

  const Mesh mesh_ = mesh_of<Mesh>(GetParam());
  const htloops::Answer answer_ = solved();
};

// The length of the edges between triangles of a colour and others.
double length_of_border(const htloops::Drawn_surface& surface, const Colour& colour) {
  std::map<Edge, bool> is_of_colour;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    for(int i = 0; i < 3; ++i)
      is_of_colour[{surface.triangles[t][i], surface.triangles[t][(i + 1) % 3]}] =
          surface.colours[t] == colour;
  double length = 0.;
  for(const auto& [edge, is_inside] : is_of_colour)
    if(is_inside && !is_of_colour.at({edge.second, edge.first})) {
      const Vector along = difference(surface.points[edge.second], surface.points[edge.first]);
      length += std::sqrt(dot(along, along));
    }
  return length;
}

double length_of(const htloops::Exported_line& line) {
  EXPECT_TRUE(line.is_closed);
  double length = 0.;
  for(std::size_t i = 0; i < line.points.size(); ++i)
    length += std::sqrt(
        CGAL::squared_distance(line.points[i], line.points[(i + 1) % line.points.size()]));
  return length;
}

TEST_P(Grown, layers_are_the_surface_up_to_their_fronts) {
  const Colour rest = grown_layers(mesh_, answer_, 0.).surface.colours.front();
  const double whole = CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh_));
  double before = -1.;
  for(const double part : {0., 0.13, 0.31, 0.57, 0.83, 1.}) {
    SCOPED_TRACE(part);
    const auto [surface, fronts] = grown_layers(mesh_, answer_, part);
    ASSERT_EQ(surface.triangles.size(), surface.colours.size());
    EXPECT_NEAR(area(surface.points, surface.triangles) / whole, 1., 1e-9);
    EXPECT_EQ(number_of_open_edges(surface.triangles), 0u);
    Triangles covered;
    for(std::size_t t = 0; t < surface.triangles.size(); ++t)
      if(surface.colours[t] != rest)
        covered.push_back(surface.triangles[t]);
    const double now = area(surface.points, covered);
    EXPECT_GT(now, before);
    before = now;
    if(part > 0.) {
      EXPECT_EQ(fronts.lines.size(), number_of_fronts_at(part * last_time(answer_.vertex_layers)));
      double length = 0.;
      for(const htloops::Exported_line& front : fronts.lines)
        length += length_of(front);
      EXPECT_NEAR(length, length_of_border(surface, rest), 1e-9 * whole);
    }
  }
  EXPECT_NEAR(before / whole, 1., 1e-9);
}

// In the colour of its layer, but for what is near the borders of layers.
TEST_P(Grown, layers_have_their_colours) {
  const auto surface = grown_layers(mesh_, answer_, 1.).surface;
  std::size_t right = 0, wrong = 0;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    for(const std::uint32_t v : surface.triangles[t]) {
      if(v >= mesh_.number_of_vertices())
        continue;
      const Colour colour = htloops::colour_of_layer(answer_.vertex_layers.layers[v]);
      const bool is_right =
          surface.colours[t] == colour ||
          surface.colours[t] == htloops::darkened(colour, htloops::light_of_dark_bands);
      ++(is_right ? right : wrong);
    }
  EXPECT_GT(right, mesh_.number_of_vertices());
  EXPECT_LT(wrong, right / 20);
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Grown,
                         testing::Values(Recipe{"sphere", {2000, 0, 0}},
                                         Recipe{"torus", {2000, 1, 0}},
                                         Recipe{"multi-torus", {6000, 4, 0}},
                                         Recipe{"gyroid", {9000, 9, 1}}));

std::vector<Vector> circle(int count) {
  std::vector<Vector> line;
  for(int i = 0; i < count; ++i) {
    const double angle = 2. * htloops::pi * i / count;
    line.push_back({std::cos(angle), std::sin(angle), 0.3 * std::sin(2. * angle)});
  }
  return line;
}

TEST(Tube, of_a_closed_line_is_closed_and_as_thick_as_asked_for) {
  const std::vector<Vector> line = circle(200);
  const auto tube = htloops::tube_around(line, true, 0.05);
  EXPECT_EQ(number_of_open_edges(tube.triangles), 0u);
  ASSERT_EQ(tube.points.size(), tube.normals.size());
  for(std::size_t i = 0; i < tube.points.size(); ++i) {
    EXPECT_NEAR(dot(tube.normals[i], tube.normals[i]), 1., 1e-9);
    double nearest = 1.;
    for(const Vector& p : line) {
      const Vector d = difference(tube.points[i], p);
      nearest = (std::min)(nearest, std::sqrt(dot(d, d)));
    }
    EXPECT_NEAR(nearest, 0.05, 1e-9);
  }
}

TEST(Tube, of_an_open_line_is_open_at_its_ends) {
  std::vector<Vector> line = circle(200);
  line.resize(50);
  EXPECT_EQ(number_of_open_edges(htloops::tube_around(line, false, 0.05).triangles), 16u);
}

TEST(Tube, of_points_at_one_place_is_that_of_one_of_them) {
  std::vector<Vector> line = circle(20), twice;
  for(const Vector& p : line)
    twice.insert(twice.end(), {p, p});
  const auto once = htloops::tube_around(line, true, 0.05);
  const auto again = htloops::tube_around(twice, true, 0.05);
  EXPECT_EQ(once.points, again.points);
  EXPECT_EQ(once.triangles, again.triangles);
  EXPECT_TRUE(htloops::tube_around({{1., 2., 3.}, {1., 2., 3.}}, true, 0.05).triangles.empty());
}

const htl_scene::Surface& sphere() {
  static const htl_scene::Surface surface = [] {
    const auto drawn = htloops::drawn_surface(mesh_of<Mesh>(Recipe{"sphere", {5000, 0, 0}}));
    return htl_scene::Surface{"", drawn.points, drawn.triangles, {}, {}};
  }();
  return surface;
}

// A small triangle on the sphere.
std::vector<Vector> mark_at(const Vector& direction) {
  const Vector n = htloops::unit(direction);
  const Vector u = htloops::unit(cross(n, Vector{0.36, -0.48, 0.8})), v = cross(n, u);
  std::vector<Vector> mark;
  for(const auto& [a, b] : {std::pair{0.02, 0.}, std::pair{-0.01, 0.02}, std::pair{-0.01, -0.02}}) {
    mark.push_back(
        {n[0] + a * u[0] + b * v[0], n[1] + a * u[1] + b * v[1], n[2] + a * u[2] + b * v[2]});
  }
  return mark;
}

std::vector<Vector> directions() {
  std::vector<Vector> all;
  for(const double x : {-1., 0., 1.})
    for(const double y : {-1., 0., 1.})
      for(const double z : {-1., 0., 1.})
        if(x != 0. || y != 0. || z != 0.)
          all.push_back({x, y, z});
  return all;
}

TEST(View, is_from_where_the_chosen_lines_are) {
  for(const Vector& direction : directions()) {
    htloops::View view;
    view.chosen = {mark_at(direction)};
    EXPECT_GT(dot(whole_view(view, sphere()).from, direction), 0.)
        << direction[0] << " " << direction[1] << " " << direction[2];
  }
}

bool is_towards(const htloops::View& view, const Vector& direction) {
  constexpr double rim = -0.1; // from where both sides may be seen
  return dot(htloops::unit(whole_view(view, sphere()).from), htloops::unit(direction)) > rim;
}

TEST(View, is_from_where_most_chosen_lines_are) {
  for(const Vector& direction : directions()) {
    htloops::View view;
    view.chosen = {mark_at(direction), mark_at(direction),
                   mark_at({-direction[0], -direction[1], -direction[2]})};
    EXPECT_TRUE(is_towards(view, direction))
        << direction[0] << " " << direction[1] << " " << direction[2];
  }
}

TEST(View, is_the_one_that_was_given_whatever_is_chosen) {
  htloops::View view{{1., 2., 3.}, {0., 1., 0.}, {mark_at({-1., -2., -3.})}};
  EXPECT_EQ(whole_view(view, sphere()).from, (Vector{1., 2., 3.}));
  EXPECT_EQ(whole_view(view, sphere()).up, (Vector{0., 1., 0.}));
}

} // namespace test_htloops_drawing
