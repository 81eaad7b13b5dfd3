// What --triangulate and --repair do to a soup.

#include "app/mend/mending.h"

#include "app/mend/mesh_reader.h"
#include "app/mend/steps.h"
#include "app/read/soup_diagnosis.h"
#include "generators/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace test_htloops_mending {

using namespace htloops;
using htloops::Soup;

using Faces = std::vector<Corners>;

constexpr Remedies triangulation = {true, false};
constexpr Remedies repair = {false, true};
constexpr Remedies both = {true, true};

Soup soup_of(const std::vector<Point>& points, const Faces& faces) {
  Soup soup;
  soup.points = points;
  for(const Corners& face : faces)
    add_face(soup, face);
  return soup;
}

Faces faces_of(const Soup& soup) {
  Faces faces;
  for_each_polygon(soup, [&](std::size_t, const Corners& corners) { faces.push_back(corners); });
  return faces;
}

const std::vector<Point> corners_of_tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Faces tetrahedron = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

const std::vector<Point> corners_of_cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const Faces cube = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

Soup generated(const std::string& kind, std::size_t faces, std::size_t genus) {
  namespace generators = CGAL::Handle_tunnel_loops::generators;
  generators::Request request;
  request.faces = faces;
  request.genus = genus;
  Soup soup;
  for(const generators::Kind& candidate : generators::kinds())
    if(candidate.name == kind) {
      const generators::Soup mesh = generators::make(candidate, request);
      for(const auto& p : mesh.points)
        soup.points.emplace_back(p[0], p[1], p[2]);
      for(const auto& t : mesh.triangles)
        add_face(soup, {t[0], t[1], t[2]});
    }
  return soup;
}

// Euler characteristic of what is used of a soup of triangles.
long long euler_characteristic(const Soup& soup) {
  std::set<std::uint32_t> vertices;
  std::set<std::uint64_t> edges;
  for(const Corners& face : faces_of(soup))
    for_each_side(face, [&](std::uint32_t u, std::uint32_t v) {
      vertices.insert(u);
      edges.insert(edge_key(u, v));
    });
  return static_cast<long long>(vertices.size()) - static_cast<long long>(edges.size()) +
         static_cast<long long>(soup.faces.size());
}

std::string words(const Mended_soup& mended) {
  std::string text;
  for(const Change& change : mended.changes)
    text += std::to_string(change.count) + " " + change.words + "\n";
  return text;
}

void expect_sound(const Soup& soup) {
  for(const Defect& defect : diagnose(soup))
    ADD_FAILURE() << defect.message;
}

// Sound but for boundary.
void expect_manifold(const Soup& soup) {
  for(const Defect& defect : diagnose(soup))
    EXPECT_EQ(defect.kind, Mesh_defect::BOUNDARY_EDGE) << defect.message;
}

// ---- triangulation

TEST(Triangulation, cuts_all_faces_of_a_cube) {
  const Mended_soup mended = mend(soup_of(corners_of_cube, cube), triangulation);
  EXPECT_EQ(mended.soup.faces.size(), 12u);
  EXPECT_EQ(mended.diagonals.size(), 6u);
  EXPECT_EQ(words(mended), "6 faces with more than three vertices triangulated, first: face 0\n");
  expect_sound(mended.soup);
  EXPECT_EQ(euler_characteristic(mended.soup), 2);
}

TEST(Triangulation, leaves_triangles_alone) {
  const Mended_soup mended = mend(soup_of(corners_of_tetrahedron, tetrahedron), triangulation);
  EXPECT_TRUE(mended.changes.empty());
  EXPECT_TRUE(mended.diagonals.empty());
  EXPECT_EQ(faces_of(mended.soup), tetrahedron);
}

TEST(Triangulation, takes_the_diagonal_that_lies_inside) {
  const std::vector<Point> arrow = {{0, 0, 0}, {4, -4, 0}, {1, 0, 0}, {4, 4, 0}};
  const auto is_free = [](std::uint32_t, std::uint32_t) { return true; };
  // From the tip to the notch, whichever corner comes first.
  for(const Corners& corners : Faces{{0, 1, 2, 3}, {1, 2, 3, 0}, {3, 2, 1, 0}, {2, 1, 0, 3}})
    for(const auto& triangle : triangulate_polygon(arrow, corners, is_free)) {
      EXPECT_TRUE(std::count(triangle.begin(), triangle.end(), 0u));
      EXPECT_TRUE(std::count(triangle.begin(), triangle.end(), 2u));
    }
}

// In the plane of the first two coordinates, without sign.
double area(const std::vector<Point>& points, const Triangles& triangles) {
  double sum = 0.;
  for(const auto& [u, v, w] : triangles) {
    const auto a = points[v] - points[u], b = points[w] - points[u];
    sum += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
  }
  return sum;
}

