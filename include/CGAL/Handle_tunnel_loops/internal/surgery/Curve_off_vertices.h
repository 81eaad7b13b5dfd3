// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CURVE_OFF_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CURVE_OFF_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Where a curve leaves a face, through a halfedge of it: between `ratio - margin` and `ratio +
/// margin`, of the way from its source to its target, it is alone on the edge.
struct Edge_crossing
{
  Index halfedge;
  double ratio;
  double margin = 0.;
};

/*!
A simple closed curve on the surface that comes to no vertex, nor to the boundary: the halfedges
that it crosses, in order. So faces can be divided along it, whatever their size and shape.
*/
class Curve_off_vertices
{
public:
  /// a short curve beside places that follow each other in faces: it passes by the vertices among
  /// these on the side where the angle is smaller, and is straight between those that it must pass
  /// by. None if the places are not of the mesh as it is by now, or if there is no such curve.
  static std::optional<Curve_off_vertices> beside(const Surgery_mesh& mesh,
                                                  const std::vector<Place_on_edge>& places) {
    constexpr int most_rounds = 6;
    std::optional<Curve_off_vertices> best;
    std::vector<Place_on_edge> next = places;
    for(int round = 0; round < most_rounds; ++round) {
      Curve_off_vertices curve;
      if(!curve.find(mesh, next) || (best && !(curve.length_ < 0.999 * best->length_)))
        break;
      next = curve.places(mesh);
      best = std::move(curve);
    }
    if(best)
      best->limit_margins(mesh);
    return best;
  }

  const std::vector<Edge_crossing>& crossings() const { return crossings_; }

  std::size_t size() const { return crossings_.size(); }

  /// the i-th crossing, and the one before.
  const Edge_crossing& operator[](std::size_t i) const { return crossings_[i]; }
  std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }

  double length() const { return length_; }

  Surgery_mesh::Point point(const Surgery_mesh& mesh, std::size_t i) const {
    return point_beside(mesh, crossings_[i], 0.);
  }

  /// a point beside a crossing, on the edge that is crossed there: towards the left if \p shift is
  /// positive.
  static Surgery_mesh::Point
  point_beside(const Surgery_mesh& mesh, const Edge_crossing& crossing, double shift) {
    // The same from both sides of the edge.
    const Index h = crossing.halfedge;
    const double ratio = crossing.ratio + shift;
    return CGAL::barycenter(mesh.point(mesh.source(h)), 1. - ratio, mesh.point(mesh.target(h)),
                            ratio);
  }

  /// the faces that the curve passes through, in ascending order.
  std::vector<Index> faces() const {
    std::vector<Index> faces;
    for(const Edge_crossing& crossing : crossings_)
      faces.push_back(Surgery_mesh::face(crossing.halfedge));
    make_set(faces);
    return faces;
  }

  /// the edges that are crossed an odd number of times, by both halfedges, in ascending order.
  std::vector<Index> odd_halfedges(const Surgery_mesh& mesh) const {
    std::vector<Index> edges;
    for(const Edge_crossing& crossing : crossings_)
      edges.push_back(edge(mesh, crossing.halfedge));
    std::sort(edges.begin(), edges.end());
    std::vector<Index> odd;
    for(auto i = edges.begin(); i != edges.end();) {
      const auto end = std::upper_bound(i, edges.end(), *i);
      if((end - i) % 2 == 1)
        odd.insert(odd.end(), {*i, mesh.twin(*i)});
      i = end;
    }
    std::sort(odd.begin(), odd.end());
    return odd;
  }

