#ifndef HTL_TEST_LAYER_DEFINITIONS_H
#define HTL_TEST_LAYER_DEFINITIONS_H

#include "Reeb_by_levels.h"

#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

// What the layers of a sweep are: between two events each contour of a level is the front of one
// layer, and each layer that has begun and not ended has one front. So the layers are the arcs of
// the Reeb graph, which the host's own sweep finds by labels that it moves along with the contours.

namespace layer_definitions {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::Front_event;
using CGAL::Handle_tunnel_loops::Front_event_type;

inline Sweep_order order_of(const Flat_mesh& mesh, const std::vector<Time>& times) {
  return Sweep_order(Execution(), mesh, [&](Index v) { return times[v]; });
}

inline std::size_t number_of(const Front_log& log, Front_event_type type) {
  return std::count_if(log.events.begin(), log.events.end(),
                       [type](const Front_event& event) { return event.type == type; });
}

// The vertices at which the layers begin and end.
struct Spans
{
  std::vector<Index> begin, end; // by layer; the first one is none
};

// Layers are numbered as they begin, each ends once, and only with minima do they begin without an
// event.
inline Spans spans_of(const Front_log& log, const Flat_mesh& mesh, const Sweep_order& order) {
  std::map<std::size_t, Index> begin, end;
  std::size_t last = 0;
  const auto begin_minima_before = [&](Index rank, Index& next) {
    for(; next < rank; ++next) {
      const Index v = order.vertices()[next];
      const Ring ring = mesh.ring(v);
      if(std::all_of(ring.begin(), ring.end(), [&](Index u) { return order.rank(u) > next; }))
        begin[++last] = v;
    }
  };
  Index next = 0;
  for(const Front_event& event : log.events) {
    const Index v = static_cast<Index>(event.vertex);
    EXPECT_LE(next, order.rank(v) + 1) << "events are not in the order of arrival";
    begin_minima_before(order.rank(v), next);
    for(const Front_event::Front& front : event.before) {
      EXPECT_EQ(begin.count(front.layer), 1u) << "a layer ends that has not begun";
      EXPECT_TRUE(end.insert({front.layer, v}).second) << "a layer ends twice";
    }
    for(const Front_event::Front& front : event.after) {
      EXPECT_EQ(front.layer, ++last);
      begin[front.layer] = v;
    }
  }
  EXPECT_EQ(begin.size(), end.size());
  Spans spans = {{no_index}, {no_index}};
  for(std::size_t layer = 1; layer <= last; ++layer) {
    spans.begin.push_back(begin[layer]);
    spans.end.push_back(end[layer]);
  }
  return spans;
}

// A surface of genus g that is swept from m minima: g + m - 1 merges, and Euler's formula. (For c
// components of genus g in all, `Flat_mesh_of_soup.h` takes g - c + 1 for the genus.)
inline void expect_counts(const Front_log& log, const Flat_mesh& mesh, std::size_t minima) {
  const std::size_t splits = number_of(log, Front_event_type::SPLIT);
  const std::size_t merges = number_of(log, Front_event_type::MERGE);
  const std::size_t closings = number_of(log, Front_event_type::CLOSING);
  EXPECT_EQ(merges + 1, mesh.genus + minima);
  EXPECT_EQ(splits + minima, merges + closings);
  EXPECT_EQ(splits + merges + closings, log.events.size());
  for(const Front_event& event : log.events) {
    EXPECT_EQ(event.before.size(), event.type == Front_event_type::MERGE ? 2u : 1u);
    EXPECT_EQ(event.after.size(), event.type == Front_event_type::SPLIT   ? 2u
                                  : event.type == Front_event_type::MERGE ? 1u
                                                                          : 0u);
  }
}

inline std::set<Index> minima_of(const Flat_mesh& mesh, const Sweep_order& order) {
  std::set<Index> minima;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    if(std::all_of(ring.begin(), ring.end(),
                   [&](Index u) { return order.rank(u) > order.rank(v); }))
      minima.insert(v);
  }
  return minima;
}

