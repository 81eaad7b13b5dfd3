// The pieces of a mesh that is cut along edges, and what they are found with, against a search from
// face to face.

#include "Meshes_of_soups.h"
#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <list>
#include <numeric>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_cut_components {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::generators::Random;

class Pieces : public testing::TestWithParam<bool>
{
protected:
  const Execution execution = GetParam() ? Execution::parallel() : Execution();
};

INSTANTIATE_TEST_SUITE_P(Executions, Pieces, testing::Bool(), [](const auto& test) {
  return test.param ? "parallel" : "sequential";
});

// ---- parts of ranges

template <typename Range> void expect_parts(Execution execution, const Range& range) {
  using Iterator = typename Range::const_iterator;
  const std::vector<int> all(range.begin(), range.end());
  for(const std::size_t part_size : {1, 3, 1000}) {
    const Range_parts<Iterator> parts(range, part_size);
    EXPECT_EQ(parts.size(), all.size());
    std::vector<std::vector<int>> found(parts.number_of_parts());
    parts.for_each_part(execution, [&](std::size_t i, Iterator begin, Iterator end) {
      found[i].assign(begin, end);
    });
    std::vector<int> joined;
    for(const auto& part : found) {
      EXPECT_LE(part.size(), part_size);
      joined.insert(joined.end(), part.begin(), part.end());
    }
    EXPECT_EQ(joined, all);
  }
}

TEST_P(Pieces, PartsCoverARangeInItsOrder) {
  for(const std::size_t n : {0, 1, 2, 3, 4, 100}) {
    std::vector<int> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    expect_parts(execution, numbers);
    expect_parts(execution, std::list<int>(numbers.begin(), numbers.end()));
  }
}

// ---- sets

TEST_P(Pieces, SetsAreThoseOfAGraphWithTheLeastNumberAsRoot) {
  constexpr Index size = 20000;
  for(const std::size_t number_of_edges : {0, 5000, 10000, 40000}) {
    Random random(number_of_edges);
    std::vector<std::pair<Index, Index>> edges(number_of_edges);
    for(auto& [i, j] : edges) {
      i = static_cast<Index>(random.below(size / 2)) * 2;
      j = static_cast<Index>(random.below(size / 2)) * 2;
    }
    Concurrent_disjoint_sets sets(execution, size);
    for(Index i = 0; i < size; i += 2)
      sets.insert(i);
    for_each_index(
        execution, edges.size(),
        [&](std::size_t e) { sets.unite(edges[e].first, edges[e].second); }, 16);
    const std::vector<Index> roots = sets.flatten(execution);

    std::vector<Index> least(size);
    std::iota(least.begin(), least.end(), Index(0));
    for(bool changes = true; changes;) {
      changes = false;
      for(const auto& [i, j] : edges)
        if(least[i] != least[j]) {
          least[i] = least[j] = (std::min)(least[i], least[j]);
          changes = true;
        }
    }
    std::set<Index> expected_roots;
    for(Index i = 0; i < size; ++i) {
      EXPECT_EQ(sets.contains(i), i % 2 == 0);
      if(i % 2 == 0) {
        EXPECT_EQ(sets.label(i), least[i]);
        expected_roots.insert(least[i]);
      }
    }
    EXPECT_EQ(roots, std::vector<Index>(expected_roots.begin(), expected_roots.end()));
  }
}

// ---- pieces

struct Cuts
{
  std::vector<char> is_cut; // by edge
  std::vector<Index> ends;
};

Cuts random_cuts(const Mesh& mesh, std::size_t one_of, Random& random) {
  Cuts cuts;
  cuts.is_cut.assign(mesh.num_edges(), 0);
  for(const Mesh::Edge_index e : mesh.edges())
    if(random.below(one_of) == 0) {
      cuts.is_cut[e] = 1;
      for(int i = 0; i < 2; ++i)
        cuts.ends.push_back(mesh.vertex(e, i));
    }
  return cuts;
}

