// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CONTACT_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CONTACT_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Oriented_box.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Principal_axes.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/triangles_apart.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Finds pairs of triangles that may meet elsewhere than in a vertex or an edge that they share,
/// where boxes along the axes of the coordinates are of little use: of long triangles, which share
/// a vertex with thousands of others, and of large ones in many layers.
///
/// Triangles are in a tree of oriented boxes, those of a hub, which is a vertex of many, in a part
/// of their own. Two parts of the same hub are not compared: two triangles at a vertex meet
/// elsewhere just if they do as seen from it, so at a hub directions are compared. Near linear,
/// but for sorting, in the number of triangles and of pairs that are found.
class Contact_search
{
public:
  using Point = std::array<double, 3>;

  struct Triangle
  {
    std::array<Index, 3> vertices;
    std::array<Point, 3> points;
  };

  /// all triangles have an area. If \p number_of_first is not 0, these are compared with all
  /// others, but not with each other, nor the others with each other.
  explicit Contact_search(std::vector<Triangle> triangles, std::size_t number_of_first = 0)
      : triangles_(std::move(triangles))
      , number_of_first_(number_of_first) {
    CGAL_precondition(number_of_first <= triangles_.size());
    scale_points();
    find_hubs();
    build();
  }

  /// calls `f(i, j)` for pairs of triangles that may meet, some of them several times.
  template <typename Function>
  void for_each_candidate(Execution execution, const Function& f) const {
    visit(execution, std::atomic<bool>(false), f);
  }

  /// whether `f(i, j)` holds for any of those; ends soon after the first.
  template <typename Predicate> bool any_candidate(Execution execution, const Predicate& f) const {
    std::atomic<bool> is_found(false);
    visit(execution, is_found, [&](Index i, Index j) {
      if(!is_found && f(i, j))
        is_found = true;
    });
    return is_found;
  }

  /// how many pairs of boxes were compared.
  std::size_t work() const { return work_; }

private:
  static constexpr std::size_t hub_size = 64;
  static constexpr std::size_t leaf_size = 4;
  static constexpr Index no_hub = static_cast<Index>(-1);

  using Iterator = std::vector<Index>::iterator;

  struct Node
  {
    Oriented_box box;
    std::size_t begin, end;     // in the order
    Index hub;                  // that all have in common
    Index children[2] = {0, 0}; // none, if these are 0

    std::size_t size() const { return end - begin; }
    bool is_leaf() const { return children[0] == 0; }
  };

  using Node_pair = std::pair<Index, Index>;

  template <typename Function>
  void visit(Execution execution, const std::atomic<bool>& is_over, const Function& f) const {
    if(!nodes_.empty())
      compare_parts(execution, is_over, f);
    for(std::size_t hub = 0; hub < hubs_.size() && !is_over; ++hub)
      compare_directions(execution, is_over, hub, f);
  }

  // By a power of two, to be between -1 and 1.
  void scale_points() {
    double largest = 0.;
    for(const Triangle& t : triangles_)
      for(const Point& p : t.points)
        for(const double x : p)
          largest = (std::max)(largest, std::abs(x));
    int exponent = 0;
    std::frexp(largest, &exponent);
    for(Triangle& t : triangles_)
      for(Point& p : t.points)
        for(double& x : p)
          x = std::ldexp(x, -exponent);
  }

  void find_hubs() {
    std::size_t number_of_vertices = 0;
    for(const Triangle& t : triangles_)
      for(const Index v : t.vertices)
        number_of_vertices = (std::max)(number_of_vertices, v + std::size_t(1));
    std::vector<Index> count(number_of_vertices, 0), number(number_of_vertices, no_hub);
    for(const Triangle& t : triangles_)
      for(const Index v : t.vertices)
        ++count[v];
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      if(count[v] > hub_size) {
        number[v] = static_cast<Index>(hubs_.size());
        hubs_.emplace_back();
        vertices_of_hubs_.push_back(static_cast<Index>(v));
      }
    hub_of_.assign(triangles_.size(), no_hub);
    for(std::size_t i = 0; i < triangles_.size(); ++i)
      for(const Index v : triangles_[i].vertices)
        if(number[v] != no_hub) {
          hubs_[number[v]].push_back(static_cast<Index>(i));
          hub_of_[i] = number[v]; // any of them, as it is compared at each
        }
  }

