// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FACE_BOXES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FACE_BOXES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/halved_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
A tree of boxes around faces: to find what is near a point or on a way, and what may meet a box.

Faces that are long and thin have several boxes, one beside the other. Coordinates are rounded to
single precision, once the whole is moved and scaled, and boxes made larger by more than that does;
four boxes are looked at at once.
*/
class Face_boxes
{
public:
  /// of faces 0 .. n - 1; `triangle(i)` has the corners of the i-th.
  template <typename Function>
  Face_boxes(Execution execution, std::size_t n, const Function& triangle) {
    place(n, triangle);
    const std::vector<Index> begin = number_parts(execution, n, triangle);
    std::vector<Index> face_of_part;
    if(begin.back() > n)
      for(std::size_t f = 0; f < n; ++f)
        face_of_part.resize(begin[f + 1], static_cast<Index>(f));
    const auto box_of_part = [&](Index part) {
      const Index f = face_of_part.empty() ? part : face_of_part[part];
      return box(triangle(f), part - begin[f], begin[f + 1] - begin[f]);
    };
    order_ = halved_order<group_size>(execution, begin.back(), box_of_part);
    build(execution, [&](std::size_t i) { return box_of_part(order_[i]); });
    if(!face_of_part.empty())
      for(Index& part : order_)
        part = face_of_part[part];
  }

  /// calls `f(face)` for the faces that are nearer to a point than the root of a limit, about the
  /// nearest first, and for others; `f` returns the limit from there on. Of a long face this may be
  /// more than once.
  template <typename Function>
  void for_each_nearer(const Vector& p, double limit, const Function& f) const {
    const Point at = placed(p);
    const auto placed_square = [this](double x) { return scale_ * (scale_ * x); };
    visit_nearer(
        placed_square(limit), [&](const Group& group) { return squared_distances(at, group); },
        [&](Index face) { return placed_square(f(face)); });
  }

  /// the same for the faces that are on a way: a direction and, as the limit, how far in that.
  template <typename Function>
  void
  for_each_on_way(const Vector& p, const Vector& direction, double limit, const Function& f) const {
    constexpr float most = 1e30f;
    const Point at = placed(p);
    Point inverse;
    for(int d = 0; d < 3; ++d) {
      const float i = 1.f / static_cast<float>(direction[d]);
      inverse[d] = (std::max)(-most, (std::min)(most, i));
    }
    visit_nearer(
        scale_ * limit, [&](const Group& group) { return ways(at, inverse, group); },
        [&](Index face) { return scale_ * f(face); });
  }

  /// whether `f(face)` holds for any face of which a box meets the given one, and may hold for
  /// others; ends with the first. Of a long face it may be asked more than once.
  template <typename Predicate> bool any_meeting(const Box<3>& box, const Predicate& f) const {
    constexpr float none = (std::numeric_limits<float>::min)(); // of a gap
    const Point low = placed(box.low), high = placed(box.high);
    bool is_found = false;
    visit_nearer(
        none, [&](const Group& group) { return gaps(low, high, group); },
        [&](Index face) {
          is_found = f(face);
          return is_found ? -far_away : none;
        });
    return is_found;
  }

private:
  static constexpr std::size_t group_size = 8;

  using Point = std::array<float, 3>;
  using Numbers = std::array<float, group_size>;

  // Some boxes, or fewer and others far away. Around groups, or in a leaf around faces, of which
  // the first has number `below`.
  struct Group
  {
    std::array<Numbers, 3> low, high;
    Index below;
  };
  static constexpr float far_away = 1e15f;

  // What is left to look at, the last first.
  class Open_groups
  {
  public:
    struct Group
    {
      float distance;
      Index number;
    };

    std::size_t size() const { return size_; }
    void push(const Group& group) { all_[size_++] = group; }
    Group pop() { return all_[--size_]; }

    // The nearest last. Nothing branches that can't be foretold.
    void push_nearer(const Numbers& distances, Index first, float limit) {
      const std::size_t begin = size_;
      for(Index k = 0; k < group_size; ++k) {
        all_[size_] = {distances[k], first + k};
        size_ += distances[k] < limit ? 1 : 0;
      }
      for(std::size_t i = begin; i + 1 < size_; ++i)
        if(all_[i].distance < all_[size_ - 1].distance)
          std::swap(all_[i], all_[size_ - 1]);
    }

  private:
    static constexpr std::size_t most_levels = 11; // of numbers of 32 bits
    std::array<Group, most_levels * group_size + 1> all_;
    std::size_t size_ = 0;
  };

  // ---- building

