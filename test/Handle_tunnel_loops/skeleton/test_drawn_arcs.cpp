// How arcs of skeletons are drawn: smooth wherever they can be, and one where two are side by side.

#include "Flat_mesh_of_soup.h"

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Arcs_side_by_side.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_draft.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Arc_smoothing.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test_drawn_arcs {

using namespace CGAL::Handle_tunnel_loops::internal;

using Place = std::array<double, 3>;

/// The inside of a prism that stands on a polygon, for segments and distances in it.
struct Prism
{
  Prism(const std::vector<std::array<double, 2>>& polygon, double half_height)
      : mesh(flat_mesh_of(sides_of(polygon, half_height))) {}

  // Its ends are fans of faces around a corner: nothing here comes near them.
  static Soup sides_of(const std::vector<std::array<double, 2>>& polygon, double half_height) {
    Soup soup;
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for(const double z : {-half_height, half_height})
      for(const auto& [x, y] : polygon)
        soup.points.push_back({x, y, z});
    for(std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      soup.triangles.push_back({i, j, n + j});
      soup.triangles.push_back({i, n + j, n + i});
    }
    for(std::uint32_t i = 1; i + 1 < n; ++i) {
      soup.triangles.push_back({0, i + 1, i});
      soup.triangles.push_back({n, n + i, n + i + 1});
    }
    return soup;
  }

  Inner_ball ball(const Place& p) const { return {p, wall.nearest(p, 10.).distance}; }

  Flat_mesh mesh;
  Face_tree faces{Execution(), mesh, span_of(mesh.points)};
  Wall wall{mesh, span_of(mesh.points), faces};
};

/// a graph of balls at places, of which each but the first is joined to one before.
Ball_graph
tree_of(const Prism& prism, const std::vector<Place>& places, const std::vector<Index>& before) {
  Ball_graph graph;
  for(std::size_t i = 0; i < places.size(); ++i) {
    graph.balls.push_back(prism.ball(places[i]));
    graph.component.push_back(0);
    graph.is_inlet.push_back(0);
    if(i > 0)
      graph.edges.push_back({before[i], static_cast<Index>(i)});
  }
  graph.link();
  return graph;
}

std::vector<Place> joints_of(const Skeleton_draft& draft) {
  std::vector<Place> joints;
  for(const Index joint : draft.joints())
    joints.push_back(draft[joint].ball.centre);
  return joints;
}

// In a long block, from a joint near one end: two arcs to the other end, so far apart there.
std::vector<Place> joints_of_fork(double apart) {
  const Prism block({{{-3, -1}, {12, -1}, {12, 1}, {-3, 1}}}, 1.);
  std::vector<Place> places = {{0, 0, 0}, {-2, 0, 0}};
  std::vector<Index> before = {0, 0};
  for(const double side : {-0.5, 0.5}) {
    before.push_back(0);
    for(int i = 1; i <= 10; ++i) {
      places.push_back({double(i), side * apart * i / 10., 0});
      if(i < 10)
        before.push_back(static_cast<Index>(places.size() - 1));
    }
  }
  const Ball_graph graph = tree_of(block, places, before);
  Skeleton_draft draft(graph, std::vector<char>(graph.edges.size(), 1), {0});
  Arcs_side_by_side(block.wall, 0.1, draft).join();
  return joints_of(draft);
}

TEST(Arcs_side_by_side, AreOneUntilTheyPart) {
  const std::vector<Place> joints = joints_of_fork(1.6);
  ASSERT_EQ(joints.size(), 1u);
  EXPECT_GT(joints[0][0], 4.);
  EXPECT_LT(joints[0][0], 9.);
  EXPECT_NEAR(joints[0][1], 0., 1e-9);
}

TEST(Arcs_side_by_side, AreNotThoseThatLeaveInTwoDirections) {
  const Prism block({{{-3, -9}, {9, -9}, {9, 9}, {-3, 9}}}, 1.);
  std::vector<Place> places = {{0, 0, 0}, {-2, 0, 0}};
  std::vector<Index> before = {0, 0};
  for(const double side : {-1., 1.}) {
    before.push_back(0);
    for(int i = 1; i <= 7; ++i) {
      places.push_back({double(i), side * i, 0});
      if(i < 7)
        before.push_back(static_cast<Index>(places.size() - 1));
    }
  }
  const Ball_graph graph = tree_of(block, places, before);
  Skeleton_draft draft(graph, std::vector<char>(graph.edges.size(), 1), {0});
  Arcs_side_by_side(block.wall, 0.1, draft).join();
  EXPECT_EQ(joints_of(draft), std::vector<Place>(1, Place{0, 0, 0}));
}

// So thin that a part of the radius is lost in coordinates.
TEST(Arcs_side_by_side, DoNotTakeManyStepsInThinSheets) {
  for(const double half_height : {1e-6, 1e-12, 1e-17}) {
    SCOPED_TRACE(half_height);
    const Prism sheet({{{-3, -1}, {12, -1}, {12, 1}, {-3, 1}}}, half_height);
    const std::vector<Place> places = {
        {0.3, 0.3, 0}, {-2, 0.3, 0}, {9, 0.3, 0}, {10, 0.3, 0}, {9, 0.6, 0}};
    const Ball_graph graph = tree_of(sheet, places, {0, 0, 0, 0, 0});
    Skeleton_draft draft(graph, std::vector<char>(graph.edges.size(), 1), {0});
    Arcs_side_by_side(sheet.wall, 0.1, draft).join();
    EXPECT_LT(draft.size(), 1000u);
  }
}

// The largest turn at bends from some length on, in radians.
double largest_turn(const std::vector<Inner_ball>& line, double from) {
  double most = 0.;
  for(std::size_t i = 1; i + 1 < line.size(); ++i)
    if(line[i].centre[0] > from) {
      const Place a = line[i].centre - line[i - 1].centre, b = line[i + 1].centre - line[i].centre;
      most = (std::max)(most, std::acos(dot(a, b) / (norm(a) * norm(b))));
    }
  return most;
}

// Closely over a thin wall, from which the middle leads away, and in a zigzag from there on.
TEST(Arc_smoothing, IsOnlyLeftOutWhereItWouldLeaveTheSolid) {
  const Prism hall({{{-3, -1}, {-0.01, -1}, {0, 0.4}, {0.01, -1}, {20, -1}, {20, 1}, {-3, 1}}}, 1.);
  std::vector<Inner_ball> arc = {hall.ball({-2, 0, 0}), hall.ball({-1, 0.41, 0}),
                                 hall.ball({1, 0.41, 0})};
  for(int i = 2; i < 18; ++i)
    arc.push_back(hall.ball({double(i), i % 2 == 0 ? 0.3 : -0.3, 0}));
  const Inner_balls balls(hall.wall, {1});
  constexpr double least_spacing = 2.;
  const std::vector<Inner_ball> line =
      Arc_smoothing(hall.wall, balls, least_spacing, false)(arc, false, false);
  EXPECT_TRUE(is_line_free(hall.wall, line));
  EXPECT_GT(largest_turn(arc, 4.), 1.);
  EXPECT_LT(largest_turn(line, 4.), 0.3);
}

} // namespace test_drawn_arcs
