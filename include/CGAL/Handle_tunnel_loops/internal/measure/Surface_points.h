// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_SURFACE_POINTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_SURFACE_POINTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <boost/container_hash/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Points on the surface, close together where that matters.

A face is halved across its longest side until its pieces are small; corners of pieces are points.
So no point of a piece with sides of length s or less is farther than \f$ s / \sqrt{3} \f$ from a
point, nor one of a side of a face farther than s / 2.
*/
class Surface_points
{
public:
  Surface_points(Execution execution, const Face_tree& faces)
      : faces_(faces)
      , side_square_(faces.size()) {
    for_each_index(execution, faces.size(), [&](std::size_t f) {
      side_square_[f] = longest_side(faces.triangle(static_cast<Index>(f))).second;
    });
  }

  const std::vector<Vector>& points() const { return points_; }

  void add(const Vector& p) {
    if(known_.insert(p).second)
      points_.push_back(p);
  }

  /// how many points there may be at most when faces are divided as is asked for.
  void set_most(std::size_t most) { most_ = most; }

  bool is_full() const { return points_.size() >= most_; }

  /// What is nearer to a place than a radius is to be divided into pieces with sides of such a
  /// length.
  struct Request
  {
    Vector place;
    double radius, side;
  };

  /// divides faces as is asked for. A corner close to a point that is there already is left out: of
  /// long and thin faces there are many side by side.
  void refine(Execution execution, const std::vector<Request>& requests) {
    auto met = collect<Met>(execution, requests.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<Met> found;
      for(std::size_t r = begin; r < end; ++r) {
        const double limit = requests[r].radius * requests[r].radius;
        faces_.boxes().for_each_nearer(requests[r].place, limit, [&](Index f) {
          if(side_square_[f] > requests[r].side * requests[r].side)
            found.push_back({f, static_cast<Index>(r)});
          return limit;
        });
      }
      return found;
    });
    std::sort(met.begin(), met.end());
    met.erase(std::unique(met.begin(), met.end()), met.end());
    std::vector<const Request*> asked;
    for(std::size_t i = 0; i < met.size() && !is_full(); ++i) {
      asked.push_back(&requests[met[i][1]]);
      if(i + 1 == met.size() || met[i + 1][0] != met[i][0]) {
        divide(faces_.triangle(met[i][0]), asked);
        asked.clear();
      }
    }
  }

  /// divides faces until sides are no longer than a part of the distance to what faces them, or
  /// than \p least.
  void refine_by_thickness(Execution execution, const Wall& wall, double part, double least) {
    const auto corners =
        collect<Corner>(execution, faces_.size(), [&](std::size_t begin, std::size_t end) {
          std::vector<Corner> found;
          for(Index f = static_cast<Index>(begin); f < end; ++f)
            divide_by_thickness(faces_.triangle(f), {f, wall, part, least}, found);
          return found;
        });
    for(const Corner& corner : corners)
      add_unless_close(corner.place, corner.level);
  }

private:
  using Met = std::array<Index, 2>; // a face and a request

  /// Of a piece, and the exponent of the distance of what is close to it.
  struct Corner
  {
    Vector place;
    int level;
  };

  struct Thickness_rule
  {
    Index face;
    const Wall& wall;
    double part, least;
  };

  // Which it is, and its square.
  static std::pair<int, double> longest_side(const Triangle& t) {
    int longest = 0;
    double length = 0.;
    for(int k = 0; k < 3; ++k) {
      const Vector side = t[(k + 1) % 3] - t[k];
      if(const double square = dot(side, side); square > length) {
        length = square;
        longest = k;
      }
    }
    return {longest, length};
  }

  // By a point, the same from both faces at a side. The other corner comes last.
  static std::array<Triangle, 2> halves(const Triangle& t, int longest) {
    const Vector &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3],
                 middle = 0.5 * (a + b);
    return {Triangle{a, middle, c}, Triangle{middle, b, c}};
  }

  static void
  divide_by_thickness(const Triangle& t, const Thickness_rule& rule, std::vector<Corner>& corners) {
    const auto [longest, square] = longest_side(t);
    const double side = std::sqrt(square);
    if(side <= rule.least)
      return;
    const double wanted = (std::max)(rule.least, rule.part * thickness(t, rule, side / rule.part));
    if(side <= wanted)
      return;
    const auto pieces = halves(t, longest);
    corners.push_back({pieces[0][1], std::ilogb(wanted / 3.)});
    for(const Triangle& piece : pieces)
      divide_by_thickness(piece, rule, corners);
  }

  // From the middle of a piece to the nearer of the faces on both sides that look towards it, if
  // they are no farther away than is given.
  static double thickness(const Triangle& t, const Thickness_rule& rule, double most) {
    constexpr double facing = -0.3;
    double thickness = most;
    const Vector middle = (1. / 3.) * (t[0] + t[1] + t[2]), normal = rule.wall.normal(rule.face);
    const double length = norm(normal);
    if(length > 0.)
      for(const double sign : {1., -1.}) {
        const Vector direction = (sign / length) * normal;
        const auto [way, met] = rule.wall.first_on_way(middle, direction, rule.face, 0., thickness);
        if(met != no_index)
          if(const Vector other = rule.wall.normal(met);
             dot(other, normal) < facing * norm(other) * length)
            thickness = way;
      }
    return thickness;
  }

  void divide(const Triangle& t, const std::vector<const Request*>& requests) {
    const auto [longest, square] = longest_side(t);
    std::vector<const Request*> asked;
    double side = std::numeric_limits<double>::infinity();
    for(const Request* r : requests)
      if(square > r->side * r->side) {
        const Vector way = nearest_point(r->place, t[0], t[1], t[2]) - r->place;
        if(dot(way, way) < r->radius * r->radius) {
          asked.push_back(r);
          side = (std::min)(side, r->side);
        }
      }
    if(asked.empty() || is_full())
      return;
    const auto pieces = halves(t, longest);
    add_unless_close(pieces[0][1], std::ilogb(side / 3.));
    for(const Triangle& piece : pieces)
      divide(piece, asked);
  }

  // A cube of a grid.
  using Cell = std::array<std::int64_t, 4>;

  void add_unless_close(const Vector& p, int level) {
    const auto [x, y, z, l] = cell(p, level);
    const double distance = std::ldexp(1., level);
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j)
        for(int k = -1; k <= 1; ++k)
          if(const auto known = point_in_.find(Cell{x + i, y + j, z + k, l});
             known != point_in_.end())
            if(const Vector way = points_[known->second] - p; dot(way, way) < distance * distance)
              return;
    point_in_.emplace(Cell{x, y, z, l}, static_cast<Index>(points_.size()));
    add(p);
  }

  static Cell cell(const Vector& p, int level) {
    const auto part = [level](double x) {
      return static_cast<std::int64_t>(std::floor(std::ldexp(x, -level)));
    };
    return {part(p[0]), part(p[1]), part(p[2]), level};
  }

  const Face_tree& faces_;
  std::size_t most_ = (std::numeric_limits<std::size_t>::max)();
  std::vector<double> side_square_; // of the longest side, by face
  std::vector<Vector> points_;
  std::unordered_map<Cell, Index, boost::hash<Cell>> point_in_;
  std::unordered_set<Vector, boost::hash<Vector>> known_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_SURFACE_POINTS_H
