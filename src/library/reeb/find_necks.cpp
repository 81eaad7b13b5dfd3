// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/reeb/find_necks.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_index.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Distance_buckets.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Narrow_places.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_sweep.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/contour_above.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/furthest_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the distances of all vertices from the nearest of the sources, along edges. There is to be a
/// source in each component.
static std::vector<float> edge_distances(const Flat_mesh& mesh, const std::vector<Index>& sources) {
  std::vector<float> distance(mesh.number_of_vertices(), std::numeric_limits<float>::infinity());
  std::vector<char> is_waiting(mesh.number_of_vertices(), 0);
  Distance_buckets buckets(mesh);
  const auto reach = [&](Index v, float d) {
    distance[v] = d;
    is_waiting[v] = 1;
    buckets.push(d, v);
  };
  for(Index v : sources)
    reach(v, 0.f);
  while(!buckets.empty()) {
    const Index v = buckets.pop();
    if(!std::exchange(is_waiting[v], char(0)))
      continue;
    for(Index u : mesh.ring(v)) {
      const float d = distance[v] + static_cast<float>(mesh.edge_length(v, u));
      if(d < distance[u])
        reach(u, d);
    }
  }
  return distance;
}

/*!
The pieces into which disjoint loops cut a surface. A loop that is kept joins the pieces on its two
sides as an edge of a graph; one that is given up makes them one.
*/
class Neck_pieces
{
public:
  Neck_pieces(const Flat_mesh& mesh,
              const std::vector<Crossing_loop>& loops,
              const std::vector<double>& vertex_areas)
      : mesh_(mesh)
      , piece_(mesh.number_of_vertices(), no_index) {
    number_pieces(Crossing_index(mesh, loops));
    total_.assign(mesh.seeds.size(), 0.);
    for(Index v = 0; v < piece_.size(); ++v) {
      area_[piece_[v]] += vertex_areas[v];
      total_[component_[piece_[v]]] += vertex_areas[v];
    }
    for(const Crossing_loop& loop : loops)
      sides_.emplace_back(piece_[loop.front().left], piece_[loop.front().right]);
  }

  /// whether each loop separates its component: the pieces and loops are trees, one for each
  /// component.
  bool is_forest() const {
    return area_.size() == mesh_.seeds.size() + sides_.size() &&
           std::all_of(sides_.begin(), sides_.end(),
                       [](const auto& sides) { return sides.first != sides.second; });
  }

  /// which of the loops to keep so that no piece is smaller than a share of its component: of those
  /// around a small piece the later ones are given up first.
  std::vector<char> kept(double minimal_share) {
    std::vector<char> is_kept(sides_.size(), 1);
    // Joining pieces may leave one that was large enough as it is, but never makes one small.
    for(std::size_t i = sides_.size(); i-- > 0;) {
      const Index a = find(sides_[i].first), b = find(sides_[i].second);
      if((std::min)(area_[a], area_[b]) >= minimal_share * total_[component_[a]])
        continue;
      is_kept[i] = 0;
      parent_[b] = a;
      area_[a] += area_[b];
    }
    return is_kept;
  }

private:
  void number_pieces(const Crossing_index& walls) {
    const Loops_from all = {0};
    std::vector<Index> reached;
    for(Index seed = 0; seed < piece_.size(); ++seed) {
      if(piece_[seed] != no_index)
        continue;
      const Index piece = static_cast<Index>(area_.size());
      area_.push_back(0.);
      parent_.push_back(piece);
      component_.push_back(mesh_.component[seed]);
      piece_[seed] = piece;
      reached.push_back(seed);
      while(!reached.empty()) {
        const Index v = reached.back();
        reached.pop_back();
        const bool is_beside_loop = walls.has_crossing(v);
        for(Index u : mesh_.ring(v))
          if(piece_[u] == no_index && !(is_beside_loop && walls.is_crossed(v, u, all))) {
            piece_[u] = piece;
            reached.push_back(u);
          }
      }
    }
  }

  Index find(Index piece) {
    while(parent_[piece] != piece)
      piece = parent_[piece] = parent_[parent_[piece]];
    return piece;
  }

  const Flat_mesh& mesh_;
  std::vector<Index> piece_; // by vertex
  std::vector<double> area_; // by piece
  std::vector<Index> parent_, component_;
  std::vector<double> total_;                  // by component
  std::vector<std::pair<Index, Index>> sides_; // by loop
};

/// a third of the area of the faces at each vertex.
static std::vector<double> vertex_areas(Execution execution, const Flat_mesh& mesh) {
  std::vector<double> areas(mesh.number_of_vertices());
  for_each_index(execution, areas.size(), [&](std::size_t i) {
    const Index v = static_cast<Index>(i);
    const Ring ring = mesh.ring(v);
    double sum = 0.;
    for(Index p = 0; p < ring.size(); ++p)
      sum += norm(cross(mesh.points[ring[p]] - mesh.points[v],
                        mesh.points[ring[ring.next(p)]] - mesh.points[v]));
    areas[v] = sum / 6.;
  });
  return areas;
}