// Two partitions are one up to the names of their parts.
template <typename A, typename B> void expect_same_parts(const A& a, const B& b) {
  ASSERT_EQ(a.size(), b.size());
  std::map<Index, Index> b_of_a, a_of_b;
  for(std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(b_of_a.insert({a[i], b[i]}).first->second, b[i]) << "vertex " << i;
    EXPECT_EQ(a_of_b.insert({b[i], a[i]}).first->second, a[i]) << "vertex " << i;
  }
}

// Layers are the arcs that the host finds, and arcs are numbered as they begin there too.
inline void
expect_arcs_of_host(const Front_log& log, const Flat_mesh& mesh, const Sweep_order& order) {
  const std::vector<Star> stars = sweep_stars(Execution(), mesh, order);
  Reeb_sweep sweep(mesh, order, stars, (std::numeric_limits<std::uint64_t>::max)(), 0.01);
  const Flat_reeb_graph graph = sweep.run();
  expect_same_parts(log.layer, graph.vertex_arc);
  const Spans spans = spans_of(log, mesh, order);
  ASSERT_EQ(spans.begin.size(), graph.arcs.size() + 1);
  for(std::size_t a = 0; a < graph.arcs.size(); ++a)
    EXPECT_EQ(graph.nodes[graph.arcs[a].lower].vertex, spans.begin[a + 1]);
}

// The arcs as the levels between all vertices give them; takes quadratic time.
inline void
expect_arcs_of_levels(const Front_log& log, const Flat_mesh& mesh, const Sweep_order& order) {
  const Spans spans = spans_of(log, mesh, order);
  std::vector<std::vector<Index>> vertices(spans.begin.size());
  std::set<Index> critical = minima_of(mesh, order);
  for(const Front_event& event : log.events)
    critical.insert(static_cast<Index>(event.vertex));
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    if(critical.count(v) == 0)
      vertices.at(log.layer[v]).push_back(v);
  std::vector<reeb_by_levels::Arc> arcs;
  for(std::size_t layer = 1; layer < spans.begin.size(); ++layer)
    if(spans.begin[layer] != spans.end[layer])
      arcs.push_back({spans.begin[layer], spans.end[layer], vertices[layer]});
  std::sort(arcs.begin(), arcs.end());
  EXPECT_EQ(arcs, reeb_by_levels::reeb_arcs(mesh, order));
}

using Edge = std::pair<Index, Index>; // the earlier end first

// The contours just above a vertex: the edges that are crossed, joined across triangles.
class Contours_above
{
public:
  Contours_above(const Flat_mesh& mesh, const Sweep_order& order, Index rank) {
    for(Index u = 0; u < mesh.number_of_vertices(); ++u)
      for(const Index w : mesh.ring(u))
        if(order.rank(u) <= rank && order.rank(w) > rank)
          number_.insert({{u, w}, number_.size()});
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(number_.size());
    next_.resize(number_.size());
    for(const auto& [edge, i] : number_) {
      const Index apex = mesh.ring(edge.first).after(edge.second);
      next_[i] = order.rank(apex) <= rank ? Edge(apex, edge.second) : Edge(edge.first, apex);
      add_edge(i, number_.at(next_[i]), graph);
    }
    component_.resize(number_.size());
    number_of_components_ = connected_components(graph, component_.data());
  }

  std::size_t number_of_components() const { return number_of_components_; }

  // calls f(edge, contour) for the crossed edges.
  template <typename Function> void for_each(const Function& f) const {
    for(const auto& [edge, i] : number_)
      f(edge, component_[i]);
  }

