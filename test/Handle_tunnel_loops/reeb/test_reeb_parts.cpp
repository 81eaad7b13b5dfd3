// Arcs that are contracted, and the parts of a surface that are left, by definition.

#include "Flat_mesh_of_soup.h"
#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/reeb/Arc_contraction.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Limb_bases.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Short_borders.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/measure_parts.h>
#include <CGAL/reeb_graph.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace test_reeb_parts {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;

// Pieces that a number of things is in, if some of them are joined.
class Pieces
{
public:
  explicit Pieces(std::size_t n)
      : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t(0));
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }
  std::size_t root(std::size_t a) const {
    while(parent_[a] != a)
      a = parent_[a];
    return a;
  }

private:
  std::vector<std::size_t> parent_;
};

std::size_t number_of_cycles(const std::vector<Sized_arc>& arcs) {
  std::set<Index> nodes;
  for(const Sized_arc& arc : arcs)
    nodes.insert({arc.lower, arc.upper});
  Pieces pieces(*nodes.rbegin() + 1);
  for(const Sized_arc& arc : arcs)
    pieces.join(arc.lower, arc.upper);
  std::set<std::size_t> roots;
  for(const Index node : nodes)
    roots.insert(pieces.root(node));
  return arcs.size() + roots.size() - nodes.size();
}

double area_of(const std::vector<Sized_arc>& arcs) {
  double sum = 0.;
  for(const Sized_arc& arc : arcs)
    sum += arc.area;
  return sum;
}

bool is_leaf(const Sized_arc& arc, const std::vector<Sized_arc>& arcs) {
  const auto degree = [&](Index node) {
    int sum = 0;
    for(const Sized_arc& other : arcs)
      sum += (other.lower == node) + (other.upper == node);
    return sum;
  };
  return degree(arc.lower) == 1 || degree(arc.upper) == 1;
}

// A connected graph, with loops and parallel arcs, of which some have no part of the surface.
std::vector<Sized_arc> random_arcs(Random& random, Index number_of_nodes) {
  std::vector<Sized_arc> arcs;
  const auto add = [&](std::size_t a, std::size_t b) {
    const double girth = 0.1 + double(random.below(100)) / 100.;
    arcs.push_back({static_cast<Index>(a), static_cast<Index>(b),
                    random.below(4) == 0 ? 0. : double(random.below(100)) / 100., girth});
  };
  for(Index n = 1; n < number_of_nodes; ++n)
    add(random.below(n), n);
  for(std::size_t i = random.below(number_of_nodes); i > 0; --i)
    add(random.below(number_of_nodes), random.below(number_of_nodes));
  return arcs;
}

std::vector<Shared_border> random_borders(Random& random, const std::vector<Sized_arc>& arcs) {
  std::vector<Shared_border> borders;
  for(Index a = 0; a < arcs.size(); ++a)
    for(Index b = 0; b < a; ++b)
      if(arcs[a].area > 0. && arcs[b].area > 0. &&
         (arcs[a].lower == arcs[b].lower || arcs[a].lower == arcs[b].upper ||
          arcs[a].upper == arcs[b].lower || arcs[a].upper == arcs[b].upper))
        borders.push_back({a, b, double(random.below(10))});
  return borders;
}

TEST(Arc_contraction, KeepsCyclesAndLeavesNoShortArc) {
  Random random(1);
  constexpr double shortest = 2.;
  std::size_t contracted = 0;
  for(int i = 0; i < 300; ++i) {
    const Index number_of_nodes = static_cast<Index>(2 + random.below(20));
    const std::vector<Sized_arc> arcs = random_arcs(random, number_of_nodes);
    Arc_contraction contraction(number_of_nodes, arcs, random_borders(random, arcs));
    contraction.run(shortest);
    std::vector<Sized_arc> kept;
    for(Index a = 0; a < arcs.size(); ++a) {
      EXPECT_TRUE(contraction.is_kept(contraction.owner(a)));
      if(contraction.is_kept(a)) {
        kept.push_back(contraction.arc(a));
        EXPECT_EQ(contraction.owner(a), a);
      } else
        EXPECT_FALSE(is_leaf(arcs[a], arcs));
    }
    EXPECT_EQ(number_of_cycles(kept), number_of_cycles(arcs));
    for(const Sized_arc& arc : kept)
      EXPECT_TRUE(arc.lower == arc.upper || is_leaf(arc, kept) || arc.slenderness() >= shortest);
    contracted += arcs.size() - kept.size();
  }
  EXPECT_GT(contracted, 300u);
}