template <typename T> bool has_repetition(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

/// whether a closed walk on the edges, given by its vertices with repetitions where it stays,
/// visits three vertices or more, and none of them twice.
static bool is_simple_walk(std::vector<Index> vertices) {
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  while(vertices.size() > 1 && vertices.front() == vertices.back())
    vertices.pop_back();
  return vertices.size() >= 3 && !has_repetition(vertices);
}

/// whether a loop passes no edge twice, and can be moved aside to a simple walk on the edges.
static bool is_simple(const Crossing_loop& loop) {
  std::vector<std::pair<Index, Index>> edges;
  std::vector<Index> left, right;
  for(const Crossing& c : loop) {
    edges.push_back(std::minmax(c.left, c.right));
    left.push_back(c.left);
    right.push_back(c.right);
  }
  return !has_repetition(edges) && (is_simple_walk(left) || is_simple_walk(right));
}

/// Looks for necks on the contours of the distance from a place in each component. Far from it
/// compared with the length of a neck they pass through the neck all but straight.
class Neck_search
{
public:
  Neck_search(const Flat_mesh& mesh,
              const std::vector<double>& vertex_areas,
              const Neck_limits& limits)
      : mesh_(mesh)
      , vertex_areas_(vertex_areas)
      , limits_(limits) {}

  /// necks that may meet.
  std::vector<Flat_neck> run(Execution execution, const std::vector<float>& distance) const {
    const Sweep_order order(
        execution, mesh_, [&](Index v) { return ordering_key(static_cast<double>(distance[v])); });
    const std::vector<Star> stars = sweep_stars(execution, mesh_, order);
    const std::uint64_t most_steps = 8 * std::uint64_t(mesh_.neighbor.size());
    constexpr double no_samples = (std::numeric_limits<float>::max)();
    const Flat_reeb_graph graph = Reeb_sweep(mesh_, order, stars, most_steps, no_samples).run();
    Narrow_places places(mesh_, order, stars, graph, vertex_areas_,
                         oblique * limits_.maximal_length, negligible * limits_.minimal_share);
    std::vector<Flat_neck> necks;
    Loop_tightening tightening(mesh_);
    for(Index v : places.find())
      add_if_neck(contour_above(mesh_, order, distance, v), tightening, necks);
    return necks;
  }

private:
  /// by how much a contour close to a neck may be longer than it.
  static constexpr double oblique = 4.;

  /// of the smallest piece: what is not looked at along the way.
  static constexpr double negligible = 0.1;

  void add_if_neck(const Crossing_loop& contour,
                   Loop_tightening& tightening,
                   std::vector<Flat_neck>& necks) const {
    Crossing_loop tight = contour;
    tightening.tighten(tight);
    if(tight.empty())
      return;
    for(const Crossing_loop& loop : {tight, contour}) {
      const double size = length(mesh_, loop);
      if(size < limits_.maximal_length && is_simple(loop)) {
        necks.push_back({loop, size});
        return;
      }
    }
  }

  const Flat_mesh& mesh_;
  const std::vector<double>& vertex_areas_;
  Neck_limits limits_;
};

/// loops no two of which pass edges with a common end, short ones rather than long ones.
static std::vector<Crossing_loop> disjoint_loops(const Flat_mesh& mesh,
                                                 std::vector<Flat_neck> found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Flat_neck& a, const Flat_neck& b) { return a.length < b.length; });
  std::vector<char> is_taken(mesh.number_of_vertices(), 0);
  std::vector<Crossing_loop> loops;
  for(Flat_neck& neck : found) {
    const bool is_free = std::none_of(neck.loop.begin(), neck.loop.end(), [&](const Crossing& c) {
      return is_taken[c.left] || is_taken[c.right];
    });
    if(!is_free)
      continue;
    for(const Crossing& c : neck.loop)
      is_taken[c.left] = is_taken[c.right] = 1;
    loops.push_back(std::move(neck.loop));
  }
  return loops;
}

/// keeps necks between pieces that are large enough.
static std::vector<Flat_neck> choose_necks(const Flat_mesh& mesh,
                                           const std::vector<double>& vertex_areas,
                                           double minimal_share,
                                           std::vector<Crossing_loop> loops) {
  if(loops.empty())
    return {};
  Neck_pieces pieces(mesh, loops, vertex_areas);
  const bool all_separate = pieces.is_forest();
  CGAL_assertion_msg(all_separate, "each contour on a bridge of the Reeb graph separates");
  if(!all_separate)
    return {};
  const std::vector<char> is_kept = pieces.kept(minimal_share);
  std::vector<Flat_neck> necks;
  for(std::size_t i = 0; i < loops.size(); ++i)
    if(is_kept[i] != 0) {
      const double size = length(mesh, loops[i]);
      necks.push_back({std::move(loops[i]), size});
    }
  return necks;
}

/// the distances from any place, from one furthest from there, and from one furthest from that: a
/// neck on which, or around which, one of the contours is not as it should be is far from another.
static std::array<std::vector<float>, 3> distances_from_ends(const Flat_mesh& mesh) {
  std::array<std::vector<float>, 3> distances;
  std::vector<Index> sources = mesh.seeds;
  for(std::vector<float>& distance : distances) {
    distance = edge_distances(mesh, sources);
    sources = furthest_vertices(mesh, distance);
  }
  return distances;
}

std::vector<Flat_neck>
find_flat_necks(Execution execution, const Flat_mesh& mesh, const Neck_limits& limits) {
  const std::vector<double> areas = vertex_areas(execution, mesh);
  const std::array<std::vector<float>, 3> distances = distances_from_ends(mesh);
  const Neck_search search(mesh, areas, limits);
  std::array<std::vector<Flat_neck>, 3> found;
  for_each_index(
      execution, found.size(),
      [&](std::size_t i) { found[i] = search.run(execution, distances[i]); }, 1);
  std::vector<Flat_neck> all;
  for(std::vector<Flat_neck>& necks : found)
    std::move(necks.begin(), necks.end(), std::back_inserter(all));
  return choose_necks(mesh, areas, limits.minimal_share, disjoint_loops(mesh, std::move(all)));
}

} // namespace CGAL::Handle_tunnel_loops::internal
