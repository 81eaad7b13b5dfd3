// Of loops that stay as others are replaced, the relations that are kept are those that are found
// anew.

#include "Loops_of_classes.h"
#include "Pure_bases.h"

#include <CGAL/Handle_tunnel_loops/internal/passes/Pair_relations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

namespace test_pair_relations {

using namespace CGAL::Handle_tunnel_loops::internal;

// What is in a matrix.
std::vector<std::tuple<Index, Index, std::int64_t>> entries(const Sparse_matrix& matrix) {
  std::vector<std::tuple<Index, Index, std::int64_t>> all;
  for(const Matrix_entry& e : matrix)
    all.emplace_back(e.row, e.column, e.value);
  return all;
}

void expect_same(const Loop_relations& a, const Loop_relations& b) {
  EXPECT_EQ(entries(a.intersections), entries(b.intersections));
  EXPECT_EQ(entries(a.linking), entries(b.linking));
  EXPECT_EQ(a.problems, b.problems);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.outward, b.outward);
  EXPECT_EQ(a.is_linked, b.is_linked);
}

// A surface with a basis, and others of it.
class Changing_loops
{
public:
  explicit Changing_loops(const Recipe& recipe)
      : soup_(soup_of(recipe))
      , flat_(with_components(flat_mesh_of(soup_)))
      , surface_(flat_, points())
      , loops_(loops_of_basis(soup_)) {}

  const Flat_surface& surface() const { return surface_; }
  std::size_t size() const { return loops_.size(); }
  std::vector<Flat_pair> pairs() const { return pairs_of(loops_); }

  // Some loops are put together with others of their component, and all change their numbers.
  std::vector<Flat_pair> changed(Random& random,
                                 const std::vector<std::size_t>& components,
                                 std::vector<Index>& before) const {
    before.resize(size());
    std::iota(before.begin(), before.end(), Index(0));
    for(std::size_t i = size(); i > 1; --i)
      std::swap(before[i - 1], before[random.below(i)]);
    std::vector<Crossing_loop> loops;
    const std::size_t rarity = 1 + random.below(4);
    for(Index& b : before) {
      const Index i = b, j = static_cast<Index>(random.below(size()));
      if(random.below(rarity) != 0) {
        loops.push_back(loops_[i]);
        continue;
      }
      Class_coordinates row = {{i, random.below(2) == 0 ? 1 : -1}};
      if(i != j && components[i] == components[j])
        row.emplace_back(j, 1);
      std::sort(row.begin(), row.end());
      loops.push_back(combined(flat_, loops_, {row}).front());
      b = no_index;
    }
    return pairs_of(loops);
  }

private:
  static std::vector<Flat_pair> pairs_of(const std::vector<Crossing_loop>& loops) {
    std::vector<Flat_pair> pairs;
    for(std::size_t k = 0; k < loops.size() / 2; ++k)
      pairs.push_back({loops[2 * k], loops[2 * k + 1]});
    return pairs;
  }

  static Flat_mesh with_components(Flat_mesh mesh) {
    std::fill(mesh.component.begin(), mesh.component.end(), no_index);
    mesh.seeds.clear();
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      if(mesh.component[v] != no_index)
        continue;
      const Index component = static_cast<Index>(mesh.seeds.size());
      mesh.seeds.push_back(v);
      mesh.component[v] = component;
      std::vector<Index> queue(1, v);
      for(std::size_t q = 0; q < queue.size(); ++q)
        for(Index u : mesh.ring(queue[q]))
          if(mesh.component[u] == no_index) {
            mesh.component[u] = component;
            queue.push_back(u);
          }
    }
    return mesh;
  }

  std::vector<Flat_surface::Point> points() const {
    std::vector<Flat_surface::Point> points;
    for(const auto& p : soup_.points)
      points.emplace_back(p[0], p[1], p[2]);
    return points;
  }

  Soup soup_;
  Flat_mesh flat_;
  Flat_surface surface_;
  std::vector<Crossing_loop> loops_;
};

TEST(Relations, ThatAreKeptAreThoseFoundAnew) {
  Random random(1);
  std::size_t kept = 0, changed = 0;
  for(const Recipe& recipe : recipes_of_embedded_surfaces()) {
    SCOPED_TRACE(testing::PrintToString(recipe));
    const Changing_loops surface(recipe);
    Pair_relations relations(surface.surface());
    for(int round = 0; round < 15; ++round) {
      Loop_relations known = relations.relate(Execution(), surface.pairs(), true);
      std::vector<Index> before;
      const std::vector<Flat_pair> pairs = surface.changed(random, known.components, before);
      const Loop_relations updated = relations.relate(Execution(), pairs, {known, before});
      expect_same(updated, Pair_relations(surface.surface()).relate(Execution(), pairs, true));
      const auto new_loops = std::count(before.begin(), before.end(), no_index);
      changed += static_cast<std::size_t>(new_loops);
      kept += before.size() - static_cast<std::size_t>(new_loops);
    }
  }
  EXPECT_GT(kept, 500u);
  EXPECT_GT(changed, 300u);
}

// What is near a new loop has to be found: nothing else is counted.
TEST(Relations, OfLoopsFarFromNewOnesAreTakenOver) {
  const Changing_loops surface(Recipe{"lattice", {6000, 12, 1}});
  Pair_relations relations(surface.surface());
  Loop_relations known = relations.relate(Execution(), surface.pairs(), true);
  std::vector<Index> before(surface.size());
  std::iota(before.begin(), before.end(), Index(0));
  before[0] = no_index;
  // A number that is not counted again shows that it has been taken over.
  ASSERT_FALSE(known.linking.empty());
  const Sparse_matrix linking = known.linking;
  for(Matrix_entry& e : known.linking)
    e.value += 1000;
  const Loop_relations updated = relations.relate(Execution(), surface.pairs(), {known, before});
  ASSERT_EQ(updated.linking.size(), linking.size());
  for(std::size_t i = 0; i < linking.size(); ++i) {
    const bool is_of_new = linking[i].row == 0 || linking[i].column == 0;
    EXPECT_EQ(updated.linking[i].value, linking[i].value + (is_of_new ? 0 : 1000));
  }
}

} // namespace test_pair_relations