TEST(Triangulation, covers_polygons_that_are_not_convex) {
  const auto is_free = [](std::uint32_t, std::uint32_t) { return true; };
  std::vector<Point> comb;
  Corners corners;
  for(int i = 0; i < 10; ++i) {
    comb.emplace_back(2 * i, 10, i);
    comb.emplace_back(2 * i + 1, 10, i);
    comb.emplace_back(2 * i + 1, 1, i);
    comb.emplace_back(2 * i + 2, 1, i);
  }
  comb.emplace_back(20, 0, 10);
  comb.emplace_back(0, 0, 0);
  for(std::uint32_t v = 0; v < comb.size(); ++v)
    corners.push_back(v);
  const Triangles triangles = triangulate_polygon(comb, corners, is_free);
  EXPECT_EQ(triangles.size(), corners.size() - 2);
  EXPECT_DOUBLE_EQ(area(comb, triangles), 20. + 10. * 9.);
  // However large or small it is.
  for(const double scale : {std::ldexp(1., 500), std::ldexp(1., -500)}) {
    std::vector<Point> scaled;
    for(const Point& p : comb)
      scaled.emplace_back(scale * p.x(), scale * p.y(), scale * p.z());
    EXPECT_EQ(triangulate_polygon(scaled, corners, is_free), triangles) << scale;
  }
}

// A square with a square hole, which the polygon goes to and comes back from along one edge.
TEST(Triangulation, goes_around_a_hole) {
  const auto is_free = [](std::uint32_t, std::uint32_t) { return true; };
  const std::vector<Point> points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0},
                                     {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 1, 0}};
  const Triangles triangles = triangulate_polygon(points, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}, is_free);
  EXPECT_EQ(triangles.size(), 8u);
  EXPECT_DOUBLE_EQ(area(points, triangles), 8.);
}

TEST(Triangulation, makes_triangles_of_polygons_that_cross_themselves_or_have_no_area) {
  const auto is_free = [](std::uint32_t, std::uint32_t) { return true; };
  std::vector<Point> points;
  Corners corners;
  for(std::uint32_t i = 0; i < 7; ++i) {
    points.emplace_back(std::cos(2.7 * i), std::sin(2.7 * i), 0.1 * i);
    corners.push_back(i);
  }
  EXPECT_EQ(triangulate_polygon(points, corners, is_free).size(), 5u);
  for(Point& p : points)
    p = Point(p.x(), 0., 0.);
  EXPECT_EQ(triangulate_polygon(points, corners, is_free).size(), 5u);
  for(Point& p : points)
    p = Point(1., 1., 1.);
  EXPECT_EQ(triangulate_polygon(points, corners, is_free).size(), 5u);
}

// Two faces that share two sides, and with them a vertex of two edges: the same diagonal in both
// would have four faces.
TEST(Triangulation, uses_no_diagonal_twice) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.4, 0.4, 0.2}};
  const Faces roof = {{0, 1, 2, 3}, {2, 1, 0, 4}, {0, 3, 4}, {3, 2, 4}};
  const Mended_soup mended = mend(soup_of(points, roof), triangulation);
  expect_sound(mended.soup);
  EXPECT_EQ(euler_characteristic(mended.soup), 2);
}

TEST(Triangulation, of_quadrangles_keeps_the_surface) {
  // A torus of n times m quadrangles, n and m as small as they can be and larger.
  for(const std::uint32_t n : {3u, 4u, 20u})
    for(const std::uint32_t m : {3u, 5u}) {
      std::vector<Point> points;
      Faces faces;
      for(std::uint32_t i = 0; i < n; ++i)
        for(std::uint32_t j = 0; j < m; ++j) {
          const double a = 6.283185 * i / n, b = 6.283185 * j / m;
          points.emplace_back((3 + std::cos(b)) * std::cos(a), (3 + std::cos(b)) * std::sin(a),
                              std::sin(b));
          const std::uint32_t i1 = (i + 1) % n, j1 = (j + 1) % m;
          faces.push_back({m * i + j, m * i1 + j, m * i1 + j1, m * i + j1});
        }
      const Mended_soup mended = mend(soup_of(points, faces), triangulation);
      EXPECT_EQ(mended.soup.faces.size(), 2 * faces.size());
      expect_sound(mended.soup);
      EXPECT_EQ(euler_characteristic(mended.soup), 0);
    }
}

// ---- repair

TEST(Repair, leaves_sound_meshes_as_they_are) {
  std::vector<Soup> soups = {generated("torus", 500, 1), generated("lattice", 3000, 5),
                             soup_of(corners_of_tetrahedron, tetrahedron)};
  soups.push_back(soups[2]);
  soups.back().points.emplace_back(0., 0., 0.); // isolated, and where another one is
  // Two that touch, in vertices of their own.
  Soup pair = soups[0];
  for(const Corners& face : faces_of(soups[0]))
    add_face(pair, {face[0] + 250, face[1] + 250, face[2] + 250});
  pair.points.insert(pair.points.end(), soups[0].points.begin(), soups[0].points.end());
  if(soups[0].points.size() == 250)
    soups.push_back(pair);
  for(const Soup& soup : soups) {
    const Mended_soup mended = mend(soup, both);
    EXPECT_TRUE(mended.changes.empty()) << words(mended);
    EXPECT_EQ(faces_of(mended.soup), faces_of(soup));
    EXPECT_EQ(mended.soup.points, soup.points);
  }
}