TEST(Arc_contraction, TellsHowLongACylinderIs) {
  const double pi = std::acos(-1.), radius = 0.3, length = 1.2;
  const Sized_arc cylinder = {0, 1, 2. * pi * radius * length, 2. * pi * radius};
  EXPECT_NEAR(cylinder.slenderness(), length / radius, 1e-12);
}

double length_of_borders(const Flat_mesh& mesh, const std::vector<Index>& parts) {
  double sum = 0.;
  for(const Shared_border& border : shared_borders(mesh, parts))
    sum += border.length;
  return sum;
}

std::size_t number_of_pieces(const Flat_mesh& mesh, const std::vector<Index>& parts) {
  Pieces pieces(parts.size());
  for(Index v = 0; v < parts.size(); ++v)
    for(const Index u : mesh.ring(v))
      if(parts[u] == parts[v])
        pieces.join(u, v);
  std::set<std::size_t> roots;
  for(Index v = 0; v < parts.size(); ++v)
    roots.insert(pieces.root(v));
  return roots.size();
}

TEST(Short_borders, AreShorterAndPartsConnected) {
  Random random(2);
  for(const Recipe& recipe : {Recipe{"torus", {2000, 1, 0}}, Recipe{"gyroid", {4000, 5, 0}},
                              Recipe{"lattice", {3000, 5, 0}}})
  {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    // Slabs with ragged borders and with spots of others.
    std::vector<Index> parts;
    for(const Vector& p : mesh.points)
      parts.push_back(random.below(50) == 0
                          ? Index(random.below(3))
                          : Index(std::floor(3. * p[0] + 0.1 * double(random.below(10))) + 100));
    std::map<Index, Index> number;
    for(Index& part : parts)
      part = number.emplace(part, static_cast<Index>(number.size())).first->second;
    std::vector<Index> shorter = parts;
    Short_borders(mesh, shorter).run();
    const std::set<Index> before(parts.begin(), parts.end()), after(shorter.begin(), shorter.end());
    EXPECT_EQ(before, after);
    EXPECT_EQ(number_of_pieces(mesh, shorter), after.size());
    EXPECT_LT(length_of_borders(mesh, shorter), 0.8 * length_of_borders(mesh, parts));
    std::vector<Index> again = shorter;
    Short_borders(mesh, again).run();
    EXPECT_LE(length_of_borders(mesh, again), length_of_borders(mesh, shorter) * (1. + 1e-9));
  }
}

// Of graphs that are handed out.
// A ball of radius 3 around the origin, with a limb of radius 1 up to x = 10.
Soup body_with_limb() {
  constexpr double base = 2.8284271247461903; // where the limb leaves the ball
  std::vector<std::array<double, 2>> profile; // x, radius
  for(double t = -1.5; t < 1.2; t += 0.05)
    profile.push_back({3. * std::sin(t), 3. * std::cos(t)});
  for(double x = base; x < 9.9; x += 0.15)
    profile.push_back({x, 1.});
  constexpr std::uint32_t around = 40;
  Soup soup;
  for(std::size_t i = 0; i < profile.size(); ++i)
    for(std::uint32_t j = 0; j < around; ++j) {
      const double u = 6.283185307179586 * (j + 0.5 * double(i % 2)) / around;
      soup.points.push_back(
          {profile[i][0], profile[i][1] * std::cos(u), profile[i][1] * std::sin(u)});
    }
  const auto end = static_cast<std::uint32_t>(soup.points.size());
  soup.points.push_back({-3., 0., 0.});
  soup.points.push_back({10., 0., 0.});
  for(std::uint32_t j = 0; j < around; ++j) {
    const std::uint32_t next = (j + 1) % around, last = end - around;
    soup.triangles.push_back({end, next, j});
    soup.triangles.push_back({end + 1, last + j, last + next});
    for(std::uint32_t row = 0; row < last; row += around) {
      soup.triangles.push_back({row + j, row + next, row + around + j});
      soup.triangles.push_back({row + next, row + around + next, row + around + j});
    }
  }
  return soup;
}

