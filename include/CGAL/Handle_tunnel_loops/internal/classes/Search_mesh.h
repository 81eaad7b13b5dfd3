// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Edge_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Intrinsic_triangulation.h>
#include <CGAL/Handle_tunnel_loops/internal/classes/Step_coarsening.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/rounded_product.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// A graph to search for loops on: the edges of the mesh, or of a better triangulation of the same
/// surface, or steps between some of the vertices of one of these. Its steps from a vertex have
/// consecutive numbers; for each stands a walk on the edges of the surface, which is the mesh or a
/// subdivision of it. Steps to hubs of caps are infinitely long.
class Search_mesh
{
public:
  explicit Search_mesh(const Flat_mesh& mesh)
      : mesh_(mesh)
      , surface_(&mesh)
      , number_of_vertices_(mesh.number_of_vertices())
      , begin_(mesh.row_begin.data())
      , heads_(mesh.neighbor.data()) {}

  /// places of another such mesh that are nowhere nearer to each other than \p spacing, and steps
  /// between them of each class; see `Step_coarsening`. Their walks are those of the other mesh,
  /// which has been counted.
  Search_mesh(const Search_mesh& finer, const Edge_classes& classes, double spacing)
      : mesh_(finer.mesh_)
      , finer_(&finer)
      , surface_(finer.surface_)
      , subdivision_(finer.subdivision_) {
    const Step_coarsening<Search_mesh> coarsening(finer, classes, spacing);
    nodes_ = coarsening.nodes();
    for(Index v = 0; v < finer.number_of_vertices(); ++v)
      node_of_.push_back(coarsening.node(v));
    for(Index node = 0; node < nodes_.size(); ++node) {
      add_vertex();
      for(const auto& step : coarsening.steps(node)) {
        add_step(step.head, step.length);
        coarsening.append_walk(step, walks_);
      }
    }
    take_steps();
  }

  Search_mesh(const Search_mesh&) = delete;
  Search_mesh& operator=(const Search_mesh&) = delete;

  /// replaces the edges of the mesh by those of a triangulation with up to so many more vertices,
  /// or about twice as many in all if the mesh has few: ways along edges are poor where triangles
  /// are long and thin.
  void refine(std::size_t number_of_vertices) {
    const std::size_t n = (std::max)(number_of_vertices, mesh_.number_of_vertices());
    // An even mesh of n vertices has 2n triangles of area s^2 sqrt(3) / 4.
    const double longest = std::sqrt(1.5 * 2.31 * area() / double(2 * n));
    Intrinsic_triangulation triangulation(mesh_);
    triangulation.split(longest, n + number_of_vertices);
    subdivision_ = std::make_shared<const Subdivision>(
        Subdivision{triangulation.subdivision(), triangulation.places(), triangulation.corners()});
    surface_ = &subdivision_->mesh;
    triangulation.make_delaunay();
    add_edges(triangulation);
    take_steps();
  }

  /// computes the lengths of all edges once: it pays if many searches follow.
  void measure() {
    if(has_walks())
      return;
    lengths_.resize(mesh_.neighbor.size());
    for(Index v = 0; v < number_of_vertices(); ++v)
      for(Index s = begin(v); s != end(v); ++s)
        lengths_[s] = length_of_edge(v, head(s));
  }

  /// counts what the steps cross.
  void count(const Edge_classes& classes) {
    sums_.assign(own_heads_.size(), {});
    steps_.clear();
    for(Index v = 0; has_walks() && v < number_of_vertices(); ++v)
      for(Index s = begin(v); s != end(v); ++s) {
        for_each_edge(v, s, [&](Index from, Index to) {
          const Index u = corner(from), w = corner(to);
          if(u != w && classes.has_crossing(u))
            sums_[s].add(1, classes.edge(u, mesh_.ring(u).position(w)).sums);
        });
        if(!sums_[s].is_zero())
          note_step(v, s, classes);
      }
    std::sort(steps_.begin(), steps_.end());
  }

  /// how often a step from `v` crosses a loop, in net numbers, by the edge classes that were last
  /// counted.
  int number(Index v, Index step, Index loop, const Edge_classes& classes) const {
    int sum = 0;
    for_each_edge(v, step, [&](Index from, Index to) {
      classes.for_each_term(corner(from), corner(to),
                            [&](Index other, int number) { sum += other == loop ? number : 0; });
    });
    return sum;
  }

