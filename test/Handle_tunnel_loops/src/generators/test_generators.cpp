#include "Meshes_of_soups.h"
#include "Number_of_cases.h"
#include "generators/Shape.h"
#include "generators/generators.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <boost/pending/disjoint_sets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_generators {

namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Request;
using generators::Soup;
using Index = std::uint32_t;

const generators::Kind& kind(const std::string& name) {
  for(const generators::Kind& k : generators::kinds())
    if(name == k.name)
      return k;
  throw std::logic_error("no kind " + name);
}

// One shape stands for all, unless all cases are tried: the same function makes them.
std::vector<generators::Kind> kinds_to_try() {
  std::vector<generators::Kind> kinds = generators::kinds();
  const auto shapes = generators::kinds_of_shapes();
  if(are_few_cases_tried())
    kinds.erase(std::remove_if(kinds.begin(), kinds.end(),
                               [&](const generators::Kind& k) {
                                 return std::any_of(shapes.begin() + 1, shapes.end(),
                                                    [&](const generators::Kind& s) {
                                                      return std::strcmp(s.name, k.name) == 0;
                                                    });
                               }),
                kinds.end());
  return kinds;
}

using Directed_edges = std::map<std::pair<Index, Index>, Index>; // to the third vertex

Directed_edges directed_edges(const Soup& soup) {
  Directed_edges edges;
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i) {
      const bool is_new = edges.emplace(std::pair(t[i], t[(i + 1) % 3]), t[(i + 2) % 3]).second;
      EXPECT_TRUE(is_new) << "edge " << t[i] << ' ' << t[(i + 1) % 3] << " occurs twice";
    }
  return edges;
}

/// Each edge in two triangles that traverse it in opposite directions, and the edges all different.
void expect_closed_and_oriented(const Directed_edges& edges) {
  for(const auto& [edge, third] : edges) {
    EXPECT_NE(edge.first, edge.second);
    EXPECT_TRUE(edges.count({edge.second, edge.first}) != 0)
        << "edge " << edge.first << ' ' << edge.second << " is on the boundary";
  }
}

/// The triangles at each vertex form one fan, and no vertex is without.
void expect_one_fan_per_vertex(const Soup& soup, const Directed_edges& edges) {
  std::vector<Index> degree(soup.points.size(), 0), some_neighbour(soup.points.size());
  for(const auto& [edge, third] : edges) {
    ++degree[edge.first];
    some_neighbour[edge.first] = edge.second;
  }
  for(Index v = 0; v < soup.points.size(); ++v) {
    ASSERT_GT(degree[v], 0u) << "vertex " << v << " is isolated";
    Index steps = 0, neighbour = some_neighbour[v];
    do {
      neighbour = edges.at({v, neighbour});
      ++steps;
    } while(neighbour != some_neighbour[v] && steps <= degree[v]);
    EXPECT_EQ(steps, degree[v]) << "vertex " << v << " has more than one fan";
  }
}

void expect_closed_surface(const Soup& soup, std::size_t genus, std::size_t components = 1) {
  const Directed_edges edges = directed_edges(soup);
  expect_closed_and_oriented(edges);
  if(testing::Test::HasFailure())
    return;
  expect_one_fan_per_vertex(soup, edges);
  EXPECT_EQ(generators::number_of_components(soup), components);
  EXPECT_EQ(generators::genus(soup), genus);
  for(const auto& point : soup.points)
    for(double x : point)
      ASSERT_TRUE(std::isfinite(x));
}

double signed_volume(const Soup& soup) {
  double volume = 0.;
  for(const auto& [a, b, c] : soup.triangles) {
    const auto &p = soup.points[a], &q = soup.points[b], &r = soup.points[c];
    volume += p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
              p[2] * (q[0] * r[1] - q[1] * r[0]);
  }
  return volume / 6.;
}

bool is_embedded(const Soup& soup) {
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> mesh;
  std::vector<decltype(mesh)::Vertex_index> vertices;
  for(const auto& [x, y, z] : soup.points)
    vertices.push_back(mesh.add_vertex({x, y, z}));
  for(const auto& [a, b, c] : soup.triangles)
    mesh.add_face(vertices[a], vertices[b], vertices[c]);
  return !CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
}

struct Case
{
  const char* kind;
  Request request;
};

std::ostream& operator<<(std::ostream& os, const Case& c) {
  return os << c.kind << " faces " << c.request.faces << " genus " << c.request.genus << " seed "
            << c.request.seed << " parts " << c.request.parts << " torus knot " << c.request.p
            << ' ' << c.request.q;
}

