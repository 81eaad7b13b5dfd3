// What is written for the device, run on the host in several ways, computes what the host's own
// passes compute: the same times, the same handles, the same walks.

#include "Flat_mesh_of_soup.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/Host_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Device_solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Host_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/device/label_front.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

inline bool operator==(const Crossing& a, const Crossing& b) {
  return a.left == b.left && a.right == b.right && a.ratio == b.ratio;
}
inline std::ostream& operator<<(std::ostream& os, const Crossing& c) {
  return os << c.left << '|' << c.right << '@' << c.ratio;
}
inline bool operator==(const Sweep_handle& a, const Sweep_handle& b) {
  return a.loop == b.loop && a.saddle == b.saddle && a.foot_a == b.foot_a && a.foot_b == b.foot_b;
}
inline std::ostream& operator<<(std::ostream& os, const Sweep_handle& handle) {
  return os << "saddle " << handle.saddle << " feet " << handle.foot_a << ' ' << handle.foot_b
            << ", " << handle.loop.size() << " crossings";
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

namespace {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::Field_constants;
using CGAL::Handle_tunnel_loops::Interrupted_exception;
using CGAL::Handle_tunnel_loops::Stage;
using CGAL::Handle_tunnel_loops::Statistics;
using device::Host_executor;
using generators::Random;
using Passes = Host_passes<Sequential_execution>;
using Solver = device::Device_solver<Host_executor>;
using Order = Host_executor::Order;

const auto go_on = [](double) { return true; };

Field_constants random_constants(Random& random) {
  Field_constants c;
  c.mobility = std::pow(10., random.uniform(-3., 3.));
  c.gradient_coefficient = std::pow(10., random.uniform(-6., 6.));
  c.penalty = std::pow(10., random.uniform(-6., 3.));
  c.driving_force = c.penalty * (1. + std::pow(10., random.uniform(-3., 6.)));
  c.step = random.uniform(0.05, 1.);
  return c;
}

Recipe random_recipe(Random& random, std::size_t largest_genus) {
  const std::size_t genus = random.below(largest_genus + 1);
  return {"random",
          {20 + 12 * genus + random.below(400), genus, static_cast<unsigned>(random.next())}};
}

// Runs passes on the host without anybody looking on.
class Quiet_progress : public Progress
{
public:
  Quiet_progress()
      : Progress(
            {}, [](Stage) {}, [](Stage) {}, statistics_) {}

private:
  Statistics statistics_;
};

std::vector<Crossing_loop> loops_of(const std::vector<Sweep_handle>& handles) {
  std::vector<Crossing_loop> loops;
  for(const Sweep_handle& handle : handles)
    loops.push_back(handle.loop);
  return loops;
}

std::vector<Index> first_numbers(std::size_t n) {
  std::vector<Index> numbers(n);
  std::iota(numbers.begin(), numbers.end(), Index(0));
  return numbers;
}

// What the passes of a mesh came to, to see that the tests test something.
struct Tally
{
  std::size_t walks = 0, given_up = 0;

  void add(const std::vector<Found_walks>& all) {
    for(const Found_walks& found : all) {
      walks += found.walks.size();
      given_up += found.walks.empty() && found.has_given_up;
    }
  }
};

class Device_passes : public testing::TestWithParam<Order>
{
protected:
  // All passes on a mesh, one after the other.
  static Tally expect_agreement(const Flat_mesh& mesh, Index seed, const Field_constants& c) {
    const Step_coefficients k = step_coefficients(c);
    Host_executor executor(GetParam());
    Solver solver(executor, mesh);
    Passes host(mesh, k);
    Quiet_progress progress;
    const std::vector<Sweep_handle> handles = solver.sweep({seed}, k, go_on);
    EXPECT_EQ(handles, host.sweep({seed}, progress));
    EXPECT_EQ(solver.sweep_times(), host.sweep_times());
    EXPECT_EQ(handles.size(), mesh.genus);

    const std::vector<Crossing_loop> contours = loops_of(handles);
    const Crossing_index index(mesh, contours);
    EXPECT_EQ(solver.times_from_loops(contours, index, k), host.times_from_loops(contours, index));
    const std::vector<Index> all = first_numbers(contours.size());
    Tally tally;
    for(const std::uint64_t updates : {100u, 3000u})
      tally.add(expect_same(solver, host, k, {contours, index, false, all, 1, {}, updates}));
    const std::vector<Found_walks> tunnels =
        expect_same(solver, host, k, {contours, index, false, all});
    tally.add(tunnels);
    std::vector<Crossing_loop> loops;
    std::vector<Time> steps;
    for(const Found_walks& found : tunnels)
      if(!found.walks.empty()) {
        loops.push_back(pushed_left(mesh, found.walks.front()));
        steps.push_back(static_cast<Time>(20 + loops.back().size()));
      }
    const Crossing_index tunnel_index(mesh, loops);
    tally.add(expect_same(solver, host, k,
                          {loops, tunnel_index, true, first_numbers(loops.size()), 6, steps}));
    return tally;
  }

  static std::vector<Found_walks> expect_same(Solver& solver,
                                              const Passes& host,
                                              const Step_coefficients& k,
                                              const Loop_search& search) {
    const std::vector<Found_walks> found = solver.search(search, k, go_on);
    EXPECT_EQ(found.size(), search.numbers.size());
    Quiet_progress progress;
    std::size_t i = 0;
    host.search(search, progress, [&](Index number, const Found_walks& expected) {
      EXPECT_EQ(number, search.numbers[i]);
      EXPECT_EQ(found[i].walks, expected.walks);
      if(expected.walks.empty()) {
        EXPECT_EQ(found[i].has_given_up, expected.has_given_up);
      }
      ++i;
    });
    return found;
  }
};

std::string name_of(const testing::TestParamInfo<Order>& info) {
  return info.param == Order::FORWARD ? "forward"
                                      : (info.param == Order::SHUFFLED ? "shuffled" : "threads");
}

INSTANTIATE_TEST_SUITE_P(Orders,
                         Device_passes,
                         testing::Values(Order::FORWARD, Order::SHUFFLED, Order::THREADS),
                         name_of);

TEST_P(Device_passes, AgreeWithTheHostOnSmoothSurfaces) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1)) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Tally tally =
        expect_agreement(mesh, static_cast<Index>(mesh.number_of_vertices() / 2), {});
    EXPECT_GE(tally.walks, 2 * mesh.genus);
    EXPECT_GE(tally.given_up, mesh.genus);
  }
}

