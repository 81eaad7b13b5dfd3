#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"
#include "random_input.h"
#include "with.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/remove_handles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_remove_handles {

namespace htl = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;
using Options = htl::Removal_options;
namespace PMP = CGAL::Polygon_mesh_processing;

using Exact_predicates_mesh =
    CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

template <typename Member, typename Value> auto wish(Member Options::*member, const Value& value) {
  return params::removal_options(with(member, value));
}

Recipe recipe(const char* kind, std::size_t faces, std::size_t genus, unsigned seed = 0) {
  Recipe recipe;
  recipe.kind = kind;
  recipe.request.faces = faces;
  recipe.request.genus = genus;
  recipe.request.seed = seed;
  return recipe;
}

template <typename TriangleMesh> std::ptrdiff_t euler_characteristic(const TriangleMesh& mesh) {
  std::ptrdiff_t number = 0;
  for([[maybe_unused]] auto v : vertices(mesh))
    ++number;
  for([[maybe_unused]] auto e : edges(mesh))
    --number;
  for([[maybe_unused]] auto f : faces(mesh))
    ++number;
  return number;
}

template <typename TriangleMesh> std::size_t number_of_components(const TriangleMesh& mesh) {
  std::map<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::size_t> component;
  return PMP::connected_components(mesh, boost::make_assoc_property_map(component));
}

// By programs of others.
template <typename TriangleMesh>
void expect_solid(const TriangleMesh& mesh, std::size_t genus, std::size_t components = 1) {
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh, true));
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_EQ(number_of_components(mesh), components);
  EXPECT_EQ(euler_characteristic(mesh),
            2 * static_cast<std::ptrdiff_t>(components) - 2 * static_cast<std::ptrdiff_t>(genus));
  Exact_predicates_mesh copy;
  CGAL::copy_face_graph(mesh, copy);
  EXPECT_FALSE(PMP::does_self_intersect(copy));
  EXPECT_TRUE(PMP::does_bound_a_volume(copy));
}

std::array<Mesh::Point, 3> points_of(const Mesh& mesh, Mesh::Face_index f) {
  std::array<Mesh::Point, 3> points;
  std::size_t i = 0;
  for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
    points[i++] = mesh.point(v);
  std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
  return points;
}

std::set<std::array<Mesh::Point, 3>> faces_by_points(const Mesh& mesh) {
  std::set<std::array<Mesh::Point, 3>> all;
  for(const auto f : mesh.faces())
    all.insert(points_of(mesh, f));
  return all;
}

template <typename NamedParameters>
void expect_refusal(Mesh& mesh, const NamedParameters& np, const std::string& words) {
  const auto before = faces_by_points(mesh);
  try {
    CGAL::remove_handles(mesh, np);
    ADD_FAILURE() << "no refusal: " << words;
  } catch(const std::invalid_argument& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(words), std::string::npos) << refusal.what();
  }
  EXPECT_EQ(faces_by_points(mesh), before);
}

class Removal : public testing::TestWithParam<Recipe>
{};