std::string name_of_case(const testing::TestParamInfo<Case>& info) {
  std::string name = info.param.kind;
  name += "_f" + std::to_string(info.param.request.faces) + "_g" +
          std::to_string(info.param.request.genus) + "_s" +
          std::to_string(info.param.request.seed) + "_n" +
          std::to_string(info.param.request.parts) + "_p" + std::to_string(info.param.request.p) +
          "_q" + std::to_string(info.param.request.q);
  for(char& c : name)
    c = c == '-' ? '_' : c;
  return name;
}

std::size_t components_of(const Case& c) {
  const std::string name = c.kind;
  if(name == "chain" || name == "torus-link")
    return c.request.genus;
  if(name == "shell" || name == "interlaced")
    return 2;
  return c.request.parts;
}

class Generated_mesh : public testing::TestWithParam<Case>
{};

TEST_P(Generated_mesh, IsAsAskedFor) {
  const auto& [name, request] = GetParam();
  const Soup soup = kind(name).make(request);
  expect_closed_surface(soup, request.genus, components_of(GetParam()));
  EXPECT_NEAR(static_cast<double>(soup.triangles.size()) / request.faces, 1., 0.2);
  if(std::strcmp(name, "random") != 0) {
    EXPECT_GT(signed_volume(soup), 0.);
    EXPECT_TRUE(is_embedded(soup));
  }
}

INSTANTIATE_TEST_SUITE_P(Fixed_genus,
                         Generated_mesh,
                         testing::Values(Case{"sphere", {4, 0, 0}},
                                         Case{"sphere", {100, 0, 0}},
                                         Case{"sphere", {20000, 0, 0}},
                                         Case{"torus", {18, 1, 0}},
                                         Case{"torus", {1000, 1, 0}},
                                         Case{"torus", {20001, 1, 0}},
                                         Case{"knot", {150, 1, 0}},
                                         Case{"knot", {20000, 1, 0}},
                                         Case{"hubs", {120, 3, 0}},
                                         Case{"hubs", {4000, 20, 0}},
                                         Case{"fan", {6, 0, 0}},
                                         Case{"fan", {2000, 0, 1}},
                                         Case{"lattice", {5400, 20, 8}},
                                         Case{"torus-link", {500, 1, 0}}),
                         name_of_case);

std::vector<Case> cases_of_any_genus() {
  std::vector<Case> cases;
  for(const char* name : {"multi-torus", "lattice", "gyroid", "sponge", "random"})
    for(std::size_t genus : {0, 1, 2, 3, 5, 8, 13, 30})
      for(std::size_t faces : {800 + 400 * genus, std::size_t(15000)})
        for(unsigned seed : {0u, 1u})
          cases.push_back({name, {faces, genus, seed}});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Any_genus,
                         Generated_mesh,
                         testing::ValuesIn(enough_of(cases_of_any_genus())),
                         name_of_case);

std::vector<Case> cases_of_parts() {
  std::vector<Case> cases;
  for(const char* name : {"plates", "bars"})
    for(std::size_t genus : {1, 2, 5, 30})
      for(std::size_t parts : {1, 3, 5})
        for(std::size_t faces : {16 * genus + 12 * parts, std::size_t(3000)})
          for(unsigned seed : {0u, 1u, 2u})
            if(parts <= genus)
              cases.push_back({name, {faces, genus, seed, parts}});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Parts,
                         Generated_mesh,
                         testing::ValuesIn(enough_of(cases_of_parts())),
                         name_of_case);

std::vector<Case> cases_of_tubes() {
  std::vector<Case> cases;
  for(std::size_t genus : {1, 2, 3, 7})
    for(unsigned seed : {0u, 1u, 2u, 3u})
      for(std::size_t faces : {72 * genus, std::size_t(3000)})
        cases.push_back({"chain", {faces, genus, seed}});
  const std::vector<std::pair<std::size_t, std::size_t>> knots = {{1, 1}, {2, 1}, {1, 5}, {2, 3},
                                                                  {3, 2}, {5, 2}, {3, 7}};
  for(const auto& [p, q] : knots)
    for(std::size_t genus : {1, 2, 5}) {
      cases.push_back({"torus-link", {5000 * genus, genus, 0, 1, p, q}});
      cases.push_back({"torus-link", {15000 * genus, genus, 0, 1, p, q}});
      cases.push_back({"ladder", {75000, genus, 0, 1, p, q}});
    }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Tubes,
                         Generated_mesh,
                         testing::ValuesIn(enough_of(cases_of_tubes())),
                         name_of_case);

