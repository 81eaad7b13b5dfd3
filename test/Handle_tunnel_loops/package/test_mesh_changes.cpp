// Noise, decimation and remeshing move handles, and neither make nor take away any: there are as
// many loops after them as before, as defined, from whichever vertex the front starts.

#include "Loop_definitions.h"
#include "Mesh_changes.h"
#include "Meshes_of_soups.h"
#include "Number_of_cases.h"

#include "generators/Random.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#endif

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_mesh_changes {

using generators::Random;
using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Exact_pairs = std::vector<CGAL::Handle_tunnel_pair<Exact_mesh>>;

template <typename ConcurrencyTag>
void expect_loops_of_tag(const Exact_mesh& mesh, std::size_t genus, Random& random) {
  Exact_pairs pairs;
  const Exact_mesh::Vertex_index seed(
      static_cast<Exact_mesh::size_type>(random.below(mesh.number_of_vertices())));
  ASSERT_NO_THROW(CGAL::handle_tunnel_loops<ConcurrencyTag>(mesh, std::back_inserter(pairs),
                                                            CGAL::parameters::seed_vertex(seed)))
      << "seed vertex " << seed;
  expect_handle_tunnel_pairs(mesh, pairs, genus);
}

void expect_loops(const Exact_mesh& mesh, std::size_t genus, Random& random) {
  expect_loops_of_tag<CGAL::Sequential_tag>(mesh, genus, random);
#ifdef CGAL_EIGEN3_ENABLED
  expect_loops_of_tag<CGAL::Reference_tag>(mesh, genus, random);
#endif
}

// Those with a genus, that do not cross themselves.
std::vector<Recipe> shapes() {
  std::vector<Recipe> shapes;
  for(const Recipe& recipe : recipes_of_all_kinds({1, 4}, 1))
    if(recipe.kind != "random")
      shapes.push_back(recipe);
  return shapes;
}

class Changed_mesh : public testing::Test
{
protected:
  // Of each shape, several changes of a kind.
  template <typename Change> void expect_loops_of_changed(int number, const Change& change) {
    Random random(1);
    for(const Recipe& recipe : shapes()) {
      const Exact_mesh mesh = mesh_of<Exact_mesh>(soup_of(recipe));
      for(int i = 0; i < number_of_cases(number); ++i) {
        SCOPED_TRACE(testing::Message() << recipe << ", change " << i);
        expect_loops(change(mesh, random), recipe.request.genus, random);
      }
    }
  }
};

TEST_F(Changed_mesh, HasTheSameHandlesWithNoise) {
  expect_loops_of_changed(6, [](const Exact_mesh& mesh, Random& random) {
    // Beyond an edge or so most cross themselves.
    return mesh_changes::with_noise(mesh, random.uniform(0., random.below(2) == 0 ? 0.3 : 4.),
                                    static_cast<unsigned>(random.next()));
  });
}

TEST_F(Changed_mesh, HasTheSameHandlesWithFewerFaces) {
  expect_loops_of_changed(3, [](const Exact_mesh& mesh, Random& random) {
    const Exact_mesh changed = mesh_changes::decimated(mesh, random.uniform(0.01, 0.6));
    EXPECT_LT(changed.number_of_faces(), mesh.number_of_faces());
    return changed;
  });
}

TEST_F(Changed_mesh, HasTheSameHandlesWithOtherFaces) {
  expect_loops_of_changed(1, [](const Exact_mesh& mesh, Random& random) {
    return mesh_changes::graded(mesh, random.uniform(1., 2.), random.uniform(0.5, 1.));
  });
  expect_loops_of_changed(1, [](const Exact_mesh& mesh, Random& random) {
    return mesh_changes::stretched(mesh, random.uniform(1., 16.));
  });
}

} // namespace test_mesh_changes
