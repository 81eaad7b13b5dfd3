// Copyright (c) 2026 The Handle_tunnel_loops authors.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a skeleton is to be, by definition: every edge against every face and every other edge, with
// exact constructions, and linking numbers by a cone over the loop. Nothing of it is the package's.

#ifndef HTL_TEST_SKELETON_DEFINITIONS_H
#define HTL_TEST_SKELETON_DEFINITIONS_H

#include "Determinant.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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
#include <tuple>
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
  bool is_apart_from(const Double_box& b) const { return is_apart_in(3, b); }

  /// whether neither has a point above one of the other.
  bool is_beside(const Double_box& b) const { return is_apart_in(2, b); }

private:
  bool is_apart_in(int dimensions, const Double_box& b) const {
    for(int d = 0; d < dimensions; ++d)
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

inline bool is_in_solid(const Exact_place& p,
                        const Double_box& around,
                        const std::vector<Triangle>& triangles,
                        std::size_t component);

/// The faces of a mesh and of the caps that close it: fans of faces around inlets, or around the
/// means of curves that have none.
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
      add_face(corners, component_.at(target(halfedge(f, mesh), mesh)), -1);
    }
    std::set<Halfedge> seen;
    for(const Halfedge h : halfedges(mesh))
      if(CGAL::is_border(h, mesh) && seen.count(h) == 0)
        add_cap(h, seen);
    move_to_inlets(skeleton);
    for(std::size_t i = 0; i < caps_.size(); ++i)
      for(std::size_t k = 0; k < caps_[i].curve.size(); ++k)
        add_face({caps_[i].hub, caps_[i].curve[k], caps_[i].curve[(k + 1) % caps_[i].curve.size()]},
                 caps_[i].component, static_cast<int>(i));
    join_cavities();
  }

  /// that of the outer surface of the piece of the solid.
  std::size_t component(Vertex v) const { return outer_[component_.at(v)]; }
  bool is_outer(std::size_t c) const { return outer_[c] == c; }

  /// V - E + F of each capped surface is 2 - 2 g; of all surfaces of a piece.
  std::size_t genus(std::size_t c) const {
    return (2 * std::count(outer_.begin(), outer_.end(), c) - euler_[c]) / 2;
  }
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

  struct Cap
  {
    std::vector<Place> curve;
    Place hub;
    std::size_t component;
  };

  void add_cap(Halfedge first, std::set<Halfedge>& seen) {
    Cap cap = {{}, {0., 0., 0.}, component_.at(target(first, mesh_))};
    Halfedge h = first;
    do {
      cap.curve.push_back(place(target(h, mesh_)));
      seen.insert(h);
      h = next(h, mesh_);
    } while(h != first);
    for(const Place& p : cap.curve)
      for(int d = 0; d < 3; ++d)
        cap.hub[d] += p[d] / double(cap.curve.size());
    ++euler_[cap.component];
    caps_.push_back(std::move(cap));
  }

  // A component bounds a cavity of the next one around it if that is an outer surface and the signs
  // of their volumes differ.
  void join_cavities() {
    const std::size_t n = euler_.size();
    std::vector<std::vector<std::size_t>> around(n);
    std::vector<Exact::FT> volume(n, 0);
    std::vector<const Triangle*> first(n, nullptr);
    for(const Triangle& t : triangles) {
      const auto to = [&t](int k) { return t.exact[k] - CGAL::ORIGIN; };
      volume[t.component] += CGAL::determinant(to(0), to(1), to(2));
      first[t.component] = &t;
    }
    std::vector<std::size_t> order(n);
    for(std::size_t c = 0; c < n; ++c) {
      outer_.push_back(order[c] = c);
      for(std::size_t d = 0; d < n; ++d)
        if(d != c && is_in_solid(first[c]->exact[0], first[c]->box, triangles, d))
          around[c].push_back(d);
    }
    const auto is_farther_out = [&around](std::size_t c, std::size_t d) {
      return around[c].size() < around[d].size();
    };
    std::stable_sort(order.begin(), order.end(), is_farther_out);
    for(const std::size_t c : order)
      if(!around[c].empty()) {
        const std::size_t next =
            *std::max_element(around[c].begin(), around[c].end(), is_farther_out);
        if(outer_[next] == next && CGAL::sign(volume[c]) != CGAL::sign(volume[next])) {
          outer_[c] = next;
          euler_[next] += euler_[c];
        }
      }
    for(Triangle& t : triangles)
      t.component = outer_[t.component];
  }

  // Each inlet is that of one curve: those that are nearest to each other first.
  void move_to_inlets(const Skeleton& skeleton) {
    std::vector<std::tuple<double, std::size_t, std::size_t>> near_ones;
    for(std::size_t p = 0; p < skeleton.points.size(); ++p)
      for(std::size_t i = 0; i < caps_.size() && skeleton.is_inlet[p]; ++i)
        if(caps_[i].component == skeleton.component[p])
          near_ones.emplace_back(largest_difference(skeleton.points[p], caps_[i].hub), p, i);
    std::sort(near_ones.begin(), near_ones.end());
    std::set<std::size_t> is_taken; // caps
    for(const auto& [distance, p, i] : near_ones)
      if(hub_of_point[p] == -1 && is_taken.insert(i).second) {
        hub_of_point[p] = static_cast<int>(i);
        caps_[i].hub = skeleton.points[p];
      }
  }

  static double largest_difference(const Place& p, const Place& q) {
    double largest = 0.;
    for(int d = 0; d < 3; ++d)
      largest = (std::max)(largest, std::abs(p[d] - q[d]));
    return largest;
  }

  const Mesh& mesh_;
  std::map<Vertex, std::size_t> component_;
  std::vector<long> euler_;        // by component
  std::vector<std::size_t> outer_; // by component, that of the piece of the solid
  std::vector<Cap> caps_;
};