// By face, the least face of its piece.
std::vector<Index> pieces_by_search(const Mesh& mesh, const Cuts& cuts) {
  std::vector<Index> piece(mesh.num_faces(), no_index);
  for(const Mesh::Face_index first : mesh.faces()) {
    if(piece[first] != no_index)
      continue;
    std::vector<Mesh::Face_index> queue(1, first);
    piece[first] = first;
    for(std::size_t q = 0; q < queue.size(); ++q)
      for(const Mesh::Halfedge_index h : halfedges_around_face(mesh.halfedge(queue[q]), mesh)) {
        const Mesh::Face_index f = mesh.face(mesh.opposite(h));
        if(cuts.is_cut[mesh.edge(h)] == 0 && piece[f] == no_index) {
          piece[f] = first;
          queue.push_back(f);
        }
      }
  }
  return piece;
}

Closed_triangles triangles_of(Execution execution, const Mesh& mesh) {
  const auto face_index = get(boost::face_index, mesh);
  const Triangle_reader<Mesh, std::decay_t<decltype(face_index)>> reader(mesh, face_index);
  return Closed_triangles(
      reader.read(execution, get(boost::vertex_index, mesh), get(CGAL::vertex_point, mesh)));
}

Closed_triangles::Halfedge face_of(Mesh::Face_index f) { return {3 * static_cast<Index>(f)}; }

void expect_pieces(Execution execution, const Mesh& mesh, const Cuts& cuts) {
  const Closed_triangles triangles = triangles_of(execution, mesh);
  Cut_components pieces(triangles);
  std::vector<std::atomic<int>> calls(mesh.num_edges());
  pieces.cut(execution, cuts.ends, [&](Closed_triangles::Halfedge h) {
    const Mesh::Vertex_index u(source(h, triangles)), v(target(h, triangles));
    EXPECT_LT(u, v);
    const Mesh::Edge_index e = mesh.edge(mesh.halfedge(u, v));
    ++calls[e];
    return cuts.is_cut[e] != 0;
  });
  const std::vector<Index> expected = pieces_by_search(mesh, cuts);
  std::set<Index> expected_pieces;
  for(const Mesh::Face_index f : mesh.faces()) {
    EXPECT_EQ(pieces.piece(face_of(f)), expected[f]);
    expected_pieces.insert(expected[f]);
  }
  EXPECT_EQ(pieces.pieces(), std::vector<Index>(expected_pieces.begin(), expected_pieces.end()));
  for(const Mesh::Edge_index e : mesh.edges()) {
    EXPECT_LE(calls[e], 1);
    EXPECT_GE(calls[e], cuts.is_cut[e]);
  }
  pieces.renumber(execution, [](Index piece) { return piece + 7; });
  for(const Mesh::Face_index f : mesh.faces())
    EXPECT_EQ(pieces.piece(face_of(f)), expected[f] + 7);
}

TEST_P(Pieces, AreThoseOfASearch) {
  Random random(1);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Mesh mesh = mesh_of(recipe);
    for(const std::size_t one_of : {2, 3, 10, 1000000})
      expect_pieces(execution, mesh, random_cuts(mesh, one_of, random));
  }
}

TEST_P(Pieces, ArePiecesOfAllComponents) {
  Random random(2);
  const Mesh mesh = mesh_of(generators::permute_vertices(
      generators::disjoint_union({soup_of({"torus", {20000, 1, 0}}),
                                  soup_of({"sphere", {500, 0, 0}}),
                                  soup_of({"multi-torus", {3000, 2, 0}})}),
      3));
  for(const std::size_t one_of : {2, 10, 1000000})
    expect_pieces(execution, mesh, random_cuts(mesh, one_of, random));
}