TEST_P(Device_passes, AgreeWithTheHostOnRandomSurfaces) {
  Random random(1);
  const int number = GetParam() == Order::THREADS ? 20 : 100;
  for(int i = 0; i < number; ++i) {
    const Recipe recipe = random_recipe(random, 10);
    const Field_constants c = i % 2 == 0 ? Field_constants() : random_constants(random);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    const Index seed = static_cast<Index>(random.below(mesh.number_of_vertices()));
    SCOPED_TRACE(testing::Message() << recipe << ", seed vertex " << seed << ", constants "
                                    << c.mobility << ' ' << c.driving_force << ' '
                                    << c.gradient_coefficient << ' ' << c.penalty << ' ' << c.step);
    expect_agreement(mesh, seed, c);
  }
}

// In so little memory that the passes of a search must run one after the other, they find the same.
TEST_P(Device_passes, DoNotDependOnTheMemory) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"sponge", {3000, 16, 1}});
  const Step_coefficients k = step_coefficients({});
  Host_executor large(GetParam());
  Solver expected(large, mesh);
  const std::vector<Crossing_loop> contours = loops_of(expected.sweep({0}, k, go_on));
  const Crossing_index index(mesh, contours);
  const Loop_search search = {contours, index, false, first_numbers(contours.size()), 1, {}, 30000};
  const std::vector<Found_walks> all = expected.search(search, k, go_on);
  EXPECT_EQ(expected.costs().largest_batch, contours.size());
  std::size_t number_of_batches = 0;
  for(const std::size_t mib : {2, 3}) {
    Host_executor small(GetParam(), mib << 20);
    Solver solver(small, mesh);
    const std::vector<Found_walks> found = solver.search(search, k, go_on);
    ASSERT_EQ(found.size(), all.size());
    for(std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(found[i].walks, all[i].walks);
    number_of_batches += solver.costs().number_of_batches;
    EXPECT_LE(solver.costs().largest_bytes, mib << 20);
  }
  EXPECT_GT(number_of_batches, 4u);
}

// ---- the labels of a front