std::vector<Case> cases_of_grids() {
  std::vector<Case> cases;
  for(const char* name : {"shell", "foam", "interlaced"})
    for(std::size_t genus : {0, 1, 2, 3, 5, 8, 13, 30})
      for(std::size_t faces : {1000 + 600 * genus, std::size_t(20000)})
        for(unsigned seed : {0u, 1u})
          cases.push_back({name, {faces, genus, seed}});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Grids,
                         Generated_mesh,
                         testing::ValuesIn(enough_of(cases_of_grids())),
                         name_of_case);

INSTANTIATE_TEST_SUITE_P(High_genus,
                         Generated_mesh,
                         testing::Values(Case{"multi-torus", {150000, 500, 0}},
                                         Case{"lattice", {150000, 500, 0}},
                                         Case{"gyroid", {200000, 500, 0}},
                                         Case{"sponge", {40000, 1000, 0}},
                                         Case{"plates", {10000, 500, 0, 7}},
                                         Case{"bars", {10000, 500, 0, 7}},
                                         Case{"ladder", {150000, 150, 0}},
                                         Case{"shell", {200000, 300, 0}},
                                         Case{"foam", {200000, 300, 0}},
                                         Case{"interlaced", {150000, 300, 0}},
                                         Case{"random", {20000, 1000, 0}}),
                         name_of_case);

TEST(Waves, AreEmbedded) {
  for(std::size_t frequency : {1, 2, 4})
    for(unsigned seed = 0; seed < 5; ++seed) {
      Request request = {1000 + 400 * frequency * frequency * frequency, 0, seed};
      request.frequency = frequency;
      const Soup soup = kind("waves").make(request);
      SCOPED_TRACE(testing::PrintToString(Case{"waves", request}));
      expect_closed_surface(soup, generators::genus(soup), generators::number_of_components(soup));
      EXPECT_NEAR(static_cast<double>(soup.triangles.size()) / request.faces, 1., 0.2);
      EXPECT_GT(signed_volume(soup), 0.);
      EXPECT_TRUE(is_embedded(soup));
    }
}

Request scan_request(std::size_t faces, std::size_t genus, std::size_t planted, unsigned seed) {
  Request request = {faces, genus, seed};
  request.bridges = planted;
  request.tunnels = planted / 2;
  return request;
}

TEST(Scan, HasAHandleForEachBridgeAndTunnel) {
  for(const std::size_t genus : {0, 1, 4})
    for(const std::size_t planted : {0, 1, 24})
      for(unsigned seed = 0; seed < (are_few_cases_tried() ? 1 : 3); ++seed) {
        const Request request = scan_request(50000, genus, planted, seed);
        SCOPED_TRACE(testing::PrintToString(Case{"scan", request}));
        const Soup soup = kind("scan").make(request);
        expect_closed_surface(soup, genus + planted + planted / 2);
        EXPECT_NEAR(static_cast<double>(soup.triangles.size()) / request.faces, 1., 0.1);
        EXPECT_GT(signed_volume(soup), 0.);
        EXPECT_TRUE(is_embedded(soup));
      }
}

TEST(Scan, IsEmbeddedWhereItIsCrowded) {
  const Soup soup = kind("scan").make(scan_request(260000, 2, 250, 0));
  expect_closed_surface(soup, 2 + 375);
  EXPECT_TRUE(is_embedded(soup));
  EXPECT_THROW(kind("scan").make(scan_request(200000, 2, 2000, 0)), std::invalid_argument);
}

TEST(Scan, GrowsWithTheNumberOfItsHandles) {
  const Soup soup = kind("scan").make(scan_request(120000, 14, 20, 0));
  expect_closed_surface(soup, 14 + 30);
  EXPECT_TRUE(is_embedded(soup));
}

// How many pairs have a loop shorter than a bound; the loops of the others are longer than another.
std::size_t number_of_short_pairs(const Soup& soup, double most, double least) {
  std::size_t count = 0;
  for(const auto& pair : find_loops(mesh_of(soup))) {
    const double shorter = (std::min)(pair.handle().length(), pair.tunnel().length());
    EXPECT_TRUE(shorter < most || shorter > least) << shorter;
    count += shorter < most;
  }
  return count;
}

TEST(Scan, HasLoopsAsShortAndAsLongAsItSays) {
  for(unsigned seed = 0; seed < 3; ++seed)
    EXPECT_EQ(number_of_short_pairs(kind("scan").make(scan_request(50000, 3, 20, seed)), 0.9, 1.),
              30u);
}