// By the number of faces that a ray meets: upwards, or along another one if it meets an edge. The
// point lies in a box.
inline bool is_in_solid(const Exact_place& p,
                        const Double_box& around,
                        const std::vector<Triangle>& triangles,
                        std::size_t component) {
  for(int attempt = 0;; ++attempt) {
    const Exact::Vector_3 along =
        attempt == 0 ? Exact::Vector_3(0, 0, 1)
                     : Exact::Vector_3(1 + 7 * attempt % 11, 0.618 + attempt, 0.3 - 0.9 * attempt);
    const Exact_place far = p + along;
    int number = 0;
    bool is_decided = true;
    for(const Triangle& t : triangles) {
      if(t.component != component || (attempt == 0 && t.box.is_beside(around)))
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

// A triangle without area is no more than its sides.
inline bool is_on(const Exact_place& p, const Exact::Triangle_3& t) {
  if(!t.is_degenerate())
    return t.has_on(p);
  for(int k = 0; k < 3; ++k)
    if(p == t[k] || (t[k] != t[k + 1] && Exact::Segment_3(t[k], t[k + 1]).has_on(p)))
      return true;
  return false;
}

inline bool is_off_faces(const Exact_place& p, const std::vector<Triangle>& triangles) {
  return std::none_of(triangles.begin(), triangles.end(),
                      [&p](const Triangle& t) { return is_on(p, t.exact); });
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

// Whether no two edges meet but in a common end.
inline bool is_embedded(const Skeleton& skeleton) {
  std::vector<Double_box> boxes;
  for(const Edge& e : skeleton.edges)
    boxes.push_back(Double_box({skeleton.points[e[0]], skeleton.points[e[1]]}));
  for(std::size_t i = 0; i < boxes.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(!boxes[i].is_apart_from(boxes[j]) &&
         meet_wrongly(skeleton, skeleton.edges[i], skeleton.edges[j]))
        return false;
  return true;
}

// ---- linking numbers

using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
using Rounded_place = Predicates::Point_3;
using Polygon = std::vector<Rounded_place>;

// 1 if a segment crosses a triangle from its positive side, -1 if it does from its negative one,
// and 0 if they do not meet; nothing is decided if one meets the border of the other.
inline int crossing_number(const Rounded_place& p,
                           const Rounded_place& q,
                           const std::array<Rounded_place, 3>& t,
                           bool& is_decided) {
  const auto side_p = CGAL::orientation(t[0], t[1], t[2], p),
             side_q = CGAL::orientation(t[0], t[1], t[2], q);
  if(side_p == side_q && side_p != CGAL::COPLANAR)
    return 0;
  const std::array<CGAL::Orientation, 3> around = {CGAL::orientation(p, q, t[0], t[1]),
                                                   CGAL::orientation(p, q, t[1], t[2]),
                                                   CGAL::orientation(p, q, t[2], t[0])};
  const auto count = [&](CGAL::Orientation o) {
    return std::count(around.begin(), around.end(), o);
  };
  if(count(CGAL::POSITIVE) > 0 && count(CGAL::NEGATIVE) > 0)
    return 0;
  is_decided = is_decided && side_p != CGAL::COPLANAR && side_q != CGAL::COPLANAR &&
               count(CGAL::COPLANAR) == 0;
  return side_p == CGAL::POSITIVE ? 1 : -1;
}

// Another one for each attempt.
inline Rounded_place place_beside(const Polygon& rim, int attempt) {
  const CGAL::Bbox_3 box = CGAL::bbox_3(rim.begin(), rim.end());
  const double size =
      (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  return {box.xmin() + (0.123 + 1.7 * attempt) * size, box.ymin() + (0.377 + 0.9 * attempt) * size,
          box.zmin() + (0.511 - attempt) * size};
}

// How often some edges cross the triangles from a point to the sides of a closed line.
inline std::map<std::size_t, int>
crossing_numbers(const Skeleton& skeleton, const std::set<std::size_t>& edges, const Polygon& rim) {
  for(int attempt = 0;; ++attempt) {
    const Rounded_place apex = place_beside(rim, attempt);
    std::map<std::size_t, int> numbers;
    bool is_decided = true;
    for(const std::size_t e : edges) {
      const Place &p = skeleton.points[skeleton.edges[e][0]],
                  &q = skeleton.points[skeleton.edges[e][1]];
      for(std::size_t k = 0; k < rim.size() && is_decided; ++k)
        numbers[e] +=
            crossing_number(Rounded_place(p[0], p[1], p[2]), Rounded_place(q[0], q[1], q[2]),
                            {apex, rim[k], rim[(k + 1) % rim.size()]}, is_decided);
    }
    if(is_decided)
      return numbers;
  }
}

// An edge, and 1 or -1, which tells from which end to which.
using Step = std::pair<std::size_t, int>;

// How often a closed line goes along each edge, those along which it goes forth and back left out.
using Cycle = std::map<std::size_t, int>;

// The cycles that edges outside a tree make with it, found by depth-first search.
inline std::vector<Cycle> cycles_of(const Skeleton& skeleton, std::size_t component) {
  std::map<std::size_t, std::vector<Step>> at; // that lead away
  for(std::size_t e = 0; e < skeleton.edges.size(); ++e)
    if(skeleton.component[skeleton.edges[e][0]] == component) {
      at[skeleton.edges[e][0]].emplace_back(e, 1);
      at[skeleton.edges[e][1]].emplace_back(e, -1);
    }
  const auto end = [&](const Step& s) { return skeleton.edges[s.first][s.second == 1 ? 1 : 0]; };
  const auto begin = [&](const Step& s) { return skeleton.edges[s.first][s.second == 1 ? 0 : 1]; };
  const std::size_t none = skeleton.edges.size();
  std::map<std::size_t, Step> step_to; // by point
  std::set<std::size_t> is_used;       // edges
  for(const auto& item : at) {
    std::vector<std::size_t> stack;
    if(step_to.emplace(item.first, Step(none, 0)).second)
      stack.push_back(item.first);
    while(!stack.empty()) {
      const std::size_t p = stack.back();
      stack.pop_back();
      for(const Step& s : at[p])
        if(step_to.emplace(end(s), s).second) {
          is_used.insert(s.first);
          stack.push_back(end(s));
        }
    }
  }
  // To the root and from there.
  std::vector<Cycle> cycles;
  for(std::size_t e = 0; e < skeleton.edges.size(); ++e)
    if(skeleton.component[skeleton.edges[e][0]] == component && is_used.count(e) == 0) {
      cycles.push_back({{e, 1}});
      for(int k = 0; k < 2; ++k)
        for(Step s = step_to.at(skeleton.edges[e][k]); s.first != none; s = step_to.at(begin(s)))
          if((cycles.back()[s.first] += k == 0 ? s.second : -s.second) == 0)
            cycles.back().erase(s.first);
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
  const std::vector<Cycle> cycles = cycles_of(skeleton, component);
  std::set<std::size_t> edges;
  for(const Cycle& cycle : cycles)
    for(const auto& step : cycle)
      edges.insert(step.first);
  Integer_matrix matrix;
  for(const auto& pair : pairs) {
    std::vector<typename boost::graph_traits<Mesh>::halfedge_descriptor> walk;
    CGAL::loop_to_halfedges(pair.loop(type), mesh, std::back_inserter(walk));
    if(walk.empty() || surface.component(target(walk[0], mesh)) != component)
      continue;
    Polygon rim;
    for(const auto h : walk) {
      const auto& p = get(get(CGAL::vertex_point, mesh), target(h, mesh));
      rim.push_back(Rounded_place(p.x(), p.y(), p.z()));
    }
    const std::map<std::size_t, int> numbers = crossing_numbers(skeleton, edges, rim);
    matrix.emplace_back();
    for(const auto& cycle : cycles) {
      int sum = 0;
      for(const auto& [e, sign] : cycle)
        sum += sign * numbers.at(e);
      matrix.back().push_back(sum);
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
       !is_in_solid(middle, Double_box({skeleton.points[e[0]], skeleton.points[e[1]]}),
                    surface.triangles, c))
      truth.edges_outside.insert(e);
  }
  truth.is_inside = truth.edges_outside.empty();
  truth.is_embedded = is_embedded(skeleton);
  for(std::size_t p = 0; p < skeleton.points.size(); ++p)
    if(is_with_edge.count(p) == 0) {
      const Exact_place place = exact_place(skeleton.points[p]);
      truth.is_inside = truth.is_inside && is_off_faces(place, surface.triangles) &&
                        is_in_solid(place, Double_box({skeleton.points[p]}), surface.triangles,
                                    skeleton.component[p]);
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
    if(!surface.is_outer(c))
      continue;
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
    // The faces of a component that is taken alone may look inside.
    bool is_basis = false;
    for(const auto type : {CGAL::Loop_type::HANDLE, CGAL::Loop_type::TUNNEL})
      is_basis = is_basis || abs(linking_determinant(mesh, surface, skeleton, pairs, type, c)) == 1;
    truth.is_basis = truth.is_basis && is_basis;
  }
  return truth;
}

} // namespace skeleton_definitions

#endif // HTL_TEST_SKELETON_DEFINITIONS_H
