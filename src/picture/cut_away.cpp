// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "cut_away.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace htl_picture {
namespace {

Point between(const Point& a, const Point& b, double t) {
  return {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])};
}

// Adds the part of a triangle that is below, as a fan; its corners are so much above.
void add_part(const Triangle& triangle, const std::array<double, 3>& above, Rest& rest) {
  std::vector<std::uint32_t> corners;
  for(std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if(above[i] <= 0.)
      corners.push_back(triangle[i]);
    if((above[i] <= 0.) != (above[j] <= 0.)) {
      corners.push_back(static_cast<std::uint32_t>(rest.points.size()));
      rest.points.push_back(between(rest.points[triangle[i]], rest.points[triangle[j]],
                                    above[i] / (above[i] - above[j])));
    }
  }
  for(std::size_t i = 2; i < corners.size(); ++i)
    rest.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

// Adds the parts of a line that are below.
template <typename Above> void add_parts(const Line& line, const Above& above, Rest& rest) {
  const std::size_t size = line.points.size();
  Line part = line;
  part.closed = false;
  part.points.clear();
  const auto end_part = [&] {
    if(part.points.size() > 1)
      rest.lines.push_back(part);
    part.points.clear();
  };
  // A closed line is gone around from a point that is not left.
  std::size_t first = 0;
  while(line.closed && above(line.points[first]) <= 0.)
    ++first;
  for(std::size_t k = 0; k < size + (line.closed ? 1 : 0); ++k) {
    const Point& p = line.points[(first + k) % size];
    const double height = above(p);
    if(k > 0) {
      const Point& before = line.points[(first + k - 1) % size];
      const double height_before = above(before);
      if((height > 0.) != (height_before > 0.))
        part.points.push_back(between(before, p, height_before / (height_before - height)));
    }
    if(height <= 0.)
      part.points.push_back(p);
    else
      end_part();
  }
  end_part();
}

} // namespace

Rest rest_below(float height,
                const Camera& camera,
                const std::vector<Point>& points,
                const std::vector<Triangle>& triangles,
                const std::vector<Colour>& triangle_colours,
                const std::vector<Line>& lines) {
  Rest rest = {points, {}, {}, {}};
  const auto above = [&](const Point& p) { return double(camera.in_frame(p).z) - height; };
  std::vector<double> heights;
  heights.reserve(points.size());
  for(const Point& p : points)
    heights.push_back(above(p));
  for(std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    add_part(triangles[t], {heights[a], heights[b], heights[c]}, rest);
    if(!triangle_colours.empty())
      rest.triangle_colours.resize(rest.triangles.size(), triangle_colours[t]);
  }
  for(const Line& line : lines)
    if(std::none_of(line.points.begin(), line.points.end(),
                    [&](const Point& p) { return above(p) > 0.; }))
      rest.lines.push_back(line);
    else if(line.radii.empty())
      add_parts(line, above, rest);
  return rest;
}

} // namespace htl_picture
