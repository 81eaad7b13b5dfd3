// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CLOSED_TRIANGLES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CLOSED_TRIANGLES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Closed_graph_traits.h>

#include <CGAL/Simple_cartesian.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A `Triangle_list` as a closed model of `FaceListGraph`, and the loops on it. Boundary curves are
/// closed by caps: fans of faces around a vertex more, the hub.
class Closed_triangles
{
public:
  /// A halfedge by its number. It stands for its face, too, where it is the first one of that.
  struct Halfedge
  {
    Index number = no_index;

    friend bool operator==(Halfedge a, Halfedge b) { return a.number == b.number; }
    friend bool operator!=(Halfedge a, Halfedge b) { return a.number != b.number; }
    friend bool operator<(Halfedge a, Halfedge b) { return a.number < b.number; }
  };

  using Point = Simple_cartesian<double>::Point_3;
  using Loop = Loop_on_surface<Closed_triangles, Point>;
  using Walk = std::vector<Halfedge>;

  explicit Closed_triangles(Triangle_list list)
      : list_(std::move(list)) {
    if(!list_.is_closed)
      add_caps();
  }

  /// the boundary curves, with the surface to their left.
  std::vector<Walk> boundaries() const {
    std::vector<Walk> boundaries;
    for(Index hub = list_.first_hub; hub < list_.arriving.size(); ++hub) {
      Walk walk;
      const Halfedge first = {list_.arriving[hub]};
      Halfedge h = first;
      do {
        walk.push_back(opposite(prev(h, *this), *this));
        h = opposite(next(h, *this), *this);
      } while(h != first);
      boundaries.push_back(std::move(walk));
    }
    return boundaries;
  }

  bool is_in_cap(Halfedge h) const {
    return (std::max)({target(h, *this), target(next(h, *this), *this), source(h, *this)}) >=
           list_.first_hub;
  }

  /// loops as what follows wants them; a step that is on no edge remains so.
  std::vector<Loop> loops(const std::vector<Listed_loop>& listed) const;

  struct Point_map
  {
    using key_type = Index;
    using value_type = Point;
    using reference = Point;
    using category = boost::readable_property_map_tag;

    const Closed_triangles* triangles = nullptr;

    friend Point get(const Point_map& map, Index v) {
      const Vector& p = map.triangles->coordinates(v);
      return Point(p[0], p[1], p[2]);
    }
  };
  Point_map point() const { return {this}; }
  const Vector& coordinates(Index v) const { return list_.points[v]; }
  bool has_points() const { return !list_.points.empty(); }
  using Vertex_index_map = boost::typed_identity_property_map<Index>;

  friend Index target(Halfedge h, const Closed_triangles& t) { return t.list_.target[h.number]; }
  friend Index source(Halfedge h, const Closed_triangles& t) { return target(prev(h, t), t); }
  friend Halfedge opposite(Halfedge h, const Closed_triangles& t) {
    return {t.list_.opposite[h.number]};
  }
  friend Halfedge next(Halfedge h, const Closed_triangles&) {
    return {h.number % 3 == 2 ? h.number - 2 : h.number + 1};
  }
  friend Halfedge prev(Halfedge h, const Closed_triangles&) {
    return {h.number % 3 == 0 ? h.number + 2 : h.number - 1};
  }
  friend Halfedge face(Halfedge h, const Closed_triangles&) { return {h.number - h.number % 3}; }
  friend Halfedge halfedge(Halfedge f, const Closed_triangles&) { return f; }
  friend Halfedge halfedge(Index v, const Closed_triangles& t) { return {t.list_.arriving[v]}; }
  friend std::pair<Halfedge, bool> halfedge(Index u, Index v, const Closed_triangles& t) {
    const Halfedge first = halfedge(v, t);
    Halfedge h = first;
    do {
      if(source(h, t) == u)
        return {h, true};
      h = opposite(next(h, t), t);
    } while(h != first);
    return {{}, false};
  }
  friend bool is_border(Halfedge, const Closed_triangles&) { return false; }

