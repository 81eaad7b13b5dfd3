// The parts of the reference solver: each obeys the definitions of the paper, on any mesh.

#include "Crossing_loops.h"
#include "Random_growth.h"
#include "random_input.h"

#include <CGAL/Handle_tunnel_loops/internal/field/Front_layers.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Narrow_band.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Processor_executor.h>
#include <CGAL/Handle_tunnel_loops/internal/field/handle_candidates.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Initial_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Reference_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Streamline.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace test_reference_parts {

using namespace CGAL::Handle_tunnel_loops;
using namespace CGAL::Handle_tunnel_loops::internal;
namespace reference = CGAL::Handle_tunnel_loops::internal::reference;
using reference::Arrivals;
using reference::Initial_pass;
using reference::Surface_point;

const Field_constants constants;

std::size_t count(const std::vector<Front_event>& events, Front_event_type type) {
  return static_cast<std::size_t>(
      std::count_if(events.begin(), events.end(),
                    [type](const Front_event& event) { return event.type == type; }));
}

// ---- the fields

void expect_partition_of_unity(const Eigen::MatrixXd& phi) {
  ASSERT_GE(phi.minCoeff(), 0.);
  ASSERT_LE(phi.maxCoeff(), 1.);
  ASSERT_LE((phi.colwise().sum().array() - 1.).abs().maxCoeff(), 1e-12);
}

TEST(Layered_field, SumsUpToOne) {
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 4}, 1)) {
    SCOPED_TRACE(recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    Initial_pass pass(mesh, constants, mesh.seeds);
    for(int i = 0; !pass.is_done(); ++i) {
      if(i % 8 == 0)
        expect_partition_of_unity(pass.field().phi());
      pass.step();
    }
    expect_partition_of_unity(pass.field().phi());
  }
}

// Section 3 of the paper, term by term, for the fields at one vertex: their values, their
// Laplacians, and which of them are there.
struct Column
{
  Eigen::VectorXd value, laplacian;
  std::vector<Eigen::Index> present;

  Eigen::VectorXd after_a_step(double step) const {
    const auto w = [](auto i, auto j) { return i == j ? 0. : constants.penalty; };
    const auto a2 = [](auto i, auto j) { return i == j ? 0. : constants.gradient_coefficient; };
    const double n = static_cast<double>(present.size());
    Eigen::VectorXd next = value;
    for(const auto i : present)
      for(const auto j : present) {
        if((i == 0) == (j == 0))
          continue; // the mobility is zero
        double sum = 0.;
        for(const auto k : present)
          sum += (w(i, k) - w(j, k)) * value[k] + 0.5 * (a2(i, k) - a2(j, k)) * laplacian[k];
        const double e = j == 0 ? constants.driving_force : -constants.driving_force;
        next[i] -= step * constants.mobility / n * (sum - e * std::sqrt(value[i] * value[j]));
      }
    next = next.cwiseMax(0.).cwiseMin(1.);
    return next / next.sum();
  }
};

// Where several layers are present at once, too.
TEST(Layered_field, FollowsTheEquationOfThePaper) {
  const Flat_mesh mesh = flat_mesh_of({"multi-torus", {1200, 3, 0}});
  Initial_pass pass(mesh, constants, mesh.seeds);
  const double step = 1. / (0.5 * constants.mobility * 4. * constants.gradient_coefficient);
  std::size_t most_layers = 0;
  while(!pass.is_done()) {
    pass.step();
    reference::Layered_field field = pass.field();
    const Eigen::MatrixXd phi = field.phi();
    field.step();
    const Eigen::MatrixXd next = field.phi();
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      const Ring ring = mesh.ring(v);
      Eigen::VectorXd mean = Eigen::VectorXd::Zero(phi.rows());
      for(const Index u : ring)
        mean += phi.col(u) / ring.size();
      Column column = {phi.col(v), 4. * (mean - phi.col(v)), {}};
      for(Eigen::Index i = 0; i < phi.rows(); ++i)
        if(phi(i, v) > 0. || mean[i] > 0.)
          column.present.push_back(i);
      most_layers = (std::max)(most_layers, column.present.size());
      const Ring seed_ring = mesh.ring(mesh.seeds[0]);
      if(v != mesh.seeds[0] && seed_ring.position(v) == seed_ring.size()) {
        ASSERT_LE((column.after_a_step(step) - next.col(v)).cwiseAbs().maxCoeff(), 1e-12);
      }
    }
  }
  EXPECT_GE(most_layers, 4u) << "the fronts never met";
}