  // The middle of all goes to the origin, and nothing is much farther away than 1.
  template <typename Function> void place(std::size_t n, const Function& triangle) {
    constexpr int most = 1022; // of powers of two without loss
    Box<3> all = Box<3>::empty();
    for(std::size_t i = 0; i < n; ++i)
      for(const Vector& p : triangle(static_cast<Index>(i)))
        all.extend({p, p});
    double extent = 0., largest = 0.;
    for(int d = 0; d < 3 && n > 0; ++d) {
      origin_[d] = 0.5 * all.low[d] + 0.5 * all.high[d];
      extent = (std::max)(extent, half_difference(all.high[d], all.low[d]));
      largest = (std::max)({largest, std::abs(all.low[d]), std::abs(all.high[d])});
    }
    int exponent = 0;
    std::frexp(extent, &exponent);
    scale_ = std::ldexp(1., (std::max)(-most, (std::min)(most, -exponent)));
    margin_ = 0x1p-20 + largest * scale_ * 0x1p-48;
  }

  double placed(double x, int d) const { return (x - origin_[d]) * scale_; }
  Point placed(const Vector& p) const {
    return {static_cast<float>(placed(p[0], 0)), static_cast<float>(placed(p[1], 1)),
            static_cast<float>(placed(p[2], 2))};
  }

  // The number of the first part of each face: thin faces have so many that their boxes are not
  // much wider, as long as there are not too many in all.
  template <typename Function>
  std::vector<Index>
  number_parts(Execution execution, std::size_t n, const Function& triangle) const {
    constexpr double longest = 4., most_parts = 256.;
    constexpr std::size_t more_parts = 20000;
    std::vector<float> length(n), width(n);
    for_each_index(execution, n, [&](std::size_t i) {
      const Triangle t = triangle(static_cast<Index>(i));
      std::array<double, 3> extents;
      double square = 0.; // of the longest side
      for(int d = 0; d < 3; ++d) {
        const auto [low, high] = std::minmax({t[0][d], t[1][d], t[2][d]});
        extents[d] = (high - low) * scale_;
        const Vector side = scale_ * (t[d] - t[(d + 1) % 3]);
        square = (std::max)(square, dot(side, side));
      }
      std::sort(extents.begin(), extents.end());
      const Vector normal = cross(scale_ * (t[1] - t[0]), scale_ * (t[2] - t[0]));
      length[i] = static_cast<float>(extents[1]);
      width[i] = static_cast<float>(square > 0. ? longest * norm(normal) / std::sqrt(square) : 0.);
    });
    double sum = 0.;
    for(std::size_t i = 0; i < n; ++i)
      if(length[i] > width[i])
        sum += length[i];
    const double least = sum / static_cast<double>(n + more_parts);
    std::vector<Index> begin(n + 1, 0);
    for(std::size_t i = 0; i < n; ++i) {
      const double parts =
          length[i] > width[i] ? std::ceil(length[i] / (std::max)(least, double(width[i]))) : 1.;
      begin[i + 1] = begin[i] + static_cast<Index>((std::max)(1., (std::min)(most_parts, parts)));
    }
    return begin;
  }

  // Of a part of a face, which is cut across the axis along which it is longest.
  Box<3> box(const Triangle& triangle, Index part, Index number) const {
    std::array<Vector, 3> t;
    Box<3> box = Box<3>::empty();
    for(int k = 0; k < 3; ++k) {
      for(int d = 0; d < 3; ++d)
        t[k][d] = placed(triangle[k][d], d);
      box.extend({t[k], t[k]});
    }
    if(number > 1)
      box = box_between(t, box, part, number);
    for(int d = 0; d < 3; ++d) {
      box.low[d] -= margin_;
      box.high[d] += margin_;
    }
    return box;
  }

  static Box<3>
  box_between(const std::array<Vector, 3>& t, const Box<3>& all, Index part, Index number) {
    std::size_t axis = 0;
    for(std::size_t d = 1; d < 3; ++d)
      if(all.high[d] - all.low[d] > all.high[axis] - all.low[axis])
        axis = d;
    const double step = (all.high[axis] - all.low[axis]) / number;
    const double low = all.low[axis] + part * step, high = all.low[axis] + (part + 1.) * step;
    Box<3> box = Box<3>::empty();
    for(int k = 0; k < 3; ++k) {
      const Vector &a = t[k], &b = t[(k + 1) % 3];
      const double from = (std::max)(low, (std::min)(a[axis], b[axis])),
                   to = (std::min)(high, (std::max)(a[axis], b[axis]));
      if(from > to)
        continue;
      const double length = b[axis] - a[axis];
      for(const double x : {from, to}) {
        const double ratio = length == 0. ? 0. : (x - a[axis]) / length;
        const Vector p = (1. - ratio) * a + ratio * b;
        box.extend({p, p});
      }
      if(length == 0.)
        box.extend({b, b});
    }
    return box;
  }

  // Leaves first, the root last.
  template <typename Function> void build(Execution execution, const Function& box) {
    add_groups(execution, order_.size(), 0, box);
    number_of_leaves_ = static_cast<Index>(groups_.size());
    for(std::size_t begin = 0, n = groups_.size(); n > 1;) {
      add_groups(execution, n, begin, [&](std::size_t i) { return union_of(groups_[begin + i]); });
      begin += n;
      n = groups_.size() - begin;
    }
  }

