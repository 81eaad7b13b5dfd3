// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_WALKER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_WALKER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Cap_hubs.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/halfedge_near.h>
#include <CGAL/Handle_tunnel_loops/internal/support/are_collinear.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Moves loops onto the edges of the mesh, as closed walks from vertex to vertex in the same classes
that keep away from faces without area: no vertex of such a face is on a walk, nor one that is to be
avoided for another reason. Where the loop passes such vertices, the walk goes around all that are
connected.

On a surface with caps, each hub is to be avoided, and the faces around it have no area worth
speaking of. So a walk that has to go around a vertex on the boundary goes around the cap.
*/
template <typename TriangleMesh, typename VertexPointMap, typename VertexIndexMap> class Edge_walker
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using Members = std::unordered_set<Index>;
  enum class Cluster { DISC, OTHER, UNKNOWN };

public:
  using Walk = std::vector<halfedge_descriptor>;

  /// \p hubs must outlive it.
  Edge_walker(const TriangleMesh& tm,
              VertexPointMap point,
              VertexIndexMap vertex_index,
              const Cap_hubs& hubs)
      : tm_(tm)
      , point_(point)
      , vertex_index_(vertex_index)
      , hubs_(hubs) {}

  /// the walk of a loop that is closed and lies on the surface.
  template <typename Loop> Walk operator()(const Loop& loop) {
    failure_ = no_index;
    Walk walk = without_spurs(around_clusters(straight(loop)));
    CGAL_postcondition(is_closed(walk));
    return walk;
  }

  /// the walk as it would be if there were no faces without area.
  template <typename Loop> Walk straight(const Loop& loop) const {
    return without_spurs(along_edges(loop));
  }

  /// the walk around a cap and what is to be avoided beside it, given an edge of its curve with the
  /// surface to the left: homologous to the curve, but for the sense. It fails as well if another
  /// cap is there.
  Walk around_cap(halfedge_descriptor on_curve) {
    const vertex_descriptor hub = target(next(opposite(on_curve, tm_), tm_), tm_);
    CGAL_precondition(is_hub(hub));
    failure_ = no_index;
    if(!check_cluster(hub))
      return Walk();
    const std::vector<vertex_descriptor> cluster = connected(hub);
    if(std::count_if(cluster.begin(), cluster.end(),
                     [this](vertex_descriptor v) { return is_hub(v); }) > 1)
    {
      failure_ = index(hub);
      return Walk();
    }
    return without_spurs(rim(cluster));
  }

  /// whether a walk comes to no vertex to be avoided, and so need not go around any.
  bool is_clear(const Walk& walk) {
    return std::none_of(walk.begin(), walk.end(),
                        [this](halfedge_descriptor h) { return is_avoided(source(h, tm_)); });
  }

  /// lets the walks to come go around a vertex, given by its index.
  void avoid(Index v) {
    is_avoided_[v] = 1;
    cluster_of_.clear();
  }

  /// whether the last walk should have gone around vertices, but these enclose a handle; then it is
  /// empty, which means nothing.
  bool has_failed() const { return failure_ != no_index; }

  /// the index of such a vertex.
  Index failure() const { return failure_; }