private:
  bool find(const Surgery_mesh& mesh, const std::vector<Place_on_edge>& places) {
    if(!follow(mesh, places))
      return false;
    remove_spurs(mesh);
    if(crossings_.size() < 3 || is_in_cap(mesh))
      return false;
    find_length(mesh);
    spread(mesh);
    straighten(mesh);
    find_length(mesh);
    return is_simple(mesh);
  }

  // With the vertices that it comes as near to as it may.
  std::vector<Place_on_edge> places(const Surgery_mesh& mesh) const {
    std::vector<Place_on_edge> places;
    for(const Edge_crossing& crossing : crossings_) {
      const double nearest = 3.001 * crossing.margin;
      const Index h = crossing.halfedge;
      places.push_back({mesh.source(h), mesh.target(h),
                        crossing.ratio <= nearest        ? 0.
                        : crossing.ratio >= 1. - nearest ? 1.
                                                         : crossing.ratio});
    }
    return places;
  }

  static Index edge(const Surgery_mesh& mesh, Index h) { return (std::min)(h, mesh.twin(h)); }

  static bool is_at_vertex(const Place_on_edge& p) { return p.ratio == 0. || p.ratio == 1.; }
  static Index vertex(const Place_on_edge& p) { return p.ratio == 0. ? p.source : p.target; }

  // The halfedge of a face from a vertex, or the one along an edge; no_index if there is none.
  static Index spoke(const Surgery_mesh& mesh, Index face, Index v) {
    for(Index h : {3 * face, 3 * face + 1, 3 * face + 2})
      if(mesh.source(h) == v)
        return h;
    return no_index;
  }
  static Index side(const Surgery_mesh& mesh, Index face, const Place_on_edge& p) {
    for(Index h : {3 * face, 3 * face + 1, 3 * face + 2})
      if(std::minmax(mesh.source(h), mesh.target(h)) == std::minmax(p.source, p.target))
        return h;
    return no_index;
  }

  // Whether the face of a halfedge from a vertex is one in which the curve goes on to another
  // place: that on the left or the right, if it is a vertex.
  static bool
  leads_to(const Surgery_mesh& mesh, Index spoke, const Place_on_edge& p, bool is_left) {
    if(is_at_vertex(p))
      return (is_left ? mesh.target(spoke) : mesh.source(mesh.previous(spoke))) == vertex(p);
    const Index opposite = mesh.next(spoke);
    return std::minmax(mesh.source(opposite), mesh.target(opposite)) ==
           std::minmax(p.source, p.target);
  }

  bool follow(const Surgery_mesh& mesh, std::vector<Place_on_edge> places) {
    const auto are_same = [](const Place_on_edge& p, const Place_on_edge& q) {
      return is_at_vertex(p) && is_at_vertex(q) && vertex(p) == vertex(q);
    };
    places.erase(std::unique(places.begin(), places.end(), are_same), places.end());
    while(places.size() > 1 && are_same(places.front(), places.back()))
      places.pop_back();
    if(places.size() < 2)
      return false;
    // If it begins between vertices, it comes back to the same face.
    const auto free = std::find_if_not(places.begin(), places.end(), is_at_vertex);
    std::rotate(places.begin(), free == places.end() ? places.begin() : free, places.end());
    const Index first = first_face(mesh, places[0], places[1]);
    Index face = first;
    for(std::size_t i = 1; i <= places.size() && face != no_index; ++i) {
      const std::size_t at = i % places.size(), next = (i + 1) % places.size();
      face = is_at_vertex(places[at]) ? pass_by(mesh, face, places[i - 1], places[at], places[next],
                                                at == 0 ? first : no_index)
                                      : cross_at(mesh, face, places[at]);
    }
    return face != no_index && face == first;
  }

  // The face to the left of the way from one place to another.
  static Index
  first_face(const Surgery_mesh& mesh, const Place_on_edge& from, const Place_on_edge& to) {
    if(is_at_vertex(from))
      return face_towards(mesh, vertex(from), to);
    const Index h = is_alive(mesh, from) ? mesh.halfedge(from.source, from.target) : no_index;
    if(h == no_index)
      return no_index;
    for(Index g : {h, mesh.twin(h)}) {
      const Index face = mesh.face(g);
      if(is_at_vertex(to) ? spoke(mesh, face, vertex(to)) != no_index
                          : side(mesh, face, to) != no_index)
        return face;
    }
    return no_index;
  }

  static bool is_alive(const Surgery_mesh& mesh, const Place_on_edge& p) {
    return mesh.outgoing(p.source) != no_index && mesh.outgoing(p.target) != no_index;
  }

  static Index face_towards(const Surgery_mesh& mesh, Index v, const Place_on_edge& to) {
    Index face = no_index;
    mesh.for_each_outgoing(v, [&](Index h) {
      if(leads_to(mesh, h, to, true))
        face = mesh.face(h);
    });
    return face;
  }

  // From a face through an edge of it to the next one.
  Index cross_at(const Surgery_mesh& mesh, Index face, const Place_on_edge& place) {
    const Index h = side(mesh, face, place);
    if(h == no_index)
      return no_index;
    cross(h, mesh.source(h) == place.source ? place.ratio : 1. - place.ratio);
    return mesh.face(mesh.twin(h));
  }

  // A way around a vertex: the edges from there that are crossed, and the face where it ends.
  struct Way_around
  {
    std::vector<Index> halfedges; // by which the curve leaves the faces
    Index face = no_index;        // none if there is no such way
    double angle = 0.;
  };

  // From a face around a vertex, to a face where it goes on to the next place: the one that is
  // given, if so.
  Index pass_by(const Surgery_mesh& mesh,
                Index face,
                const Place_on_edge& before,
                const Place_on_edge& place,
                const Place_on_edge& next,
                Index end) {
    const Index v = vertex(place);
    const Way_around left = way_around(mesh, face, v, before, next, end, true),
                     right = way_around(mesh, face, v, before, next, end, false);
    const bool is_left =
        right.face == no_index || (left.face != no_index && left.angle <= right.angle);
    const Way_around& way = is_left ? left : right;
    for(Index h : way.halfedges)
      cross(h, mesh.source(h) == v ? 0. : 1.);
    return way.face;
  }

  // On the left of the vertex is clockwise.
  Way_around way_around(const Surgery_mesh& mesh,
                        Index face,
                        Index v,
                        const Place_on_edge& before,
                        const Place_on_edge& next,
                        Index end,
                        bool is_left) const {
    Way_around way;
    Surgery_mesh::Point last = point_at(mesh, before);
    const auto turn_to = [&](const Surgery_mesh::Point& p) {
      way.angle += CGAL::approximate_angle(last, mesh.point(v), p);
      last = p;
    };
    const Index begin = face;
    for(;;) {
      const Index h = spoke(mesh, face, v);
      if(h == no_index)
        return {};
      if(leads_to(mesh, h, next, is_left) && (end == no_index || face == end)) {
        turn_to(point_at(mesh, next));
        way.face = face;
        return way;
      }
      const Index side = is_left ? h : mesh.previous(h);
      way.halfedges.push_back(side);
      turn_to(mesh.point(is_left ? mesh.target(h) : mesh.source(side)));
      face = mesh.face(mesh.twin(side));
      if(face == begin)
        return {};
    }
  }

  void cross(Index h, double ratio) { crossings_.push_back({h, ratio}); }

  // Where the curve crosses an edge and comes back at once.
  void remove_spurs(const Surgery_mesh& mesh) {
    std::vector<Edge_crossing> kept;
    const auto is_back = [&](const Edge_crossing& a, const Edge_crossing& b) {
      return mesh.twin(a.halfedge) == b.halfedge;
    };
    for(const Edge_crossing& crossing : crossings_)
      if(!kept.empty() && is_back(kept.back(), crossing))
        kept.pop_back();
      else
        kept.push_back(crossing);
    std::size_t begin = 0, end = kept.size();
    while(end - begin > 1 && is_back(kept[end - 1], kept[begin])) {
      ++begin;
      --end;
    }
    crossings_.assign(kept.begin() + begin, kept.begin() + end);
  }

  bool is_in_cap(const Surgery_mesh& mesh) const {
    return std::any_of(crossings_.begin(), crossings_.end(), [&](const Edge_crossing& crossing) {
      return mesh.is_in_cap(mesh.face(crossing.halfedge));
    });
  }

  void find_length(const Surgery_mesh& mesh) {
    length_ = 0.;
    for(std::size_t i = 0; i < size(); ++i)
      length_ += std::sqrt(CGAL::squared_distance(point(mesh, before(i)), point(mesh, i)));
  }

  // Gives crossings of the same edge, and vertices, room, as far as the edge is long enough; but no
  // more than is little against the length of the curve.
  void spread(const Surgery_mesh& mesh) {
    std::vector<std::pair<Index, std::size_t>> order; // edges, and the places of their crossings
    for(std::size_t i = 0; i < size(); ++i)
      order.push_back({edge(mesh, crossings_[i].halfedge), i});
    const auto ratio = [&](std::size_t i) {
      const Edge_crossing& crossing = crossings_[i];
      return edge(mesh, crossing.halfedge) == crossing.halfedge ? crossing.ratio
                                                                : 1. - crossing.ratio;
    };
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      return std::make_tuple(a.first, ratio(a.second), a.second) <
             std::make_tuple(b.first, ratio(b.second), b.second);
    });
    for(auto begin = order.begin(); begin != order.end();) {
      const auto end =
          std::find_if(begin, order.end(), [&](const auto& o) { return o.first != begin->first; });
      std::vector<double> ratios;
      for(auto i = begin; i != end; ++i)
        ratios.push_back(ratio(i->second));
      const double gap = spread(ratios, mesh, begin->first);
      for(auto i = begin; i != end; ++i) {
        Edge_crossing& crossing = crossings_[i->second];
        const double r = ratios[i - begin];
        crossing.ratio = crossing.halfedge == begin->first ? r : 1. - r;
        crossing.margin = gap / 3.;
      }
      begin = end;
    }
  }

  // Returns how far from each other they are, at least.
  double spread(std::vector<double>& ratios, const Surgery_mesh& mesh, Index h) const {
    constexpr double most_of_length = 0.005, least = 1e-7;
    const double room = 0.25 / double(ratios.size() + 1),
                 length = distance(mesh, mesh.source(h), mesh.target(h));
    const double gap = most_of_length * length_ < room * length
                           ? (std::max)(least, most_of_length * length_ / length)
                           : room;
    for(std::size_t i = 0; i < ratios.size(); ++i)
      ratios[i] = (std::max)(ratios[i], i == 0 ? gap : ratios[i - 1] + gap);
    for(std::size_t i = ratios.size(); i-- > 0;)
      ratios[i] = (std::min)(ratios[i], i + 1 == ratios.size() ? 1. - gap : ratios[i + 1] - gap);
    return gap;
  }

  // Moves crossings along their edges, but for those that share one.
  void straighten(const Surgery_mesh& mesh) {
    constexpr int number_of_passes = 8;
    std::vector<Index> edges;
    for(const Edge_crossing& crossing : crossings_)
      edges.push_back(edge(mesh, crossing.halfedge));
    std::sort(edges.begin(), edges.end());
    std::vector<char> is_alone;
    for(const Edge_crossing& crossing : crossings_) {
      const auto range =
          std::equal_range(edges.begin(), edges.end(), edge(mesh, crossing.halfedge));
      is_alone.push_back(range.second - range.first == 1);
    }
    for(int pass = 0; pass < number_of_passes; ++pass)
      for(std::size_t i = 0; i < size(); ++i)
        if(is_alone[i])
          straighten(mesh, i);
  }

  // As the two faces are in the plane.
  void straighten(const Surgery_mesh& mesh, std::size_t i) {
    using Step = Surgery_mesh::Kernel::Vector_3;
    Edge_crossing& crossing = crossings_[i];
    const Surgery_mesh::Point &a = mesh.point(mesh.source(crossing.halfedge)),
                              &b = mesh.point(mesh.target(crossing.halfedge));
    const double square = CGAL::squared_distance(a, b), gap = 3. * crossing.margin;
    const auto along = [&](const Surgery_mesh::Point& p) { return ((p - a) * (b - a)) / square; };
    const auto height = [&](const Surgery_mesh::Point& p) {
      const Step up = (p - a) - along(p) * (b - a);
      return std::sqrt(up.squared_length());
    };
    const Surgery_mesh::Point p = point(mesh, before(i)),
                              q = point(mesh, i + 1 == size() ? 0 : i + 1);
    const double h = height(p), k = height(q);
    if(h + k > 0.)
      crossing.ratio = std::clamp((along(p) * k + along(q) * h) / (h + k), gap, 1. - gap);
  }

  // To what is little against the way to the crossings before and after: points on edges that are
  // crossed at a sharp angle should follow each other as the crossings do.
  void limit_margins(const Surgery_mesh& mesh) {
    constexpr double most_of_way = 0.2;
    const auto way_to = [&](std::size_t i) {
      return std::sqrt(CGAL::squared_distance(point(mesh, before(i)), point(mesh, i)));
    };
    for(std::size_t i = 0; i < size(); ++i) {
      Edge_crossing& crossing = crossings_[i];
      const double way = (std::min)(way_to(i), way_to(i + 1 == size() ? 0 : i + 1)),
                   length = distance(mesh, mesh.source(crossing.halfedge),
                                     mesh.target(crossing.halfedge));
      if(most_of_way * way < crossing.margin * length)
        crossing.margin = most_of_way * way / length;
    }
  }

  // Whether its ways through each face do not cross: by the order of their ends around it.
  bool is_simple(const Surgery_mesh& mesh) const {
    struct Way
    {
      Index face;
      double begin, end; // the smaller one first

      bool separates(double place) const { return begin < place && place < end; }
    };
    std::vector<Way> ways;
    for(std::size_t i = 0; i < size(); ++i) {
      const Edge_crossing &from = crossings_[before(i)], &to = crossings_[i];
      // By value: they are temporary.
      const auto [begin, end] =
          std::minmax({mesh.twin(from.halfedge) % 3 + 1. - from.ratio, to.halfedge % 3 + to.ratio});
      ways.push_back({mesh.face(to.halfedge), begin, end});
    }
    std::stable_sort(ways.begin(), ways.end(),
                     [](const Way& a, const Way& b) { return a.face < b.face; });
    for(std::size_t i = 0; i < ways.size(); ++i)
      for(std::size_t j = i + 1; j < ways.size() && ways[j].face == ways[i].face; ++j)
        if(ways[i].separates(ways[j].begin) != ways[i].separates(ways[j].end))
          return false;
    return true;
  }

  std::vector<Edge_crossing> crossings_;
  double length_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CURVE_OFF_VERTICES_H