TEST(Repair, welds_faces_that_share_no_vertex) {
  Soup soup;
  for(const Corners& face : tetrahedron) {
    Corners own;
    for(const std::uint32_t v : face) {
      own.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(corners_of_tetrahedron[v]);
    }
    add_face(soup, own);
  }
  soup.points[0] = Point(-0., 0., 0.); // equal, if not the same bits
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(words(mended), "8 vertices welded to others at the same place, first: vertex 3 "
                           "to vertex 0\n"
                           "12 fewer boundary edges: 0 instead of 12\n");
  expect_sound(mended.soup);
  EXPECT_EQ(mended.soup.points.size(), 12u); // numbers stay
  EXPECT_EQ(euler_characteristic(mended.soup), 2);
}

TEST(Repair, welds_quadrangles_before_they_are_cut) {
  Soup soup;
  for(const Corners& face : cube) {
    Corners own;
    for(const std::uint32_t v : face) {
      own.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back(corners_of_cube[v]);
    }
    add_face(soup, own);
  }
  expect_sound(mend(soup, both).soup);
}

// Each face gets vertices of its own.
Soup unwelded(const std::vector<Point>& points, const Faces& faces) {
  Soup soup;
  for(Corners face : faces) {
    for(std::uint32_t& v : face) {
      soup.points.push_back(points[v]);
      v = static_cast<std::uint32_t>(soup.points.size() - 1);
    }
    add_face(soup, face);
  }
  return soup;
}

// Its edges have two faces each, but only one that will stay.
TEST(Repair, welds_faces_that_are_there_twice) {
  const std::pair<std::vector<Point>, Faces> solids[] = {{corners_of_tetrahedron, tetrahedron},
                                                         {corners_of_cube, cube}};
  for(const auto& [points, faces] : solids)
    for(const std::size_t number_of_faces : {std::size_t(1), faces.size()})
      for(const bool is_flipped : {false, true}) {
        Soup soup = unwelded(points, faces);
        const Faces own = faces_of(soup);
        for(std::size_t f = 0; f < number_of_faces; ++f) {
          Corners duplicate(own[f]);
          std::rotate(duplicate.begin(), duplicate.begin() + 1, duplicate.end());
          if(is_flipped)
            std::reverse(duplicate.begin(), duplicate.end());
          add_face(soup, duplicate);
        }
        const Mended_soup mended = mend(soup, both);
        expect_sound(mended.soup);
        EXPECT_EQ(euler_characteristic(mended.soup), 2) << words(mended);
        EXPECT_EQ(3 * mended.soup.faces.size(), 6 * (points.size() - 2));
        EXPECT_TRUE(mend(mended.soup, both).changes.empty());
      }
}

TEST(Repair, does_not_weld_what_merely_touches) {
  // Two tents without floor, whose tops are at one place.
  const std::vector<Point> points = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0},
                                     {0, 0, 1}, {1, 0, 2}, {0, 1, 2}, {-1, -1, 2}};
  const Mended_soup mended = mend(
      soup_of(points, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {4, 6, 5}, {4, 7, 6}, {4, 5, 7}}), repair);
  EXPECT_TRUE(mended.changes.empty()) << words(mended);
}

TEST(Repair, drops_degenerate_and_duplicate_faces) {
  Faces faces = tetrahedron;
  faces.insert(faces.begin() + 1, {2, 0, 2});
  faces.push_back({1, 0, 2});
  faces.push_back({0, 1});
  const Mended_soup mended = mend(soup_of(corners_of_tetrahedron, faces), repair);
  EXPECT_EQ(words(mended), "2 degenerate faces dropped, first: face 1\n"
                           "1 duplicate face dropped: face 5\n");
  EXPECT_EQ(faces_of(mended.soup), tetrahedron);
}

TEST(Repair, drops_duplicates_of_polygons) {
  for(const Corners& duplicate : Faces{{3, 2, 1, 0}, {0, 1, 2, 3}, {1, 0, 3, 2}, {6, 7, 4, 5}}) {
    Faces faces = cube;
    faces.push_back(duplicate);
    const Mended_soup mended = mend(soup_of(corners_of_cube, faces), both);
    EXPECT_NE(words(mended).find("1 duplicate face dropped: face 6"), std::string::npos);
    expect_sound(mended.soup);
    EXPECT_EQ(euler_characteristic(mended.soup), 2);
  }
}

