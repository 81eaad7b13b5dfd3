// Bulges are what one comes to by narrow places only.

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Bulges.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_bulges {

using namespace CGAL::Handle_tunnel_loops::internal;

// Balls along a line, each beside the next.
Ball_graph line_of(const std::vector<double>& radii) {
  Ball_graph graph;
  for(std::size_t i = 0; i < radii.size(); ++i) {
    graph.balls.push_back({{double(i), 0., 0.}, radii[i]});
    graph.component.push_back(0);
    graph.is_inlet.push_back(0);
    if(i > 0)
      graph.edges.push_back({static_cast<Index>(i - 1), static_cast<Index>(i)});
  }
  graph.link();
  return graph;
}

TEST(Bulges, AreBehindNarrowPlaces) {
  const Ball_graph graph = line_of({1., 0.3, 0.2, 0.8, 0.9, 0.7, 0.65, 0.7});
  EXPECT_EQ(Bulges(graph, {0}).balls(), std::vector<Index>{4});
  EXPECT_EQ(Bulges(graph, {2}).balls(), (std::vector<Index>{0, 4}));
}

TEST(Bulges, AreNotOnTheSkeleton) {
  const Ball_graph graph = line_of({1., 0.3, 0.2, 0.8});
  EXPECT_TRUE(Bulges(graph, {0, 3}).balls().empty());
}

} // namespace test_bulges