TEST(Necks, HaveLoopsAsShortAndAsLongAsTheySay) {
  Request request = {60000, 2, 0};
  request.necks = 8;
  EXPECT_EQ(number_of_short_pairs(kind("twins").make(request), 0.5, 1.), 7u);
  EXPECT_EQ(number_of_short_pairs(kind("hollow").make(request), 0.5, 0.8), 7u);
}

TEST(Necks, JoinTwoBodies) {
  for(const char* name : {"twins", "hollow"})
    for(const std::size_t genus : {0, 1, 3})
      for(const std::size_t necks : {1, 2, 40}) {
        if(are_few_cases_tried() && (genus == 1 || necks == 2))
          continue;
        Request request = {60000, genus, static_cast<unsigned>(necks)};
        request.necks = necks;
        SCOPED_TRACE(testing::PrintToString(Case{name, request}));
        const Soup soup = kind(name).make(request);
        expect_closed_surface(soup, 2 * genus + necks - 1);
        EXPECT_NEAR(static_cast<double>(soup.triangles.size()) / request.faces, 1., 0.1);
        EXPECT_GT(signed_volume(soup), 0.);
        EXPECT_TRUE(is_embedded(soup));
      }
}

TEST(Necks, NeedRoom) {
  Request request = {60000, 0, 0};
  request.necks = 0;
  EXPECT_THROW(kind("hollow").make(request), std::invalid_argument);
  request.necks = 10000;
  EXPECT_THROW(kind("hollow").make(request), std::invalid_argument);
}

TEST(Random_generator, MakesSurfacesOfAllSmallSizes) {
  for(std::size_t genus = 0; genus <= 6; ++genus)
    for(std::size_t faces = genus == 0 ? 4 : 2 + 12 * genus; faces < 120; ++faces) {
      const Request request = {faces, genus, static_cast<unsigned>(faces)};
      const Soup soup = kind("random").make(request);
      const Case c = {"random", request};
      SCOPED_TRACE(testing::PrintToString(c));
      EXPECT_EQ(soup.triangles.size(), faces - faces % 2);
      expect_closed_surface(soup, genus);
    }
}

TEST(Generators, NamesAreDistinct) {
  std::set<std::string> names;
  for(const generators::Kind& k : generators::kinds())
    EXPECT_TRUE(names.insert(k.name).second) << k.name;
}

TEST(Generators, RefuseWhatTheyCannotMake) {
  EXPECT_THROW(kind("sphere").make({1000, 1, 0}), std::invalid_argument);
  EXPECT_THROW(kind("torus").make({1000, 0, 0}), std::invalid_argument);
  EXPECT_THROW(kind("knot").make({1000, 2, 0}), std::invalid_argument);
  EXPECT_THROW(kind("chain").make({1000, 0, 0}), std::invalid_argument);
  EXPECT_THROW(kind("plates").make({1000, 2, 0, 3}), std::invalid_argument);
  EXPECT_THROW(kind("bars").make({1000, 2, 0, 0}), std::invalid_argument);
  EXPECT_THROW(kind("torus-link").make({100000, 1, 0, 1, 2, 4}), std::invalid_argument);
  EXPECT_THROW(kind("ladder").make({100000, 1, 0, 1, 0, 1}), std::invalid_argument);
  for(const generators::Kind& k : kinds_to_try()) {
    const std::size_t genus = k.default_genus;
    EXPECT_THROW(k.make({2, genus, 0}), std::invalid_argument) << k.name;
    EXPECT_THROW(k.make({2000000000, genus, 0}), std::invalid_argument) << k.name;
  }
}

TEST(Generators, SayHowManyFacesTheyNeed) {
  try {
    kind("multi-torus").make({100, 7, 0});
    FAIL() << "100 faces for genus 7";
  } catch(const std::invalid_argument& e) {
    EXPECT_STREQ(e.what(),
                 "a mesh of the kind 'multi-torus' of genus 7 needs at least 1600 faces, not 100");
  }
}

// Also where there is not even one for each handle.
TEST(Generators, SayHowManyFacesTheyNeedInPlaceOfNone) {
  const auto words = [](const char* name, const Request& request) -> std::string {
    try {
      generators::make(kind(name), request);
      return "it was made";
    } catch(const std::invalid_argument& e) {
      return e.what();
    }
  };
  EXPECT_EQ(words("torus", {0, 1, 0}),
            "a mesh of the kind 'torus' of genus 1 needs at least 18 faces, not 0");
  EXPECT_EQ(words("gyroid", {10, 500, 0}),
            "a mesh of the kind 'gyroid' with 10 faces cannot have 500 handles");
  Request request = {100, 1, 0};
  request.bridges = 1;
  request.tunnels = 0;
  EXPECT_EQ(words("scan", request),
            "a mesh of the kind 'scan' with 1 large handle and 1 bridge or tunnel needs at least "
            "25600 faces, not 100");
}

