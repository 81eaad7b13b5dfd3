// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_STREAMLINE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_STREAMLINE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_flat_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>

#include <CGAL/assertions.h>
#include <CGAL/use.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/// A place on the mesh: `a + ratio * (b - a)` on an edge, or a vertex, if `a` is `b`.
struct Surface_point
{
  Index a, b;
  double ratio;

  bool is_vertex() const { return a == b; }
  bool has_end(Index v) const { return a == v || b == v; }
};

inline Surface_point vertex_point(Index v) { return {v, v, 0.}; }

inline bool are_same_vertex(const Surface_point& p, const Surface_point& q) {
  return p.is_vertex() && q.is_vertex() && p.a == q.a;
}

/// takes out, from a closed line, each step from a vertex there and back.
inline void remove_turns(std::vector<Surface_point>& line) {
  for(std::size_t i = 0; i < line.size() && line.size() > 1;) {
    const std::size_t n = line.size(), next = (i + 1) % n, over_next = (i + 2) % n;
    if(are_same_vertex(line[i], line[next])) {
      line.erase(line.begin() + static_cast<std::ptrdiff_t>(next));
      i = 0;
    } else if(n > 2 && line[next].is_vertex() && are_same_vertex(line[i], line[over_next])) {
      line.erase(line.begin() + static_cast<std::ptrdiff_t>((std::max)(next, over_next)));
      line.erase(line.begin() + static_cast<std::ptrdiff_t>((std::min)(next, over_next)));
      i = 0;
    } else
      ++i;
  }
}

/// appends how a line crosses the edge of a place on its way to the next one.
inline void append_across(const Flat_mesh& mesh,
                          const Surface_point& p,
                          const Surface_point& next,
                          Crossing_loop& loop) {
  const Index apex = p.has_end(next.a) ? next.b : next.a;
  if(mesh.ring(p.a).after(p.b) == apex)
    loop.push_back({p.a, p.b, p.ratio});
  else
    loop.push_back({p.b, p.a, 1. - p.ratio});
}

/// appends the edges at a vertex, clockwise from where a line comes from to where it goes to.
inline void append_around(const Flat_mesh& mesh,
                          Index v,
                          const Surface_point& from,
                          const Surface_point& to,
                          Crossing_loop& loop) {
  const Ring ring = mesh.ring(v);
  const auto clockwise_end = [&](const Surface_point& p) { // of an edge of the ring
    const Index position = ring.position(p.a);
    return ring[ring.next(position)] == p.b ? position : ring.position(p.b);
  };
  const Index end = to.is_vertex() ? ring.position(to.a) : clockwise_end(to);
  Index p = from.is_vertex() ? ring.previous(ring.position(from.a)) : clockwise_end(from);
  CGAL_precondition(p < ring.size() && end < ring.size());
  for(; p != end; p = ring.previous(p))
    loop.push_back({ring[p], v, 1.});
}

/// turns a closed line of places, of which consecutive ones lie in a common triangle but not on a
/// common edge unless at its ends, into a crossing loop. At vertices it passes on their left.
inline Crossing_loop loop_of_line(const Flat_mesh& mesh, const std::vector<Surface_point>& line) {
  Crossing_loop loop;
  const std::size_t n = line.size();
  for(std::size_t i = 0; i < n; ++i) {
    const Surface_point &previous = line[(i + n - 1) % n], &next = line[(i + 1) % n];
    if(line[i].is_vertex())
      append_around(mesh, line[i].a, previous, next, loop);
    else
      append_across(mesh, line[i], next, loop);
  }
  remove_backtracks(loop);
  return loop;
}

/*!
A streamline of the arrival time (paper, 4.2): from a vertex back to where the field came from,
straight through each triangle along the gradient.

The time is linear in each triangle. Where it falls towards an edge from both sides, and where a
wall crosses a triangle, the line follows the edge to its earlier end; at a vertex it takes the
steepest way out. The time never grows along the line, and the vertices that it passes become
earlier and earlier, so it ends at a source.
*/
class Streamline
{
public:
  Streamline(const Flat_mesh& mesh, const Arrivals& arrivals)
      : mesh_(mesh)
      , arrivals_(arrivals) {}

  /// the line from `start`, reached but no source, to a source: a vertex of time 0.
  std::vector<Surface_point> trace(Index start) {
    line_.assign(1, vertex_point(start));
    while(!is_at_source())
      if(line_.back().is_vertex())
        leave_vertex(line_.back().a);
      else
        cross_triangle();
    return line_;
  }

private:
  // The way of steepest descent from the first corner of a triangle: it falls by `slope` per length
  // and leaves the triangle at `p`.
  struct Way
  {
    double slope;
    Surface_point p;
  };