  /// calls `f(vertex, step)` for steps, among which are all that cross a loop in net numbers, in
  /// one direction at least.
  template <typename Function>
  void for_each_step_across(const Crossing_loop& loop, Index number, const Function& f) const {
    if(!has_walks()) {
      for(const Crossing& c : loop) {
        const Index v = mesh_.is_hub(c.left) ? c.right : c.left;
        f(v, begin(v) + mesh_.ring(v).position(v == c.left ? c.right : c.left));
      }
      return;
    }
    for(auto s = std::lower_bound(steps_.begin(), steps_.end(), Step{number, 0, 0});
        s != steps_.end() && s->loop == number; ++s)
      f(s->vertex, s->step);
  }

  std::size_t number_of_vertices() const { return number_of_vertices_; }
  const Vector& point(Index v) const { return surface_->points[vertex_of_walks(v)]; }

  /// not of a coarse mesh.
  bool is_hub(Index v) const { return mesh_.is_hub(v); }

  /// the vertex on the edges along which steps lead.
  Index vertex_of_walks(Index v) const { return nodes_.empty() ? v : nodes_[v]; }

  /// the steps from a vertex are those from `begin()` to `end()`.
  Index begin(Index v) const { return begin_[v]; }
  Index end(Index v) const { return begin_[v + 1]; }
  Index head(Index step) const { return heads_[step]; }

  float length(Index v, Index step) const {
    return lengths_.empty() ? length_of_edge(v, head(step)) : lengths_[step];
  }

  /// what a step from `v` crosses, by the edge classes that were last counted.
  Class_sums sums(Index v, Index step, const Edge_classes& classes) const {
    if(has_walks())
      return sums_[step];
    return classes.has_crossing(v) ? classes.edge(v, step - begin(v)).sums : Class_sums();
  }

  /// the corner of the mesh that stands for a vertex on the edges along which steps lead.
  Index corner(Index v) const { return subdivision_ == nullptr ? v : subdivision_->corners[v]; }

  /// calls `f(from, to)` for the edges along which a step from `v` leads.
  template <typename Function> void for_each_edge(Index v, Index step, const Function& f) const {
    if(!has_walks())
      return f(v, head(step));
    Index from = vertex_of_walks(v);
    for(Index i = walk_begin_[step]; i != walk_begin_[step + 1]; ++i) {
      f(from, walks_[i]);
      from = walks_[i];
    }
  }

  /// the loop on the mesh along a closed walk on these edges without spurs. It crosses the edges of
  /// the mesh where it crosses those of the subdivision that lie on them.
  Crossing_loop loop_along(const std::vector<Index>& walk) const {
    if(subdivision_ == nullptr)
      return pushed_left(mesh_, walk);
    Crossing_loop loop;
    for(const Crossing& c : pushed_left(*surface_, walk)) {
      const Place &left = subdivision_->places[c.left], &right = subdivision_->places[c.right];
      if(const std::optional<Crossing> crossing = crossing_between(left, right, c.ratio))
        loop.push_back(*crossing);
    }
    remove_backtracks(loop);
    return loop;
  }

  /// a vertex near a place, by steps towards it from a corner near it that is no hub.
  Index vertex_near(const Vector& place, Index corner) const {
    if(finer_ != nullptr)
      return node_of_[finer_->vertex_near(place, corner)];
    Index v = corner;
    for(double best = squared_distance(v, place);;) {
      const Index from = v;
      for(Index s = begin(from); s != end(from); ++s)
        if(const double d = squared_distance(head(s), place); d < best && !mesh_.is_hub(head(s))) {
          best = d;
          v = head(s);
        }
      if(v == from)
        return v;
    }
  }

  /// of the surface.
  double area() const {
    double sum = 0.;
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v) {
      const Ring ring = mesh_.ring(v);
      for(Index p = 0; p < ring.size(); ++p) {
        const Index a = ring[p], b = ring[ring.next(p)];
        if(v < a && v < b && !mesh_.is_hub(v) && !mesh_.is_spoke(a, b))
          sum += 0.5 *
                 norm(cross(mesh_.points[a] - mesh_.points[v], mesh_.points[b] - mesh_.points[v]));
      }
    }
    return sum;
  }