// Removed and isolated vertices leave gaps.
TEST_P(Pieces, TakeNoNoticeOfVerticesWithoutFaces) {
  Mesh mesh = mesh_of(Recipe{"torus", {2000, 1, 0}});
  const Mesh::Vertex_index removed = mesh.add_vertex();
  mesh.add_vertex();
  mesh.remove_vertex(removed);
  const Closed_triangles triangles = triangles_of(execution, mesh);
  Cut_components pieces(triangles);
  pieces.cut(execution, {}, [](Closed_triangles::Halfedge) { return true; });
  EXPECT_EQ(pieces.pieces(), std::vector<Index>(1, 0));
}

// ---- the list of triangles

// What a model of `FaceListGraph` promises; without a boundary, on the caller's own halfedges.
void expect_closed(const Closed_triangles& triangles) {
  for(const Closed_triangles::Halfedge h : halfedges(triangles)) {
    EXPECT_EQ(opposite(opposite(h, triangles), triangles), h);
    EXPECT_EQ(source(opposite(h, triangles), triangles), target(h, triangles));
    EXPECT_EQ(target(opposite(h, triangles), triangles), source(h, triangles));
    EXPECT_EQ(prev(next(h, triangles), triangles), h);
    EXPECT_EQ(face(next(h, triangles), triangles), face(h, triangles));
  }
  for(const Index v : vertices(triangles))
    if(const Closed_triangles::Halfedge h = halfedge(v, triangles);
       h != Closed_triangles::Halfedge()) {
      EXPECT_EQ(target(h, triangles), v);
    }
}

TEST_P(Pieces, AListOfTrianglesIsTheMeshFaceByFace) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 2)) {
    const Mesh mesh = mesh_of(recipe);
    const Closed_triangles triangles = triangles_of(execution, mesh);
    expect_closed(triangles);
    EXPECT_TRUE(triangles.boundaries().empty());
    ASSERT_EQ(num_faces(triangles), mesh.number_of_faces());
    for(const Mesh::Face_index f : mesh.faces()) {
      const Mesh::Halfedge_index first = mesh.halfedge(f);
      EXPECT_EQ(target(face_of(f), triangles), Index(mesh.target(first)));
      EXPECT_EQ(source(face_of(f), triangles), Index(mesh.source(first)));
    }
  }
}

// A torus without some of its faces, which do not touch each other.
TEST_P(Pieces, CapsCloseAListOfTriangles) {
  Mesh mesh = mesh_of(Recipe{"torus", {4000, 1, 0}});
  Random random(3);
  std::set<Mesh::Vertex_index> at_holes;
  std::size_t holes = 0;
  for(int tries = 0; tries < 50; ++tries) {
    const Mesh::Face_index f(static_cast<Mesh::size_type>(random.below(mesh.number_of_faces())));
    if(mesh.is_removed(f))
      continue;
    std::vector<Mesh::Vertex_index> around;
    for(const auto v : vertices_around_face(mesh.halfedge(f), mesh))
      for(const auto u : vertices_around_target(v, mesh))
        around.push_back(u);
    if(std::any_of(around.begin(), around.end(),
                   [&](const auto u) { return at_holes.count(u) > 0; }))
      continue;
    at_holes.insert(around.begin(), around.end());
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
    ++holes;
  }
  ASSERT_GT(holes, 5u);
  const Closed_triangles triangles = triangles_of(execution, mesh); // faces leave gaps
  expect_closed(triangles);
  EXPECT_EQ(num_faces(triangles), mesh.number_of_faces() + 3 * holes);
  const auto boundaries = triangles.boundaries();
  EXPECT_EQ(boundaries.size(), holes);
  for(const auto& walk : boundaries) {
    EXPECT_EQ(walk.size(), 3u);
    for(std::size_t i = 0; i < walk.size(); ++i) {
      EXPECT_EQ(target(walk[i], triangles), source(walk[(i + 1) % walk.size()], triangles));
      EXPECT_FALSE(triangles.is_in_cap(walk[i]));
      EXPECT_TRUE(triangles.is_in_cap(opposite(walk[i], triangles)));
    }
  }
}

} // namespace test_cut_components
