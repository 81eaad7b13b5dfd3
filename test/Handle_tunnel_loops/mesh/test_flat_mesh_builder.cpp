// The arrays of a mesh are what their definition says, and the same for any execution.

#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Unit_box.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace test_flat_mesh_builder {

using namespace CGAL::Handle_tunnel_loops::internal;
using generators::Random;

Flat_mesh flat_mesh_of(Execution execution, const Mesh& mesh) {
  const auto index = get(boost::vertex_index, mesh);
  const auto point = get(CGAL::vertex_point, mesh);
  return Flat_mesh_builder<Mesh, std::decay_t<decltype(index)>, std::decay_t<decltype(point)>>(
             execution, mesh, index, point)
      .build();
}

// ---- pieces

struct Item
{
  std::uint32_t key;
  std::size_t number;

  friend bool operator==(const Item& a, const Item& b) {
    return a.key == b.key && a.number == b.number;
  }
};

template <unsigned bits> void expect_sorted(Execution execution, std::size_t n, Random& random) {
  Uninitialized_vector<Item> items;
  const std::uint32_t bound = 1 + static_cast<std::uint32_t>(random.below(std::size_t(1) << bits));
  for(std::size_t i = 0; i < n; ++i)
    items.push_back({static_cast<std::uint32_t>(random.below(bound)), i});
  Uninitialized_vector<Item> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const Item& a, const Item& b) { return a.key < b.key; });
  radix_sort<bits>(execution, items, [](const Item& item) { return item.key; });
  EXPECT_TRUE(items == expected) << n << " items below " << bound;
}

TEST(Radix_sort, IsAStableSort) {
  Random random(1);
  for(const std::size_t n : {0u, 1u, 2u, 100u, 65535u, 65536u, 65537u, 300000u}) {
    expect_sorted<8>(Execution(), n, random);
    expect_sorted<30>(Execution(), n, random);
    expect_sorted<30>(Execution::parallel(), n, random);
  }
}

TEST(Sum_before_each, IsThatSum) {
  Random random(2);
  for(const std::size_t n : {0u, 1u, 10u, 20u, 21u, 1000u}) {
    std::vector<std::uint32_t> numbers(n), expected(n);
    for(auto& x : numbers)
      x = static_cast<std::uint32_t>(random.below((std::size_t(1) << 32) / (n + 1)));
    std::uint32_t sum = 0;
    for(std::size_t i = 0; i < n; ++i) {
      expected[i] = sum;
      sum += numbers[i];
    }
    EXPECT_EQ(sum_before_each(Execution::parallel(), numbers, 10), sum);
    EXPECT_EQ(numbers, expected);
  }
}

TEST(Unit_box, KeepsTheShape) {
  const Uninitialized_vector<Vector> points = {{-1., 5., 2.}, {3., 5., 2.5}, {1., 5., 4.}};
  const Unit_box box(Execution(), points);
  EXPECT_EQ(box.half_scale(), 2.);
  EXPECT_EQ(box(points[0]), (Vector{0., 0., 0.}));
  EXPECT_EQ(box(points[1]), (Vector{1., 0., 0.125}));
  EXPECT_EQ(box(points[2]), (Vector{0.5, 0., 0.5}));
}

// ---- the whole

// The cell of a point of the unit box on the Morton curve, bit by bit.
std::uint32_t cell_of(const Vector& p) {
  std::uint32_t cell = 0;
  for(int bit = 0; bit < 10; ++bit)
    for(int d = 0; d < 3; ++d)
      cell |= (static_cast<std::uint32_t>(p[d] * 1023.) >> bit & 1u) << (3 * bit + d);
  return cell;
}

void expect_sorted_along_curve(const Flat_mesh& flat) {
  for(std::size_t i = 1; i < flat.number_of_vertices(); ++i) {
    const auto before = cell_of(flat.points[i - 1]), after = cell_of(flat.points[i]);
    ASSERT_TRUE(before < after || (before == after && flat.original[i - 1] < flat.original[i]));
  }
}

void expect_rings_of(const Mesh& mesh, const Flat_mesh& flat) {
  ASSERT_EQ(flat.neighbor.size(), mesh.number_of_halfedges());
  for(Index i = 0; i < flat.number_of_vertices(); ++i) {
    const Mesh::Vertex_index v(flat.original[i]);
    const Ring ring = flat.ring(i);
    Mesh::Halfedge_index h = mesh.halfedge(v);
    for(const Index u : ring) {
      ASSERT_EQ(flat.original[u], mesh.source(h));
      h = mesh.prev(mesh.opposite(h));
    }
    ASSERT_EQ(h, mesh.halfedge(v));
  }
}

