// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LOOP_CAPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LOOP_CAPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

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
How wide balls are at most that are led through a loop.

Their way passes any disc that the loop bounds, at a point from which the surface is no nearer than
their radius. The disc is the cone over the loop from its centroid, in pieces. On a piece, the
distance to a face is convex, and so at most what interpolates it between the corners. Of two faces
the smaller such number counts: where a wall is thin, these are the two sides of it, and large
pieces do. Where it is not so, pieces are divided.
*/
class Loop_caps
{
public:
  /// \p tolerance is how much more than the least bound that this can find is enough, as a part.
  Loop_caps(const Face_tree& faces, double tolerance)
      : faces_(faces)
      , tolerance_(tolerance) {}

  /// of a loop on the surface. The more pieces it takes, up to a number, the better it is.
  double largest_radius(const std::vector<Vector>& loop) const {
    const Corner middle = corner_at(centroid(loop));
    double room = middle.distance; // somewhere in the disc
    std::priority_queue<Piece> pieces;
    Corner a = corner_at(loop.back());
    for(const Vector& p : loop) {
      const Corner b = corner_at(p);
      pieces.push(piece({middle, a, b}));
      a = b;
    }
    const std::size_t most = most_pieces + 4 * loop.size();
    for(std::size_t i = 0; i < most && pieces.top().radius > (1. + tolerance_) * room; ++i) {
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

private:
  static constexpr std::size_t most_pieces = 2000;

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
    constexpr double nothing_is_farther = 4.;
    Corner corner = {p, 0, nothing_is_farther};
    faces_.boxes().for_each_nearer(p, nothing_is_farther * nothing_is_farther, [&](Index f) {
      if(const double d = distance(p, f); d < corner.distance) {
        corner.distance = d;
        corner.face = f;
      }
      return corner.distance * corner.distance;
    });
    return corner;
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
  double tolerance_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_LOOP_CAPS_H
