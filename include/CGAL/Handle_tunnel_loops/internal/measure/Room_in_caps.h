// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_ROOM_IN_CAPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_ROOM_IN_CAPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Clearance.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
How wide balls are at most that pass a cap.

They do so at a point from which the surface is no nearer than their radius. What is led through a
loop passes any disc that the loop bounds, such as the cone over it from its centroid. On a piece of
a cap, the distance to a face is convex, and so at most what interpolates it between the corners. Of
two faces the smaller such number counts: where a wall is thin, these are the two sides of it, and
large pieces do. Where it is not so, pieces are divided.
*/
class Room_in_caps
{
public:
  /// \p tolerance is how much more than the least bound that this can find is enough, as a part.
  Room_in_caps(const Face_tree& faces, const Clearance& clearance, double tolerance)
      : faces_(faces)
      , clearance_(clearance)
      , tolerance_(tolerance) {}

  /// of the cone over a loop on the surface. The more pieces it takes, up to a number, the better
  /// it is.
  double of_loop(const std::vector<Vector>& loop) const {
    const Corner middle = corner_at(centroid(loop));
    std::vector<std::array<Corner, 3>> cone;
    Corner a = corner_at(loop.back());
    for(const Vector& p : loop) {
      const Corner b = corner_at(p);
      cone.push_back({middle, a, b});
      a = b;
    }
    return largest_radius(cone, nothing_is_farther);
  }

  /// of a cap in triangles; or any number that is larger than \p enough, if it is so.
  double of_triangles(const std::vector<std::array<Vector, 3>>& triangles, double enough) const {
    std::vector<std::array<Corner, 3>> cap;
    for(const auto& [a, b, c] : triangles)
      cap.push_back({corner_at(a), corner_at(b), corner_at(c)});
    return largest_radius(cap, enough);
  }

private:
  static constexpr std::size_t most_pieces = 2000;
  static constexpr double nothing_is_farther = 4.;

  struct Corner
  {
    Vector place;
    Index face; // that is nearest
    double distance;
  };

  struct Piece
  {
    std::array<Corner, 3> corners;
    double radius; // at most, of balls with their centers in it

    bool operator<(const Piece& other) const { return radius < other.radius; }
  };

  double largest_radius(const std::vector<std::array<Corner, 3>>& cap, double enough) const {
    double room = 0.; // somewhere in the cap
    std::priority_queue<Piece> pieces;
    for(const std::array<Corner, 3>& corners : cap) {
      for(const Corner& corner : corners)
        room = (std::max)(room, corner.distance);
      pieces.push(piece(corners));
    }
    const std::size_t most = most_pieces + 4 * cap.size();
    for(std::size_t i = 0;
        i < most && room <= enough && pieces.top().radius > (1. + tolerance_) * room; ++i)
    {
      const Piece whole = pieces.top();
      pieces.pop();
      const auto [u, v, w] = with_longest_side_first(whole.corners);
      const Corner half = corner_at(0.5 * (u.place + v.place));
      room = (std::max)(room, half.distance);
      pieces.push(piece({u, half, w}));
      pieces.push(piece({half, v, w}));
    }
    return (std::max)(room, pieces.top().radius);
  }

  static Vector centroid(const std::vector<Vector>& loop) {
    Vector sum = {0., 0., 0.};
    double length = 0.;
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Vector &a = loop[i], &b = loop[i + 1 < loop.size() ? i + 1 : 0];
      sum = sum + 0.5 * norm(b - a) * (a + b);
      length += norm(b - a);
    }
    return length > 0. ? (1. / length) * sum : loop.front();
  }

  Corner corner_at(const Vector& p) const {
    const auto touch = clearance_.nearest(p, nothing_is_farther);
    return touch ? Corner{p, touch->face, touch->distance} : Corner{p, 0, nothing_is_farther};
  }

  double distance(const Vector& p, Index f) const {
    const Triangle t = faces_.triangle(f);
    return norm(nearest_point(p, t[0], t[1], t[2]) - p);
  }

  static std::array<Corner, 3> with_longest_side_first(std::array<Corner, 3> corners) {
    const auto side = [&](int i) { return norm(corners[(i + 1) % 3].place - corners[i].place); };
    const int first = side(0) >= side(1) && side(0) >= side(2) ? 0 : side(1) >= side(2) ? 1 : 2;
    std::rotate(corners.begin(), corners.begin() + first, corners.end());
    return corners;
  }

  // By the faces that are nearest to the corners, each alone, and two together.
  Piece piece(const std::array<Corner, 3>& corners) const {
    using Distances = std::array<double, 3>; // from the corners
    std::array<Distances, 3> to;
    for(int f = 0; f < 3; ++f)
      for(int c = 0; c < 3; ++c)
        to[f][c] = f == c ? corners[c].distance : distance(corners[c].place, corners[f].face);
    double radius = least_of_two(to[0], to[0]);
    for(int f = 0; f < 3; ++f)
      radius = (std::min)(radius, least_of_two(to[f], to[(f + 1) % 3]));
    return {corners, radius};
  }

  // The largest value, on a triangle, of the smaller of two linear functions, given at the corners:
  // as linear programming says, the least that the largest of `(1 - t) a + t b` at a corner is for
  // a t from 0 to 1, which is at an end, or where two of them are equal.
  static double least_of_two(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    const auto largest = [&](double t) {
      double most = 0.;
      for(int c = 0; c < 3; ++c)
        most = (std::max)(most, (1. - t) * a[c] + t * b[c]);
      return most;
    };
    double least = (std::min)(largest(0.), largest(1.));
    for(int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      const double difference = a[c] - a[d], slope = difference - (b[c] - b[d]);
      if(const double t = difference / slope; t > 0. && t < 1.)
        least = (std::min)(least, largest(t));
    }
    return least;
  }

  const Face_tree& faces_;
  const Clearance& clearance_;
  double tolerance_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_ROOM_IN_CAPS_H
