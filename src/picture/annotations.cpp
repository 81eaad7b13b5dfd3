// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "annotations.h"

#include "Painter.h"
#include "Text_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <numeric>

namespace htl_picture {
namespace {

using Pixel = Text_layer::Pixel;

// What annotations have to know of a line.
struct Sight
{
  double size = 0.;          // of its box on the picture
  float x = 0.f, y = 0.f;    // the middle of that
  std::vector<Pixel> places; // where it can be pointed at
  bool is_seen = false;      // not only through the surface
};

Sight sight_of(const Seen_lines& seen, std::uint32_t number) {
  const std::vector<Point>& points = seen.lines[number].points;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float left = infinity, right = -infinity, top = infinity, bottom = -infinity;
  std::vector<Pixel> hidden;
  Sight sight;
  constexpr std::size_t enough = 24;
  const std::size_t count = (std::min)(enough, points.size());
  for(std::size_t k = 0; k < count; ++k) {
    // From the middle to both ends.
    const std::size_t turn = (k % 2 == 0 ? count - k : count + k) / 2;
    const std::size_t i = turn * points.size() / count;
    const Projected_point p =
        seen.camera.project(seen.camera.in_frame(points[(std::min)(i, points.size() - 1)]));
    left = (std::min)(left, p.x / samples);
    right = (std::max)(right, p.x / samples);
    top = (std::min)(top, p.y / samples);
    bottom = (std::max)(bottom, p.y / samples);
    if(p.x < 0.f || p.y < 0.f || p.x >= float(samples * seen.width) ||
       p.y >= float(samples * seen.height))
      continue;
    const int x = static_cast<int>(p.x), y = static_cast<int>(p.y);
    const Line_layer::Sample& sample = seen.layer.in_front(x, y);
    (sample.line == number && !sample.is_gap() ? sight.places : hidden)
        .push_back({x / samples, y / samples});
  }
  sight.is_seen = !sight.places.empty();
  if(!sight.is_seen)
    sight.places = hidden;
  if(count > 0) {
    sight.size = (std::max)(right - left, bottom - top);
    sight.x = (left + right) / 2.f;
    sight.y = (top + bottom) / 2.f;
  }
  return sight;
}

std::vector<Sight> sights_of(const Seen_lines& seen) {
  std::vector<Sight> sights;
  for(std::uint32_t i = 0; i < seen.lines.size(); ++i)
    sights.push_back(sight_of(seen, i));
  return sights;
}

// Of those that are small, the smallest first: they have the fewest places.
std::vector<std::size_t> by_size(const std::vector<Sight>& sights) {
  std::vector<std::size_t> order(sights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return sights[i].size < sights[j].size; });
  return order;
}

// How many of some pixels of a rectangle show a line.
double lines_in(const Seen_lines& seen, const Rectangle& box) {
  int count = 0;
  for(int y = (std::max)(0, box.y); y < (std::min)(seen.height, box.y + box.height); y += 2)
    for(int x = (std::max)(0, box.x); x < (std::min)(seen.width, box.x + box.width); x += 2)
      count += seen.layer.in_front(samples * x, samples * y).line != Line_layer::no_line;
  return count;
}

std::vector<Pixel> places_around(const Ring& ring) {
  std::vector<Pixel> places;
  constexpr int count = 8;
  for(int k = 0; k < count; ++k) {
    const double angle = 6.283185307179586 * k / count;
    places.push_back({static_cast<int>(ring.x + ring.radius * std::cos(angle)),
                      static_cast<int>(ring.y + ring.radius * std::sin(angle))});
  }
  return places;
}

// Around closed lines that would not be found; one ring for those at one place.
void add_rings(const Seen_lines& seen,
               const Options& options,
               std::vector<Sight>& sights,
               Text_layer& texts) {
  constexpr double speck = 0.025;                            // of the picture
  const double extent = (std::min)(seen.width, seen.height); // which the surface fills
  const auto least = static_cast<float>(0.016 * extent);
  std::vector<Ring> rings;
  std::vector<std::array<std::size_t, 2>> at_ring; // lines, each with its ring
  for(const std::size_t i : by_size(sights)) {
    const Sight& sight = sights[i];
    const Line& line = seen.lines[i];
    if(!sight.is_seen || !line.closed || line.points.size() < 3 || sight.size >= speck * extent)
      continue;
    const auto half = static_cast<float>(0.8 * sight.size);
    const float widest = 4.f * least; // then there is another one
    const auto at_this = [&](const Ring& ring) {
      const float away = std::hypot(ring.x - sight.x, ring.y - sight.y);
      return away < 1.4 * ring.radius && away + half < widest;
    };
    auto ring = std::find_if(rings.begin(), rings.end(), at_this);
    if(ring == rings.end())
      ring = rings.insert(rings.end(),
                          {sight.x, sight.y, (std::max)(least, half),
                           (std::max)(1.2f, float(0.4 * options.line_width_px)), line.colour});
    else // that of the other loop of a pair, as a rule
      ring->radius =
          (std::max)(ring->radius, std::hypot(ring->x - sight.x, ring->y - sight.y) + half);
    at_ring.push_back({i, static_cast<std::size_t>(ring - rings.begin())});
  }
  for(const auto& [i, number] : at_ring)
    sights[i].places = places_around(rings[number]);
  for(const Ring& ring : rings)
    texts.add_ring(ring);
}

// A label of what is hidden would be read as one of what is in front. Bones are all hidden, but for
// joints.
void add_labels(const Seen_lines& seen, const std::vector<Sight>& sights, Text_layer& texts) {
  bool is_any_seen = false;
  for(std::size_t i = 0; i < sights.size(); ++i)
    is_any_seen = is_any_seen || (sights[i].is_seen && seen.lines[i].points.size() > 1);
  for(const std::size_t i : by_size(sights))
    if(const Line& line = seen.lines[i]; !line.label.empty() && (sights[i].is_seen || !is_any_seen))
      texts.add_label(line.label, line.colour, sights[i].places,
                      [&](const Rectangle& box) { return lines_in(seen, box); });
}

// How many of some pixels of a rectangle are not background.
double covered_in(const Seen_lines& seen,
                  const Colour& background,
                  const Rectangle& box,
                  const std::vector<Colour>& pixels) {
  int count = 0;
  for(int y = (std::max)(0, box.y); y < (std::min)(seen.height, box.y + box.height); y += 3)
    for(int x = (std::max)(0, box.x); x < (std::min)(seen.width, box.x + box.width); x += 3)
      count += pixels[std::size_t(y) * seen.width + x] != background;
  return count;
}

// A round number is as long as the bar: 1, 2 or 5 with zeros.
void add_scale_bar(const Seen_lines& seen, const Options& options, Text_layer& texts) {
  const double pixel = samples * seen.camera.in_space(seen.camera.pixel_size_in_middle());
  const double longest = 0.22 * seen.width * pixel;
  if(!(longest > 0.) || !std::isfinite(longest))
    return;
  double length = std::pow(10., std::floor(std::log10(longest)));
  for(const double digit : {5., 2.})
    if(digit * length <= longest) {
      length *= digit;
      break;
    }
  char text[64];
  std::snprintf(text, sizeof text, "%g", length);
  const std::string unit = options.unit.empty() ? "" : " " + options.unit;
  texts.add_scale_bar(static_cast<int>(std::lround(length / pixel)), text + unit);
}

} // namespace

void annotate(const Seen_lines& seen,
              const Options& options,
              const Words& words,
              std::vector<Colour>& pixels) {
  Text_layer texts(seen.width, seen.height,
                   (std::max)(10., (std::min)(double(seen.height), 0.75 * seen.width) / 44.));
  if(options.has_scale_bar && has_font())
    add_scale_bar(seen, options, texts);
  if(!words.caption.empty())
    texts.add_caption(words.caption);
  if(words.has_legend && !options.legend.empty())
    texts.add_legend(options.legend, [&](const Rectangle& box) {
      return covered_in(seen, options.background, box, pixels);
    });
  std::vector<Sight> sights = sights_of(seen);
  if(options.has_rings)
    add_rings(seen, options, sights, texts);
  add_labels(seen, sights, texts);
  texts.draw_on(pixels);
}

} // namespace htl_picture
