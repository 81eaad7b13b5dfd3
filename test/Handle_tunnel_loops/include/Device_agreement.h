#ifndef HTL_TEST_DEVICE_AGREEMENT_H
#define HTL_TEST_DEVICE_AGREEMENT_H

#include "Flat_mesh_of_soup.h"
#include "Layer_definitions.h"
#include "Same_events.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Host_backend.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <vector>

// What a device computes is what the host's own passes compute: the same times, the same handles,
// the same layers, the same walks. And its fronts have the components that they have.

namespace CGAL::Handle_tunnel_loops::internal {

inline bool operator==(const Crossing& a, const Crossing& b) {
  return a.left == b.left && a.right == b.right && a.ratio == b.ratio;
}
inline std::ostream& operator<<(std::ostream& os, const Crossing& c) {
  return os << c.left << '|' << c.right << '@' << c.ratio;
}
inline bool operator==(const Handle_candidate& a, const Handle_candidate& b) {
  return a.loop == b.loop && a.saddle == b.saddle && a.foot_a == b.foot_a && a.foot_b == b.foot_b;
}
inline std::ostream& operator<<(std::ostream& os, const Handle_candidate& handle) {
  return os << "saddle " << handle.saddle << " feet " << handle.foot_a << ' ' << handle.foot_b
            << ", " << handle.loop.size() << " crossings";
}

} // namespace CGAL::Handle_tunnel_loops::internal

namespace device_agreement {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::Field_constants;
using generators::Random;

const auto go_on = [](double) { return true; };

inline std::vector<Crossing_loop> loops_of(const std::vector<Handle_candidate>& handles) {
  std::vector<Crossing_loop> loops;
  for(const Handle_candidate& handle : handles)
    loops.push_back(handle.loop);
  return loops;
}

inline std::vector<Index> first_numbers(std::size_t n) {
  std::vector<Index> numbers(n);
  std::iota(numbers.begin(), numbers.end(), Index(0));
  return numbers;
}

// What the passes of a mesh came to, to see that the tests test something.
struct Tally
{
  std::size_t walks = 0, given_up = 0;

  void add(const std::vector<Dual_walks>& all) {
    for(const Dual_walks& found : all) {
      walks += found.walks.size();
      given_up += found.walks.empty() && found.has_given_up;
    }
  }
};

inline std::vector<Dual_walks> expect_same(device::Solver& solver,
                                           Host_backend& host,
                                           const Step_coefficients& k,
                                           const Dual_loop_query& query) {
  const std::vector<Dual_walks> found = solver.dual_walks(query, k, go_on);
  const std::vector<Dual_walks> expected = host.dual_walks(query, k, go_on);
  EXPECT_EQ(expected.size(), query.numbers.size());
  EXPECT_EQ(found.size(), expected.size());
  for(std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].walks, expected[i].walks);
    if(expected[i].walks.empty()) {
      EXPECT_EQ(found[i].has_given_up, expected[i].has_given_up);
    }
  }
  return found;
}

// All passes on a mesh, one after the other.
inline Tally expect_agreement(device::Solver& solver,
                              const Flat_mesh& mesh,
                              Index seed,
                              const Field_constants& c) {
  const Step_coefficients k = step_coefficients(c), searching = coefficients_for_searching(k);
  Host_backend host(Execution(), mesh);
  const std::vector<Handle_candidate> handles = solver.initial_field({seed}, k, go_on);
  EXPECT_EQ(handles, host.initial_field({seed}, k, go_on));
  EXPECT_EQ(solver.arrival_times(), host.arrival_times());
  EXPECT_EQ(handles.size(), mesh.genus);
  const Front_log log = solver.front_log();
  layer_definitions::expect_layers(log, mesh, host.arrival_times());
  EXPECT_EQ(log.layer, host.front_log().layer);
  EXPECT_EQ(log.events, host.front_log().events);

  const std::vector<Crossing_loop> contours = loops_of(handles);
  const Crossing_index index(mesh, contours);
  EXPECT_EQ(solver.times_from_loops(contours, index, searching),
            host.times_from_loops(contours, index, searching));
  // One of them twice, and one beside another.
  const std::vector<Index> vertices = {mesh.ring(seed)[0], seed, mesh.seeds[0], seed};
  EXPECT_EQ(solver.times_from_vertices(vertices, k, go_on),
            host.times_from_vertices(vertices, k, go_on));
  const std::vector<Index> all = first_numbers(contours.size());
  Tally tally;
  for(const std::uint64_t updates : {100u, 3000u})
    tally.add(expect_same(solver, host, searching, {contours, index, false, all, 1, {}, updates}));
  const std::vector<Dual_walks> tunnels =
      expect_same(solver, host, searching, {contours, index, false, all});
  tally.add(tunnels);
  std::vector<Crossing_loop> loops;
  std::vector<Time> steps;
  for(const Dual_walks& found : tunnels)
    if(!found.walks.empty()) {
      loops.push_back(pushed_left(mesh, found.walks.front()));
      steps.push_back(static_cast<Time>(20 + loops.back().size()));
    }
  const Crossing_index tunnel_index(mesh, loops);
  tally.add(expect_same(solver, host, searching,
                        {loops, tunnel_index, true, first_numbers(loops.size()), 6, steps}));
  return tally;
}

// ---- the labels of a front

// A triangle by the least of its three places in the rings, and that place for each of them.
inline std::vector<Index> triangle_of_places(const Flat_mesh& mesh) {
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

// The labels of a few fronts of a sweep: `label(times, level)` is what finds them.
template <typename Label>
void expect_front_labels(const Flat_mesh& mesh, Random& random, const Label& label) {
  Host_backend host(Execution(), mesh);
  host.initial_field({0}, step_coefficients({}), go_on);
  const std::vector<Time> times = host.arrival_times();
  for(int i = 0; i < 5; ++i) {
    const Time level = times[random.below(times.size())];
    SCOPED_TRACE(testing::Message() << "level " << level);
    Front_graph(mesh, times, level).expect_labels(label(times, level));
  }
}

} // namespace device_agreement

#endif // HTL_TEST_DEVICE_AGREEMENT_H
