// The layers of a sweep and the events of its fronts, as the device's code finds them.

#include "Layer_definitions.h"
#include "Lower_components.h"
#include "Orders.h"
#include "Random_growth.h"
#include "random_input.h"

#include "Host_executor.h"
#include <CGAL/Handle_tunnel_loops/internal/field/Front_layers.h>
#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

namespace test_front_layers {

using namespace layer_definitions;
using generators::Random;

class Layers : public testing::TestWithParam<Order>
{
protected:
  Front_log found(const Flat_mesh& mesh, const std::vector<Time>& times) const {
    Host_executor executor(GetParam());
    const Span<const Time> span(times.data(), times.size());
    return Front_layers<Host_executor>(executor, mesh, view_of(mesh), span).run();
  }

  // How many of a number of meshes there is time for.
  int share(int number) const { return GetParam() == Order::THREADS ? (number + 9) / 10 : number; }
};

INSTANTIATE_TEST_SUITE_P(Orders, Layers, all_orders(), name_of_order);

Recipe small_recipe(Random& random) {
  const std::size_t genus = random.below(6);
  return {"random",
          {20 + 12 * genus + random.below(100), genus, static_cast<unsigned>(random.next())}};
}

// With few different times there are large plateaus; minima are anywhere.
std::vector<Time> random_times(const Flat_mesh& mesh, Random& random, std::size_t number) {
  std::vector<Time> times(mesh.number_of_vertices());
  for(Time& time : times)
    time = static_cast<Time>(random.below(number));
  return times;
}

TEST_P(Layers, AreTheContoursOfTheLevels) {
  Random random(1);
  std::size_t merges = 0;
  for(int i = 0; i < share(300); ++i) {
    const Recipe recipe = small_recipe(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::size_t width = i % 3 == 0 ? 1 : 1 + random.below(50);
    SCOPED_TRACE(testing::Message() << recipe << ", front of " << width);
    const std::vector<Time> times = Random_growth(mesh, random, width).times();
    const Front_log log = found(mesh, times);
    expect_layers(log, mesh, times);
    expect_arcs_of_levels(log, mesh, order_of(mesh, times));
    expect_fronts_at_events(log, mesh, order_of(mesh, times));
    expect_lengths(log, mesh, times);
    merges += number_of(log, Front_event_type::MERGE);
  }
  EXPECT_GT(merges, 20u) << "the meshes are too harmless";
}

TEST_P(Layers, AreTheContoursOfTheLevelsWithAnyNumberOfMinima) {
  Random random(2);
  for(int i = 0; i < share(200); ++i) {
    const Recipe recipe = small_recipe(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::size_t number = i % 3 == 0 ? 3 : 1000000;
    SCOPED_TRACE(testing::Message() << recipe << ", times " << number);
    const std::vector<Time> times = random_times(mesh, random, number);
    const Front_log log = found(mesh, times);
    expect_layers(log, mesh, times);
    expect_arcs_of_levels(log, mesh, order_of(mesh, times));
  }
}

// Both surfaces of a mesh, one beside the other.
Soup together(Soup a, const Soup& b) {
  const auto n = static_cast<Index>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for(const auto& t : b.triangles)
    a.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return a;
}

TEST_P(Layers, AreThoseOfEachComponent) {
  Random random(4);
  for(int i = 0; i < share(50); ++i) {
    Recipe a = small_recipe(random), b = small_recipe(random);
    a.request.genus = b.request.genus = 1 + random.below(3);
    SCOPED_TRACE(testing::Message() << a << " and " << b);
    const Flat_mesh mesh = flat_mesh_of(together(soup_of(a), soup_of(b)));
    const std::vector<Time> times = random_times(mesh, random, 1000);
    const Front_log log = found(mesh, times);
    expect_layers(log, mesh, times);
    expect_arcs_of_levels(log, mesh, order_of(mesh, times));
  }
}

TEST_P(Layers, AreRightInEveryOrderOfTheSmallestTorus) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  std::vector<Time> times(7);
  std::iota(times.begin(), times.end(), 0u);
  int left = share(5040);
  do {
    SCOPED_TRACE(testing::PrintToString(times));
    const Front_log log = found(mesh, times);
    expect_layers(log, mesh, times);
    expect_arcs_of_levels(log, mesh, order_of(mesh, times));
  } while(--left > 0 && std::next_permutation(times.begin(), times.end()));
}

TEST_P(Layers, AreTheArcsOfTheHost) {
  Random random(3);
  Index lower_components = 0;
  for(int i = 0; i < share(300); ++i) {
    const Recipe recipe = random_recipe(random, 12);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const std::size_t width = i % 3 == 0 ? 1 : 1 + random.below(100);
    SCOPED_TRACE(testing::Message() << recipe << ", front of " << width);
    const std::vector<Time> times = Random_growth(mesh, random, width).times();
    expect_layers(found(mesh, times), mesh, times);
    lower_components = (std::max)(lower_components, most_lower_components(mesh, times));
  }
  EXPECT_GE(lower_components, GetParam() == Order::THREADS ? 4u : 5u)
      << "the meshes are too harmless";
}

} // namespace test_front_layers