TEST(Repair, drops_flaps_altogether) {
  Soup soup = generated("torus", 500, 1);
  const std::uint32_t u = soup.faces[17][0], v = soup.faces[17][1];
  const auto tip = static_cast<std::uint32_t>(soup.points.size());
  soup.points.emplace_back(5., 5., 5.);
  soup.points.emplace_back(6., 5., 5.);
  const Faces sound = faces_of(soup);
  for(const Corners& face : Faces{{u, v, tip}, {v, u, tip}, {v, tip + 1, tip}, {v, tip, tip + 1}})
    add_face(soup, face);
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(mended.changes.size(), 1u);
  EXPECT_NE(words(mended).find("4 faces of zero-thickness flaps dropped"), std::string::npos);
  EXPECT_EQ(faces_of(mended.soup), sound);
}

TEST(Repair, keeps_one_side_of_what_is_there_twice) {
  const Soup torus = generated("torus", 500, 1);
  for(const std::size_t number_of_faces : {std::size_t(100), torus.faces.size()}) {
    Soup soup = torus;
    for(std::size_t f = 0; f < number_of_faces; ++f)
      add_face(soup, {torus.faces[f][1], torus.faces[f][0], torus.faces[f][2]});
    EXPECT_EQ(faces_of(mend(soup, repair).soup), faces_of(torus));
  }
}

TEST(Repair, takes_corners_off_that_repeat_a_vertex) {
  Faces faces = cube;
  faces[1] = {4, 5, 5, 6, 7, 4};
  const Mended_soup mended = mend(soup_of(corners_of_cube, faces), both);
  EXPECT_NE(words(mended).find("1 face with repeated vertices simplified"), std::string::npos)
      << words(mended);
  expect_sound(mended.soup);
}

TEST(Repair, turns_the_fewer_faces_over) {
  Soup soup = generated("torus", 500, 1);
  for(const std::size_t f : {7, 8, 300})
    std::swap(soup.faces[f][0], soup.faces[f][1]);
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(words(mended), "3 faces flipped, first: face 7\n");
  expect_sound(mended.soup);
}