// A triangle by the least of its three places in the rings, and that place for each of them.
std::vector<Index> triangle_of_places(const Flat_mesh& mesh) {
  std::vector<Index> triangle(mesh.neighbor.size());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    for(Index i = 0; i < ring.size(); ++i) {
      const Index a = ring[i], b = ring[ring.next(i)];
      triangle[mesh.row_begin[v] + i] =
          (std::min)({mesh.row_begin[v] + i, mesh.row_begin[a] + mesh.ring(a).position(b),
                      mesh.row_begin[b] + mesh.ring(b).position(v)});
    }
  }
  return triangle;
}

// The same front by the definition: triangles with vertices on both sides, joined across the edges
// with ends on both sides.
class Front_graph
{
public:
  Front_graph(const Flat_mesh& mesh, const std::vector<Time>& times, Time level)
      : triangle_(triangle_of_places(mesh))
      , graph_(mesh.neighbor.size()) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v);
      for(Index i = 0; i < ring.size(); ++i)
        if((times[v] <= level) != (times[ring[i]] <= level)) {
          is_front_.insert(triangle_[mesh.row_begin[v] + i]);
          add_edge(triangle_[mesh.row_begin[v] + i],
                   triangle_[mesh.row_begin[v] + ring.previous(i)], graph_);
        }
    }
    component_.resize(mesh.neighbor.size());
    connected_components(graph_, component_.data());
  }

  void expect_labels(const std::vector<Index>& labels) const {
    std::set<Index> triangles;
    std::map<Index, Index> component_of_label, least_place;
    std::map<Index, Index> label_of_component;
    for(Index place = 0; place < labels.size(); ++place) {
      if(labels[place] == no_index)
        continue;
      const Index triangle = triangle_[place];
      EXPECT_TRUE(triangles.insert(triangle).second) << "a triangle is labelled twice";
      const Index component = component_[triangle];
      EXPECT_EQ(component_of_label.insert({labels[place], component}).first->second, component);
      EXPECT_EQ(label_of_component.insert({component, labels[place]}).first->second, labels[place]);
      least_place.insert({labels[place], place});
    }
    EXPECT_EQ(triangles, is_front_);
    for(const auto& [label, place] : least_place)
      EXPECT_EQ(label, place);
  }

private:
  std::vector<Index> triangle_; // by place
  std::set<Index> is_front_;
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph_;
  std::vector<Index> component_;
};

TEST_P(Device_passes, LabelFrontsAsConnectedComponents) {
  Random random(3);
  std::vector<Recipe> recipes = recipes_of_all_kinds({0, 1, 5}, 1);
  for(int i = 0; i < 20; ++i)
    recipes.push_back(random_recipe(random, 20));
  for(const Recipe& recipe : recipes) {
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Host_executor executor(GetParam());
    Solver solver(executor, mesh);
    solver.sweep({0}, step_coefficients({}), go_on);
    const std::vector<Time> times = solver.sweep_times();
    for(int i = 0; i < 5; ++i) {
      const Time level = times[random.below(times.size())];
      SCOPED_TRACE(testing::Message() << recipe << ", level " << level);
      const std::vector<Index> labels =
          device::label_front(executor, device::view_of(mesh), {times.data(), times.size()}, level);
      Front_graph(mesh, times, level).expect_labels(labels);
    }
  }
}

TEST_P(Device_passes, StopWhenTheyAreAskedTo) {
  const Flat_mesh mesh = flat_mesh_of(Recipe{"torus", {2000, 1, 0}});
  const Step_coefficients k = step_coefficients({});
  const auto stop = [](double) { return false; };
  Host_executor executor(GetParam());
  Solver solver(executor, mesh);
  EXPECT_THROW(solver.sweep({0}, k, stop), Interrupted_exception);
  const std::vector<Crossing_loop> contours = loops_of(solver.sweep({0}, k, go_on));
  const Crossing_index index(mesh, contours);
  const Loop_search search = {contours, index, false, {0}};
  EXPECT_THROW(solver.search(search, k, stop), Interrupted_exception);
  EXPECT_EQ(solver.search(search, k, go_on)[0].walks.size(), 1u);
  EXPECT_GT(executor.bytes_in_use(), 0u);
}

TEST_P(Device_passes, GiveBackAllMemory) {
  Host_executor executor(GetParam());
  {
    const Flat_mesh mesh = flat_mesh_of(Recipe{"random", {500, 5, 3}});
    expect_agreement(mesh, 0, {});
    Solver solver(executor, mesh);
    solver.sweep({0}, step_coefficients({}), go_on);
    EXPECT_GT(executor.bytes_in_use(), 0u);
  }
  EXPECT_EQ(executor.bytes_in_use(), 0u);
}

} // namespace