// Components are numbered, and have their seeds, by the smallest caller's index.
void expect_components_of(const Flat_mesh& flat) {
  std::vector<Index> component(flat.number_of_vertices(), no_index), by_caller(component.size());
  std::vector<Index> seeds;
  std::iota(by_caller.begin(), by_caller.end(), 0);
  std::sort(by_caller.begin(), by_caller.end(),
            [&](Index a, Index b) { return flat.original[a] < flat.original[b]; });
  for(const Index first : by_caller)
    if(component[first] == no_index) {
      std::vector<Index> queue(1, first);
      component[first] = static_cast<Index>(seeds.size());
      seeds.push_back(first);
      for(std::size_t q = 0; q < queue.size(); ++q)
        for(const Index u : flat.ring(queue[q]))
          if(component[u] == no_index) {
            component[u] = component[first];
            queue.push_back(u);
          }
    }
  EXPECT_EQ(flat.seeds, seeds);
  EXPECT_TRUE(
      std::equal(component.begin(), component.end(), flat.component.begin(), flat.component.end()));
}

void expect_flat_mesh_of(const Mesh& mesh, std::size_t genus) {
  const Flat_mesh flat = flat_mesh_of(Execution(), mesh);
  const Flat_mesh other = flat_mesh_of(Execution::parallel(), mesh);
  EXPECT_EQ(flat.genus, genus);
  expect_sorted_along_curve(flat);
  expect_rings_of(mesh, flat);
  expect_components_of(flat);
  EXPECT_TRUE(flat.points == other.points && flat.row_begin == other.row_begin &&
              flat.neighbor == other.neighbor && flat.original == other.original &&
              flat.component == other.component && flat.seeds == other.seeds);
}

TEST(Flat_mesh_builder, MakesWhatIsDefined) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 5}, 2)) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Soup soup = soup_of(recipe);
    expect_flat_mesh_of(mesh_of(soup), recipe.request.genus);
    expect_flat_mesh_of(mesh_of(generators::permute_vertices(soup, 3)), recipe.request.genus);
  }
}

TEST(Flat_mesh_builder, NumbersComponentsByTheirFirstVertex) {
  Random random(4);
  for(int i = 0; i < 20; ++i) {
    std::vector<Soup> soups;
    std::size_t genus = 0;
    for(std::size_t k = 1 + random.below(30); k > 0; --k) {
      const std::size_t g = random.below(3);
      genus += g;
      soups.push_back(soup_of({"random", {30 + 12 * g, g, static_cast<unsigned>(random.next())}}));
    }
    expect_flat_mesh_of(mesh_of(generators::permute_vertices(generators::disjoint_union(soups), 5)),
                        genus);
  }
}

// So many that they are several ranges of every kind, in a good order and in a bad one, and in one
// place, where there is no order along a curve.
TEST(Flat_mesh_builder, MakesLargeMeshes) {
  Soup soup = generators::disjoint_union(
      {soup_of({"torus", {140000, 1, 0}}), soup_of({"multi-torus", {20000, 3, 0}})});
  expect_flat_mesh_of(mesh_of(soup), 4);
  expect_flat_mesh_of(mesh_of(generators::permute_vertices(soup, 6)), 4);
  expect_flat_mesh_of(mesh_of(transformed(generators::permute_vertices(soup, 7), 0., 1.)), 4);
}

// Of vertices with many neighbours by a table, however they are asked for.
TEST(Flat_mesh_builder, KnowsThePositionsOfNeighbors) {
  const Flat_mesh mesh = flat_mesh_of(Execution(), mesh_of({"hubs", {4000, 5, 0}}));
  std::size_t in_long_rings = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    for(Index p = 0; p < ring.size(); ++p)
      EXPECT_EQ(mesh.position(v, ring[p]), p);
    EXPECT_EQ(mesh.position(v, v), ring.size());
    in_long_rings += ring.size() > many_neighbors ? ring.size() : 0;
  }
  EXPECT_GT(in_long_rings, mesh.neighbor.size() / 8);
  EXPECT_EQ(mesh.places_in_long_rings.size(), in_long_rings);
}

TEST(Flat_mesh_builder, LeavesOutWhatIsRemovedOrIsolated) {
  Soup soup = soup_of({"multi-torus", {2000, 3, 0}});
  soup.points.insert(soup.points.begin() + 100, {5., 5., 5.});
  for(auto& triangle : soup.triangles)
    for(auto& corner : triangle)
      corner += corner >= 100;
  Mesh mesh = mesh_of(soup);
  expect_flat_mesh_of(mesh, 3);
  mesh.remove_vertex(Mesh::Vertex_index(100));
  mesh.add_vertex({7., 7., 7.});
  expect_flat_mesh_of(mesh, 3);
}

} // namespace test_flat_mesh_builder
