#include "Bored_parts.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"
#include "with.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/remove_handles.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_bores {

namespace htl = CGAL::Handle_tunnel_loops;
namespace PMP = CGAL::Polygon_mesh_processing;
using Options = htl::Removal_options;
using Plane = CGAL::Simple_cartesian<double>::Plane_3;

std::ptrdiff_t genus_of(const Mesh& mesh) {
  const auto number = [](auto n) { return static_cast<std::ptrdiff_t>(n); };
  return 1 - (number(mesh.number_of_vertices()) - number(mesh.number_of_edges()) +
              number(mesh.number_of_faces())) /
                 2;
}

std::vector<Plane> planes_of(const Mesh& mesh) {
  std::vector<Plane> planes;
  for(const auto f : mesh.faces()) {
    std::vector<Mesh::Point> p;
    for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      p.push_back(mesh.point(v));
    planes.emplace_back(p[0], p[1], p[2]);
  }
  return planes;
}

std::size_t number_of_faces_off(const std::vector<Plane>& planes, const Mesh& mesh) {
  constexpr double rounding = 1e-12; // of parts of size 1
  const auto faces = mesh.faces();
  return static_cast<std::size_t>(std::count_if(faces.begin(), faces.end(), [&](const auto f) {
    const auto corners = vertices_around_face(mesh.halfedge(f), mesh);
    return std::none_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return std::all_of(corners.begin(), corners.end(), [&](const auto v) {
        return CGAL::squared_distance(plane, mesh.point(v)) < rounding * rounding;
      });
    });
  }));
}

std::size_t number_of_points_off(const Mesh& original, const Mesh& mesh) {
  const std::set<Mesh::Point> known(original.points().begin(), original.points().end());
  const auto vertices = mesh.vertices();
  return static_cast<std::size_t>(
      std::count_if(vertices.begin(), vertices.end(),
                    [&](const auto v) { return known.count(mesh.point(v)) == 0; }));
}

class Bores : public testing::TestWithParam<unsigned>
{};

// The part is as if they had never been.
TEST_P(Bores, AreRemovedWithoutATrace) {
  const Bored_part part = Bored_part_maker(GetParam())();
  SCOPED_TRACE(part.kind);
  Mesh mesh = part.mesh;
  const htl::Removal_report report = CGAL::remove_handles(mesh);
  EXPECT_EQ(report.removed.size(), static_cast<std::size_t>(genus_of(part.mesh)));
  for(const htl::Refused_handle& refused : report.refused)
    ADD_FAILURE() << refused.reason;
  for(const htl::Removed_handle& removed : report.removed)
    EXPECT_EQ(removed.by, htl::Removal_way::FILL) << removed.length;
  EXPECT_EQ(genus_of(mesh), 0);
  const double volume = PMP::volume(part.blank);
  EXPECT_NEAR(PMP::volume(mesh), volume, 1e-9 * volume);
  EXPECT_EQ(number_of_faces_off(planes_of(part.blank), mesh), 0u);
  EXPECT_EQ(number_of_points_off(part.mesh, mesh), 0u);
}

class Bores_of_diameters : public testing::TestWithParam<unsigned>
{};

// As many as have a diameter in the range; slots and square holes have none.
TEST_P(Bores_of_diameters, AreChosen) {
  const Bored_part part = Bored_part_maker(GetParam())();
  for(const char* other : {"meet", "oblique", "keyways"})
    if(part.kind.find(other) != std::string::npos)
      return; // they are narrower where they meet, not as wide as they were made, or not round
  SCOPED_TRACE(part.kind);
  std::vector<double> diameters = part.diameters;
  std::sort(diameters.begin(), diameters.end());
  const std::size_t n = diameters.size();
  const double below = n == 0 ? 1. : 0.99 * diameters[n / 2],
               above = n == 0 ? 1. : 1.01 * below / 0.99;
  const auto number_in = [&](double least, double most) {
    return static_cast<std::size_t>(std::count_if(
        diameters.begin(), diameters.end(), [&](double d) { return least <= d && d <= most; }));
  };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for(const auto& [least, most] : {std::array{0., infinity}, std::array{below, infinity},
                                   std::array{0., below}, std::array{below, above}})
  {
    Options options = with(&Options::minimal_bore_diameter, least);
    options.maximal_bore_diameter = most;
    Mesh mesh = part.mesh;
    const htl::Removal_report report =
        CGAL::remove_handles(mesh, CGAL::parameters::removal_options(options));
    EXPECT_EQ(report.removed.size(), number_in(least, most)) << least << ' ' << most;
    EXPECT_TRUE(report.refused.empty());
    EXPECT_EQ(number_of_points_off(part.mesh, mesh), 0u);
    for(const htl::Removed_handle& removed : report.removed)
      EXPECT_EQ(removed.by, htl::Removal_way::FILL);
  }
}

INSTANTIATE_TEST_SUITE_P(Generated,
                         Bores,
                         testing::Range(0u, 200u, are_few_cases_tried() ? 4u : 1u));
INSTANTIATE_TEST_SUITE_P(Generated,
                         Bores_of_diameters,
                         testing::Range(0u, 200u, are_few_cases_tried() ? 15u : 5u));

TEST(Bores_by_diameter, ThatMakeNoSenseAreRefused) {
  Mesh mesh = Bored_part_maker(0)().mesh;
  const auto refuses = [&](const Options& options) {
    EXPECT_THROW(CGAL::remove_handles(mesh, CGAL::parameters::removal_options(options)),
                 std::invalid_argument);
  };
  refuses(with(&Options::minimal_bore_diameter, -1.));
  refuses(with(&Options::maximal_bore_diameter, -1.));
  refuses(with(&Options::maximal_bore_diameter, 1., with(&Options::minimal_bore_diameter, 2.)));
  refuses(
      with(&Options::method, htl::Removal_method::CUT, with(&Options::minimal_bore_diameter, 0.)));
}

// A ring has a hole and no bore.
TEST(Bores_by_diameter, AreNoHandlesOfOtherKinds) {
  Recipe recipe;
  recipe.kind = "multi-torus";
  recipe.request.faces = 2000;
  recipe.request.genus = 3;
  Mesh mesh = mesh_of(recipe);
  const htl::Removal_report report = CGAL::remove_handles(
      mesh, CGAL::parameters::removal_options(with(&Options::minimal_bore_diameter, 0.)));
  EXPECT_TRUE(report.removed.empty());
  EXPECT_EQ(report.genus_after, 3u);
}

} // namespace test_bores