// Whether its part ends halfway or holds half of the body.
TEST(Limb_bases, AreWhereTheGirthJumps) {
  const Soup soup = body_with_limb();
  const Flat_mesh mesh = flat_mesh_of(soup);
  const auto x = [&](Index v) { return soup.points[mesh.original[v]][0]; };
  Index tip = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    tip = x(v) > x(tip) ? v : tip;
  for(const double border : {7., 5., 0., -1.}) {
    std::vector<Index> parts;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      parts.push_back(x(v) > border ? 0 : 1);
    Limb_bases(mesh, parts).run({tip, no_index});
    for(Index v = 0; v < parts.size(); ++v) {
      const bool is_of_limb = x(v) > 3.8, is_of_body = x(v) < 2.; // the base is at 2.83
      if(is_of_limb || is_of_body) {
        EXPECT_EQ(parts[v], is_of_limb ? 0u : 1u) << border << ' ' << x(v);
      }
    }
  }
}

TEST(Reeb_parts, AreFewConnectedAndHaveAllCycles) {
  for(const Recipe& recipe : {Recipe{"torus", {600, 1, 0}}, Recipe{"multi-torus", {3000, 4, 0}},
                              Recipe{"gyroid", {4000, 5, 0}}, Recipe{"lattice", {3000, 5, 0}},
                              Recipe{"plates", {3000, 3, 0}}})
  {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of<Mesh>(soup_of(recipe));
    CGAL::Handle_tunnel_loops::Reeb_options options;
    options.allow_parallel_arcs = true;
    CGAL::Reeb_graph<Mesh> all, graph;
    const auto statistics = CGAL::reeb_graph(mesh, all, CGAL::parameters::reeb_options(options));
    options.shortest_arc = 2.;
    CGAL::reeb_graph(mesh, graph, CGAL::parameters::reeb_options(options));
    EXPECT_LE(num_edges(graph), num_edges(all));
    EXPECT_EQ(num_edges(graph) + statistics.number_of_components - num_vertices(graph),
              statistics.genus);
    std::map<Mesh::Vertex_index, std::size_t> part;
    for(const auto e : CGAL::make_range(edges(graph))) {
      EXPECT_LE(graph[source(e, graph)].value, graph[target(e, graph)].value);
      for(const auto v : graph[e].vertices)
        EXPECT_TRUE(part.emplace(v, graph[e].index).second);
    }
    EXPECT_EQ(part.size(), mesh.number_of_vertices());
    Pieces pieces(mesh.number_of_vertices());
    for(const auto e : mesh.edges())
      if(part[mesh.vertex(e, 0)] == part[mesh.vertex(e, 1)])
        pieces.join(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx());
    std::set<std::size_t> roots, parts;
    for(const auto v : mesh.vertices()) {
      roots.insert(pieces.root(v.idx()));
      parts.insert(part[v]);
    }
    EXPECT_EQ(roots.size(), parts.size());
  }
}

TEST(Reeb_parts, RefuseNegativeLengths) {
  const Mesh mesh = mesh_of<Mesh>(soup_of({"torus", {100, 1, 0}}));
  CGAL::Handle_tunnel_loops::Reeb_options options;
  CGAL::Reeb_graph<Mesh> graph;
  for(const double length : {-1., std::nan("")}) {
    options.shortest_arc = length;
    EXPECT_THROW(CGAL::reeb_graph(mesh, graph, CGAL::parameters::reeb_options(options)),
                 std::invalid_argument);
  }
}

} // namespace test_reeb_parts