TEST(Repair, leaves_what_has_one_side_only) {
  std::vector<Point> points;
  Faces faces; // a strip with half a turn in it
  for(std::uint32_t i = 0; i < 9; ++i) {
    points.emplace_back(std::cos(0.7 * i), std::sin(0.7 * i), -0.3);
    points.emplace_back(std::cos(0.7 * i), std::sin(0.7 * i), 0.3);
    const std::uint32_t a = 2 * i, b = a + 1, c = i == 8 ? 1 : a + 2, d = i == 8 ? 0 : a + 3;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  const Mended_soup mended = mend(soup_of(points, faces), repair);
  EXPECT_TRUE(mended.changes.empty()) << words(mended);
  const auto defects = diagnose(mended.soup);
  ASSERT_FALSE(defects.empty());
  EXPECT_NE(defects.back().message.find("not orientable"), std::string::npos);
  EXPECT_EQ(words_on_remedy(soup_of(points, faces), defects, {}),
            "no option fixes this"); // the diagnosis says why
}

TEST(Repair, splits_a_vertex_of_two_surfaces) {
  Soup soup = soup_of(corners_of_tetrahedron, tetrahedron);
  for(const std::uint32_t v : {1, 2, 3})
    soup.points.emplace_back(-corners_of_tetrahedron[v].x(), -corners_of_tetrahedron[v].y(),
                             -corners_of_tetrahedron[v].z());
  for(const Corners& face : tetrahedron) {
    Corners other;
    for(const std::uint32_t v : face)
      other.push_back(v == 0 ? 0 : v + 3);
    add_face(soup, {other[0], other[2], other[1]});
  }
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(words(mended), "1 vertex split: vertex 0 into 2\n");
  expect_sound(mended.soup);
  ASSERT_EQ(mended.origins, std::vector<std::uint32_t>{0});
  EXPECT_EQ(mended.soup.points[7], mended.soup.points[0]);
}

// What was welded and has come apart again is no change.
TEST(Repair, tells_what_is_different_in_the_end) {
  // Two tetrahedra that are not welded and touch along an edge: four faces there for a while.
  Soup soup = unwelded(corners_of_tetrahedron, tetrahedron);
  const std::vector<Point> others = {{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const Soup second = unwelded(others, tetrahedron);
  for(const Corners& face : faces_of(second))
    add_face(soup, {face[0] + 12, face[1] + 12, face[2] + 12});
  soup.points.insert(soup.points.end(), second.points.begin(), second.points.end());
  const Mended_soup mended = mend(soup, repair);
  expect_sound(mended.soup);
  EXPECT_EQ(euler_characteristic(mended.soup), 4);
  // Twelve corners of each are four vertices in the end; of neither is one split.
  EXPECT_EQ(words(mended),
            "16 vertices welded to others at the same place, first: vertex 3 to vertex 0\n"
            "1 edge with more than two faces split: edge 0-2 with 4 faces\n"
            "24 fewer boundary edges: 0 instead of 24\n");
}

TEST(Repair, counts_vertices_that_were_shared_already_once) {
  Soup soup = unwelded(corners_of_tetrahedron, tetrahedron);
  soup.faces[1][0] = soup.faces[0][0]; // both at the origin
  const Mended_soup mended = mend(soup, repair);
  expect_sound(mended.soup);
  EXPECT_EQ(words(mended),
            "7 vertices welded to others at the same place, first: vertex 4 to vertex 2\n"
            "12 fewer boundary edges: 0 instead of 12\n");
}

TEST(Repair, drops_pillows) {
  Soup soup = generated("torus", 500, 1);
  const Faces sound = faces_of(soup);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for(const double x : {5., 6., 7.})
    soup.points.emplace_back(x, x * x, 0.);
  add_face(soup, {first, first + 1, first + 2});
  add_face(soup, {first, first + 2, first + 1});
  expect_sound(soup);
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(faces_of(mended.soup), sound);
  EXPECT_EQ(mended.face_in_file.size(), sound.size());
  EXPECT_EQ(words(mended), "2 faces of pillows dropped (two faces that share all edges), "
                           "first: face " +
                               std::to_string(sound.size()) + "\n");
}

// A pillow that comes of an edge with four faces: one tent on each side of it.
TEST(Repair, drops_pillows_that_hang_on_a_surface) {
  Soup soup = generated("torus", 500, 1);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.emplace_back(5., 5., 5.);
  soup.points.emplace_back(6., 5., 5.);
  const Faces sound = faces_of(soup);
  const std::uint32_t v = soup.faces[17][0];
  add_face(soup, {v, first, first + 1});
  add_face(soup, {v, first + 1, first});
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(faces_of(mended.soup), sound);
  EXPECT_NE(words(mended).find("2 faces of pillows"), std::string::npos) << words(mended);
}

Faces moebius_strip(std::vector<Point>& points, std::uint32_t first) {
  Faces faces;
  for(std::uint32_t i = 0; i < 9; ++i) {
    points.emplace_back(20. + std::cos(0.7 * i), std::sin(0.7 * i), -0.25);
    points.emplace_back(20. + std::cos(0.7 * i), std::sin(0.7 * i), 0.25);
    const std::uint32_t a = first + 2 * i, b = a + 1, c = i == 8 ? first + 1 : a + 2,
                        d = i == 8 ? first : a + 3;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  return faces;
}

TEST(Repair, drops_a_component_that_is_not_orientable) {
  Soup soup = generated("torus", 500, 1);
  const Faces sound = faces_of(soup);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for(const Corners& face : moebius_strip(soup.points, first))
    add_face(soup, face);
  const Mended_soup mended = mend(soup, repair);
  EXPECT_EQ(faces_of(mended.soup), sound);
  expect_sound(mended.soup);
  ASSERT_EQ(mended.changes.size(), 2u) << words(mended); // and the boundary that it had
  EXPECT_EQ(mended.changes[0].count, 18u);
  EXPECT_EQ(mended.changes[0].words.find("of " + std::to_string(soup.faces.size()) +
                                         " faces dropped: component 1 of 2 is not orientable, "
                                         "first: face " +
                                         std::to_string(sound.size()) + ", bounding box: 19."),
            0u)
      << words(mended);
  const auto defects = diagnose(soup);
  EXPECT_EQ(words_on_remedy(soup, defects, {}).find("--repair fixes this:\n  18 of "), 0u);
}

// The strip is fixed to the torus along an edge, which then has three faces.
TEST(Repair, drops_a_piece_that_is_not_orientable_from_an_edge) {
  Soup soup = generated("torus", 500, 1);
  const Faces sound = faces_of(soup);
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  const std::uint32_t u = soup.faces[17][0], v = soup.faces[17][1];
  for(Corners face : moebius_strip(soup.points, first)) {
    for(std::uint32_t& w : face)
      w = w == first ? u : w == first + 2 ? v : w; // an edge of its boundary
    add_face(soup, face);
  }
  const Mended_soup mended = mend(soup, repair);
  expect_sound(mended.soup);
  EXPECT_EQ(faces_of(mended.soup), sound) << words(mended);
}

TEST(Repair, names_a_few_of_many_components_that_are_not_orientable) {
  Soup soup = soup_of(corners_of_tetrahedron, tetrahedron);
  for(int i = 0; i < 11; ++i) {
    std::vector<Point> points;
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for(const Corners& face : moebius_strip(points, first))
      add_face(soup, face);
    for(const Point& p : points)
      soup.points.emplace_back(p.x() + 5. * i, p.y(), p.z());
  }
  const Mended_soup mended = mend(soup, repair);
  ASSERT_EQ(mended.changes.size(), 10u) << words(mended);
  EXPECT_EQ(mended.changes[7].words.find("of 202 faces dropped: component 8 of 12"), 0u);
  EXPECT_EQ(mended.changes[8].count, 54u);
  EXPECT_EQ(mended.changes[8].words, "faces dropped in 3 more components that are not orientable");
}

Remedies steps(std::initializer_list<Repair_step> steps) {
  Remedies remedies = {false, true, {}};
  for(const Repair_step step : steps)
    remedies.steps.set(static_cast<std::size_t>(step));
  return remedies;
}

TEST(Repair, does_the_steps_that_are_asked_for) {
  Soup soup = generated("torus", 500, 1);
  const Soup torus = soup;
  std::swap(soup.faces[7][1], soup.faces[7][2]);
  const Faces turned = faces_of(soup);
  soup.points.push_back(Point(soup.points[soup.faces[100][0]]));
  soup.faces[100][0] = static_cast<std::uint32_t>(soup.points.size() - 1);
  const Mended_soup welded = mend(soup, steps({Repair_step::WELD}));
  EXPECT_EQ(faces_of(welded.soup), turned);
  ASSERT_EQ(welded.changes.size(), 2u) << words(welded);
  EXPECT_EQ(welded.changes[0].kind, Change_kind::VERTICES_WELDED);
  const Mended_soup oriented = mend(soup, steps({Repair_step::ORIENT}));
  EXPECT_EQ(words(oriented), "1 face flipped: face 7\n");
  EXPECT_EQ(oriented.soup.faces[100][0], soup.faces[100][0]);
  // Without the step that turns them, faces are as they were, and what is split is so all the same.
  for(const Repair_step step : {Repair_step::SPLIT, Repair_step::PILLOWS, Repair_step::DUPLICATES,
                                Repair_step::ONE_SIDED, Repair_step::DEGENERATE})
  {
    const Mended_soup same = mend(soup, steps({step}));
    EXPECT_EQ(faces_of(same.soup), faces_of(soup));
    EXPECT_TRUE(same.changes.empty()) << words(same);
  }
  EXPECT_EQ(faces_of(mend(soup, steps({Repair_step::WELD, Repair_step::ORIENT})).soup),
            faces_of(torus));
}

TEST(Repair, splits_without_turning) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0},  {1, 1, 0},
                                     {2, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const Faces faces = {{0, 1, 2}, {1, 2, 3}, {0, 4, 5}};
  const Mended_soup mended = mend(soup_of(points, faces), steps({Repair_step::SPLIT}));
  EXPECT_EQ(words(mended), "1 vertex split: vertex 0 into 2\n");
  EXPECT_EQ(faces_of(mended.soup), (Faces{{0, 1, 2}, {1, 2, 3}, {6, 4, 5}}));
  EXPECT_EQ(mend(soup_of(points, faces), steps({Repair_step::ORIENT})).origins.size(), 0u);
}

// Two boxes that have an edge in common come apart, whether they are told by pieces or, joined
// elsewhere, by what is solid.
TEST(Repair, takes_solids_apart_at_an_edge) {
  std::vector<Point> points = corners_of_cube;
  for(const Point& p : corners_of_cube)
    points.emplace_back(p.x() + 1., p.y() + 1., p.z());
  Faces faces = cube;
  for(Corners face : cube) {
    for(std::uint32_t& v : face)
      v = v == 0 ? 2 : v == 4 ? 6 : v + 8;
    faces.push_back(face);
  }
  const Mended_soup mended = mend(soup_of(points, faces), both);
  EXPECT_NE(words(mended).find("1 edge with more than two faces split: edge 2-6 with 4 faces"),
            std::string::npos);
  EXPECT_NE(words(mended).find("2 vertices split"), std::string::npos);
  expect_sound(mended.soup);
  EXPECT_EQ(euler_characteristic(mended.soup), 4);
}

TEST(Repair, lets_a_surface_go_on_below_a_fin) {
  for(const bool is_upright : {false, true}) {
    Soup soup = generated("torus", 500, 1);
    const std::uint32_t u = soup.faces[17][0], v = soup.faces[17][1];
    const auto tip = static_cast<std::uint32_t>(soup.points.size());
    soup.points.emplace_back(5., 5., 5.);
    add_face(soup, is_upright ? Corners{u, v, tip} : Corners{v, u, tip});
    const Mended_soup mended = mend(soup, repair);
    expect_manifold(mended.soup);
    EXPECT_EQ(euler_characteristic(mended.soup), 1); // a torus and a triangle
    EXPECT_EQ(mended.origins.size(), 2u);
  }
}

TEST(Repair, makes_boundary_curves_simple) {
  // Two triangles of one fan each, which have a vertex in common.
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const Mended_soup mended = mend(soup_of(points, {{0, 1, 2}, {0, 3, 4}}), repair);
  EXPECT_EQ(words(mended), "1 vertex split: vertex 0 into 2\n");
  expect_manifold(mended.soup);
}

// Among them some in which a fan passes an edge twice, so that splitting vertices is not enough.
TEST(Repair, makes_manifolds_of_random_triangles) {
  std::mt19937 random(5);
  int number_with_divisions = 0;
  for(int i = 0; i < 2000; ++i) {
    SCOPED_TRACE("soup " + std::to_string(i));
    std::uniform_int_distribution<std::uint32_t> vertex(0, 4 + i % 5), coordinate(0, 2);
    std::vector<Point> points;
    for(int v = 0; v < 9; ++v)
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    Faces faces;
    for(int f = 0; f < 4 + i % 17; ++f)
      faces.push_back({vertex(random), vertex(random), vertex(random)});
    const Mended_soup mended = mend(soup_of(points, faces), repair);
    if(mended.is_one_sided || mended.soup.faces.empty())
      continue;
    expect_manifold(mended.soup);
    // What came apart at an edge may be welded there now, and be a pillow.
    const Mended_soup again = mend(mended.soup, repair);
    if(!again.soup.faces.empty())
      expect_manifold(again.soup);
    number_with_divisions += words(mended).find("split at ") != std::string::npos;
  }
  EXPECT_GT(number_with_divisions, 10);
}

TEST(Repair, makes_manifolds_of_random_polygons) {
  std::mt19937 random(7);
  for(int i = 0; i < 1000; ++i) {
    SCOPED_TRACE("soup " + std::to_string(i));
    std::uniform_int_distribution<std::uint32_t> vertex(0, 4 + i % 9), coordinate(0, 3), size(1, 7);
    std::vector<Point> points;
    for(int v = 0; v < 13; ++v)
      points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    Faces faces;
    for(int f = 0; f < 2 + i % 11; ++f) {
      Corners corners(size(random));
      for(std::uint32_t& v : corners)
        v = vertex(random);
      faces.push_back(corners);
    }
    const Mended_soup mended = mend(soup_of(points, faces), both);
    if(!mended.is_one_sided && !mended.soup.faces.empty())
      expect_manifold(mended.soup);
    for(const Corners& face : faces_of(mended.soup))
      EXPECT_EQ(face.size(), 3u);
  }
}

TEST(Repair, does_nothing_about_points_that_are_nowhere) {
  Soup soup = soup_of(corners_of_cube, cube);
  soup.points[3] = Point(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  const Mended_soup mended = mend(soup, both);
  EXPECT_TRUE(mended.changes.empty());
  EXPECT_EQ(words_on_remedy(soup, diagnose(soup), {}), "no option fixes this");
}

// ---- damage that is undone

class Vandal
{
public:
  Vandal(const Soup& soup, std::uint32_t seed)
      : random_(seed)
      , points_(soup.points)
      , faces_(faces_of(soup)) {}

  std::uint32_t number_below(std::size_t bound) {
    return std::uniform_int_distribution<std::uint32_t>(0, std::uint32_t(bound) - 1)(random_);
  }

  void flip_faces() {
    for(std::size_t i = 0; i < faces_.size() / 3; ++i) {
      Corners& face = faces_[number_below(faces_.size())];
      std::swap(face[0], face[1]);
    }
  }

  // The vertices of some faces become their own.
  void unweld() {
    for(std::size_t i = 0; i < faces_.size() / 2; ++i)
      for(std::uint32_t& v : faces_[number_below(faces_.size())]) {
        points_.push_back(Point(points_[v]));
        v = static_cast<std::uint32_t>(points_.size() - 1);
      }
  }

  void duplicate_faces() {
    for(int i = 0; i < 20; ++i) {
      Corners face = faces_[number_below(faces_.size())];
      std::rotate(face.begin(), face.begin() + number_below(3), face.end());
      if(number_below(2) == 0)
        std::swap(face[0], face[1]);
      faces_.push_back(face);
    }
  }

  void add_degenerate_faces() {
    for(int i = 0; i < 20; ++i) {
      const std::uint32_t u = number_below(points_.size()), v = number_below(points_.size());
      faces_.insert(faces_.begin() + number_below(faces_.size()), {u, v, i % 2 == 0 ? u : v});
    }
  }

  // Vertices so far apart that no edge gets more than two faces.
  void glue_vertices() {
    for(int i = 0; i < 5; ++i) {
      const std::uint32_t v = number_below(points_.size()), w = number_below(points_.size());
      const std::set<std::uint32_t> near = neighbors(v, 4);
      if(near.count(w) == 0)
        replace(v, w);
    }
  }

  Soup soup() const { return soup_of(points_, faces_); }

private:
  std::set<std::uint32_t> neighbors(std::uint32_t v, int distance) const {
    std::set<std::uint32_t> near = {v};
    for(int i = 0; i < distance; ++i) {
      std::set<std::uint32_t> next = near;
      for(const Corners& face : faces_)
        if(std::any_of(face.begin(), face.end(), [&](auto u) { return near.count(u) != 0; }))
          next.insert(face.begin(), face.end());
      near = next;
    }
    return near;
  }

  void replace(std::uint32_t v, std::uint32_t by) {
    for(Corners& face : faces_)
      std::replace(face.begin(), face.end(), v, by);
  }

  std::mt19937 random_;
  std::vector<Point> points_;
  Faces faces_;
};

TEST(Repair, undoes_random_damage) {
  const std::pair<const char*, std::size_t> kinds[] = {
      {"torus", 1}, {"multi-torus", 3}, {"lattice", 4}};
  std::uint32_t seed = 0;
  for(const auto& [kind, genus] : kinds) {
    const Soup original = generated(kind, 1500, genus);
    for(int damage = 1; damage < 32; ++damage) {
      SCOPED_TRACE(std::string(kind) + ", damage " + std::to_string(damage));
      Vandal vandal(original, ++seed);
      if(damage & 1)
        vandal.glue_vertices();
      if(damage & 2)
        vandal.flip_faces();
      if(damage & 4)
        vandal.duplicate_faces();
      if(damage & 8)
        vandal.unweld();
      if(damage & 16)
        vandal.add_degenerate_faces();
      const Soup damaged = vandal.soup();
      const Mended_soup mended = mend(damaged, repair);
      expect_sound(mended.soup);
      EXPECT_EQ(mended.soup.faces.size(), original.faces.size());
      EXPECT_EQ(euler_characteristic(mended.soup), euler_characteristic(original));
      EXPECT_EQ(faces_of(mend(damaged, repair).soup), faces_of(mended.soup));
      const auto defects = diagnose(damaged);
      if(!defects.empty()) {
        EXPECT_NE(words_on_remedy(damaged, defects, {}).find("--repair"), std::string::npos);
      }
    }
  }
}

// ---- which remedy is named

TEST(Remedy, is_the_one_that_helps) {
  const auto words_on = [](const Soup& soup, const Remedies& given = {}) {
    const std::vector<Defect> defects = diagnose(mend(soup, given).soup);
    return defects.empty() ? "nothing is wrong" : words_on_remedy(soup, defects, given);
  };
  EXPECT_EQ(words_on(soup_of(corners_of_cube, cube)), "--triangulate splits them into triangles");
  EXPECT_EQ(words_on(soup_of(corners_of_cube, cube), repair),
            "--triangulate splits them into triangles");
  Faces faces = cube;
  faces.push_back({0, 0, 1});
  const char for_both[] = "--triangulate and --repair together fix this:\n"
                          "  1 degenerate face dropped: face 6\n"
                          "  6 faces with more than three vertices triangulated, first: face 0";
  EXPECT_EQ(words_on(soup_of(corners_of_cube, faces)), for_both);
  EXPECT_EQ(words_on(soup_of(corners_of_cube, faces), repair), for_both);
  faces = tetrahedron;
  faces.push_back({0, 0, 1});
  EXPECT_EQ(words_on(soup_of(corners_of_tetrahedron, faces)), "--repair drops it");
  EXPECT_EQ(words_on(soup_of(corners_of_tetrahedron, faces), triangulation), "--repair drops it");
  faces.back() = {0, 1, 2};
  EXPECT_EQ(words_on(soup_of(corners_of_tetrahedron, faces)),
            "--repair fixes this:\n  1 duplicate face dropped: face 4");
  // Not what was found, if something else is done about it: here a vertex with two fans.
  const std::vector<Point> ring = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_EQ(words_on(soup_of(ring, {{0, 2, 1}, {0, 1, 3}, {4, 5, 3}, {2, 0, 3}})),
            "--repair fixes this:\n"
            "  2 vertices welded to others at the same place, first: vertex 4 to vertex 1\n"
            "  6 fewer boundary edges: 0 instead of 6");
  EXPECT_EQ(words_on(soup_of(corners_of_tetrahedron, {})), "no option fixes this");
  EXPECT_EQ(words_on(soup_of(corners_of_tetrahedron, {}), both), "no other option fixes this");
}

// ---- effort

// One vertex in all faces, and one edge in all faces.
TEST(Repair, takes_no_quadratic_time) {
  std::vector<Point> points = {{0, 0, 0}, {0, 0, 1}};
  Faces fan, book;
  constexpr std::uint32_t n = 100000;
  for(std::uint32_t i = 0; i < n; ++i) {
    const double a = 6.28 * i / n;
    points.emplace_back(std::cos(a), std::sin(a), 0.);
    fan.push_back({0, 2 + i, 2 + (7919 * i + 1) % n});
    book.push_back({0, 1, 2 + i});
  }
  expect_manifold(mend(soup_of(points, fan), repair).soup);
  expect_manifold(mend(soup_of(points, book), repair).soup);
  Corners corners;
  for(std::uint32_t i = 2; i < n; ++i)
    corners.push_back(i);
  EXPECT_EQ(mend(soup_of(points, {corners}), triangulation).soup.faces.size(), corners.size() - 2);
}

} // namespace test_htloops_mending
