// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/skeleton_solver.h"

#include "solve/certification.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/curve_skeleton.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

using Ends = std::array<std::size_t, 2>;

/// Finds the edges of a graph that are no bridges: each edge that is not in a spanning forest
/// closes a cycle with the ways up from its ends, which are then contracted.
class Edges_on_cycles
{
public:
  Edges_on_cycles(const std::vector<Ends>& ends,
                  const std::vector<std::vector<std::size_t>>& edges_at)
      : ends_(ends)
      , edges_at_(edges_at)
      , edge_up_(edges_at.size(), Skeleton_answer::none)
      , depth_(edges_at.size(), Skeleton_answer::none)
      , top_(edges_at.size())
      , is_on_cycle_(ends.size(), 0) {}

  std::vector<char> find() {
    std::iota(top_.begin(), top_.end(), std::size_t(0));
    for(std::size_t point = 0; point < depth_.size(); ++point)
      if(depth_[point] == Skeleton_answer::none)
        add_tree(point);
    for(std::size_t edge = 0; edge < ends_.size(); ++edge)
      if(edge_up_[ends_[edge][0]] != edge && edge_up_[ends_[edge][1]] != edge)
        close(edge);
    return std::move(is_on_cycle_);
  }

private:
  std::size_t other_end(std::size_t edge, std::size_t point) const {
    return ends_[edge][0] == point ? ends_[edge][1] : ends_[edge][0];
  }

  void add_tree(std::size_t root) {
    depth_[root] = 0;
    std::vector<std::size_t> waiting = {root};
    while(!waiting.empty()) {
      const std::size_t point = waiting.back();
      waiting.pop_back();
      for(const std::size_t edge : edges_at_[point])
        if(const std::size_t next = other_end(edge, point); depth_[next] == Skeleton_answer::none) {
          depth_[next] = depth_[point] + 1;
          edge_up_[next] = edge;
          waiting.push_back(next);
        }
    }
  }

  std::size_t top_of(std::size_t point) {
    while(top_[point] != point)
      point = top_[point] = top_[top_[point]];
    return point;
  }

  void close(std::size_t edge) {
    is_on_cycle_[edge] = 1;
    std::size_t a = top_of(ends_[edge][0]), b = top_of(ends_[edge][1]);
    while(a != b) {
      if(depth_[a] < depth_[b])
        std::swap(a, b);
      is_on_cycle_[edge_up_[a]] = 1;
      a = top_[a] = top_of(other_end(edge_up_[a], a));
    }
  }

  const std::vector<Ends>& ends_;                         // by edge
  const std::vector<std::vector<std::size_t>>& edges_at_; // by point
  std::vector<std::size_t> edge_up_, depth_;              // by point, in a spanning forest
  std::vector<std::size_t> top_;                          // by point
  std::vector<char> is_on_cycle_;
};

/// Finds the arcs of a graph, each from both of its ends.
class Arc_finder
{
public:
  explicit Arc_finder(const Skeleton_graph& graph)
      : graph_(graph)
      , edges_at_(num_vertices(graph)) {
    for(const auto e : CGAL::make_range(edges(graph))) {
      edges_at_[source(e, graph)].push_back(ends_.size());
      edges_at_[target(e, graph)].push_back(ends_.size());
      ends_.push_back({source(e, graph), target(e, graph)});
    }
    is_told_.assign(ends_.size(), 0);
    is_on_cycle_ = Edges_on_cycles(ends_, edges_at_).find();
  }

  std::vector<Skeleton_arc> find() {
    for(std::size_t point = 0; point < edges_at_.size(); ++point)
      if(edges_at_[point].size() != 2)
        find_at(point);
    for(std::size_t point = 0; point < edges_at_.size(); ++point) // cycles without a node
      find_at(point);
    return std::move(arcs_);
  }

private:
  void find_at(std::size_t point) {
    for(const std::size_t edge : edges_at_[point])
      if(!is_told_[edge])
        follow(point, edge);
  }

  void follow(std::size_t start, std::size_t edge) {
    Skeleton_arc arc;
    arc.points = {start};
    arc.is_on_cycle = is_on_cycle_[edge] != 0;
    for(;;) {
      is_told_[edge] = 1;
      const std::size_t last = arc.points.back();
      const std::size_t next = ends_[edge][0] == last ? ends_[edge][1] : ends_[edge][0];
      arc.points.push_back(next);
      if(next == start || edges_at_[next].size() != 2)
        break;
      edge = edges_at_[next][edges_at_[next][0] == edge ? 1 : 0];
    }
    measure(arc);
    arcs_.push_back(std::move(arc));
  }

  void measure(Skeleton_arc& arc) const {
    arc.component = graph_[arc.points.front()].component;
    arc.smallest_radius = arc.mean_radius = graph_[arc.points.front()].radius;
    for(std::size_t i = 1; i < arc.points.size(); ++i) {
      const auto &from = graph_[arc.points[i - 1]], &to = graph_[arc.points[i]];
      const double length = distance(from.point, to.point);
      arc.length += length;
      if(length > 0.)
        arc.mean_radius +=
            length / arc.length * (from.radius / 2. + to.radius / 2. - arc.mean_radius);
      arc.smallest_radius = (std::min)(arc.smallest_radius, to.radius);
    }
  }