// Until a front splits, the field of layers is one field and one minus that.
TEST(Single_field, IsWhatTheLayersAreWhileThereIsOne) {
  const Flat_mesh mesh = flat_mesh_of({"torus", {4000, 1, 0}});
  Initial_pass pass(mesh, constants, mesh.seeds);
  while(pass.tracker().events().empty())
    pass.step();
  const double end = static_cast<double>(pass.tracker().events()[0].step - 1);
  reference::Single_field field(mesh, constants, {});
  field.add_source(mesh.seeds[0]);
  for(const Index u : mesh.ring(mesh.seeds[0]))
    field.add_source(u);
  field.run_until(std::vector<char>(mesh.number_of_vertices(), 0));
  std::size_t number_of_compared = 0;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    if(field.arrivals().time(v) < end) {
      EXPECT_NEAR(field.arrivals().time(v), pass.arrivals().time(v), 1e-9);
      ++number_of_compared;
    }
  EXPECT_GT(number_of_compared, mesh.number_of_vertices() / 10);
}

class Smooth_surface : public testing::TestWithParam<Recipe>
{
protected:
  const Flat_mesh mesh = flat_mesh_of(GetParam());

  // In steps.
  std::vector<double> arrivals_of_narrow_band() const {
    const Stencils stencils(Execution(), mesh);
    Narrow_band band(mesh, stencils, step_coefficients(constants));
    band.add_source(mesh.seeds[0], 0);
    for(const Index u : mesh.ring(mesh.seeds[0]))
      band.add_source(u, 1);
    band.start(No_walls());
    while(band.step(No_walls(), [](Index) {})) {
    }
    std::vector<double> times;
    for(const Time time : band.take_times())
      times.push_back(static_cast<double>(time) / ticks_per_step);
    return times;
  }

  void expect_near(const Arrivals& arrivals,
                   const std::vector<double>& expected,
                   double largest,
                   double mean) const {
    double sum = 0.;
    for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
      EXPECT_NEAR(arrivals.time(v), expected[v], largest);
      sum += std::abs(arrivals.time(v) - expected[v]);
    }
    EXPECT_LE(sum, mean * static_cast<double>(mesh.number_of_vertices()));
  }
};

INSTANTIATE_TEST_SUITE_P(Arrivals,
                         Smooth_surface,
                         testing::Values(Recipe{"torus", {6000, 1, 0}},
                                         Recipe{"multi-torus", {9000, 3, 0}},
                                         Recipe{"knot", {8000, 1, 0}},
                                         Recipe{"sphere", {3000, 0, 0}}),
                         [](const auto& test) {
                           return test.param.kind == "multi-torus" ? "multi_torus"
                                                                   : test.param.kind;
                         });

// The narrow band leaves out nothing but rounding: its ticks, three of them, of 128 a step.
TEST_P(Smooth_surface, HasOneFieldInANarrowBandAndInAllOfTheMesh) {
  reference::Single_field field(mesh, constants, {});
  field.add_source(mesh.seeds[0]);
  for(const Index u : mesh.ring(mesh.seeds[0]))
    field.add_source(u);
  field.run_until(std::vector<char>(mesh.number_of_vertices(), 0));
  expect_near(field.arrivals(), arrivals_of_narrow_band(), 0.05, 0.02);
}

// Where layers meet, the sum over the layers is divided by three, not two, and the front is late by
// about a step; it takes three to pass an edge.
TEST_P(Smooth_surface, HasOneFieldInLayersAndInANarrowBand) {
  Initial_pass pass(mesh, constants, mesh.seeds);
  while(!pass.is_done())
    pass.step();
  expect_near(pass.arrivals(), arrivals_of_narrow_band(), 2., 0.1);
}