TEST(Holes, AreAllMadeOrRefused) {
  const Soup sphere = kind("sphere").make({10000, 0, 0});
  const auto number = [&](std::size_t wanted, bool may_be_fewer) {
    return generators::number_of_boundaries(
        generators::with_holes(sphere, {wanted, 20, false, 0, may_be_fewer}));
  };
  EXPECT_EQ(number(100, false), 100u);
  const std::size_t most = number(100000, true);
  EXPECT_GT(most, 100u);
  EXPECT_EQ(number(most, false), most);
  try {
    number(100000, false);
    FAIL() << "there is no room";
  } catch(const std::invalid_argument& e) {
    EXPECT_EQ(e.what(), "only " + std::to_string(most) +
                            " of 100000 holes fit: use more faces, fewer holes or smaller ones");
  }
}

TEST(Generators, RepeatThemselves) {
  for(const generators::Kind& k : kinds_to_try()) {
    const std::size_t faces = are_few_cases_tried() ? 15000 : 60000;
    const Request request = {(std::max)(k.default_faces, faces), k.default_genus, 7};
    const Soup first = k.make(request), second = k.make(request);
    EXPECT_EQ(first.points, second.points) << k.name;
    EXPECT_EQ(first.triangles, second.triangles) << k.name;
  }
}

TEST(Generators, HaveDefaultsThatCanBeMade) {
  for(const generators::Kind& k : kinds_to_try()) {
    Request request;
    request.faces = k.default_faces;
    request.genus = k.default_genus;
    SCOPED_TRACE(k.name);
    const Soup soup = k.make(request);
    std::size_t genus = k.default_genus;
    if((k.options & generators::SMALL_BRIDGES) != 0)
      genus += request.bridges + request.tunnels;
    if((k.options & generators::NECKS) != 0)
      genus = 2 * genus + request.necks - 1;
    expect_closed_and_oriented(directed_edges(soup));
    if((k.options & generators::GENUS) != 0) {
      EXPECT_EQ(generators::genus(soup), genus);
    }
  }
}

TEST(Generators, DependOnTheSeed) {
  for(const char* name : {"lattice", "gyroid", "sponge", "plates", "bars", "shell", "foam",
                          "interlaced", "waves", "random", "scan", "twins", "hollow"})
    EXPECT_NE(kind(name).make({60000, 4, 1}).triangles, kind(name).make({60000, 4, 2}).triangles)
        << name;
}

TEST(Permute_vertices, KeepsTheSurface) {
  const Soup soup = kind("lattice").make({5000, 3, 0});
  const Soup permuted = generators::permute_vertices(soup, 5);
  EXPECT_NE(permuted.triangles, soup.triangles);
  EXPECT_NEAR(signed_volume(permuted), signed_volume(soup), 1e-9);
  expect_closed_surface(permuted, 3);
}

TEST(Disjoint_union, PutsSurfacesBesideEachOther) {
  const Soup both = generators::disjoint_union(
      {kind("torus").make({500, 1, 0}), kind("sphere").make({500, 0, 0})});
  EXPECT_EQ(generators::number_of_components(both), 2u);
  EXPECT_EQ(generators::euler_characteristic(both), 2);
  EXPECT_EQ(generators::genus(both), 1u);
  EXPECT_TRUE(generators::disjoint_union({}).points.empty());
}

TEST(Shell, HasItsHollowTurnedInwards) {
  const Soup soup = kind("shell").make({5000, 2, 0});
  boost::disjoint_sets_with_storage<> components(soup.points.size());
  for(const auto& [a, b, c] : soup.triangles) {
    components.union_set(a, b);
    components.union_set(b, c);
  }
  Soup outer = soup, hollow = soup;
  outer.triangles.clear();
  hollow.triangles.clear();
  for(const auto& triangle : soup.triangles) {
    const bool is_outer = components.find_set(triangle[0]) == components.find_set(Index(0));
    (is_outer ? outer : hollow).triangles.push_back(triangle);
  }
  EXPECT_GT(signed_volume(outer), -signed_volume(hollow));
  EXPECT_LT(signed_volume(hollow), 0.);
}

TEST(Euler_characteristic, IgnoresIsolatedVertices) {
  Soup soup = kind("sphere").make({4, 0, 0});
  soup.points.push_back({0., 0., 0.});
  EXPECT_EQ(generators::euler_characteristic(soup), 2);
}

} // namespace test_generators