  template <typename Function>
  void add_groups(Execution execution, std::size_t n, std::size_t below, const Function& box) {
    const std::size_t begin = groups_.size(),
                      number = (std::max)(std::size_t(1), (n + group_size - 1) / group_size);
    groups_.resize(begin + number);
    for_each_index(execution, number, [&](std::size_t g) {
      Group& group = groups_[begin + g];
      group.below = static_cast<Index>(below + g * group_size);
      for(std::size_t k = 0; k < group_size; ++k) {
        const bool is_box = g * group_size + k < n;
        const Box<3> b = is_box ? box(g * group_size + k) : Box<3>::empty();
        for(int d = 0; d < 3; ++d) {
          group.low[d][k] = is_box ? static_cast<float>(b.low[d]) : far_away;
          group.high[d][k] = is_box ? static_cast<float>(b.high[d]) : far_away;
        }
      }
    });
  }

  static Box<3> union_of(const Group& group) {
    Box<3> box = Box<3>::empty();
    for(std::size_t k = 0; k < group_size && group.low[0][k] < far_away; ++k)
      for(int d = 0; d < 3; ++d) {
        box.low[d] = (std::min)(box.low[d], double(group.low[d][k]));
        box.high[d] = (std::max)(box.high[d], double(group.high[d][k]));
      }
    return box;
  }

  // ---- four boxes at once: loops without branches, which compilers make one of vectors

  static float larger(float a, float b) { return a > b ? a : b; }
  static float smaller(float a, float b) { return a < b ? a : b; }

  static float squared_distance(float x, float low, float high) {
    const float below = low - x, above = x - high;
    const float off = (below < 0.f ? 0.f : below) + (above < 0.f ? 0.f : above);
    return off * off; // not a number where x is none, and so not near
  }

  BOOST_NOINLINE static Numbers squared_distances(const Point& p, const Group& g) {
    Numbers squares;
    for(std::size_t k = 0; k < group_size; ++k)
      squares[k] = squared_distance(p[0], g.low[0][k], g.high[0][k]) +
                   squared_distance(p[1], g.low[1][k], g.high[1][k]) +
                   squared_distance(p[2], g.low[2][k], g.high[2][k]);
    return squares;
  }

  BOOST_NOINLINE static Numbers ways(const Point& p, const Point& inverse, const Group& g) {
    constexpr float infinite = std::numeric_limits<float>::infinity(), sure = 1.f + 1e-5f;
    Numbers ways;
    for(std::size_t k = 0; k < group_size; ++k) {
      const float x = (g.low[0][k] - p[0]) * inverse[0], u = (g.high[0][k] - p[0]) * inverse[0],
                  y = (g.low[1][k] - p[1]) * inverse[1], v = (g.high[1][k] - p[1]) * inverse[1],
                  z = (g.low[2][k] - p[2]) * inverse[2], w = (g.high[2][k] - p[2]) * inverse[2];
      const float first = larger(larger(smaller(x, u), smaller(y, v)), larger(smaller(z, w), 0.f)),
                  last = smaller(smaller(larger(x, u), larger(y, v)), larger(z, w));
      ways[k] = first <= last * sure ? first : infinite;
    }
    return ways;
  }

  // How far boxes are from a box along some axis, or not.
  BOOST_NOINLINE static Numbers gaps(const Point& low, const Point& high, const Group& g) {
    Numbers gaps;
    for(std::size_t k = 0; k < group_size; ++k) {
      const float x = larger(g.low[0][k] - high[0], low[0] - g.high[0][k]),
                  y = larger(g.low[1][k] - high[1], low[1] - g.high[1][k]),
                  z = larger(g.low[2][k] - high[2], low[2] - g.high[2][k]);
      gaps[k] = larger(larger(x, y), z);
    }
    return gaps;
  }

  // ---- walking

  Index root() const { return static_cast<Index>(groups_.size() - 1); }
  bool is_leaf(Index group) const { return group < number_of_leaves_; }

  // Calls `f(face)`, which returns the limit from there on.
  template <typename Distances, typename Function>
  void visit_nearer(double first_limit, const Distances& distances, const Function& f) const {
    const auto bounded = [](double limit) {
      return static_cast<float>((std::min)(limit, 1e-3 * far_away));
    };
    float limit = bounded(first_limit);
    Open_groups open;
    for(open.push({0.f, root()}); open.size() > 0;) {
      const auto [distance, number] = open.pop();
      if(!(distance < limit))
        continue;
      const std::size_t begin = open.size();
      open.push_nearer(distances(groups_[number]), groups_[number].below, limit);
      while(is_leaf(number) && open.size() > begin)
        if(const auto box = open.pop(); box.distance < limit)
          limit = bounded(f(order_[box.number]));
    }
  }

  Vector origin_ = {};
  double scale_ = 1., margin_ = 0.;
  std::vector<Index> order_; // the face of each box
  std::vector<Group> groups_;
  Index number_of_leaves_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_FACE_BOXES_H