// ---- the fronts

// As many closed curves as the region's boundary has pieces, each simple.
void expect_simple_fronts(const Flat_mesh& mesh, const reference::Fronts& fronts) {
  std::vector<std::size_t> size(fronts.number_of_fronts(), 0);
  for(const Crossing& c : fronts.crossings())
    ++size[fronts.front(c)];
  for(const Crossing& c : fronts.crossings()) {
    const Crossing_loop loop = fronts.loop(c);
    ASSERT_EQ(loop.size(), size[fronts.front(c)]);
    expect_crossing_loop(mesh, loop);
  }
}

// Layer by layer the same as the other solvers find, and from the same events; lengths are those of
// other fields.
void expect_layers(const Flat_mesh& mesh,
                   const std::vector<Time>& times,
                   const reference::Front_tracker& tracker) {
  Processor_executor executor((Execution()));
  const Span<const Time> span(times.data(), times.size());
  const Front_log log = Front_layers<Processor_executor>(executor, mesh, view_of(mesh), span).run();
  EXPECT_EQ(tracker.layers_of_vertices(), log.layer);
  const auto layers = [](const std::vector<Front_event::Front>& fronts) {
    std::vector<std::size_t> numbers;
    for(const Front_event::Front& front : fronts)
      numbers.push_back(front.layer);
    return numbers;
  };
  ASSERT_EQ(tracker.events().size(), log.events.size());
  for(std::size_t i = 0; i < log.events.size(); ++i) {
    const Front_event &a = tracker.events()[i], &b = log.events[i];
    EXPECT_EQ(a.type, b.type);
    EXPECT_EQ(a.vertex, b.vertex);
    EXPECT_EQ(layers(a.before), layers(b.before));
    EXPECT_EQ(layers(a.after), layers(b.after));
  }
}

// The same order for the tracker, for a region that is looked at without it, and for the host's
// reading of saddles.
void expect_handles(const Flat_mesh& mesh, const std::vector<Time>& times) {
  const std::vector<double> covered(mesh.number_of_vertices(), 0.);
  std::vector<Index> order(mesh.number_of_vertices());
  for(Index v = 0; v < order.size(); ++v)
    order[times[v]] = v;
  reference::Front_tracker tracker(mesh);
  reference::Covered_region region(mesh);
  for(std::size_t i = 0; i < order.size(); ++i) {
    const Index v = order[i];
    if(i == 0)
      tracker.start(v);
    else
      tracker.cover(v, i, covered);
    region.add(v);
    for(Index run = 1; run < region.number_of_runs(); ++run)
      region.link_next_run();
    if(i % 16 != 0)
      continue;
    const reference::Fronts fronts(region);
    const auto& events = tracker.events();
    ASSERT_EQ(fronts.number_of_fronts(), 1 + count(events, Front_event_type::SPLIT) -
                                             count(events, Front_event_type::MERGE) -
                                             count(events, Front_event_type::CLOSING));
    if(i % 64 == 0)
      expect_simple_fronts(mesh, fronts);
  }

  expect_layers(mesh, times, tracker);
  const Arrival_order arrival_order(times);
  const std::vector<Handle_candidate> handles = find_handle_candidates(Execution(), mesh, times);
  const auto& meetings = tracker.meetings();
  ASSERT_EQ(meetings.size(), mesh.genus);
  ASSERT_EQ(handles.size(), mesh.genus);
  std::vector<Crossing_loop> loops;
  for(std::size_t k = 0; k < meetings.size(); ++k) {
    EXPECT_EQ(meetings[k].saddle, handles[k].saddle);
    expect_crossing_loop(mesh, meetings[k].loop);
    loops.push_back(meetings[k].loop);
  }
  const Crossing_index index(mesh, loops);
  for(const Crossing_loop& loop : loops)
    EXPECT_TRUE(index.intersections(loop).empty()) << "fronts cross";
}

