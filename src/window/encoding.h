// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_WINDOW_ENCODING_H
#define HTL_WINDOW_ENCODING_H

#include "base64.h"
#include "window.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace htl_window {

/// The box around all that is shown, in 65535 steps along each axis; lines that go far out from the
/// surfaces are pressed to its sides.
class Grid
{
public:
  using Place = std::array<std::int32_t, 3>;

  explicit Grid(const Scene& scene) {
    for(const Surface& surface : scene.surfaces)
      add(surface.points);
    const Point low = low_, high = high_;
    for(const Line& line : scene.lines)
      add(line.points);
    if(low[0] <= high[0])
      keep_about(low, high);
  }

  Place place_of(const Point& p) const {
    Place place{};
    for(int i = 0; i < 3; ++i)
      if(low_[i] < high_[i]) {
        // Halves, as an extent may be larger than the largest number.
        const double x = std::clamp(p[i], low_[i], high_[i]);
        const double part = (x / 2. - low_[i] / 2.) / (high_[i] / 2. - low_[i] / 2.);
        place[i] = static_cast<std::int32_t>(part * 65535. + 0.5);
      }
    return place;
  }

  /// a length in steps of the largest extent, of which no length has more than that.
  std::int32_t steps_of(double length) const {
    const Point halves = half_extents();
    const double half = *std::max_element(halves.begin(), halves.end());
    const double part = half > 0. ? length / 2. / half : 0.;
    return static_cast<std::int32_t>((std::min)(part, 1.) * 65535. + 0.5);
  }

  /// the extents, the largest of which is 1 unless all is one point.
  Point size() const {
    const Point half = half_extents();
    const double largest = *std::max_element(half.begin(), half.end());
    return largest > 0. ? Point{half[0] / largest, half[1] / largest, half[2] / largest} : half;
  }

  /// the largest extent; infinite if that is beyond all numbers.
  double extent() const {
    const Point half = half_extents();
    return 2. * *std::max_element(half.begin(), half.end());
  }

private:
  Point half_extents() const {
    Point half{};
    for(int i = 0; i < 3; ++i)
      half[i] = low_[i] < high_[i] ? high_[i] / 2. - low_[i] / 2. : 0.;
    return half;
  }

  // No further from the surfaces than half of their largest extent: lines may go far out, where
  // nobody looks, and would leave the surfaces few steps.
  void keep_about(const Point& low, const Point& high) {
    double aside = 0.;
    for(int i = 0; i < 3; ++i)
      aside = (std::max)(aside, high[i] / 2. - low[i] / 2.);
    for(int i = 0; i < 3; ++i) {
      low_[i] = (std::max)(low_[i], low[i] - aside);
      high_[i] = (std::min)(high_[i], high[i] + aside);
    }
  }

  void add(const std::vector<Point>& points) {
    for(const Point& p : points)
      for(int i = 0; i < 3; ++i) {
        low_[i] = (std::min)(low_[i], p[i]);
        high_[i] = (std::max)(high_[i], p[i]);
      }
  }

  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  Point low_ = {infinity, infinity, infinity}, high_ = {-infinity, -infinity, -infinity};
};

/// Numbers one after the other: seven bits in each byte, the least first; the eighth says that more
/// follow.
class Stream
{
public:
  void add(std::uint32_t value) {
    for(; value > 127; value >>= 7)
      bytes_ += static_cast<char>(value | 128);
    bytes_ += static_cast<char>(value);
  }

  /// the sign becomes the last bit.
  void add_signed(std::int32_t value) {
    add(value < 0 ? ~(static_cast<std::uint32_t>(value) << 1)
                  : static_cast<std::uint32_t>(value) << 1);
  }

  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

/// Places, each as its difference to one before, an axis in each stream.
using Place_streams = std::array<Stream, 3>;

inline void add_difference(Place_streams& streams, const Grid::Place& to, const Grid::Place& from) {
  for(int i = 0; i < 3; ++i)
    streams[i].add_signed(to[i] - from[i]);
}

/// Streams one after the other, deflated and in base 64, and how many bytes each has before that.
struct Packed
{
  std::string text;
  std::vector<std::size_t> lengths;
};

Packed packed(const std::vector<const Stream*>& streams);

/*!
A surface for a page. Vertices are numbered as they are met: the first is that of the first
triangle; then, for each vertex in the order of the numbers, the triangles around it that were not
there yet, and so the vertices that these name for the first time. If no vertex is left, the next
is one of another piece. There are these streams:

- for each vertex, how many triangles are new at it;
- for each of these its second and third corner: 0 for a vertex that is new, else by how much its
  number is less than that of the next new one;
- three streams of places, each as the difference to the corner before;
- if there are parts, for each triangle by how much its part differs from that of the one before.

Numbers are small that way: a million triangles are about four million bytes. Vertices without
triangles are left out.
*/
struct Encoded_surface
{
  std::size_t number_of_vertices;
  Packed streams;
};

Encoded_surface encode_surface(const Surface& surface, const Grid& grid);

} // namespace htl_window

#endif // HTL_WINDOW_ENCODING_H
