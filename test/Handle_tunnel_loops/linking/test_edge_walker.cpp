// Loops that are moved onto the edges: closed walks in the classes of the loops, around what is to
// be avoided, whatever was walked and avoided before.

#include "Changed_loops.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/linking/Edge_walker.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace test_edge_walker {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;
using Vertex = Mesh::Vertex_index;
using Point_map = boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
using Index_map = boost::property_map<Mesh, boost::vertex_index_t>::const_type;
using Walker = Edge_walker<Mesh, Point_map, Index_map>;

const Cap_hubs no_hubs;

Walker walker_on(const Mesh& mesh) {
  return Walker(mesh, get(CGAL::vertex_point, mesh), get(boost::vertex_index, mesh), no_hubs);
}

Vertex any_vertex(const Mesh& mesh, Random& random) {
  return Vertex(static_cast<Mesh::size_type>(random.below(mesh.number_of_vertices())));
}

// Through a few places, at a side of the edges or on them.
Loop random_loop(const Mesh& mesh, Random& random) {
  const Vertex first = any_vertex(mesh, random);
  Walk walk;
  Vertex last = first;
  for(std::size_t i = 1 + random.below(3); i > 0; --i) {
    const Vertex next = i == 1 ? first : any_vertex(mesh, random);
    const Walk part = path(mesh, last, next);
    walk.insert(walk.end(), part.begin(), part.end());
    last = next;
  }
  if(last != first) {
    const Walk part = path(mesh, last, first);
    walk.insert(walk.end(), part.begin(), part.end());
  }
  Steps steps;
  for(const Mesh::Halfedge_index h : walk) {
    // The edges at the source of h, from the one before to the one after, are all on one side.
    steps.push_back(random.below(2) == 0 ? Loop::Step{h, 0.} : Loop::Step{mesh.opposite(h), 1.});
    if(random.below(3) == 0)
      steps.push_back({h, random.uniform(0.1, 0.9)});
  }
  return loop_of(steps);
}

