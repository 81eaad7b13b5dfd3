// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a skeleton is to be, by definition: every edge against every face and every other edge, with
// exact constructions, and linking numbers by a cone over the loop. Nothing of it is the package's.

#ifndef HTL_TEST_SKELETON_DEFINITIONS_H
#define HTL_TEST_SKELETON_DEFINITIONS_H

#include "Determinant.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/loops_as_edges.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/version.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <variant>
#include <vector>

namespace skeleton_definitions {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_place = Exact::Point_3;
using Place = std::array<double, 3>;
using Edge = std::array<std::size_t, 2>;

struct Skeleton
{
  std::vector<Place> points;
  std::vector<Edge> edges;
  std::vector<std::size_t> component; // by point
  std::vector<bool> is_inlet;         // by point
};

/// A `CGAL::Curve_skeleton`.
template <typename Graph> Skeleton skeleton_of(const Graph& graph) {
  Skeleton skeleton;
  for(const auto v : CGAL::make_range(vertices(graph))) {
    const auto& p = graph[v].point;
    skeleton.points.push_back({p.x(), p.y(), p.z()});
    skeleton.component.push_back(graph[v].component);
    skeleton.is_inlet.push_back(graph[v].is_inlet);
  }
  for(const auto e : CGAL::make_range(edges(graph)))
    skeleton.edges.push_back({source(e, graph), target(e, graph)});
  return skeleton;
}

struct Truth
{
  bool is_connected = true, is_inside = true, is_embedded = true, is_basis = true;
  std::set<Edge> edges_outside;
};

inline Exact_place exact_place(const Place& p) { return {p[0], p[1], p[2]}; }

// What two things have in common, if it is one point.
template <typename Intersection> const Exact_place* common_place(const Intersection& common) {
#if CGAL_VERSION_NR < 1060000000
  return boost::get<Exact_place>(&*common);
#else
  return std::get_if<Exact_place>(&*common);
#endif
}

struct Double_box
{
  Place low, high;
  explicit Double_box(const std::vector<Place>& points)
      : low(points[0])
      , high(points[0]) {
    for(const Place& p : points)
      for(int d = 0; d < 3; ++d) {
        low[d] = (std::min)(low[d], p[d]);
        high[d] = (std::max)(high[d], p[d]);
      }
  }
  bool is_apart_from(const Double_box& b) const {
    for(int d = 0; d < 3; ++d)
      if(low[d] > b.high[d] || b.low[d] > high[d])
        return true;
    return false;
  }
};

struct Triangle
{
  Exact::Triangle_3 exact;
  Double_box box;
  std::size_t component;
  int hub; // the number of the boundary curve, if it is part of its cap
};

inline std::size_t representative(std::vector<std::size_t>& parent, std::size_t i) {
  while(parent[i] != i)
    i = parent[i] = parent[parent[i]];
  return i;
}

/// The faces of a mesh and of the caps that close it at inlets, or else at the mean of the curve.
template <typename Mesh> class Capped_surface
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;

public:
  Capped_surface(const Mesh& mesh, const Skeleton& skeleton)
      : hub_of_point(skeleton.points.size(), -1)
      , mesh_(mesh) {
    find_components();
    for(const auto f : faces(mesh)) {
      std::vector<Place> corners;
      for(const Vertex v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
        corners.push_back(place(v));
      add_face(corners, component(target(halfedge(f, mesh), mesh)), -1);
    }
    std::set<Halfedge> seen;
    for(const Halfedge h : halfedges(mesh))
      if(CGAL::is_border(h, mesh) && seen.count(h) == 0)
        add_cap(h, skeleton, seen);
  }

  std::size_t component(Vertex v) const { return component_.at(v); }

  /// V - E + F of the capped surface is 2 - 2 g.
  std::size_t genus(std::size_t c) const { return (2 - euler_[c]) / 2; }
  std::size_t number_of_components() const { return euler_.size(); }

  std::vector<Triangle> triangles;
  std::vector<int> hub_of_point; // by point of the skeleton, or -1

private:
  Place place(Vertex v) const {
    const auto& p = get(get(CGAL::vertex_point, mesh_), v);
    return {p.x(), p.y(), p.z()};
  }

  void find_components() {
    for(const Vertex first : vertices(mesh_)) {
      if(component_.count(first) != 0 ||
         halfedge(first, mesh_) == boost::graph_traits<Mesh>::null_halfedge())
        continue;
      const std::size_t c = euler_.size();
      long vertices_of = 0, halfedges_of = 0, borders = 0;
      std::vector<Vertex> queue = {first};
      component_[first] = c;
      while(!queue.empty()) {
        const Vertex v = queue.back();
        queue.pop_back();
        ++vertices_of;
        for(const Halfedge h : CGAL::halfedges_around_target(v, mesh_)) {
          ++halfedges_of;
          borders += CGAL::is_border(h, mesh_);
          if(component_.emplace(source(h, mesh_), c).second)
            queue.push_back(source(h, mesh_));
        }
      }
      const long faces_of = (halfedges_of - borders) / 3;
      euler_.push_back(vertices_of - halfedges_of / 2 + faces_of);
    }
  }

  void add_face(const std::vector<Place>& p, std::size_t c, int hub) {
    triangles.push_back(
        {{exact_place(p[0]), exact_place(p[1]), exact_place(p[2])}, Double_box(p), c, hub});
  }

  void add_cap(Halfedge first, const Skeleton& skeleton, std::set<Halfedge>& seen) {
    std::vector<Place> curve;
    Halfedge h = first;
    do {
      curve.push_back(place(target(h, mesh_)));
      seen.insert(h);
      h = next(h, mesh_);
    } while(h != first);
    Place middle = {0., 0., 0.};
    for(const Place& p : curve)
      for(int d = 0; d < 3; ++d)
        middle[d] += p[d] / double(curve.size());
    const std::size_t c = component(target(first, mesh_));
    for(std::size_t i = 0; i < skeleton.points.size(); ++i)
      if(skeleton.is_inlet[i] && skeleton.component[i] == c && is_near(skeleton.points[i], middle))
      {
        middle = skeleton.points[i];
        hub_of_point[i] = number_of_hubs_;
      }
    for(std::size_t i = 0; i < curve.size(); ++i)
      add_face({middle, curve[i], curve[(i + 1) % curve.size()]}, c, number_of_hubs_);
    ++number_of_hubs_;
    ++euler_[c];
  }

  static bool is_near(const Place& p, const Place& q) {
    double size = 0., distance = 0.;
    for(int d = 0; d < 3; ++d) {
      size = (std::max)(size, std::abs(q[d]));
      distance = (std::max)(distance, std::abs(p[d] - q[d]));
    }
    return distance <= 1e-13 * (1. + size);
  }

  const Mesh& mesh_;
  std::map<Vertex, std::size_t> component_;
  std::vector<long> euler_; // by component
  int number_of_hubs_ = 0;
};

// By the number of faces that a ray meets; along another one if it meets an edge.
inline bool
is_in_solid(const Exact_place& p, const std::vector<Triangle>& triangles, std::size_t component) {
  for(int attempt = 0;; ++attempt) {
    const Exact::Vector_3 along(1 + 7 * attempt % 11, 0.618 + attempt, 0.3 - 0.9 * attempt);
    const Exact_place far = p + along;
    int number = 0;
    bool is_decided = true;
    for(const Triangle& t : triangles) {
      if(t.component != component)
        continue;
      const auto &a = t.exact[0], &b = t.exact[1], &c = t.exact[2];
      const std::array<CGAL::Orientation, 3> sides = {CGAL::orientation(p, far, a, b),
                                                      CGAL::orientation(p, far, b, c),
                                                      CGAL::orientation(p, far, c, a)};
      const auto count = [&](CGAL::Orientation o) {
        return std::count(sides.begin(), sides.end(), o);
      };
      if(count(CGAL::POSITIVE) > 0 && count(CGAL::NEGATIVE) > 0)
        continue; // the line passes beside it
      is_decided = is_decided && count(CGAL::COPLANAR) == 0;
      // The line meets it: ahead, if p is on the other side of its plane than what lies far ahead.
      const auto normal = CGAL::cross_product(b - a, c - a);
      number += CGAL::sign(normal * (a - p)) == CGAL::sign(normal * along);
    }
    if(is_decided)
      return number % 2 != 0;
  }
}

inline bool is_off_faces(const Exact_place& p, const std::vector<Triangle>& triangles) {
  return std::none_of(triangles.begin(), triangles.end(),
                      [&p](const Triangle& t) { return t.exact.has_on(p); });
}

// Whether the segment from a corner of a triangle to a point meets it elsewhere, too: both are
// convex, so it does so where the segment begins.
inline bool
leads_along(const Exact_place& corner, const Exact_place& p, const Exact::Triangle_3& t) {
  return t.has_on(corner + Exact::FT(std::ldexp(1., -100)) * (p - corner));
}

// Whether the edge meets faces only as it may.
template <typename Mesh>
bool is_edge_off_faces(const Skeleton& skeleton,
                       const Edge& edge,
                       const Capped_surface<Mesh>& surface) {
  const Exact_place a = exact_place(skeleton.points[edge[0]]),
                    b = exact_place(skeleton.points[edge[1]]);
  if(a == b)
    return is_off_faces(a, surface.triangles);
  const Exact::Segment_3 segment(a, b);
  const Double_box box({skeleton.points[edge[0]], skeleton.points[edge[1]]});
  for(const Triangle& t : surface.triangles) {
    if(t.box.is_apart_from(box) || !CGAL::do_intersect(segment, t.exact))
      continue;
    bool is_at_inlet = false;
    for(int end = 0; end < 2; ++end)
      if(t.hub >= 0 && surface.hub_of_point[edge[end]] == t.hub)
        is_at_inlet = !leads_along(end == 0 ? a : b, end == 0 ? b : a, t.exact);
    if(!is_at_inlet)
      return false;
  }
  return true;
}

inline bool meet_wrongly(const Skeleton& skeleton, const Edge& e, const Edge& f) {
  const Double_box box_e({skeleton.points[e[0]], skeleton.points[e[1]]}),
      box_f({skeleton.points[f[0]], skeleton.points[f[1]]});
  if(box_e.is_apart_from(box_f))
    return false;
  const Exact::Segment_3 s(exact_place(skeleton.points[e[0]]), exact_place(skeleton.points[e[1]])),
      t(exact_place(skeleton.points[f[0]]), exact_place(skeleton.points[f[1]]));
  if(s.is_degenerate() || t.is_degenerate())
    return true;
  const auto common = CGAL::intersection(s, t);
  if(!common)
    return false;
  const Exact_place* place = common_place(common);
  if(place == nullptr)
    return true;
  for(const std::size_t p : e)
    for(const std::size_t q : f)
      if(p == q && *place == exact_place(skeleton.points[p]))
        return false;
  return true;
}

// ---- linking numbers

using Polygon = std::vector<Exact_place>;

// How often a closed line crosses the triangles from a point to the sides of another one.
inline int linking_number(const Polygon& line, const Polygon& rim) {
  for(int attempt = 0;; ++attempt) {
    const Exact_place apex(0.123 + 1.7 * attempt, -0.377 + 0.9 * attempt, 0.511 - attempt);
    int number = 0;
    bool is_decided = true;
    for(std::size_t i = 0; i < line.size() && is_decided; ++i)
      for(std::size_t j = 0; j < rim.size() && is_decided; ++j) {
        const Exact_place &p = line[i], &q = line[(i + 1) % line.size()], &a = rim[j],
                          &b = rim[(j + 1) % rim.size()];
        const auto side_p = CGAL::orientation(apex, a, b, p),
                   side_q = CGAL::orientation(apex, a, b, q);
        if(side_p == side_q && side_p != CGAL::COPLANAR)
          continue;
        const std::array<CGAL::Orientation, 3> around = {CGAL::orientation(p, q, apex, a),
                                                         CGAL::orientation(p, q, a, b),
                                                         CGAL::orientation(p, q, b, apex)};
        const bool has_left = std::count(around.begin(), around.end(), CGAL::POSITIVE) > 0,
                   has_right = std::count(around.begin(), around.end(), CGAL::NEGATIVE) > 0;
        if(has_left && has_right)
          continue;
        is_decided = side_p != CGAL::COPLANAR && side_q != CGAL::COPLANAR &&
                     std::count(around.begin(), around.end(), CGAL::COPLANAR) == 0;
        number += side_p == CGAL::POSITIVE ? 1 : -1;
      }
    if(is_decided)
      return number;
  }
}

// The cycles that edges outside a tree make with it, found by depth-first search.
inline std::vector<std::vector<std::size_t>> cycles_of(const Skeleton& skeleton,
                                                       std::size_t component) {
  std::map<std::size_t, std::vector<std::pair<std::size_t, std::size_t>>> at; // edge, other end
  for(std::size_t e = 0; e < skeleton.edges.size(); ++e)
    if(skeleton.component[skeleton.edges[e][0]] == component) {
      at[skeleton.edges[e][0]].emplace_back(e, skeleton.edges[e][1]);
      at[skeleton.edges[e][1]].emplace_back(e, skeleton.edges[e][0]);
    }
  std::vector<std::vector<std::size_t>> cycles;
  std::map<std::size_t, std::size_t> parent; // by point
  std::set<std::size_t> is_used;             // edges
  for(const auto& item : at) {
    std::vector<std::size_t> stack;
    if(parent.emplace(item.first, item.first).second)
      stack.push_back(item.first);
    while(!stack.empty()) {
      const std::size_t p = stack.back();
      stack.pop_back();
      for(const auto& [e, q] : at[p])
        if(parent.emplace(q, p).second) {
          is_used.insert(e);
          stack.push_back(q);
        }
    }
  }
  const auto to_root = [&](std::size_t p) {
    std::vector<std::size_t> way = {p};
    while(parent[way.back()] != way.back())
      way.push_back(parent[way.back()]);
    return way;
  };
  for(std::size_t e = 0; e < skeleton.edges.size(); ++e)
    if(skeleton.component[skeleton.edges[e][0]] == component && is_used.count(e) == 0) {
      std::vector<std::size_t> cycle = to_root(skeleton.edges[e][0]),
                               back = to_root(skeleton.edges[e][1]);
      cycle.insert(cycle.end(), back.rbegin(), back.rend()); // twice through the root, if need be
      cycles.push_back(cycle);
    }
  return cycles;
}

// Whether its ends are not connected without it.
inline bool is_bridge(const Skeleton& skeleton, const Edge& edge) {
  std::vector<std::size_t> parent(skeleton.points.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  bool is_left_out = false;
  for(const Edge& e : skeleton.edges)
    if(e == edge && !is_left_out)
      is_left_out = true;
    else
      parent[representative(parent, e[0])] = representative(parent, e[1]);
  return representative(parent, edge[0]) != representative(parent, edge[1]);
}

// Of the matrix of linking numbers of cycles with the loops of one type on a component.
template <typename Mesh, typename Pairs>
Integer linking_determinant(const Mesh& mesh,
                            const Capped_surface<Mesh>& surface,
                            const Skeleton& skeleton,
                            const Pairs& pairs,
                            CGAL::Loop_type type,
                            std::size_t component) {
  Integer_matrix matrix;
  for(const auto& pair : pairs) {
    std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> walk;
    CGAL::loop_to_halfedges(pair.loop(type), mesh, std::back_inserter(walk));
    if(walk.empty() || surface.component(target(walk[0], mesh)) != component)
      continue;
    Polygon rim;
    for(const auto h : walk) {
      const auto& p = get(get(CGAL::vertex_point, mesh), target(h, mesh));
      rim.push_back(Exact_place(p.x(), p.y(), p.z()));
    }
    matrix.emplace_back();
    for(const auto& cycle : cycles_of(skeleton, component)) {
      Polygon line;
      for(const std::size_t p : cycle)
        line.push_back(exact_place(skeleton.points[p]));
      matrix.back().push_back(linking_number(line, rim));
    }
  }
  return matrix.size() == surface.genus(component) ? determinant(matrix) : Integer(0);
}

/// all of it. `pairs` are a basis of the mesh, of loops that bound, each component by itself.
template <typename Mesh, typename Pairs>
Truth truth(const Mesh& mesh, const Skeleton& skeleton, const Pairs& pairs) {
  Truth truth;
  const Capped_surface<Mesh> surface(mesh, skeleton);
  std::set<std::size_t> is_with_edge;
  for(const Edge& e : skeleton.edges) {
    is_with_edge.insert(e.begin(), e.end());
    const std::size_t c = skeleton.component[e[0]];
    const Exact_place middle =
        CGAL::midpoint(exact_place(skeleton.points[e[0]]), exact_place(skeleton.points[e[1]]));
    if(skeleton.component[e[1]] != c || !is_edge_off_faces(skeleton, e, surface) ||
       !is_in_solid(middle, surface.triangles, c))
      truth.edges_outside.insert(e);
  }
  truth.is_inside = truth.edges_outside.empty();
  for(std::size_t i = 0; i < skeleton.edges.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      truth.is_embedded =
          truth.is_embedded && !meet_wrongly(skeleton, skeleton.edges[i], skeleton.edges[j]);
  for(std::size_t p = 0; p < skeleton.points.size(); ++p)
    if(is_with_edge.count(p) == 0) {
      const Exact_place place = exact_place(skeleton.points[p]);
      truth.is_inside = truth.is_inside && is_off_faces(place, surface.triangles) &&
                        is_in_solid(place, surface.triangles, skeleton.component[p]);
      for(const Edge& e : skeleton.edges)
        truth.is_embedded =
            truth.is_embedded && !Exact::Segment_3(exact_place(skeleton.points[e[0]]),
                                                   exact_place(skeleton.points[e[1]]))
                                      .has_on(place);
    }
  // Connected, with as many cycles as there are handles.
  std::vector<std::size_t> parent(skeleton.points.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  std::map<std::size_t, long> pieces, number_of_edges, number_of_points;
  for(const Edge& e : skeleton.edges) {
    truth.is_connected = truth.is_connected && skeleton.component[e[0]] == skeleton.component[e[1]];
    parent[representative(parent, e[0])] = representative(parent, e[1]);
    ++number_of_edges[skeleton.component[e[0]]];
  }
  for(std::size_t p = 0; p < parent.size(); ++p) {
    ++number_of_points[skeleton.component[p]];
    pieces[skeleton.component[p]] += parent[p] == p;
  }
  for(std::size_t c = 0; c < surface.number_of_components(); ++c) {
    const auto genus = static_cast<long>(surface.genus(c));
    const bool is_right = pieces[c] == 1 && number_of_edges[c] - number_of_points[c] + 1 == genus;
    truth.is_connected = truth.is_connected && is_right;
    bool is_off_surface = true; // all that is on cycles
    for(const Edge& e : truth.edges_outside)
      is_off_surface = is_off_surface && (skeleton.component[e[0]] != c || is_bridge(skeleton, e));
    if(!is_right || !is_off_surface) {
      truth.is_basis = false;
      continue;
    }
    // In a cavity, the solid is beyond the surface, and tunnel loops bound on the bounded side.
    bool is_basis = false;
    for(const auto type : {CGAL::Loop_type::HANDLE, CGAL::Loop_type::TUNNEL})
      is_basis = is_basis || abs(linking_determinant(mesh, surface, skeleton, pairs, type, c)) == 1;
    truth.is_basis = truth.is_basis && is_basis;
  }
  return truth;
}

} // namespace skeleton_definitions

#endif // HTL_TEST_SKELETON_DEFINITIONS_H