TEST(Front_tracker, FindsAllHandlesInAnyOrder) {
  Random random(11);
  for(int i = 0; i < 300; ++i) {
    const Recipe recipe = random_recipe(random, 11);
    const std::size_t width = i % 3 == 0 ? 1 : 1 + random.below(100);
    SCOPED_TRACE(testing::Message() << recipe << ", front of " << width);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    expect_handles(mesh, Random_growth(mesh, random, width).times());
  }
}

TEST(Front_tracker, FindsAllHandlesOfSmoothSurfaces) {
  Random random(12);
  for(const Recipe& recipe : recipes_of_all_kinds({0, 1, 3}, 1)) {
    SCOPED_TRACE(recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    expect_handles(mesh, Random_growth(mesh, random, 100000).times());
  }
}

TEST(Front_tracker, FindsTheHandleOfTheSmallestTorusInEveryOrder) {
  const Flat_mesh mesh = flat_mesh_of(smallest_torus());
  std::vector<Time> times(7);
  std::iota(times.begin(), times.end(), 0u);
  do {
    SCOPED_TRACE(testing::PrintToString(times));
    expect_handles(mesh, times);
  } while(std::next_permutation(times.begin(), times.end()));
}

// On a mesh that is fine enough, the layers are what the paper says they are: a vertex just behind
// a front belongs to the layer of the front.
TEST(Initial_pass, KeepsTheLayersBehindTheirFronts) {
  const Flat_mesh mesh = flat_mesh_of({"multi-torus", {8000, 2, 0}});
  Initial_pass pass(mesh, constants, mesh.seeds);
  std::size_t right = 0, wrong = 0;
  while(!pass.is_done()) {
    pass.step();
    const Eigen::MatrixXd phi = pass.field().phi();
    pass.tracker().for_each_front_vertex([&](Index v, Index layer) {
      Eigen::Index largest = 0;
      phi.col(v).tail(phi.rows() - 1).maxCoeff(&largest);
      ++(static_cast<Index>(largest + 1) == layer ? right : wrong);
    });
  }
  EXPECT_EQ(pass.tracker().meetings().size(), 2u);
  EXPECT_GT(right, 10000u);
  EXPECT_LT(wrong, right / 1000);
}

// Of two fronts that meet, the shorter one is kept.
TEST(Initial_pass, LeavesOutTheLongestFront) {
  const Flat_mesh mesh = flat_mesh_of({"gyroid", {4000, 6, 0}});
  Initial_pass pass(mesh, constants, mesh.seeds);
  while(!pass.is_done())
    pass.step();
  std::size_t k = 0;
  for(const Front_event& event : pass.tracker().events()) {
    if(event.type != Front_event_type::MERGE)
      continue;
    ASSERT_EQ(event.before.size(), 2u);
    EXPECT_EQ(mesh.in_units_of_caller(length(mesh, pass.tracker().meetings().at(k).loop)),
              (std::min)(event.before[0].length, event.before[1].length));
    ++k;
  }
  EXPECT_EQ(k, mesh.genus);
}

// Fronts of events are those that there are: what begins, ends later in one event.
TEST(Initial_pass, LogsTheLifeOfEachFront) {
  const Flat_mesh mesh = flat_mesh_of({"lattice", {4000, 8, 0}});
  Initial_pass pass(mesh, constants, mesh.seeds);
  while(!pass.is_done())
    pass.step();
  std::vector<int> state(pass.tracker().number_of_layers(), 0);
  state[1] = 1; // the front around the seed
  std::size_t step = 0;
  for(const Front_event& event : pass.tracker().events()) {
    EXPECT_GE(event.step, step);
    step = event.step;
    for(const Front_event::Front& front : event.before) {
      EXPECT_EQ(std::exchange(state[front.layer], 2), 1) << "layer " << front.layer;
      EXPECT_GT(front.length, 0.);
    }
    for(const Front_event::Front& front : event.after)
      EXPECT_EQ(std::exchange(state[front.layer], 1), 0) << "layer " << front.layer;
  }
  for(std::size_t layer = 1; layer < state.size(); ++layer)
    EXPECT_EQ(state[layer], 2) << "layer " << layer;
}

// Two layers that meet in a step are seen to be one after it, whatever else they do meanwhile; a
// layer that splits and comes together again is not.
TEST(Handles_within_steps, AreThoseThatLeaveNoTrace) {
  using Type = Front_event_type;
  const auto number = reference::handles_within_steps;
  const Front_event split = {Type::SPLIT, 5, 0, {{1, 1.}}, {{2, 1.}, {3, 1.}}};
  Front_event merge = {Type::MERGE, 6, 0, {{2, 1.}, {3, 1.}}, {{4, 1.}}};
  const Front_event part = {Type::SPLIT, 6, 0, {{4, 1.}}, {{5, 1.}, {6, 1.}}};
  const Front_event closing = {Type::CLOSING, 6, 0, {{5, 1.}}, {}};
  EXPECT_EQ(number({}), 0u);
  EXPECT_EQ(number({split, merge, part, closing}), 0u);
  const Front_event other = {Type::MERGE, 6, 0, {{6, 1.}, {7, 1.}}, {{8, 1.}}};
  EXPECT_EQ(number({split, merge, part, closing, other}), 0u);
  const Front_event again = {Type::MERGE, 6, 0, {{5, 1.}, {6, 1.}}, {{7, 1.}}};
  EXPECT_EQ(number({split, merge, part, again}), 1u);
  merge.step = 5;
  EXPECT_EQ(number({split, merge}), 1u);
}

// ---- streamlines

bool are_in_one_triangle(const Flat_mesh& mesh, const Surface_point& p, const Surface_point& q) {
  std::vector<Index> corners = {p.a, p.b, q.a, q.b};
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if(corners.size() > 3)
    return false;
  for(const Index u : corners)
    for(const Index v : corners)
      if(u != v && mesh.ring(u).position(v) == mesh.ring(u).size())
        return false;
  return true;
}

TEST(Streamline, LeadsDownToASource) {
  for(const Recipe& recipe : recipes_of_all_kinds({1, 3}, 1)) {
    SCOPED_TRACE(recipe);
    const Flat_mesh mesh = flat_mesh_of(recipe);
    reference::Single_field field(mesh, constants, {});
    field.add_source(0);
    field.run_until(std::vector<char>(mesh.number_of_vertices(), 0));
    const Arrivals& arrivals = field.arrivals();
    const auto time = [&](const Surface_point& p) {
      return (1. - p.ratio) * arrivals.time(p.a) + p.ratio * arrivals.time(p.b);
    };
    for(Index v = 1; v < mesh.number_of_vertices(); v += 7) {
      const std::vector<Surface_point> line = reference::Streamline(mesh, arrivals).trace(v);
      EXPECT_EQ(line.front().a, v);
      EXPECT_EQ(line.back().a, 0u);
      for(std::size_t i = 0; i + 1 < line.size(); ++i) {
        ASSERT_LE(time(line[i + 1]), time(line[i]));
        ASSERT_TRUE(are_in_one_triangle(mesh, line[i], line[i + 1]));
      }
    }
  }
}

// On a sphere the way back is an arc of a great circle, nearly.
TEST(Streamline, IsStraight) {
  const Soup soup = soup_of({"sphere", {5000, 0, 0}});
  const Flat_mesh mesh = flat_mesh_of(soup);
  reference::Single_field field(mesh, constants, {});
  field.add_source(0);
  field.run_until(std::vector<char>(mesh.number_of_vertices(), 0));
  double length = 0., shortest = 0.;
  for(Index v = 1; v < mesh.number_of_vertices(); v += 3) {
    const Vector &p = mesh.points[0], &q = mesh.points[v];
    shortest += norm(p) * std::acos((std::max)(-1., dot(p, q) / (norm(p) * norm(q))));
    Vector last = q;
    for(const Surface_point& place : reference::Streamline(mesh, field.arrivals()).trace(v)) {
      const Vector& a = mesh.points[place.a];
      const Vector next = a + place.ratio * (mesh.points[place.b] - a);
      length += norm(next - last);
      last = next;
    }
  }
  EXPECT_GE(length, 0.99 * shortest); // chords
  EXPECT_LE(length, 1.06 * shortest);
}

TEST(Loop_of_line, PassesWalksOnTheirLeft) {
  Random random(13);
  const Flat_mesh mesh = flat_mesh_of({"random", {300, 4, 1}});
  for(int i = 0; i < 200; ++i) {
    const Vertex_walk walk = random_walk_without_spurs(mesh, random);
    std::vector<Surface_point> line;
    for(const Index v : walk)
      line.push_back(reference::vertex_point(v));
    const Crossing_loop loop = reference::loop_of_line(mesh, line);
    const Crossing_loop expected = pushed_left(mesh, walk);
    ASSERT_EQ(loop.size(), expected.size());
    for(std::size_t j = 0; j < loop.size(); ++j)
      EXPECT_TRUE(loop[j].left == expected[j].left && loop[j].right == expected[j].right);
  }
}

// ---- which handles may be exchanged

// Loops are told apart by their numbers with the first handles and the tunnels; these vectors are a
// basis exactly if their determinant is one or minus one.
class Numbers_of_loops
{
public:
  Numbers_of_loops(Random& random, std::size_t g) {
    const auto small = [&] { return static_cast<int>(random.below(5)) - 2; };
    with_handles.assign(g, std::vector<int>(g, 0));
    with_tunnels = with_handles;
    for(std::size_t i = 0; i < g; ++i) {
      with_handles[i][i] = random.below(2) == 0 ? 1 : -1;
      for(std::size_t j = 0; j < i; ++j) {
        with_handles[i][j] = small();
        with_tunnels[i][j] = small();
        with_tunnels[j][i] = -with_tunnels[i][j];
      }
    }
    for(std::size_t i = 0; i < g; ++i) { // h_i . h_j = 0, h_i . t_j = - t_j . h_i
      rows.emplace_back(2 * g, 0);
      for(std::size_t j = 0; j < g; ++j)
        rows.back()[g + j] = -with_handles[j][i];
    }
    for(std::size_t i = 0; i < g; ++i) {
      rows.emplace_back(with_handles[i].begin(), with_handles[i].end());
      rows.back().insert(rows.back().end(), with_tunnels[i].begin(), with_tunnels[i].end());
    }
  }

  std::vector<std::vector<int>> with_handles, with_tunnels; // of the tunnels
  Integer_matrix rows;                                      // of the handles, then the tunnels
};

TEST(Handle_exchange, AcceptsWhatLeavesABasis) {
  Random random(14);
  int number_of_exchanges = 0;
  for(int i = 0; i < 60; ++i) {
    const std::size_t g = 1 + random.below(5);
    Numbers_of_loops loops(random, g);
    reference::Handle_exchange exchange(loops.with_handles, loops.with_tunnels);
    for(int attempt = 0; attempt < 40; ++attempt) {
      std::vector<int> with_handles(g), with_tunnels(g);
      for(std::size_t j = 0; j < g; ++j) {
        with_handles[j] = static_cast<int>(random.below(3)) - 1;
        with_tunnels[j] = static_cast<int>(random.below(3)) - 1;
      }
      const std::size_t k = random.below(g);
      Integer_matrix changed = loops.rows;
      std::copy(with_handles.begin(), with_handles.end(), changed[k].begin());
      std::copy(with_tunnels.begin(), with_tunnels.end(), changed[k].begin() + g);
      const bool is_basis = abs(determinant(changed)) == 1;
      ASSERT_EQ(exchange.replace(k, with_handles, with_tunnels), is_basis);
      if(is_basis)
        loops.rows = changed;
      number_of_exchanges += is_basis;
    }
  }
  EXPECT_GT(number_of_exchanges, 100);
}

} // namespace test_reference_parts