private:
  Index index(vertex_descriptor v) const { return static_cast<Index>(get(vertex_index_, v)); }

  // Two places on a face move to two of its corners, which are equal or joined by an edge.
  template <typename Loop> Walk along_edges(const Loop& loop) const {
    Walk walk;
    if(loop.steps().empty())
      return walk;
    vertex_descriptor u = end_of(loop.steps().back());
    for(const auto& step : loop.steps()) {
      const vertex_descriptor v = end_of(step);
      if(u != v) {
        walk.push_back(halfedge_near(step.halfedge, u, v, tm_));
        CGAL_precondition_msg(walk.back() != boost::graph_traits<TriangleMesh>::null_halfedge(),
                              "steps lie on a common face");
      }
      u = v;
    }
    return walk;
  }

  template <typename Step> vertex_descriptor end_of(const Step& step) const {
    return step.ratio == 1. ? target(step.halfedge, tm_) : source(step.halfedge, tm_);
  }

  bool is_closed(const Walk& walk) const {
    for(std::size_t i = 0; i < walk.size(); ++i)
      if(target(walk[i], tm_) != source(walk[i + 1 == walk.size() ? 0 : i + 1], tm_))
        return false;
    return true;
  }

  // Takes out edges that are passed there and back.
  Walk without_spurs(const Walk& walk) const {
    Walk reduced;
    for(halfedge_descriptor h : walk)
      if(!reduced.empty() && reduced.back() == opposite(h, tm_))
        reduced.pop_back();
      else
        reduced.push_back(h);
    std::size_t first = 0, last = reduced.size();
    while(last - first >= 2 && reduced[last - 1] == opposite(reduced[first], tm_)) {
      ++first;
      --last;
    }
    return Walk(reduced.begin() + first, reduced.begin() + last);
  }

  // ---- around vertices to be avoided

  bool is_avoided(vertex_descriptor v) {
    const auto [it, is_new] = is_avoided_.emplace(index(v), 0);
    if(is_new)
      it->second = is_hub(v) || is_at_flat_face(v);
    return it->second != 0;
  }

  bool is_hub(vertex_descriptor v) const { return hubs_.contain(index(v)); }

  bool is_at_flat_face(vertex_descriptor v) const {
    const auto at_source = halfedges_around_source(v, tm_);
    return std::any_of(at_source.begin(), at_source.end(), [&](halfedge_descriptor h) {
      const vertex_descriptor a = target(h, tm_), b = target(next(h, tm_), tm_);
      return !is_hub(a) && !is_hub(b) &&
             are_collinear(coordinates(point_, v), coordinates(point_, a), coordinates(point_, b));
    });
  }

  Walk around_clusters(const Walk& walk) {
    for(halfedge_descriptor h : walk)
      if(is_avoided(source(h, tm_)) && !check_cluster(source(h, tm_)))
        return Walk();
    std::size_t start = 0;
    while(start < walk.size() && is_avoided(source(walk[start], tm_)))
      ++start;
    // If all of it lies in one cluster it is contractible.
    if(start == walk.size())
      return Walk();
    Walk result;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const halfedge_descriptor h = walk[(start + i) % walk.size()];
      if(!is_avoided(target(h, tm_))) {
        result.push_back(h);
        continue;
      }
      halfedge_descriptor out = h;
      while(is_avoided(target(out, tm_)))
        out = walk[(start + ++i) % walk.size()];
      append_way_around(h, out, result);
    }
    return result;
  }

  // From the source of `in`, which leads into a cluster, to the target of `out`, which leads out of
  // it, along the vertices around the cluster.
  void append_way_around(halfedge_descriptor in, halfedge_descriptor out, Walk& walk) {
    for(halfedge_descriptor h = opposite(in, tm_); h != out;)
      h = turn(h, walk);
  }

  // From one edge that leads out of a cluster to the next.
  halfedge_descriptor turn(halfedge_descriptor h, Walk& walk) {
    const halfedge_descriptor beside = next(h, tm_);
    if(is_avoided(target(beside, tm_)))
      return opposite(beside, tm_);
    walk.push_back(beside);
    return opposite(next(beside, tm_), tm_);
  }

  // All around a cluster that is a disc.
  Walk rim(const std::vector<vertex_descriptor>& cluster) {
    Walk walk;
    for(vertex_descriptor v : cluster)
      for(halfedge_descriptor first : halfedges_around_source(v, tm_))
        if(!is_avoided(target(first, tm_))) {
          halfedge_descriptor h = first;
          do
            h = turn(h, walk);
          while(h != first);
          return walk;
        }
    return walk;
  }

  // Whether the vertices to be avoided that are connected to `first`, and the smaller ones of the
  // regions around them, are those of a disc. Each cluster is looked at once.
  bool check_cluster(vertex_descriptor first) {
    const auto known = cluster_of_.find(index(first));
    const bool is_disc = known != cluster_of_.end() && clusters_[known->second] != Cluster::UNKNOWN
                             ? clusters_[known->second] == Cluster::DISC
                             : look_at_cluster(first);
    if(!is_disc)
      failure_ = index(first);
    return is_disc;
  }

  bool look_at_cluster(vertex_descriptor first) {
    std::vector<vertex_descriptor> cluster = connected(first);
    if(euler_characteristic(cluster) != 1) {
      fill_holes(cluster);
      cluster = connected(first);
    }
    const bool is_disc = euler_characteristic(cluster) == 1;
    for(vertex_descriptor v : cluster)
      cluster_of_[index(v)] = clusters_.size();
    clusters_.push_back(is_disc ? Cluster::DISC : Cluster::OTHER);
    return is_disc;
  }

  std::vector<vertex_descriptor> connected(vertex_descriptor first) {
    std::vector<vertex_descriptor> cluster(1, first);
    Members members = {index(first)};
    for(std::size_t i = 0; i < cluster.size(); ++i)
      for(halfedge_descriptor h : halfedges_around_source(cluster[i], tm_))
        if(is_avoided(target(h, tm_)) && members.insert(index(target(h, tm_))).second)
          cluster.push_back(target(h, tm_));
    return cluster;
  }

  // Of the vertices and all edges and faces between them.
  std::ptrdiff_t euler_characteristic(const std::vector<vertex_descriptor>& cluster) {
    std::ptrdiff_t edges_twice = 0, faces_thrice = 0;
    for(vertex_descriptor v : cluster)
      for(halfedge_descriptor h : halfedges_around_source(v, tm_))
        if(is_avoided(target(h, tm_))) {
          ++edges_twice;
          faces_thrice += is_avoided(target(next(h, tm_), tm_));
        }
    return static_cast<std::ptrdiff_t>(cluster.size()) - edges_twice / 2 + faces_thrice / 3;
  }

  // Regions that the cluster encloses, with fewer vertices than it has, are to be avoided as well.
  void fill_holes(const std::vector<vertex_descriptor>& cluster) {
    Members seen;
    for(vertex_descriptor v : cluster)
      for(halfedge_descriptor h : halfedges_around_source(v, tm_))
        if(!is_avoided(target(h, tm_)) && seen.count(index(target(h, tm_))) == 0)
          fill_hole(target(h, tm_), cluster.size(), seen);
  }

  void fill_hole(vertex_descriptor first, std::size_t limit, Members& seen) {
    std::vector<vertex_descriptor> region(1, first);
    Members members = {index(first)};
    for(std::size_t i = 0; i < region.size(); ++i)
      for(halfedge_descriptor h : halfedges_around_source(region[i], tm_)) {
        const vertex_descriptor v = target(h, tm_);
        if(is_avoided(v) || !members.insert(index(v)).second)
          continue;
        if(members.size() >= limit || seen.count(index(v)) != 0) {
          seen.insert(members.begin(), members.end());
          return;
        }
        region.push_back(v);
      }
    for(vertex_descriptor v : region) {
      is_avoided_[index(v)] = 1;
      for(halfedge_descriptor h : halfedges_around_source(v, tm_))
        forget_cluster(target(h, tm_));
    }
  }

  // It is a larger one now.
  void forget_cluster(vertex_descriptor v) {
    const auto known = cluster_of_.find(index(v));
    if(known != cluster_of_.end())
      clusters_[known->second] = Cluster::UNKNOWN;
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  VertexIndexMap vertex_index_;
  const Cap_hubs& hubs_;
  std::unordered_map<Index, char> is_avoided_;        // by vertex, as far as known
  std::unordered_map<Index, std::size_t> cluster_of_; // by vertex, as far as looked at
  std::vector<Cluster> clusters_;
  Index failure_ = no_index;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_EDGE_WALKER_H