  double time(Index v) const { return arrivals_.time(v); }
  double time(const Surface_point& p) const {
    return (1. - p.ratio) * time(p.a) + p.ratio * time(p.b);
  }

  bool is_earlier(Index u, Index v) const { return arrivals_.rank(u) < arrivals_.rank(v); }

  bool is_at_source() const { return line_.back().is_vertex() && time(line_.back().a) == 0.; }

  // Also takes out what lies on the edges of the vertex, so that no two places share an edge.
  void append_vertex(Index v) {
    while(line_.back().has_end(v) && !line_.back().is_vertex())
      line_.pop_back();
    line_.push_back(vertex_point(v));
  }

  void append(const Surface_point& p) {
    if(p.is_vertex())
      append_vertex(p.a);
    else if(time(p.a) == 0. || time(p.b) == 0.)
      append_vertex(time(p.a) == 0. ? p.a : p.b);
    else
      line_.push_back(p);
  }

  // Whether the time is defined in all of the triangle (v, ring[i], ring[i + 1]).
  bool is_open(Index v, Index i) const {
    const Ring ring = mesh_.ring(v);
    const Index a = ring[i], b = ring[ring.next(i)];
    return arrivals_.is_reached(v) && arrivals_.is_reached(a) && arrivals_.is_reached(b) &&
           !arrivals_.is_wall(v, i) && !arrivals_.is_wall(v, ring.next(i)) &&
           !arrivals_.is_wall(a, mesh_.ring(a).position(b));
  }

  // The gradient in a triangle is -(s p + t q), where p and q are the edges from its first corner.
  // Returns whether it is defined.
  bool find_descent(Index o, Index a, Index b, double& s, double& t) const {
    const Vector p = mesh_.points[a] - mesh_.points[o], q = mesh_.points[b] - mesh_.points[o];
    const double pp = dot(p, p), pq = dot(p, q), qq = dot(q, q);
    const double determinant = pp * qq - pq * pq;
    if(!(determinant > 1e-12 * pp * qq))
      return false;
    const double drop_a = time(o) - time(a), drop_b = time(o) - time(b);
    s = (qq * drop_a - pq * drop_b) / determinant;
    t = (pp * drop_b - pq * drop_a) / determinant;
    return true;
  }

  void leave_vertex(Index v) {
    const Ring ring = mesh_.ring(v);
    Way best = {-1., vertex_point(v)};
    const auto consider = [&best](const Way& way) {
      if(way.slope > best.slope)
        best = way;
    };
    for(Index i = 0; i < ring.size(); ++i) {
      if(!arrivals_.is_wall(v, i) && is_earlier(ring[i], v))
        consider({slope_along(v, ring[i]), vertex_point(ring[i])});
      if(is_open(v, i))
        consider(way_through(v, ring[i], ring[ring.next(i)]));
    }
    CGAL_assertion_msg(best.slope >= 0., "a vertex that is no source has an earlier neighbor");
    append(best.p);
  }

  double slope_along(Index v, Index u) const {
    const double distance = mesh_.edge_length(u, v);
    return distance > 0. ? (time(v) - time(u)) / distance : (std::numeric_limits<double>::max)();
  }

  Way way_through(Index v, Index a, Index b) const {
    double s = 0., t = 0.;
    if(!find_descent(v, a, b, s, t) || !(s > 0. && t > 0.))
      return {-1., vertex_point(v)};
    const Vector direction =
        s * (mesh_.points[a] - mesh_.points[v]) + t * (mesh_.points[b] - mesh_.points[v]);
    const Surface_point p = {a, b, inner(t / (s + t))};
    return {time(p) < time(v) ? norm(direction) : -1., p};
  }

  // Away from the ends, so that places on edges and vertices cannot be confused.
  static double inner(double ratio) { return (std::min)(0.999, (std::max)(0.001, ratio)); }

  // From a place on an edge through the triangle ahead, which the line has not come from.
  void cross_triangle() {
    const Surface_point p = line_.back();
    const Index apex = apex_ahead_of_line();
    Surface_point next = vertex_point(is_earlier(p.a, p.b) ? p.a : p.b);
    const Ring ring = mesh_.ring(apex);
    const Index i = ring.position(p.a);
    CGAL_assertion(i < ring.size());
    if(is_open(apex, ring[ring.next(i)] == p.b ? i : ring.previous(i))) {
      const Surface_point through = way_out(p, apex);
      if(!through.is_vertex() && time(through) < time(p))
        next = through;
    }
    append(next);
  }