private:
  using Place = Intrinsic_triangulation::Place;

  struct Subdivision
  {
    Flat_mesh mesh; // points and rings
    std::vector<Place> places;
    std::vector<Index> corners;
  };

  // A step that crosses a loop.
  struct Step
  {
    Index loop, vertex, step;

    bool operator<(const Step& s) const { return loop != s.loop ? loop < s.loop : step < s.step; }
  };

  void note_step(Index v, Index step, const Edge_classes& classes) {
    for_each_edge(v, step, [&](Index from, Index to) {
      classes.for_each_term(corner(from), corner(to), [&](Index loop, int) {
        steps_.push_back({loop, v, step});
      });
    });
  }

  bool has_walks() const { return !walk_begin_.empty(); }

  float length_of_edge(Index u, Index v) const {
    return mesh_.is_spoke(u, v) ? std::numeric_limits<float>::infinity()
                                : static_cast<float>(mesh_.edge_length(u, v));
  }

  // Of an edge of the subdivision, if it lies on one of the mesh.
  static std::optional<Crossing> crossing_between(const Place& left, const Place& right, double r) {
    const auto is_vertex = [](const Place& p) { return p.source == p.target; };
    const Place edge = !is_vertex(left)    ? left
                       : !is_vertex(right) ? right
                                           : Place{left.source, right.source, 0.};
    const auto ratio = [&](const Place& p) {
      return !is_vertex(p) ? (p.source == edge.source && p.target == edge.target ? p.ratio : -1.)
             : p.source == edge.source ? 0.
             : p.source == edge.target ? 1.
                                       : -1.;
    };
    const double from = ratio(left), to = ratio(right);
    if(left.source == no_index || right.source == no_index || from < 0. || to < 0.)
      return std::nullopt;
    const double at = rounded_product(1. - r, from) + rounded_product(r, to);
    return from < to ? Crossing{edge.source, edge.target, at}
                     : Crossing{edge.target, edge.source, 1. - at};
  }

  double squared_distance(Index v, const Vector& place) const {
    const Vector to = place - point(v);
    return dot(to, to);
  }

  // ---- steps with walks

  // The steps that are added next are from the next vertex.
  void add_vertex() { own_begin_.push_back(static_cast<Index>(own_heads_.size())); }

  // Its walk is to be appended.
  void add_step(Index head, float length) {
    own_heads_.push_back(head);
    lengths_.push_back(length);
    walk_begin_.push_back(static_cast<Index>(walks_.size()));
  }

  void add_edges(const Intrinsic_triangulation& triangulation) {
    std::vector<std::vector<Index>> halfedges(triangulation.number_of_vertices()); // by source
    for(Index h = 0; h < triangulation.number_of_halfedges(); ++h)
      halfedges[triangulation.source(h)].push_back(h);
    for(const std::vector<Index>& of_vertex : halfedges) {
      add_vertex();
      for(const Index h : of_vertex) {
        add_step(triangulation.target(h), static_cast<float>(triangulation.length(h)));
        const std::vector<Index> walk = triangulation.walk(h);
        walks_.insert(walks_.end(), walk.begin(), walk.end());
      }
    }
  }

  void take_steps() {
    number_of_vertices_ = own_begin_.size();
    add_vertex();
    walk_begin_.push_back(static_cast<Index>(walks_.size()));
    begin_ = own_begin_.data();
    heads_ = own_heads_.data();
  }

  const Flat_mesh& mesh_;
  // The mesh of which this has a part of the vertices, if there is one, those, and by vertex there
  // the nearest of them.
  const Search_mesh* finer_ = nullptr;
  std::vector<Index> nodes_, node_of_;
  const Flat_mesh* surface_;
  std::shared_ptr<const Subdivision> subdivision_; // unless the mesh is the surface
  std::size_t number_of_vertices_ = 0;
  const Index *begin_ = nullptr, *heads_ = nullptr; // by vertex and by step, of the mesh or these:
  std::vector<Index> own_begin_, own_heads_;
  std::vector<Index> walk_begin_, walks_; // by step, and what the walks lead to
  std::vector<Class_sums> sums_;          // by step
  std::vector<Step> steps_;               // that cross loops, by loop
  std::vector<float> lengths_;            // by step, of the mesh as well if measured
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_MESH_H