  // The lengths of the contours that come to the star of a vertex, from the shortest to the
  // longest.
  template <typename PositionOf>
  std::vector<double> lengths_at(Index v, const PositionOf& position_of) const {
    std::map<std::size_t, double> length;
    for_each([&](const Edge& edge, std::size_t contour) {
      if(edge.first == v || edge.second == v)
        length[contour] = 0.;
    });
    for(const auto& [edge, i] : number_)
      if(length.count(component_[i]) != 0)
        length[component_[i]] += norm(position_of(next_[i]) - position_of(edge));
    std::vector<double> sorted;
    for(const auto& contour : length)
      sorted.push_back(contour.second);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

private:
  std::map<Edge, std::size_t> number_;
  std::vector<Edge> next_;
  std::vector<std::size_t> component_;
  std::size_t number_of_components_;
};

// Just above each event there are as many contours as layers; an edge whose ends lie in one layer,
// and not where others begin or end, is crossed by the front of that layer, which is always the
// same contour.
inline void
expect_fronts_at_events(const Front_log& log, const Flat_mesh& mesh, const Sweep_order& order) {
  const Spans spans = spans_of(log, mesh, order);
  std::set<Index> critical = minima_of(mesh, order);
  for(const Front_event& event : log.events)
    critical.insert(static_cast<Index>(event.vertex));
  for(const Front_event& event : log.events) {
    const Index rank = order.rank(static_cast<Index>(event.vertex));
    const Contours_above contours(mesh, order, rank);
    std::size_t number_of_layers = 0;
    for(std::size_t layer = 1; layer < spans.begin.size(); ++layer)
      number_of_layers +=
          order.rank(spans.begin[layer]) <= rank && order.rank(spans.end[layer]) > rank;
    EXPECT_EQ(contours.number_of_components(), number_of_layers);
    std::map<Index, std::size_t> contour_of_layer;
    std::map<std::size_t, Index> layer_of_contour;
    contours.for_each([&](const Edge& edge, std::size_t contour) {
      const Index layer = log.layer[edge.first];
      if(layer != log.layer[edge.second] || critical.count(edge.first) != 0)
        return;
      EXPECT_EQ(contour_of_layer.insert({layer, contour}).first->second, contour);
      EXPECT_EQ(layer_of_contour.insert({contour, layer}).first->second, layer);
    });
  }
}

inline void expect_lengths(const std::vector<Front_event::Front>& fronts,
                           const std::vector<double>& expected,
                           double tolerance) {
  std::vector<double> lengths;
  for(const Front_event::Front& front : fronts)
    lengths.push_back(front.length);
  std::sort(lengths.begin(), lengths.end());
  ASSERT_EQ(lengths.size(), expected.size());
  for(std::size_t i = 0; i < lengths.size(); ++i)
    EXPECT_NEAR(lengths[i], expected[i], tolerance + 1e-9 * expected[i]);
}

// The lengths of the contours below and above the vertices at which one thing happens. Above, a
// front may pass such a vertex on either side.
inline void
expect_lengths(const Front_log& log, const Flat_mesh& mesh, const std::vector<Time>& times) {
  const Sweep_order order = order_of(mesh, times);
  std::map<std::size_t, int> number_of_events;
  for(const Front_event& event : log.events)
    ++number_of_events[event.vertex];
  for(const Front_event& event : log.events) {
    const Index v = static_cast<Index>(event.vertex);
    if(number_of_events[v] > 1)
      continue;
    const auto position_of = [&](const Edge& edge) {
      const auto [u, w] = edge;
      return position(mesh, w == v   ? Crossing{u, w, largest_ratio}
                            : u == v ? Crossing{u, w, smallest_ratio}
                                     : contour_crossing(u, w, times[u], times[w], times[v]));
    };
    const Contours_above below(mesh, order, order.rank(v) - 1), above(mesh, order, order.rank(v));
    expect_lengths(event.before, below.lengths_at(v, position_of), 0.);
    double size_of_star = 0.;
    for(const Index u : mesh.ring(v))
      size_of_star += mesh.edge_length(u, v);
    expect_lengths(event.after, above.lengths_at(v, position_of), 0.05 * size_of_star);
  }
}

// All that holds whatever the order is.
inline void
expect_layers(const Front_log& log, const Flat_mesh& mesh, const std::vector<Time>& times) {
  const Sweep_order order = order_of(mesh, times);
  expect_counts(log, mesh, minima_of(mesh, order).size());
  expect_arcs_of_host(log, mesh, order);
  for(const Front_event& event : log.events)
    EXPECT_EQ(event.step, step_of(times[event.vertex]));
}

} // namespace layer_definitions

#endif // HTL_TEST_LAYER_DEFINITIONS_H