  const Skeleton_graph& graph_;
  std::vector<std::vector<std::size_t>> edges_at_; // by point
  std::vector<Ends> ends_;                         // by edge
  std::vector<char> is_told_, is_on_cycle_;        // by edge
  std::vector<Skeleton_arc> arcs_;
};

std::vector<std::size_t> points_of_vertices(const Mesh& mesh, const Skeleton_graph& graph) {
  std::vector<std::size_t> points(mesh.number_of_vertices(), Skeleton_answer::none);
  for(const auto point : CGAL::make_range(vertices(graph)))
    for(const Mesh::Vertex_index v : graph[point].vertices)
      points[v.idx()] = point;
  return points;
}

// For a point that two arcs or more leave: the unit vectors to where they leave its ball.
class Arcs_at_points
{
public:
  explicit Arcs_at_points(const Skeleton_answer& answer)
      : graph_(answer.graph)
      , arcs_at_(num_vertices(answer.graph)) {
    for(std::size_t i = 0; i < answer.arcs.size(); ++i) {
      const std::vector<std::size_t>& points = answer.arcs[i].points;
      for(std::size_t k = 1; k + 1 < points.size(); ++k)
        arcs_at_[points[k]].push_back({i, {0., 0., 0.}});
      add_end(i, points.begin(), points.end());
      add_end(i, points.rbegin(), points.rend());
    }
  }

  std::size_t arc_of(std::size_t point, const Point& from_there) const {
    const Kernel::Vector_3 wanted = from_there - graph_[point].point;
    std::size_t best = Skeleton_answer::none;
    double most = -(std::numeric_limits<double>::infinity)();
    for(const Leaving& leaving : arcs_at_[point])
      if(const double along = leaving.direction * wanted; along > most) {
        best = leaving.arc;
        most = along;
      }
    return best;
  }

private:
  struct Leaving
  {
    std::size_t arc;
    Kernel::Vector_3 direction;
  };

  template <typename Iterator> void add_end(std::size_t arc, Iterator begin, Iterator end) {
    const auto& node = graph_[*begin];
    Kernel::Vector_3 direction(0., 0., 0.);
    for(Iterator it = std::next(begin); it != end; ++it) {
      direction = graph_[*it].point - node.point;
      if(distance(graph_[*it].point, node.point) > node.radius)
        break;
    }
    const double length = length_of_vector(direction.x(), direction.y(), direction.z());
    arcs_at_[*begin].push_back({arc, length > 0. ? direction / length : direction});
  }

  const Skeleton_graph& graph_;
  std::vector<std::vector<Leaving>> arcs_at_;
};

} // namespace

Skeleton_answer
find_skeleton(const Mesh& mesh, const Skeleton_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  Skeleton_answer answer;
  answer.number_of_threads = limit.number_of_threads();
  progress.start("skeleton");
  const Stopwatch stopwatch;
  const CGAL::Handle_tunnel_loops::Skeleton_options& how = options;
  answer.statistics = CGAL::curve_skeleton<All_threads_tag>(
      mesh, answer.graph,
      CGAL::parameters::skeleton_options(how, CGAL::parameters::callback(progress.callback())));
  answer.vertex_point = points_of_vertices(mesh, answer.graph);
  answer.arcs = arcs_of(answer.graph);
  answer.does_mesh_touch_itself =
      note_self_contact(mesh, answer.statistics.certificate, [&progress] {
        if(!progress.update(1.))
          throw CGAL::Handle_tunnel_loops::Interrupted_exception();
      });
  answer.total_seconds = stopwatch.seconds();
  progress.end();
  return answer;
}

std::vector<Skeleton_arc> arcs_of(const Skeleton_graph& graph) { return Arc_finder(graph).find(); }

// Whatever the unit is: squares may be too large, or too small.
double distance(const Point& p, const Point& q) {
  return length_of_vector(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
}

double chord_of(const Skeleton_graph& graph, const Skeleton_arc& arc) {
  return distance(graph[arc.points.front()].point, graph[arc.points.back()].point);
}

const char* name_of_point(const Skeleton_graph& graph, std::size_t point) {
  return graph[point].is_inlet       ? "inlet"
         : degree(point, graph) < 2  ? "end"
         : degree(point, graph) == 2 ? "bend"
                                     : "joint";
}

std::size_t number_of_cycles(const Skeleton_graph& graph) {
  std::vector<std::size_t> piece(num_vertices(graph));
  const std::size_t pieces = boost::connected_components(
      graph, boost::make_iterator_property_map(piece.begin(), get(boost::vertex_index, graph)));
  return num_edges(graph) + pieces - num_vertices(graph);
}

std::vector<std::size_t> arcs_of_vertices(const Mesh& mesh, const Skeleton_answer& answer) {
  const Arcs_at_points at(answer);
  std::vector<std::size_t> arcs(mesh.number_of_vertices(), Skeleton_answer::none);
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(const std::size_t point = answer.vertex_point[v.idx()]; point != Skeleton_answer::none)
      arcs[v.idx()] = at.arc_of(point, mesh.point(v));
  return arcs;
}

} // namespace htloops