// Vertices of faces without area.
std::set<Vertex> flat_vertices(const Mesh& mesh) {
  std::set<Vertex> flat;
  for(const Mesh::Face_index f : mesh.faces()) {
    std::vector<Vertex> corners;
    for(const Vertex v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners.push_back(v);
    const auto p = mesh.point(corners[0]), q = mesh.point(corners[1]), r = mesh.point(corners[2]);
    if(CGAL::collinear(p, q, r)) // the coordinates are small integers
      flat.insert(corners.begin(), corners.end());
  }
  return flat;
}

void expect_closed(const Mesh& mesh, const Walk& walk) {
  for(std::size_t i = 0; i < walk.size(); ++i)
    EXPECT_EQ(mesh.target(walk[i]), mesh.source(walk[(i + 1) % walk.size()]));
}

// All that crosses a fixed family as often is of the same class.
bool have_same_class(const Mesh& mesh,
                     const std::vector<Walk>& family,
                     const Walk& a,
                     const Walk& b) {
  std::vector<Walk> walks = family;
  walks.insert(walks.end(), {a, b});
  const Integer_matrix matrix = intersection_matrix(mesh, walks);
  return std::equal(matrix[family.size()].begin(),
                    matrix[family.size()].begin() + static_cast<std::ptrdiff_t>(family.size()),
                    matrix[family.size() + 1].begin());
}

TEST(Edge_walker, GoesAroundWhateverIsToBeAvoided) {
  Random random(1);
  int around = 0, failed = 0, after_failure = 0;
  for(int round = 0; round < 60; ++round) {
    const std::size_t genus = random.below(4);
    const Recipe recipe = {
        "random",
        {60 + 12 * genus + random.below(200), genus, static_cast<unsigned>(random.next())}};
    SCOPED_TRACE(testing::Message() << recipe);
    Mesh mesh = mesh_of(recipe);
    const auto small = [&] { return static_cast<double>(random.below(200)); };
    for(const Vertex v : mesh.vertices())
      mesh.point(v) = Mesh::Point(small(), small(), small());
    for(std::size_t i = random.below(4); i > 0; --i) {
      const Mesh::Halfedge_index h(
          static_cast<Mesh::size_type>(random.below(mesh.number_of_halfedges())));
      mesh.point(mesh.source(h)) = mesh.point(mesh.target(h));
    }
    std::vector<Walk> family;
    for(int i = 0; i < 12; ++i)
      family.push_back(walk_beside(mesh, random_loop(mesh, random)));
    std::set<Vertex> avoided = flat_vertices(mesh);
    Walker walker = walker_on(mesh);
    for(int i = 0; i < 40; ++i) {
      if(random.below(4) == 0) {
        const Vertex v = any_vertex(mesh, random);
        walker.avoid(static_cast<Index>(v.idx()));
        avoided.insert(v);
      }
      const Loop loop = random_loop(mesh, random);
      const Walk straight = walker.straight(loop), walk = walker(loop);
      const bool has_failed = walker.has_failed();
      const auto is_avoided = [&](Mesh::Halfedge_index h) {
        return avoided.count(mesh.source(h)) != 0;
      };
      const bool has_to_turn = std::any_of(straight.begin(), straight.end(), is_avoided);
      expect_closed(mesh, straight);
      expect_closed(mesh, walk);
      EXPECT_TRUE(have_same_class(mesh, family, straight, walk_beside(mesh, loop)));
      EXPECT_TRUE(std::none_of(walk.begin(), walk.end(), is_avoided));
      if(has_failed) {
        EXPECT_TRUE(walk.empty());
      } else {
        EXPECT_TRUE(have_same_class(mesh, family, straight, walk));
        after_failure += failed > 0;
      }
      // Nothing is left over from the walk before.
      EXPECT_EQ(walker(loop), walk);
      EXPECT_EQ(walker.has_failed(), has_failed);
      around += has_to_turn && !has_failed && !walk.empty();
      failed += has_failed;
    }
  }
  EXPECT_GT(around, 200);
  EXPECT_GT(failed, 20);
  EXPECT_GT(after_failure, 20);
}

// Vertex by vertex, what is avoided grows to a ring. Up to the last, there is a way around it.
TEST(Edge_walker, NoticesThatTheLastVertexClosesARing) {
  const Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  Random random(2);
  int rings = 0;
  while(rings < 10) {
    // Two walks that cross once.
    const Walk ring = walker_on(mesh).straight(random_loop(mesh, random));
    const Walk across = walker_on(mesh).straight(random_loop(mesh, random));
    std::set<Vertex> members;
    for(const Mesh::Halfedge_index h : ring)
      members.insert(mesh.source(h));
    if(members.size() != ring.size() || ring.size() < 3 ||
       abs(intersection_matrix(mesh, std::vector<Walk>{ring, across})[0][1]) != 1)
      continue;
    ++rings;
    Walker walker = walker_on(mesh);
    const Loop loop = loop_of(across);
    for(std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_FALSE(walker(loop).empty());
      EXPECT_FALSE(walker.has_failed()) << i << " of " << ring.size();
      walker.avoid(static_cast<Index>(mesh.source(ring[i]).idx()));
    }
    EXPECT_TRUE(walker(loop).empty());
    EXPECT_TRUE(walker.has_failed());
    EXPECT_EQ(members.count(Vertex(static_cast<Mesh::size_type>(walker.failure()))), 1u);
    // A loop that keeps away from the ring is none the worse.
    for(const Vertex v : mesh.vertices()) {
      const Walk small = ring_around(mesh, v);
      if(std::none_of(small.begin(), small.end(),
                      [&](Mesh::Halfedge_index h) { return members.count(mesh.source(h)) != 0; }))
      {
        EXPECT_EQ(walker(loop_of(small)), walker.straight(loop_of(small)));
        EXPECT_FALSE(walker.has_failed());
        break;
      }
    }
  }
}

// What is enclosed is avoided as well.
TEST(Edge_walker, GoesAroundARingAndWhatIsInIt) {
  const Mesh mesh = mesh_of(Recipe{"torus", {400, 1, 0}});
  Random random(3);
  int around = 0;
  for(const Vertex v : mesh.vertices()) {
    Walker walker = walker_on(mesh);
    std::set<Vertex> enclosed = {v};
    for(const Vertex u : CGAL::vertices_around_target(v, mesh)) {
      walker.avoid(static_cast<Index>(u.idx()));
      enclosed.insert(u);
    }
    const auto is_enclosed = [&](Mesh::Halfedge_index h) {
      return enclosed.count(mesh.source(h)) != 0;
    };
    for(int i = 0; i < 20; ++i) {
      const Loop loop = random_loop(mesh, random);
      const Walk straight = walker.straight(loop);
      if(std::none_of(straight.begin(), straight.end(), is_enclosed))
        continue;
      const Walk walk = walker(loop);
      EXPECT_FALSE(walker.has_failed());
      EXPECT_TRUE(std::none_of(walk.begin(), walk.end(), is_enclosed));
      ++around;
    }
  }
  EXPECT_GT(around, 100);
}

// Counts how often it is asked.
struct Counting_index_map
{
  using key_type = Vertex;
  using value_type = Mesh::size_type;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  std::size_t* number_of_calls;

  friend reference get(const Counting_index_map& map, Vertex v) {
    ++*map.number_of_calls;
    return v.idx();
  }
};

TEST(Edge_walker, LooksAtAClusterThatIsNoDiscOnce) {
  Mesh mesh = mesh_of({"torus", {2000, 1, 1}});
  for(const Vertex v : mesh.vertices())
    mesh.point(v) = Mesh::Point(mesh.point(v).x(), 0., 0.); // no face has an area
  std::size_t number_of_calls = 0;
  Edge_walker<Mesh, Point_map, Counting_index_map> walker(mesh, get(CGAL::vertex_point, mesh),
                                                          {&number_of_calls}, no_hubs);
  Random random(1);
  walker(random_loop(mesh, random));
  EXPECT_TRUE(walker.has_failed());
  EXPECT_GE(number_of_calls, mesh.number_of_vertices());
  number_of_calls = 0;
  for(int i = 0; i < 100; ++i) {
    const Loop loop = random_loop(mesh, random);
    walker(loop);
    EXPECT_EQ(walker.has_failed(), !walker.straight(loop).empty());
  }
  EXPECT_LT(number_of_calls, mesh.number_of_vertices());
}

} // namespace test_edge_walker