  void build() {
    const std::size_t n = triangles_.size();
    for(std::size_t i = 0; i < n; ++i)
      order_.push_back(static_cast<Index>(i));
    const auto by_hub = [this](Index a, Index b) { return hub_of_[a] < hub_of_[b]; };
    const auto first = order_.begin(),
               others = first + static_cast<std::ptrdiff_t>(number_of_first_);
    std::stable_sort(first, others, by_hub);
    std::stable_sort(others, order_.end(), by_hub);
    if(n > number_of_first_)
      add_node(0, n);
  }

  Index add_node(std::size_t begin, std::size_t end) {
    const Index node = static_cast<Index>(nodes_.size());
    const bool is_of_both = begin < number_of_first_ && number_of_first_ < end;
    const bool is_of_one_hub = !is_of_both && hub_of_[order_[begin]] == hub_of_[order_[end - 1]];
    nodes_.push_back(
        {box_of(begin, end), begin, end, is_of_one_hub ? hub_of_[order_[begin]] : no_hub});
    if(end - begin <= leaf_size && is_of_one_hub)
      return node;
    const std::size_t middle = is_of_both      ? number_of_first_
                               : is_of_one_hub ? halve(begin, end)
                                               : split_hubs(begin, end);
    const Index first = add_node(begin, middle), second = add_node(middle, end);
    nodes_[node].children[0] = first;
    nodes_[node].children[1] = second;
    return node;
  }

  Oriented_box box_of(std::size_t begin, std::size_t end) const {
    return Oriented_box([&](const auto& f) {
      for(std::size_t i = begin; i < end; ++i)
        for(const Point& p : triangles_[order_[i]].points)
          f(p);
    });
  }

  Point center(Index triangle) const {
    const auto& [p, q, r] = triangles_[triangle].points;
    return {(p[0] + q[0] + r[0]) / 3., (p[1] + q[1] + r[1]) / 3., (p[2] + q[2] + r[2]) / 3.};
  }

