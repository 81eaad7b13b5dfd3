// Shortened by flips, a loop is in the same class; and what flipped edges cross are edges of the
// mesh, one beside the other.

#include "Crossing_loops.h"
#include "Meshes_of_soups.h"
#include "Surfaces_for_loops.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Flip_shortening.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace test_flip_shortening {

using CGAL::Handle_tunnel_loops::internal::Execution;
using CGAL::Handle_tunnel_loops::internal::Flip_shortening;
using CGAL::Handle_tunnel_loops::internal::Flipped_edges;
using CGAL::Handle_tunnel_loops::internal::lead_around_caps;
using CGAL::Handle_tunnel_loops::internal::length;
using CGAL::Handle_tunnel_loops::internal::Loop_tightening;
using CGAL::Handle_tunnel_loops::internal::Prepared_surface;

bool is_any_on_border(const Mesh& mesh, Mesh::Face_index f) {
  for(const Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
    if(mesh.is_border(v))
      return true;
  return false;
}

// The class is seen through the intersection numbers with a fixed family.
void expect_shortened(const Flat_mesh& mesh, unsigned seed) {
  Random random(seed);
  const Crossing_index index(mesh, random_loops(mesh, random, 20));
  for(const Crossing_loop& loop : random_loops(mesh, random, 30)) {
    Crossing_loop shortened = loop;
    Flip_shortening(Execution(), mesh).shorten(shortened);
    expect_crossing_loop(mesh, shortened);
    EXPECT_EQ(index.intersections(shortened), index.intersections(loop));
  }
}

TEST(Flips, KeepTheClassOnSmoothSurfaces) { for_each_smooth_surface(expect_shortened); }

TEST(Flips, KeepTheClassOnRandomSurfaces) { for_each_random_surface(expect_shortened); }

TEST(Flips, KeepTheClassWherePointsCoincide) {
  for_each_surface_with_coinciding_points(expect_shortened);
}

// Some faces are missing, so that there are caps in their place.
TEST(Flips, KeepTheClassBesideCaps) {
  Mesh mesh = mesh_of({"plates", {3000, 4, 0}});
  for(const Mesh::Face_index f :
      std::vector<Mesh::Face_index>(faces(mesh).begin(), faces(mesh).end()))
    if(f % 20 == 0 && !is_any_on_border(mesh, f))
      CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  mesh.collect_garbage();
  const Prepared_surface<Mesh, boost::property_map<Mesh, CGAL::vertex_point_t>::const_type> surface(
      Execution(), mesh, get(boost::vertex_index, mesh),
      get(CGAL::vertex_point, std::as_const(mesh)));
  const Flat_mesh& flat = surface.mesh;
  ASSERT_GT(flat.number_of_hubs, 20u);
  Random random(5);
  const Crossing_index index(flat, random_loops(flat, random, 20));
  for(Crossing_loop loop : random_loops(flat, random, 30)) {
    const auto numbers = index.intersections(loop);
    lead_around_caps(flat, loop);
    Flip_shortening(Execution(), flat).shorten(loop);
    const auto enters_no_cap = [&] {
      return std::none_of(loop.begin(), loop.end(),
                          [&](const Crossing& c) { return flat.is_spoke(c.left, c.right); });
    };
    EXPECT_TRUE(enters_no_cap());
    Loop_tightening(flat).tighten(loop, 10);
    expect_crossing_loop(flat, loop);
    EXPECT_EQ(index.intersections(loop), numbers);
    EXPECT_TRUE(enters_no_cap());
  }
}

// Edges that are flipped at random, whatever the shapes of faces are: each one leads from one of
// its ends to the other, or is an edge of the mesh again.
void expect_ways_on_mesh(const Flat_mesh& mesh, Random& random) {
  Flipped_edges edges(mesh);
  std::vector<Index> halfedges;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    for(const Index u : mesh.ring(v))
      halfedges.push_back(edges.halfedge(v, u));
  for(int i = 0; i < 500; ++i) {
    const Index h = halfedges[random.below(halfedges.size())], g = Flipped_edges::twin(h);
    if(g == edges.next(h) || g == edges.previous(h))
      continue;
    edges.flip(h);
    Crossing_loop way;
    edges.append_crossings(h, way);
    const Index source = edges.source(h), target = edges.target(h);
    if(edges.is_of_mesh(h)) {
      ASSERT_LT(mesh.ring(source).position(target), mesh.ring(source).size());
      continue;
    }
    ASSERT_FALSE(way.empty());
    for(const Crossing& c : way)
      ASSERT_LT(mesh.ring(c.left).position(c.right), mesh.ring(c.left).size());
    ASSERT_EQ(mesh.ring(way.front().right).after(way.front().left), source);
    ASSERT_EQ(mesh.ring(way.back().left).after(way.back().right), target);
    for(std::size_t k = 0; k + 1 < way.size(); ++k) {
      const Index apex = mesh.ring(way[k].left).after(way[k].right);
      ASSERT_TRUE((way[k + 1].left == way[k].left && way[k + 1].right == apex) ||
                  (way[k + 1].right == way[k].right && way[k + 1].left == apex));
    }
  }
}

TEST(Flips, LeaveWaysOnTheMesh) {
  Random random(3);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 1)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    expect_ways_on_mesh(flat_mesh_of(recipe), random);
  }
}

// To the left of a walk, across however many edges.
Crossing_loop led_around_vertices(const Flat_mesh& mesh, const Vertex_walk& walk) {
  Crossing_loop loop;
  for(std::size_t i = 0; i < walk.size(); ++i) {
    const auto ring = mesh.ring(walk[i]);
    const Index from = ring.position(walk[i == 0 ? walk.size() - 1 : i - 1]),
                to = ring.position(walk[i + 1 == walk.size() ? 0 : i + 1]);
    append_way_around(walk[i], ring, from, to, true, loop);
  }
  remove_backtracks(loop);
  return loop;
}

// On plates of long thin faces a loop is far from tight after two hundred rounds.
TEST(Flips, ShortenLoopsAcrossLongThinFaces) {
  const Flat_mesh mesh = flat_mesh_of({"plates", {20000, 4, 0}});
  Random random(4);
  double by_flips = 0., by_rounds = 0.;
  for(int i = 0; i < 10; ++i) {
    const Crossing_loop loop = led_around_vertices(mesh, random_walk_without_spurs(mesh, random));
    Crossing_loop flipped = loop, pulled = loop;
    Loop_tightening(mesh).tighten(flipped);
    Loop_tightening(mesh).tighten(pulled, 200);
    by_flips += length(mesh, flipped);
    by_rounds += length(mesh, pulled);
  }
  EXPECT_LT(by_flips, 0.9 * by_rounds);
}

} // namespace test_flip_shortening