  // The corner of the triangle on the other side of the last place.
  Index apex_ahead_of_line() const {
    const Surface_point &p = line_.back(), &previous = line_[line_.size() - 2];
    const Index behind = p.has_end(previous.a) ? previous.b : previous.a;
    const Index apex = mesh_.ring(p.a).after(p.b);
    return apex == behind ? mesh_.ring(p.a).before(p.b) : apex;
  }

  // In the coordinates of the corners (a, b, apex) the descent is (-s - t, s, t). A vertex if it
  // does not lead into the triangle.
  Surface_point way_out(const Surface_point& p, Index apex) const {
    double s = 0., t = 0.;
    if(!find_descent(p.a, p.b, apex, s, t) || !(t > 0.))
      return vertex_point(apex);
    const double unbounded = (std::numeric_limits<double>::max)();
    const double to_a = s < 0. ? p.ratio / -s : unbounded; // until the coordinate of b is zero
    const double to_b = s + t > 0. ? (1. - p.ratio) / (s + t) : unbounded;
    const bool leaves_at_a = to_a < to_b;
    return {leaves_at_a ? p.a : p.b, apex, inner(t * (leaves_at_a ? to_a : to_b))};
  }

  const Flat_mesh& mesh_;
  const Arrivals& arrivals_;
  std::vector<Surface_point> line_;
};

/// the length of a loop up to each crossing, and in all.
inline std::vector<double> lengths_up_to(const Flat_mesh& mesh, const Crossing_loop& loop) {
  std::vector<double> lengths(1, 0.);
  for(std::size_t i = 0; i < loop.size(); ++i)
    lengths.push_back(lengths.back() +
                      norm(position(mesh, loop[(i + 1) % loop.size()]) - position(mesh, loop[i])));
  return lengths;
}

/// goes on from `left`, a vertex on the left side of a loop, along the loop, the short way, to
/// beside `right`. Leaves out what shares an edge with the ends.
inline void append_along(const Flat_mesh& mesh,
                         const Crossing_loop& loop,
                         Index left,
                         Index right,
                         std::vector<Surface_point>& line) {
  const std::vector<double> along = lengths_up_to(mesh, loop);
  Shorter_arc arc(loop.data(), static_cast<Index>(loop.size()), along.data());
  const bool has_found = arc.find(&Crossing::left, left, &Crossing::right, right);
  CGAL_assertion_msg(has_found, "a line begins and ends at the loop");
  CGAL_USE(has_found);
  std::vector<Surface_point> way;
  arc.for_each([&](const Crossing& c) { way.push_back({c.left, c.right, c.ratio}); });
  auto first = way.begin(), last = way.end();
  while(first != last && first->has_end(left))
    ++first;
  while(first != last && std::prev(last)->has_end(right))
    --last;
  line.insert(line.end(), first, last);
}

/*!
The operation of the tunnel pass and the refinement pass (paper, 4.2 and 4.3): a field grows from
the left side of a loop, which is a wall, until it comes to the right side. From the places that it
comes to streamlines lead back to the left side; along the loop, and across it, they are closed.

`walls` are edges that may not be crossed, those of the loop among them. Returns the loops of all
streamlines, the shortest first.
*/
inline std::vector<Crossing_loop> dual_loops(const Flat_mesh& mesh,
                                             const Field_constants& constants,
                                             const Literal_rules& rules,
                                             const Crossing_loop& loop,
                                             const Barred_edges& walls) {
  Single_field field(mesh, constants, walls, rules);
  for(const Crossing& c : loop)
    field.add_source(c.left);
  std::vector<char> is_target(mesh.number_of_vertices(), 0);
  for(const Crossing& c : loop)
    is_target[c.right] = !field.is_source(c.right);
  if(std::count(is_target.begin(), is_target.end(), 1) == 0)
    return {};
  std::vector<Crossing_loop> loops;
  std::vector<Index> targets = field.run_until(is_target);
  if(rules.are_of_fields() && targets.empty())
    throw Literal_failure_exception("a field came to rest on its way around a loop");
  if(rules.first_reached && targets.size() > 1)
    targets.resize(1);
  for(const Index target : targets) {
    std::vector<Surface_point> line = Streamline(mesh, field.arrivals()).trace(target);
    append_along(mesh, loop, line.back().a, target, line);
    remove_turns(line);
    loops.push_back(loop_of_line(mesh, line));
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [&](const auto& a, const auto& b) { return is_shorter(mesh, a, b); });
  return loops;
}

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_STREAMLINE_H