  // As long as the triangle is large.
  Point normal(Index triangle) const {
    const auto& [p, q, r] = triangles_[triangle].points;
    const Point a = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    const Point b = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  // Along the axis on which their centers spread farthest beside their own extents, so that the
  // boxes of the halves have little in common: of a stack, across the triangles. The axes that are
  // tried are those of their centers and of their normals. Of wedges beside each other around a
  // hub, only the latter are across all of them: centers are at all distances from the hub. Of
  // many, some are asked.
  Point axis_to_halve(std::size_t begin, std::size_t end) const {
    constexpr std::size_t enough = 128;
    const std::size_t step = (end - begin) / enough + 1;
    const auto for_some = [&](const auto& f) {
      for(std::size_t i = begin; i < end; i += step)
        f(order_[i]);
    };
    const std::array<Point, 3> of_centers =
        Principal_axes::of_points([&](const auto& f) { for_some([&](Index i) { f(center(i)); }); });
    const std::array<Point, 3> of_normals = Principal_axes::of_directions(
        [&](const auto& f) { for_some([&](Index i) { f(normal(i)); }); });
    Point best{};
    double most = -1.;
    for(const auto& axes : {of_centers, of_normals})
      for(const Point& axis : axes) {
        const double spread = relative_spread(axis, for_some);
        if(spread > most) {
          most = spread;
          best = axis;
        }
      }
    return best;
  }

  template <typename For_some>
  double relative_spread(const Point& axis, const For_some& for_some) const {
    double low = 8., high = -8., extents = 1e-9,
           number = 0.; // more than rounding makes of what is flat
    for_some([&](Index i) {
      const double height = Oriented_box::dot(center(i), axis);
      low = (std::min)(low, height);
      high = (std::max)(high, height);
      extents += extent(i, axis);
      number += 1.;
    });
    return (high - low) * number / extents;
  }

  double extent(Index triangle, const Point& axis) const {
    const auto& [p, q, r] = triangles_[triangle].points;
    const auto [low, high] = std::minmax(
        {Oriented_box::dot(p, axis), Oriented_box::dot(q, axis), Oriented_box::dot(r, axis)});
    return high - low;
  }

  std::size_t halve(std::size_t begin, std::size_t end) {
    const Point axis = axis_to_halve(begin, end);
    const auto position = [&](Index i) {
      return std::make_pair(Oriented_box::dot(center(i), axis), i);
    };
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) {
      return order_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](Index a, Index b) { return position(a) < position(b); });
    return middle;
  }

  // Where the hub begins, or ends, that has the one in the middle.
  std::size_t split_hubs(std::size_t begin, std::size_t end) const {
    const Index hub = hub_of_[order_[begin + (end - begin) / 2]];
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = order_.begin() + static_cast<std::ptrdiff_t>(end);
    auto border = std::partition_point(first, last, [&](Index i) { return hub_of_[i] < hub; });
    if(border == first)
      border = std::partition_point(first, last, [&](Index i) { return hub_of_[i] <= hub; });
    return static_cast<std::size_t>(border - order_.begin());
  }

  bool have_hub_in_common(const Node& a, const Node& b) const {
    return a.hub != no_hub && a.hub == b.hub;
  }

  // What remains to be compared of two parts, which may be one and the same.
  template <typename Add> void split(const Node_pair& pair, const Add& add) const {
    const auto [a, b] = pair;
    const Node &node_a = nodes_[a], &node_b = nodes_[b];
    if(a == b) {
      add(Node_pair(node_a.children[0], node_a.children[0]));
      add(Node_pair(node_a.children[0], node_a.children[1]));
      add(Node_pair(node_a.children[1], node_a.children[1]));
    } else {
      // Pairs are of parts of about the same size.
      const bool is_first =
          !node_a.is_leaf() && (node_b.is_leaf() || node_a.size() >= node_b.size());
      for(const Index child : (is_first ? node_a : node_b).children)
        add(is_first ? Node_pair(child, b) : Node_pair(a, child));
    }
  }

  bool may_meet(const Node_pair& pair) const {
    const Node &a = nodes_[pair.first], &b = nodes_[pair.second];
    return !have_hub_in_common(a, b) &&
           (pair.first == pair.second || (a.box.meets(b.box) && !is_beside(b, a.box) &&
                                          !is_beside(a, b.box) && !are_separated(a, b)));
  }

  // Whether all points are on the same side of the slab that a box is where it is thinnest. A box
  // around a triangle is twice as large as that, so this tells layers apart where they bend. Ends
  // with the first point that is not there; as there are the fewer pairs the larger parts are, it
  // takes about as long for parts of any size.
  bool is_beside(const Node& node, const Oriented_box& box) const {
    const int side = box.side_of_slab(triangles_[order_[node.begin]].points[0]);
    for(std::size_t i = node.begin; side != 0 && i < node.end; ++i)
      for(const Point& p : triangles_[order_[i]].points)
        if(box.side_of_slab(p) != side)
          return false;
    return side != 0;
  }

  // The point of a part that is farthest in a direction.
  Point farthest(const Node& node, const Point& direction) const {
    Point best{};
    double most = -std::numeric_limits<double>::infinity();
    for(std::size_t i = node.begin; i < node.end; ++i)
      for(const Point& p : triangles_[order_[i]].points) {
        const double height = Oriented_box::dot(p, direction);
        if(height > most) {
          most = height;
          best = p;
        }
      }
    return best;
  }

  // Looks for a direction in which one part ends before the other begins: where two points stand
  // against one, that is reflected in the direction from one to the other (Chung and Wang 1996).
  // There may be one even if none is found: only a few are tried, and none for large parts, nor for
  // so small ones that to look at each triangle takes less.
  bool are_separated(const Node& a, const Node& b) const {
    constexpr std::size_t largest_size = 32;
    if((std::max)(a.size(), b.size()) > largest_size || a.size() + b.size() <= 2 * leaf_size)
      return false;
    constexpr int number_of_trials = 3;
    constexpr double margin = 1e-12;
    const auto &p = a.box.center(), &q = b.box.center();
    Point direction = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    for(int i = 0; i < number_of_trials && normalize(direction); ++i) {
      const Point end = farthest(a, direction);
      const Point begin = farthest(b, {-direction[0], -direction[1], -direction[2]});
      Point gap = {begin[0] - end[0], begin[1] - end[1], begin[2] - end[2]};
      if(Oriented_box::dot(direction, gap) > margin)
        return true;
      if(!normalize(gap))
        return false;
      const double twice = 2. * Oriented_box::dot(direction, gap);
      for(std::size_t k = 0; k < 3; ++k)
        direction[k] -= twice * gap[k];
    }
    return false;
  }

  static bool normalize(Point& vector) {
    const double length = std::sqrt(Oriented_box::dot(vector, vector));
    for(double& x : vector)
      x /= length;
    return length > 0.;
  }

  bool are_leaves(const Node_pair& pair) const {
    return nodes_[pair.first].is_leaf() && nodes_[pair.second].is_leaf();
  }

  // So many pairs that all threads have something to do, then each of them to its end.
  template <typename Function>
  void
  compare_parts(Execution execution, const std::atomic<bool>& is_over, const Function& f) const {
    constexpr std::size_t enough = 4096;
    std::vector<Node_pair> pairs = {{0, 0}};
    if(number_of_first_ > 0)
      pairs = {{nodes_[0].children[0], nodes_[0].children[1]}};
    for(bool is_changed = true; is_changed && pairs.size() < enough;) {
      is_changed = false;
      std::vector<Node_pair> next;
      for(const Node_pair& pair : pairs)
        if(are_leaves(pair)) {
          next.push_back(pair);
        } else if(may_meet(pair)) {
          is_changed = true;
          split(pair, [&next](const Node_pair& p) { next.push_back(p); });
        }
      work_ += pairs.size();
      pairs = std::move(next);
    }
    for_each_index(
        execution, pairs.size(), [&](std::size_t i) { compare_to_the_end(pairs[i], is_over, f); },
        16);
  }

  template <typename Function>
  void compare_to_the_end(const Node_pair& pair,
                          const std::atomic<bool>& is_over,
                          const Function& f) const {
    std::vector<Node_pair> open = {pair};
    std::size_t number = 0;
    for(; !open.empty() && !is_over; ++number) {
      const Node_pair next = open.back();
      open.pop_back();
      if(!may_meet(next))
        continue;
      if(are_leaves(next))
        compare_leaves(nodes_[next.first], nodes_[next.second], f);
      else
        split(next, [&open](const Node_pair& p) { open.push_back(p); });
    }
    work_ += number;
  }

  template <typename Function>
  void compare_leaves(const Node& a, const Node& b, const Function& f) const {
    for(std::size_t i = a.begin; i < a.end; ++i)
      for(std::size_t j = &a == &b ? i + 1 : b.begin; j < b.end; ++j)
        if(!are_seen_apart(triangles_[order_[i]].points, triangles_[order_[j]].points))
          f(order_[i], order_[j]);
  }

  // Those that are seen from their hub near each other: on a cube around it a triangle is an arc of
  // some segments, which are searched as triangles are.
  template <typename Function>
  void compare_directions(Execution execution,
                          const std::atomic<bool>& is_over,
                          std::size_t hub,
                          const Function& f) const {
    std::vector<Triangle> segments;
    std::vector<Index> triangle_of;
    std::size_t number_of_first = 0;
    for(const Index i : hubs_[hub]) { // in ascending order
      append_arc(triangles_[i], vertices_of_hubs_[hub], segments);
      triangle_of.resize(segments.size(), i);
      if(i < number_of_first_)
        number_of_first = segments.size();
    }
    if(number_of_first_ > 0 && (number_of_first == 0 || number_of_first == segments.size()))
      return;
    for(std::size_t i = 0; i < segments.size(); ++i) // none shares a vertex with many
      segments[i].vertices.fill(static_cast<Index>(i));
    const Contact_search search(std::move(segments), number_of_first);
    search.compare_parts(execution, is_over, [&](Index i, Index j) {
      if(triangle_of[i] != triangle_of[j])
        f(triangle_of[i], triangle_of[j]);
    });
    work_ += search.work();
  }

  // Where the triangle is as seen from a corner, on the surface of the cube between -1 and 1. What
  // is between two directions changes to another face of the cube only where coordinates are equal,
  // or opposite. Where the two are all but opposite themselves that is anywhere.
  static void append_arc(const Triangle& t, Index corner, std::vector<Triangle>& segments) {
    const auto k = static_cast<std::size_t>(
        std::find(t.vertices.begin(), t.vertices.end(), corner) - t.vertices.begin());
    const Point a = direction(t.points[k], t.points[(k + 1) % 3]);
    const Point b = direction(t.points[k], t.points[(k + 2) % 3]);
    std::vector<double> places = {0., 1.};
    for(std::size_t i = 0; i < 3; ++i)
      for(const double sign : {1., -1.}) {
        const double at_a = a[i] + sign * a[(i + 1) % 3], at_b = b[i] + sign * b[(i + 1) % 3];
        if((at_a < 0. && at_b > 0.) || (at_a > 0. && at_b < 0.))
          places.push_back(at_a / (at_a - at_b));
      }
    std::sort(places.begin(), places.end());
    const Point origin = {0., 0., 0.};
    constexpr double least = 1e-3;
    std::array<Point, 8> ends;
    for(std::size_t i = 0; i < places.size(); ++i) {
      const double u = 1. - places[i], v = places[i];
      const Point p = {u * a[0] + v * b[0], u * a[1] + v * b[1], u * a[2] + v * b[2]};
      if(largest(p) < least)
        return append_cube(segments);
      ends[i] = direction(origin, p);
    }
    for(std::size_t i = 1; i < places.size(); ++i)
      segments.push_back({{}, {ends[i - 1], ends[i], ends[i]}});
  }

  // All of its surface.
  static void append_cube(std::vector<Triangle>& segments) {
    for(std::size_t axis = 0; axis < 3; ++axis)
      for(const double side : {-1., 1.}) {
        const auto corner = [axis, side](double x, double y) {
          Point p{};
          p[axis] = side;
          p[(axis + 1) % 3] = x;
          p[(axis + 2) % 3] = y;
          return p;
        };
        segments.push_back({{}, {corner(-1., -1.), corner(1., -1.), corner(1., 1.)}});
        segments.push_back({{}, {corner(-1., -1.), corner(1., 1.), corner(-1., 1.)}});
      }
  }

  static double largest(const Point& d) {
    return (std::max)({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
  }

  // Differences are right to the last digits, and so is this, unless points are denormally close.
  static Point direction(const Point& from, const Point& to) {
    Point d = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    const double length = largest(d);
    for(double& x : d)
      x /= length;
    return d;
  }

  std::vector<Triangle> triangles_;      // scaled
  std::size_t number_of_first_;          // 0 if all are compared with all
  std::vector<std::vector<Index>> hubs_; // their triangles
  std::vector<Index> vertices_of_hubs_;
  std::vector<Index> hub_of_, order_;
  std::vector<Node> nodes_;
  mutable std::atomic<std::size_t> work_{0};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CONTACT_SEARCH_H