TEST_P(Removal, LeavesASphere) {
  for(const auto method :
      {htl::Removal_method::CUT, htl::Removal_method::FILL, htl::Removal_method::CHEAPEST})
  {
    Mesh mesh = mesh_of(GetParam());
    const std::size_t genus = GetParam().request.genus;
    const htl::Removal_report report = CGAL::remove_handles(mesh, wish(&Options::method, method));
    EXPECT_EQ(report.genus_before, genus);
    EXPECT_EQ(report.removed.size() + report.refused.size(), genus);
    // Between plates of triangles as long as they are, caps may have no room beside each other:
    // that depends on which of equally short loops they are of.
    if(method != htl::Removal_method::CHEAPEST && GetParam().kind == "plates")
      EXPECT_LE(report.refused.size(), 1u);
    else
      EXPECT_TRUE(report.refused.empty())
          << report.refused.size() << " refused: " << report.refused.front().reason;
    EXPECT_EQ(report.genus_after, report.refused.size());
    expect_solid(mesh, report.genus_after);
    for(const htl::Removed_handle& handle : report.removed) {
      EXPECT_GT(handle.area, 0.);
      if(method != htl::Removal_method::CHEAPEST) {
        EXPECT_EQ(handle.by == htl::Removal_way::CUT, method == htl::Removal_method::CUT);
        EXPECT_EQ(handle.by == htl::Removal_way::FILL, method == htl::Removal_method::FILL);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Generated,
                         Removal,
                         testing::Values(recipe("torus", 2000, 1),
                                         recipe("multi-torus", 3000, 3),
                                         recipe("gyroid", 10000, 8),
                                         recipe("lattice", 8000, 5),
                                         recipe("plates", 2000, 6),
                                         recipe("sponge", 10000, 7)),
                         [](const auto& tested) {
                           std::string name = tested.param.kind;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Also where faces point inwards.
TEST(Handle_removal, SaysWhatIsTakenAwayAndWhatIsPutIn) {
  for(bool is_reversed : {false, true}) {
    Mesh torus = mesh_of(recipe("torus", 2000, 1));
    if(is_reversed)
      PMP::reverse_face_orientations(torus);
    Mesh copy = torus;
    EXPECT_GT(CGAL::remove_handles(torus, wish(&Options::method, htl::Removal_method::CUT))
                  .removed.front()
                  .volume,
              0.);
    EXPECT_LT(CGAL::remove_handles(copy, wish(&Options::method, htl::Removal_method::FILL))
                  .removed.front()
                  .volume,
              0.);
  }
}

// What a closed profile of radii and heights sweeps as it turns, with no vertices but those of its
// circles.
Mesh turned(const std::vector<std::array<double, 2>>& profile) {
  constexpr std::uint32_t n = 24;
  const auto number = static_cast<std::uint32_t>(profile.size());
  Soup soup;
  for(const auto& [radius, z] : profile)
    for(std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2. * CGAL_PI * i / n;
      soup.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  for(std::uint32_t ring = 0; ring < number; ++ring)
    for(std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = ring * n + i, b = ring * n + (i + 1) % n;
      const std::uint32_t c = (a + n) % (number * n), d = (b + n) % (number * n);
      soup.triangles.push_back({a, c, b});
      soup.triangles.push_back({b, c, d});
    }
  Mesh mesh = mesh_of(soup);
  if(PMP::volume(mesh) < 0.)
    PMP::reverse_face_orientations(mesh);
  return mesh;
}

Mesh plate_with_a_hole(double hole_radius, double plate_radius, double thickness) {
  return turned(
      {{hole_radius, 0.}, {plate_radius, 0.}, {plate_radius, thickness}, {hole_radius, thickness}});
}

// Whatever direction the walls have at whose edges the plate ends.
TEST(Handle_removal, FillsTheHoleOfAPlateFlat) {
  Mesh mesh = plate_with_a_hole(1., 20., 3.);
  const double volume = PMP::volume(mesh), hole = PMP::volume(plate_with_a_hole(1e-9, 1., 3.));
  const htl::Removal_report report =
      CGAL::remove_handles(mesh, wish(&Options::method, htl::Removal_method::FILL));
  EXPECT_EQ(report.genus_after, 0u);
  expect_solid(mesh, 0);
  EXPECT_NEAR(PMP::volume(mesh), volume + hole, 1e-6);
  for(const auto v : mesh.vertices())
    EXPECT_NEAR((std::min)(std::abs(mesh.point(v).z()), std::abs(mesh.point(v).z() - 3.)), 0.,
                1e-9);
}

// As if they had never been: also where a slit to the rim would be shorter, and where the hole is
// wider on one side.
TEST(Handle_removal, ClosesBoresFlushByDefault) {
  const double whole = PMP::volume(plate_with_a_hole(1e-9, 20., 3.));
  for(const auto& profile : std::vector<std::vector<std::array<double, 2>>>{
          {{19., 0.}, {20., 0.}, {20., 3.}, {19., 3.}},
          {{1., 0.}, {20., 0.}, {20., 3.}, {1., 3.}},
          {{1., 0.}, {20., 0.}, {20., 3.}, {2., 3.}, {2., 2.}, {1., 2.}},
          {{1., 0.}, {20., 0.}, {20., 3.}, {2., 3.}, {1., 2.}}})
    for(bool is_reversed : {false, true}) {
      Mesh mesh = turned(profile);
      if(is_reversed)
        PMP::reverse_face_orientations(mesh);
      const htl::Removal_report report = CGAL::remove_handles(mesh);
      ASSERT_EQ(report.removed.size(), 1u);
      EXPECT_EQ(report.removed[0].by, htl::Removal_way::FILL);
      EXPECT_EQ(report.genus_after, 0u);
      EXPECT_NEAR(std::abs(PMP::volume(mesh)), whole, 1e-6 * whole);
      for(const auto v : mesh.vertices()) {
        EXPECT_TRUE(mesh.point(v).z() == 0. || mesh.point(v).z() == 3.);
      }
    }
}

TEST(Handle_removal, ObeysTheMethodOfEachPair) {
  const Mesh original = mesh_of(recipe("chain", 8000, 4));
  for(std::size_t pair = 0; pair < 4; ++pair) {
    Mesh mesh = original;
    Options options;
    options.method = htl::Removal_method::FILL;
    options.methods[pair] = htl::Removal_method::CUT;
    for(const auto& handle : CGAL::remove_handles(mesh, params::removal_options(options)).removed)
      EXPECT_EQ(handle.by, handle.pair == pair ? htl::Removal_way::CUT : htl::Removal_way::FILL);
  }
  Mesh mesh = original;
  Options options;
  options.methods[4] = htl::Removal_method::CUT;
  expect_refusal(mesh, params::removal_options(options), "pair 4 does not exist");
}

// Cuts take solid away and fills put it in; nothing leaves the box, and no cap is much larger than
// a disc on its rim.
TEST(Handle_removal, ChangesNoMoreThanARepair) {
  for(const Recipe& of :
      {recipe("gyroid", 6000, 6), recipe("lattice", 6000, 5), recipe("plates", 1500, 9),
       recipe("bars", 1500, 9), recipe("sponge", 2000, 8), recipe("knot", 3000, 1)})
    for(const auto method :
        {htl::Removal_method::CUT, htl::Removal_method::FILL, htl::Removal_method::SMALLEST_CHANGE})
    {
      Mesh mesh = mesh_of(of);
      const double volume = std::abs(PMP::volume(mesh));
      const htl::Removal_report report = CGAL::remove_handles(mesh, wish(&Options::method, method));
      double sum = 0.;
      for(const htl::Removed_handle& handle : report.removed) {
        const htl::Shape_change& change = handle.change;
        if(handle.by == htl::Removal_way::CUT) {
          EXPECT_LE(change.volume_added, 1e-9 * volume);
          EXPECT_LE(change.burial, (0.5 + 1e-9) * handle.length);
        }
        if(handle.by == htl::Removal_way::FILL) {
          EXPECT_LE(change.volume_removed, 1e-9 * volume);
        }
        EXPECT_LE(change.cap_ratio, 3.);
        EXPECT_GE(change.sharpest_angle, 30.);
        EXPECT_LE(change.box_growth, 1e-9 * volume);
        EXPECT_EQ(handle.volume, change.volume_removed - change.volume_added);
        EXPECT_EQ(handle.area, change.cap_area);
        sum += handle.volume;
      }
      EXPECT_NEAR(std::abs(PMP::volume(mesh)), volume - sum, 1e-9 * volume);
    }
}

struct Change_alone
{
  double volume;
  bool has_sharp_edge;
};

Change_alone change_alone(const Mesh& original, std::size_t pair, htl::Removal_method method) {
  Mesh mesh = original;
  Options options;
  options.methods[pair] = method;
  std::size_t number = 0;
  const auto is_the_one = [&](const auto&) { return number++ == pair; };
  const htl::Removal_report report =
      CGAL::remove_handles(mesh, params::removal_options(options).filter(is_the_one));
  if(report.removed.size() != 1)
    return {(std::numeric_limits<double>::infinity)(), false}; // refused
  return {std::abs(PMP::volume(original) - PMP::volume(mesh)),
          report.removed[0].change.has_sharp_edge()};
}

void expect_smallest_change(const Mesh& mesh, std::size_t genus) {
  for(std::size_t pair = 0; pair < genus; ++pair) {
    const Change_alone cut = change_alone(mesh, pair, htl::Removal_method::CUT),
                       fill = change_alone(mesh, pair, htl::Removal_method::FILL),
                       taken = change_alone(mesh, pair, htl::Removal_method::SMALLEST_CHANGE);
    const Change_alone& best = cut.volume < fill.volume ? cut : fill;
    // A sharp edge is avoided, unless that changes eight times as much.
    const double most = best.has_sharp_edge && !taken.has_sharp_edge ? 8. : 1.1;
    EXPECT_LE(taken.volume, most * best.volume + 1e-12 * std::abs(PMP::volume(mesh)))
        << "pair " << pair;
  }
}

// A ring as high as it likes: the less round the disc across it is, the smaller it may be.
TEST(Handle_removal, GoesTheWayThatChangesLess) {
  expect_smallest_change(mesh_of(recipe("gyroid", 6000, 3)), 3);
  for(const double height : {0.1, 0.5, 1., 2., 4.})
    expect_smallest_change(turned({{1., 0.}, {1.2, -height}, {1.4, 0.}, {1.2, height}}), 1);
}

// Of several that are taken out together, each says how long the longest loop of all is.
TEST(Handle_removal, MovesNothingFurtherThanHalfALoop) {
  Recipe scan = recipe("scan", 60000, 2);
  scan.request.bridges = 20;
  scan.request.tunnels = 12;
  Mesh mesh = mesh_of(scan);
  std::size_t number_whole = 0;
  for(const htl::Removed_handle& handle : CGAL::remove_handles(mesh).removed) {
    number_whole += handle.by == htl::Removal_way::WHOLE;
    EXPECT_LE(handle.change.displacement, (0.5 + 1e-9) * handle.length);
  }
  EXPECT_GT(number_whole, 0u);
  expect_solid(mesh, 0);
}

// Of seven vertices, each with an edge to each other one: what is left is no good in any way.
Mesh csaszar_torus() {
  Soup soup;
  soup.points = {{-20, -20, -10}, {-20, 20, -15}, {-5, -8, 8},  {0, 0, 30},
                 {5, 8, 8},       {20, -20, -15}, {20, 20, -10}};
  soup.triangles = {{1, 3, 6}, {1, 6, 5}, {2, 5, 6}, {0, 2, 6}, {0, 6, 4}, {3, 4, 6}, {1, 2, 3},
                    {1, 4, 2}, {1, 0, 4}, {1, 5, 0}, {3, 5, 4}, {0, 5, 3}, {0, 3, 2}, {2, 4, 5}};
  return mesh_of(soup);
}

// ... which may be wanted all the same.
TEST(Handle_removal, IsForcedToRuinAShape) {
  Mesh mesh = csaszar_torus(), copy = mesh;
  const htl::Removal_report report = CGAL::remove_handles(mesh);
  ASSERT_EQ(report.refused.size(), 1u);
  EXPECT_NE(report.refused[0].reason.find("degrees"), std::string::npos);
  EXPECT_EQ(CGAL::remove_handles(copy, wish(&Options::force, true)).removed.size(), 1u);
  expect_solid(copy, 0);
}

// A power of two is no difference at all.
TEST(Handle_removal, IsTheSameAtAnyScale) {
  for(const Mesh& at_first : {mesh_of(recipe("torus", 400, 1)), mesh_of(recipe("chain", 1500, 3)),
                              mesh_of(recipe("plates", 600, 2)), csaszar_torus()})
  {
    Mesh expected = at_first;
    const htl::Removal_report expected_report = CGAL::remove_handles(expected);
    for(const int exponent : {-990, -700, -200, -166, -133, 150, 200, 300, 660}) {
      Mesh mesh = at_first;
      for(const auto v : mesh.vertices()) {
        const Mesh::Point& p = mesh.point(v);
        mesh.point(v) = {std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                         std::ldexp(p.z(), exponent)};
      }
      const htl::Removal_report report =
          CGAL::remove_handles<CGAL::Parallel_if_available_tag>(mesh);
      ASSERT_EQ(report.removed.size(), expected_report.removed.size()) << exponent;
      for(std::size_t i = 0; i < report.removed.size(); ++i) {
        const htl::Removed_handle &handle = report.removed[i], &other = expected_report.removed[i];
        EXPECT_EQ(handle.pair, other.pair);
        EXPECT_EQ(handle.by, other.by);
        EXPECT_NEAR(std::ldexp(handle.length, -exponent), other.length, 1e-9);
        EXPECT_EQ(handle.change.cap_ratio, other.change.cap_ratio);
        EXPECT_EQ(handle.change.sharpest_angle, other.change.sharpest_angle);
        if(std::abs(exponent) <= 200) {
          EXPECT_NEAR(std::ldexp(handle.area, -2 * exponent), other.area, 1e-9);
          EXPECT_NEAR(std::ldexp(handle.volume, -3 * exponent), other.volume, 1e-9);
        }
      }
      ASSERT_EQ(mesh.number_of_faces(), expected.number_of_faces());
      for(const auto v : mesh.vertices())
        for(int axis = 0; axis < 3; ++axis)
          EXPECT_NEAR(std::ldexp(mesh.point(v)[axis], -exponent), expected.point(v)[axis], 1e-9);
    }
  }
}

TEST(Handle_removal, RemovesAsManyHoweverTheMeshLies) {
  for(const char* kind : {"plates", "bars", "hubs"}) {
    const Soup soup = soup_of(recipe(kind, 3000, 4));
    Mesh mesh = mesh_of(soup), other = mesh_of(generators::askew(soup));
    const htl::Removal_report report = CGAL::remove_handles(mesh),
                              report_of_other = CGAL::remove_handles(other);
    EXPECT_EQ(report.genus_after, 0u) << kind;
    EXPECT_EQ(report_of_other.genus_after, 0u) << kind;
    const auto sum_of_displacements = [](const htl::Removal_report& r) {
      return std::accumulate(r.removed.begin(), r.removed.end(), 0.,
                             [](double sum, const htl::Removed_handle& h) {
                               return sum + h.change.displacement / h.length;
                             });
    };
    EXPECT_NEAR(sum_of_displacements(report), sum_of_displacements(report_of_other), 4 * 0.02);
    expect_solid(other, 0);
    EXPECT_NEAR(PMP::volume(other), PMP::volume(mesh), 1e-3 * std::abs(PMP::volume(mesh))) << kind;
  }
}

TEST(Handle_removal, RemovesAsManyHoweverTheMeshIsNumbered) {
  const Soup soup = soup_of(recipe("shell", 6000, 8));
  for(unsigned seed = 0; seed < 4; ++seed) {
    Mesh mesh = mesh_of(generators::permute_vertices(soup, seed));
    EXPECT_EQ(CGAL::remove_handles(mesh).genus_after, 0u);
  }
}

// A surface that crosses itself all over, with points that coincide: what can't be removed is
// refused.
TEST(Handle_removal, RefusesHandlesOfRandomSurfaces) {
  Mesh mesh = mesh_of(recipe("random", 10000, 100));
  const htl::Removal_report report = CGAL::remove_handles(mesh);
  EXPECT_EQ(report.removed.size() + report.refused.size(), 100u);
  EXPECT_EQ(report.genus_after, report.refused.size());
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
  EXPECT_EQ(euler_characteristic(mesh), 2 - 2 * static_cast<std::ptrdiff_t>(report.genus_after));
}

// Pairs of faces that cross each other, by exact predicates.
std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> crossings(const Mesh& mesh) {
  Exact_predicates_mesh copy;
  std::map<Exact_predicates_mesh::Face_index, Mesh::Face_index> original;
  std::map<Mesh::Face_index, Exact_predicates_mesh::Face_index> copies;
  CGAL::copy_face_graph(mesh, copy,
                        params::face_to_face_map(boost::make_assoc_property_map(copies)));
  for(const auto& [face, face_of_copy] : copies)
    original[face_of_copy] = face;
  std::vector<std::pair<Exact_predicates_mesh::Face_index, Exact_predicates_mesh::Face_index>>
      found;
  PMP::self_intersections(copy, std::back_inserter(found));
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
  for(const auto& [f, g] : found)
    pairs.emplace_back(original.at(f), original.at(g));
  return pairs;
}

// A ring and a copy of it that is shifted by parts of its box.
Mesh crossing_rings(std::size_t faces, const std::array<double, 3>& parts) {
  Mesh rings = mesh_of(recipe("torus", faces, 1)), other = rings;
  const CGAL::Bbox_3 box = PMP::bbox(rings);
  for(const auto v : other.vertices()) {
    const Mesh::Point p = rings.point(v);
    other.point(v) = {p.x() + parts[0] * (box.xmax() - box.xmin()),
                      p.y() + parts[1] * (box.ymax() - box.ymin()),
                      p.z() + parts[2] * (box.zmax() - box.zmin())};
  }
  rings += other;
  return rings;
}

// Most discs across one of the rings meet the other one. Some of them meet only what was crossed
// there before, in fewer faces.
TEST(Handle_removal, CrossesNoMoreThanWasCrossedUnlessForced) {
  std::size_t number = 0, number_forced = 0, number_refused = 0;
  for(std::size_t faces : {32, 50, 72, 98, 128, 200})
    for(const auto& parts : {std::array{0.02, 0., 0.03}, std::array{0., 0., 0.3},
                             std::array{0., 0., 0.01}, std::array{0.1, 0., 0.}})
      for(bool force : {false, true}) {
        Mesh mesh = crossing_rings(faces, parts);
        const auto before = crossings(mesh);
        std::set<Mesh::Face_index> crossed, divided;
        for(const auto& [f, g] : before)
          crossed.insert({f, g});
        const Mesh::Face_index end_of_old(static_cast<std::uint32_t>(mesh.number_of_faces()));
        std::map<Mesh::Face_index, Mesh::Face_index> parents;
        const auto is_first = [](const auto& pair) { return pair.handle().pair_index() == 0; };
        const htl::Removal_report report = CGAL::remove_handles(
            mesh, params::removal_options(
                      with(&Options::force, force),
                      params::face_to_face_map(boost::make_assoc_property_map(parents))
                          .filter(is_first)));
        ASSERT_EQ(report.removed.size() + report.refused.size(), 1u);
        EXPECT_EQ(euler_characteristic(mesh),
                  2 - 2 * static_cast<std::ptrdiff_t>(report.refused.size()));
        EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
        for(const auto& [part, parent] : parents)
          divided.insert(parent);
        const auto is_cap = [&](Mesh::Face_index f) {
          return f >= end_of_old && parents.count(f) == 0;
        };
        const auto is_gone = [&](Mesh::Face_index f) {
          return mesh.is_removed(f) && divided.count(f) == 0;
        };
        std::size_t number_gone = 0, number_of_caps = 0;
        for(const auto& [f, g] : before)
          number_gone += is_gone(f) || is_gone(g);
        for(const auto& [f, g] : crossings(mesh))
          if(is_cap(f) || is_cap(g)) {
            ++number_of_caps;
            for(const auto h : {f, g})
              EXPECT_TRUE(h >= end_of_old || crossed.count(h) == 1);
          }
        const std::size_t more = report.change().crossings;
        EXPECT_LE(more, number_of_caps);
        EXPECT_LE(number_of_caps, number_gone + more);
        EXPECT_TRUE(force || more == 0);
        number += force ? 0 : number_of_caps;
        number_forced += more;
        for(const htl::Refused_handle& refused : report.refused)
          number_refused += refused.reason.find("intersects itself there") != std::string::npos;
      }
  EXPECT_GT(number, 0u);
  EXPECT_GT(number_forced, 0u);
  EXPECT_GT(number_refused, 0u);
}

// An isosurface that touches itself in places of coincident vertices.
TEST(Handle_removal, RemovesNothingMoreOfItsResult) {
  const auto file = mesh_corpus() / "cases" / "mc_genus4_run_twice.ply";
  Mesh mesh;
  if(!CGAL::IO::read_PLY(file.string(), mesh))
    GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
  const std::size_t genus = CGAL::remove_handles(mesh).genus_after;
  mesh.collect_garbage();
  EXPECT_EQ(CGAL::remove_handles(mesh).genus_after, genus);
}

TEST(Handle_removal, StopsAtTheTargetSmallestFirst) {
  for(std::size_t target : {0, 3, 4, 7, 8}) {
    Mesh mesh = mesh_of(recipe("gyroid", 10000, 8));
    const Pairs pairs = find_loops(mesh);
    const htl::Removal_report report = CGAL::remove_handles(
        mesh, params::known_loops(pairs, wish(&Options::target_genus, target)));
    EXPECT_EQ(report.genus_after, target + report.refused.size());
    expect_solid(mesh, report.genus_after);
    std::set<std::size_t> chosen;
    for(const auto& handle : report.removed)
      chosen.insert(handle.pair);
    for(const auto& handle : report.refused)
      chosen.insert(handle.pair);
    const auto size = [&](std::size_t i) {
      return (std::min)(pairs[i].handle().length(), pairs[i].tunnel().length());
    };
    for(std::size_t i : chosen)
      for(std::size_t j = 0; j < pairs.size(); ++j)
        EXPECT_TRUE(chosen.count(j) != 0 || size(i) <= size(j));
  }
}

// What is planted is removed, and nothing else.
TEST(Handle_removal, TakesTheNoiseOffAScan) {
  for(unsigned seed : {0u, 1u}) {
    Recipe scan = recipe("scan", 60000, 2, seed);
    scan.request.bridges = 20;
    scan.request.tunnels = 12;
    Mesh mesh = mesh_of(scan);
    const htl::Removal_report report =
        CGAL::remove_handles(mesh, wish(&Options::maximal_length, 0.95));
    EXPECT_EQ(report.genus_before, 34u);
    EXPECT_EQ(report.removed.size(), 32u);
    EXPECT_EQ(report.genus_after, 2u);
    expect_solid(mesh, 2);
  }
}

TEST(Handle_removal, TouchesNothingElse) {
  Mesh mesh = mesh_of(recipe("gyroid", 10000, 8));
  auto colour = mesh.add_property_map<Mesh::Vertex_index, int>("v:colour", -1).first;
  for(const auto v : mesh.vertices())
    colour[v] = static_cast<int>(v);
  const auto before = faces_by_points(mesh);
  const std::size_t number_of_vertices = mesh.num_vertices();
  std::vector<Mesh::Face_index> faces;
  std::vector<Mesh::Vertex_index> vertices;
  CGAL::remove_handles(mesh, params::face_output_iterator(
                                 std::back_inserter(faces),
                                 params::vertex_output_iterator(std::back_inserter(vertices),
                                                                wish(&Options::target_genus, 6))));
  const std::set<Mesh::Face_index> new_faces(faces.begin(), faces.end());
  const std::set<Mesh::Vertex_index> new_vertices(vertices.begin(), vertices.end());
  EXPECT_FALSE(new_faces.empty());
  EXPECT_LT(new_faces.size(), before.size() / 4);
  for(const auto v : mesh.vertices())
    EXPECT_EQ(colour[v], new_vertices.count(v) != 0 ? -1 : static_cast<int>(v));
  for(const auto f : mesh.faces())
    EXPECT_TRUE(new_faces.count(f) != 0 || before.count(points_of(mesh, f)) != 0);
  for(const auto v : new_vertices)
    EXPECT_GE(static_cast<std::size_t>(v), number_of_vertices);
}

TEST(Handle_removal, SaysWhichHandleAFaceCloses) {
  Mesh mesh = mesh_of(recipe("gyroid", 10000, 8));
  constexpr std::size_t none = 1000;
  auto patch = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:patch", none).first;
  std::vector<Mesh::Face_index> faces;
  const double area_before = PMP::area(mesh);
  const htl::Removal_report report = CGAL::remove_handles(
      mesh, params::face_output_iterator(std::back_inserter(faces), params::face_patch_map(patch)));
  EXPECT_EQ(std::count(patch.begin(), patch.end(), none) + std::ptrdiff_t(faces.size()),
            patch.end() - patch.begin());
  std::vector<double> area(report.removed.size(), 0.);
  for(const auto f : faces) {
    ASSERT_LT(patch[f], report.removed.size());
    area[patch[f]] += PMP::face_area(f, mesh);
  }
  // Those that close it, and what is left of the faces beside them.
  for(std::size_t i = 0; i < area.size(); ++i) {
    const std::size_t first = report.removed[i].patch;
    ASSERT_LE(first, i);
    EXPECT_EQ(report.removed[first].patch, first);
    EXPECT_EQ(area[i] > 0., first == i) << i;
  }
  EXPECT_GE(std::accumulate(area.begin(), area.end(), 0.), 0.9 * report.change().cap_area);
  EXPECT_LE(PMP::area(mesh) - area_before, report.change().cap_area);
}

// Parts of a face lie in it, and have no more area than it had.
TEST(Handle_removal, SaysOfWhichFaceAFaceIsAPart) {
  for(const char* kind : {"gyroid", "plates", "foam"}) {
    Mesh mesh = mesh_of(recipe(kind, 10000, 5));
    const Mesh before = mesh;
    std::map<Mesh::Face_index, Mesh::Face_index> parents;
    std::vector<Mesh::Face_index> faces;
    CGAL::remove_handles(mesh,
                         params::face_output_iterator(
                             std::back_inserter(faces),
                             params::face_to_face_map(boost::make_assoc_property_map(parents))));
    const std::set<Mesh::Face_index> new_faces(faces.begin(), faces.end());
    std::map<Mesh::Face_index, double> area; // of the parts of a face
    for(const auto& [part, parent] : parents) {
      EXPECT_EQ(new_faces.count(part), 1u);
      ASSERT_LT(parent.idx(), before.number_of_faces());
      EXPECT_TRUE(mesh.is_removed(parent));
      area[parent] += PMP::face_area(part, mesh);
      const auto corners = points_of(before, parent);
      const CGAL::Kernel_traits<Mesh::Point>::Kernel::Plane_3 plane(corners[0], corners[1],
                                                                    corners[2]);
      for(const Mesh::Point& p : points_of(mesh, part))
        EXPECT_LT(CGAL::squared_distance(plane, p), 1e-24);
    }
    for(const auto& [parent, area_of_parts] : area)
      EXPECT_LT(area_of_parts, (1. + 1e-9) * PMP::face_area(parent, before));
    EXPECT_EQ(parents.empty(), std::string(kind) == "plates"); // where bores are closed flush
  }
}

TEST(Handle_removal, FindsTheLoopsThatAreLeft) {
  for(const std::size_t genus : {0, 3, 8}) {
    Mesh mesh = mesh_of(recipe("gyroid", 10000, 8));
    std::vector<CGAL::Handle_tunnel_pair<Mesh>> pairs;
    CGAL::remove_handles(
        mesh, wish(&Options::target_genus, genus).output_iterator(std::back_inserter(pairs)));
    EXPECT_EQ(pairs.size(), genus);
    EXPECT_TRUE(CGAL::certify_handle_tunnel_loops(mesh, pairs));
  }
}

// Loops may be of the surface and still no basis.
TEST(Handle_removal, RemovesAHandleOnce) {
  for(const char* kind : {"torus", "gyroid"}) {
    Mesh mesh = mesh_of(recipe(kind, 4000, std::string(kind) == "torus" ? 1 : 3));
    Pairs pairs;
    CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
    const std::size_t genus = pairs.size();
    Pairs twice = pairs;
    twice.insert(twice.end(), pairs.begin(), pairs.end());
    const htl::Removal_report report = CGAL::remove_handles(mesh, params::known_loops(twice));
    EXPECT_EQ(report.removed.size(), genus);
    EXPECT_EQ(report.refused.size(), genus);
    expect_solid(mesh, 0);
  }
}

TEST(Handle_removal, ChangesNothingInADryRun) {
  Mesh mesh = mesh_of(recipe("multi-torus", 3000, 3));
  const auto before = faces_by_points(mesh);
  const htl::Removal_report report = CGAL::remove_handles(mesh, params::dry_run(true));
  EXPECT_EQ(report.genus_after, 0u);
  EXPECT_EQ(report.removed.size(), 3u);
  EXPECT_EQ(faces_by_points(mesh), before);
}

TEST(Handle_removal, TakesThePairsOfAFilterOrABox) {
  Mesh mesh = mesh_of(recipe("multi-torus", 3000, 3));
  const Pairs pairs = find_loops(mesh);
  Mesh copy = mesh;
  const auto is_second = [](const auto& pair) { return pair.handle().pair_index() == 1; };
  const htl::Removal_report by_filter =
      CGAL::remove_handles(copy, params::known_loops(pairs).filter(is_second));
  ASSERT_EQ(by_filter.removed.size(), 1u);
  EXPECT_EQ(by_filter.removed.front().pair, 1u);
  CGAL::Bbox_3 box;
  for(const auto& p : pairs[2].handle().points())
    box += p.bbox();
  Options options;
  options.box = box;
  options.method = htl::Removal_method::CUT;
  const htl::Removal_report in_box =
      CGAL::remove_handles(mesh, params::removal_options(options, params::known_loops(pairs)));
  ASSERT_EQ(in_box.removed.size(), 1u);
  EXPECT_EQ(in_box.removed.front().pair, 2u);
}

TEST(Handle_removal, IsTheSameWithThreads) {
#ifdef CGAL_LINKED_WITH_TBB
  const Mesh mesh = mesh_of(recipe("gyroid", 10000, 8));
  Mesh one = mesh, many = mesh;
  CGAL::remove_handles(one);
  CGAL::remove_handles<CGAL::Parallel_tag>(many);
  EXPECT_EQ(faces_by_points(one), faces_by_points(many));
#endif
}

TEST(Handle_removal, TakesOtherMeshesAndKernels) {
  const Soup soup = soup_of(recipe("torus", 600, 1));
  auto polyhedron = mesh_of<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>(soup);
  EXPECT_EQ(CGAL::remove_handles(polyhedron).genus_after, 0u);
  EXPECT_EQ(euler_characteristic(polyhedron), 2);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(polyhedron));
  auto exact =
      mesh_of<CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>(soup);
  EXPECT_EQ(CGAL::remove_handles(exact).genus_after, 0u);
  EXPECT_EQ(euler_characteristic(exact), 2);
}

// Seven vertices, each joined to each other: no strip of whole faces is an annulus.
TEST(Handle_removal, SubdividesWhatIsTooCoarse) {
  Mesh mesh;
  const double points[7][3] = {{3, -3, 0},  {-3, 3, 0}, {-3, -3, 1}, {3, 3, 1},
                               {-1, -2, 3}, {1, 2, 3},  {0, 0, 15}};
  std::vector<Mesh::Vertex_index> v;
  for(const auto& p : points)
    v.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  const int triangles[14][3] = {{0, 1, 2}, {0, 2, 4}, {0, 4, 5}, {0, 5, 3}, {0, 3, 6},
                                {0, 6, 1}, {1, 3, 2}, {1, 4, 3}, {1, 5, 4}, {1, 6, 5},
                                {2, 3, 5}, {2, 5, 6}, {2, 6, 4}, {3, 4, 6}};
  for(const auto& t : triangles)
    ASSERT_NE(mesh.add_face(v[t[0]], v[t[1]], v[t[2]]), Mesh::null_face());
  const htl::Removal_report report = CGAL::remove_handles(mesh);
  EXPECT_EQ(report.genus_after + report.removed.size(), 1u);
  EXPECT_EQ(euler_characteristic(mesh), report.removed.empty() ? 0 : 2);
}

TEST(Handle_removal, CutsAKnottedTube) {
  Mesh mesh = mesh_of(recipe("knot", 4000, 1));
  Mesh copy = mesh;
  const htl::Removal_report filled =
      CGAL::remove_handles(copy, wish(&Options::method, htl::Removal_method::FILL));
  ASSERT_EQ(filled.refused.size(), 1u);
  EXPECT_EQ(filled.refused.front().reason.substr(0, 6), "fill: ");
  EXPECT_EQ(faces_by_points(copy), faces_by_points(mesh));
  const htl::Removal_report cut = CGAL::remove_handles(mesh);
  ASSERT_EQ(cut.removed.size(), 1u);
  EXPECT_EQ(cut.removed.front().by, htl::Removal_way::CUT);
  expect_solid(mesh, 0);
}

class Necks_removal : public testing::TestWithParam<const char*>
{};

TEST_P(Necks_removal, LetsShellsComeApart) {
  for(std::size_t necks : {1, 2, 5}) {
    Recipe twins = recipe(GetParam(), 60000, 0);
    twins.request.necks = necks;
    Mesh mesh = mesh_of(twins);
    const htl::Removal_report report =
        CGAL::remove_handles(mesh, wish(&Options::maximal_neck_length, 0.5));
    EXPECT_EQ(report.genus_before, necks - 1);
    EXPECT_EQ(report.genus_after, 0u);
    EXPECT_EQ(report.removed.size(), necks - 1);
    ASSERT_EQ(report.removed_necks.size(), 1u);
    EXPECT_EQ(report.components_after, 2u);
    expect_solid(mesh, 0, 2);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Necks_removal, testing::Values("twins", "hollow"));

htl::Removal_report remove_channels(Mesh& mesh, double maximal_length) {
  Options options = with(&Options::maximal_neck_length, maximal_length);
  options.only_channels = true;
  return CGAL::remove_handles(mesh, params::removal_options(options));
}

// Walls of genus 2, whose holes are shorter around than channels may be.
TEST(Channels_removal, TakesInnerWallsOffAndLeavesOtherHandles) {
  for(const std::size_t channels : {1, 2, 4}) {
    if(are_few_cases_tried() && channels == 2)
      continue;
    Recipe hollow = recipe("hollow", 160000, 2, unsigned(channels));
    hollow.request.necks = channels;
    Mesh mesh = mesh_of(hollow);
    const std::ptrdiff_t before = euler_characteristic(mesh);
    const htl::Removal_report report = remove_channels(mesh, 100.);
    EXPECT_EQ(report.removed.size(), channels - 1);
    EXPECT_EQ(report.removed_necks.size(), 1u);
    EXPECT_EQ(report.components_after, report.components_before + 1);
    EXPECT_EQ(euler_characteristic(mesh), before + 2 * std::ptrdiff_t(channels));
    for(const htl::Removed_handle& channel : report.removed)
      EXPECT_EQ(channel.by, htl::Removal_way::FILL);
  }
}

TEST(Channels_removal, LeavesWhatBoundsFromOutsideOnBothSides) {
  Recipe twins = recipe("twins", 60000, 0);
  twins.request.necks = 3;
  Mesh mesh = mesh_of(twins);
  const auto before = faces_by_points(mesh);
  const htl::Removal_report report = remove_channels(mesh, 0.5);
  EXPECT_TRUE(report.removed.empty());
  EXPECT_TRUE(report.removed_necks.empty());
  EXPECT_EQ(faces_by_points(mesh), before);
}

// A hollow in a ball with a bulb in it, on a stem: its walls face each other like those of a
// channel, but along the loop around the stem they would be cut apart, and the bulb would float.
TEST(Channels_removal, LeavesBridgesInTheHollow) {
  Recipe hollow = recipe("hollow", 60000, 0);
  hollow.request.necks = 1;
  Soup ball = soup_of(recipe("sphere", 5120, 0));
  for(auto& p : ball.points)
    for(double& x : p)
      x *= 4.;
  Mesh mesh = mesh_of(generators::joined({ball, generators::reversed(soup_of(hollow))}));
  EXPECT_EQ(remove_channels(mesh, 100.).removed_necks.size(), 0u);
  EXPECT_EQ(number_of_components(mesh), 2u);
}

// One of them is too long: then the wall stays, and all others with it.
TEST(Channels_removal, TakesAllOrNone) {
  Recipe hollow = recipe("hollow", 60000, 0);
  hollow.request.necks = 3;
  Mesh mesh = mesh_of(hollow), copy = mesh;
  const auto before = faces_by_points(mesh);
  const htl::Removal_report all = remove_channels(copy, 100.);
  ASSERT_EQ(all.removed.size(), 2u);
  double longest = 0.;
  for(const htl::Removed_handle& channel : all.removed)
    longest = (std::max)(longest, channel.length);
  EXPECT_EQ(remove_channels(mesh, longest).removed.size(), 0u);
  EXPECT_EQ(faces_by_points(mesh), before);
}

TEST(Channels_removal, RefusesWhatMakesNoSense) {
  Mesh mesh = mesh_of(recipe("torus", 600, 1));
  Options options = with(&Options::maximal_neck_length, 0.);
  options.only_channels = true;
  expect_refusal(mesh, params::removal_options(options), "requires the maximal neck length");
  options.maximal_neck_length = 1.;
  options.method = htl::Removal_method::CUT;
  expect_refusal(mesh, params::removal_options(options), "filled, not cut");
}

TEST(Handle_removal, RefusesWhatMakesNoSense) {
  Mesh mesh = mesh_of(recipe("torus", 600, 1));
  expect_refusal(mesh, wish(&Options::target_genus, 2), "target genus is 2");
  expect_refusal(mesh, wish(&Options::box, CGAL::Bbox_3(9, 9, 9, 10, 10, 10)),
                 "the box contains no loop");
  expect_refusal(mesh, wish(&Options::maximal_length, -1.), "not positive");
  expect_refusal(mesh, wish(&Options::minimal_piece_share, 0.7), "share");
  Pairs pairs = find_loops(mesh);
  auto steps = pairs.front().handle().steps();
  steps.erase(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  pairs = {{{steps, {}, 1., CGAL::Loop_type::HANDLE, 0}, pairs.front().tunnel()}};
  expect_refusal(mesh, params::known_loops(pairs), "belong to another mesh");
  CGAL::Euler::join_face(halfedge(*faces(mesh).begin(), mesh), mesh);
  EXPECT_THROW(CGAL::remove_handles(mesh), htl::Invalid_mesh_exception);
}

TEST(Handle_removal, StopsWhenAsked) {
  Mesh mesh = mesh_of(recipe("gyroid", 10000, 8));
  const auto before = faces_by_points(mesh);
  for(double end : {0.1, 0.69, 0.75, 0.95}) {
    bool has_stopped = false;
    const std::function<bool(double)> callback = [&](double done) {
      EXPECT_FALSE(has_stopped);
      has_stopped = done >= end;
      return !has_stopped;
    };
    EXPECT_THROW(CGAL::remove_handles(mesh, params::callback(callback)),
                 htl::Interrupted_exception);
    EXPECT_EQ(faces_by_points(mesh), before);
  }
}

} // namespace test_remove_handles