  /// Elements by their numbers: parts of them begin anywhere at no cost.
  template <Index step> struct Halfedge_of_number
  {
    Halfedge operator()(Index i) const { return {step * i}; }
  };
  template <typename Iterator> struct Range
  {
    Index size;
    Iterator begin() const { return at(0); }
    Iterator end() const { return at(size); }

    friend Range_parts<Iterator> parts_of(const Range& range) {
      constexpr Index part_size = 4096;
      std::vector<Iterator> bounds;
      for(Index i = 0; i < range.size; i += part_size)
        bounds.push_back(at(i));
      bounds.push_back(range.end());
      return {range.size, std::move(bounds)};
    }

  private:
    static Iterator at(Index i) { return Iterator(boost::counting_iterator<Index>(i)); }
  };
  using Vertex_iterator = boost::counting_iterator<Index>;
  using Halfedge_iterator = boost::transform_iterator<Halfedge_of_number<1>, Vertex_iterator>;
  using Face_iterator = boost::transform_iterator<Halfedge_of_number<3>, Vertex_iterator>;

  friend Range<Vertex_iterator> vertices(const Closed_triangles& t) {
    return {static_cast<Index>(t.list_.arriving.size())};
  }
  friend Range<Halfedge_iterator> halfedges(const Closed_triangles& t) {
    return {static_cast<Index>(t.list_.target.size())};
  }
  friend Range<Face_iterator> faces(const Closed_triangles& t) {
    return {static_cast<Index>(t.list_.number_of_faces())};
  }
  friend std::size_t num_vertices(const Closed_triangles& t) { return t.list_.arriving.size(); }
  friend std::size_t num_halfedges(const Closed_triangles& t) { return t.list_.target.size(); }
  friend std::size_t num_faces(const Closed_triangles& t) { return t.list_.number_of_faces(); }

private:
  // The cap faces of a curve follow each other; the first halfedge of each is on the curve.
  void add_caps() {
    CGAL_precondition(list_.first_hub == no_index);
    list_.first_hub = static_cast<Index>(list_.arriving.size());
    const Index number_of_halfedges = static_cast<Index>(list_.target.size());
    std::vector<Index> leaving(list_.arriving.size(), no_index); // by vertex, on the boundary
    for(Index h = 0; h < number_of_halfedges; ++h)
      if(list_.opposite[h] == no_index)
        leaving[source({h}, *this)] = h;
    for(Index h = 0; h < number_of_halfedges; ++h)
      if(list_.opposite[h] == no_index)
        add_cap(h, leaving);
  }

  void add_cap(Index first, const std::vector<Index>& leaving) {
    const Index hub = static_cast<Index>(list_.arriving.size());
    const Index begin = static_cast<Index>(list_.target.size());
    Vector sum = {0., 0., 0.};
    for(Index h = first; h != no_index && list_.opposite[h] == no_index;
        h = leaving[target({h}, *this)])
    {
      const Index u = source({h}, *this), cap = static_cast<Index>(list_.target.size());
      if(has_points())
        sum = sum + list_.points[u];
      list_.opposite[h] = cap;
      list_.target.insert(list_.target.end(), {u, hub, target({h}, *this)});
      // Its last halfedge lies on the next face of the curve, its second one on the face before.
      list_.opposite.insert(list_.opposite.end(), {h, cap - 1, cap + 4});
    }
    const Index end = static_cast<Index>(list_.target.size());
    list_.opposite[begin + 1] = end - 1;
    list_.opposite[end - 1] = begin + 1;
    list_.arriving.push_back(begin + 1);
    // Where a hub is decides nothing.
    if(has_points())
      list_.points.push_back((3. / double(end - begin)) * sum);
  }

  Triangle_list list_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

namespace boost {

template <>
struct graph_traits<CGAL::Handle_tunnel_loops::internal::Closed_triangles>
    : CGAL::Handle_tunnel_loops::internal::Closed_graph_traits<
          CGAL::Handle_tunnel_loops::internal::Closed_triangles>
{};

} // namespace boost

namespace CGAL::Handle_tunnel_loops::internal {

inline std::vector<Closed_triangles::Loop>
Closed_triangles::loops(const std::vector<Listed_loop>& listed) const {
  std::vector<Loop> loops;
  for(const Listed_loop& l : listed) {
    std::vector<Loop::Step> steps;
    for(const Listed_step& s : l)
      steps.push_back({{s.is_opposite ? list_.opposite[s.halfedge] : s.halfedge}, s.ratio});
    loops.emplace_back(std::move(steps), std::vector<Point>(), 0., Loop_type::HANDLE, loops.size());
  }
  return loops;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CLOSED_TRIANGLES_H
