// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Text_layer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace htl_picture {
namespace {

constexpr Colour white = {255, 255, 255};
constexpr Colour ink = {40, 44, 52};

// How much of a pixel, or of those around it, is covered.
float covered_around(const Mask& mask, int x, int y, int radius) {
  float most = 0.f;
  for(int v = -radius; v <= radius; ++v)
    for(int u = -radius; u <= radius; ++u)
      if(u * u + v * v <= radius * radius)
        most = (std::max)(most, mask.at(x + u, y + v));
  return most;
}

bool is_in(const Rectangle& box, float x, float y) {
  return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
}

bool meets(const Rectangle& box, const Stroke& stroke) {
  const float left = float(box.x), top = float(box.y), right = left + box.width,
              bottom = top + box.height;
  const auto side = [&](float x0, float y0, float x1, float y1) {
    return stroke.meets({{x0, y0}, {x1, y1}, 0.f, {}});
  };
  return is_in(box, stroke.from[0], stroke.from[1]) || is_in(box, stroke.to[0], stroke.to[1]) ||
         side(left, top, right, bottom) || side(left, bottom, right, top);
}

Rectangle box_of(const Stroke& stroke) {
  const int left = static_cast<int>((std::min)(stroke.from[0], stroke.to[0])),
            top = static_cast<int>((std::min)(stroke.from[1], stroke.to[1]));
  return {left, top, static_cast<int>((std::max)(stroke.from[0], stroke.to[0])) - left + 1,
          static_cast<int>((std::max)(stroke.from[1], stroke.to[1])) - top + 1};
}

Rectangle box_of(const Ring& ring) {
  const int radius = static_cast<int>(std::ceil(ring.radius));
  return {static_cast<int>(ring.x) - radius, static_cast<int>(ring.y) - radius, 2 * radius + 1,
          2 * radius + 1};
}

} // namespace

Text_layer::Text_layer(int width, int height, double text_height)
    : width_(width)
    , height_(height)
    , text_height_(text_height)
    , margin_((std::max)(1, static_cast<int>(std::lround(text_height / 9.)))) {}

void Text_layer::add_legend(const std::vector<Legend_entry>& entries, const Cost& cost) {
  const int row = static_cast<int>(std::lround(1.3 * text_height_)), line = 2 * row;
  std::vector<Mask> masks;
  int widest = 0;
  for(const Legend_entry& entry : entries) {
    masks.push_back(written(entry.text, text_height_));
    widest = (std::max)(widest, masks.back().width);
  }
  const int width = line + 2 * row + widest, height = static_cast<int>(entries.size()) * row + row;
  const int left = row / 2, right = width_ - width - left, top = row / 2,
            bottom = height_ - height - top;
  std::optional<Rectangle> found;
  for(const auto& [x, y] :
      {Pixel{left, top}, Pixel{right, top}, Pixel{right, bottom}, Pixel{left, bottom}})
    if(const Rectangle box = {x, y, width, height};
       is_free(box) && (!found || cost(box) < cost(*found)))
      found = box;
  if(!found)
    return; // there is no room
  const Rectangle& best = *found;
  for(std::size_t i = 0; i < entries.size(); ++i) {
    const int y = best.y + row / 2 + static_cast<int>(i) * row, thickness = (std::max)(2, row / 5);
    legend_lines_.push_back(
        {{best.x + row / 2, y + (row - thickness) / 2, line, thickness}, entries[i].colour});
    texts_.push_back({std::move(masks[i]), best.x + line + row, y, ink});
  }
  taken_.push_back(best);
  backgrounds_.push_back(best);
}

void Text_layer::add_ring(const Ring& ring) {
  rings_.push_back(ring);
  taken_.push_back(box_of(ring));
}

void Text_layer::add_scale_bar(int length, const std::string& text) {
  Mask mask = written(text, text_height_);
  const int row = static_cast<int>(std::lround(1.3 * text_height_));
  const int width = (std::max)(length, mask.width);
  const Rectangle box = {row / 2, height_ - 5 * row / 2, width + row, 2 * row};
  if(box.y < 0 || box.x + box.width > width_)
    return;
  const float x0 = float(row), y0 = float(height_) - 0.95f * row, tick = 0.2f * row;
  const float thickness = (std::max)(1.5f, row / 12.f);
  const float x1 = x0 + length;
  for(const Stroke& stroke : {Stroke{{x0, y0}, {x1, y0}, thickness, ink},
                              Stroke{{x0, y0 - tick}, {x0, y0 + tick}, thickness, ink},
                              Stroke{{x1, y0 - tick}, {x1, y0 + tick}, thickness, ink}})
    strokes_.push_back(stroke);
  texts_.push_back({std::move(mask), row, box.y + row / 4, ink});
  taken_.push_back(box);
  backgrounds_.push_back(box);
}

void Text_layer::add_caption(const std::string& text) {
  Mask mask = written(text, 1.2 * text_height_);
  const Rectangle box = {(width_ - mask.width) / 2, height_ - 2 * mask.height, mask.width,
                         mask.height};
  taken_.push_back(box);
  texts_.push_back({std::move(mask), box.x, box.y, ink});
}

bool Text_layer::is_free(const Rectangle& box) const {
  if(box.x < 0 || box.y < 0 || box.x + box.width > width_ || box.y + box.height > height_)
    return false;
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Rectangle& taken) { return taken.meets(box); }) &&
         std::none_of(leaders_.begin(), leaders_.end(),
                      [&](const Stroke& leader) { return meets(box, leader); });
}

// It may begin within a ring, around what it leads to.
bool Text_layer::is_free(const Stroke& leader) const {
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Rectangle& taken) {
                        return meets(taken, leader) &&
                               !is_in(taken, leader.from[0], leader.from[1]);
                      }) &&
         std::none_of(leaders_.begin(), leaders_.end(),
                      [&](const Stroke& other) { return other.meets(leader); });
}

std::optional<Rectangle> Text_layer::beside(const std::vector<Pixel>& places,
                                            int width,
                                            int height,
                                            const Cost& cost) const {
  const int aside = static_cast<int>(std::lround(0.5 * text_height_));
  double least = std::numeric_limits<double>::infinity();
  std::optional<Rectangle> best;
  for(const auto& [x, y] : places)
    for(const Rectangle& box : {Rectangle{x + aside, y - height / 2, width, height},
                                Rectangle{x - aside - width, y - height / 2, width, height},
                                Rectangle{x - width / 2, y - aside - height, width, height},
                                Rectangle{x - width / 2, y + aside, width, height}})
      if(is_free(box)) {
        if(const double hidden = cost(box); hidden < least) {
          least = hidden;
          best = box;
        }
      }
  return best;
}

Stroke Text_layer::leader_to(const Pixel& place, const Rectangle& box) const {
  const float x = float(place[0]), y = float(place[1]);
  return {{x, y},
          {std::clamp(x, float(box.x), float(box.x + box.width)),
           std::clamp(y, float(box.y), float(box.y + box.height))},
          (std::max)(1.f, float(text_height_) / 18.f),
          ink};
}

// In rings around the place, the narrowest first.
std::optional<Rectangle>
Text_layer::further_away(const Pixel& place, int width, int height, const Cost& cost) const {
  constexpr int directions = 24;
  if(place[0] < 0 || place[1] < 0 || place[0] >= width_ || place[1] >= height_)
    return std::nullopt;
  for(const double distance : {2., 3., 4.5, 6.5, 9., 12., 16.}) {
    double least = std::numeric_limits<double>::infinity();
    std::optional<Rectangle> best;
    for(int k = 0; k < directions; ++k) {
      const double angle = 6.283185307179586 * k / directions;
      const double reach = distance * text_height_;
      const int x = place[0] + static_cast<int>(std::lround(reach * std::cos(angle))),
                y = place[1] + static_cast<int>(std::lround(reach * std::sin(angle)));
      const Rectangle box = {std::cos(angle) < 0. ? x - width : x, y - height / 2, width, height};
      if(!is_free(box) || !is_free(leader_to(place, box)))
        continue;
      if(const double hidden = cost(box); hidden < least) {
        least = hidden;
        best = box;
      }
    }
    if(best)
      return best;
  }
  return std::nullopt;
}

bool Text_layer::add_label(const std::string& text,
                           Colour colour,
                           const std::vector<Pixel>& places,
                           const Cost& cost) {
  if(places.empty())
    return false;
  Mask mask = written(text, text_height_);
  const int w = mask.width + 2 * margin_, h = mask.height + 2 * margin_;
  std::optional<Rectangle> box = beside(places, w, h, cost);
  const double crowded = 0.12 * w * h / 4.; // of the pixels that are looked at
  if(!box || cost(*box) > crowded)
    if(const auto away = further_away(places.front(), w, h, cost);
       away && (!box || cost(*away) < 0.5 * cost(*box)))
    {
      box = away;
      leaders_.push_back(leader_to(places.front(), *away));
      leaders_.back().colour = colour;
    }
  if(!box)
    return false;
  taken_.push_back(*box);
  texts_.push_back({std::move(mask), box->x + margin_, box->y + margin_, colour});
  return true;
}

void Text_layer::blend(int x, int y, Colour colour, float part, std::vector<Colour>& pixels) const {
  if(x < 0 || y < 0 || x >= width_ || y >= height_)
    return;
  Colour& pixel = pixels[std::size_t(y) * width_ + x];
  for(int i = 0; i < 3; ++i)
    pixel[i] = static_cast<unsigned char>(
        std::lround(pixel[i] + part * (float(colour[i]) - float(pixel[i]))));
}

// White around it sets it off from whatever is below.
void Text_layer::draw_text(const Text& text, std::vector<Colour>& pixels) const {
  const Mask& mask = text.mask;
  for(int y = -margin_; y < mask.height + margin_; ++y)
    for(int x = -margin_; x < mask.width + margin_; ++x) {
      blend(text.x + x, text.y + y, white, 0.9f * covered_around(mask, x, y, margin_), pixels);
      blend(text.x + x, text.y + y, text.colour, mask.at(x, y), pixels);
    }
}

// White around it sets it off.
template <typename Shape>
void Text_layer::draw_shape(const Shape& shape,
                            const Rectangle& box,
                            std::vector<Colour>& pixels) const {
  const float half = shape.width / 2.f, halo = half + (std::max)(1.f, half);
  const int around = static_cast<int>(std::ceil(halo)) + 1;
  for(int y = box.y - around; y < box.y + box.height + around; ++y)
    for(int x = box.x - around; x < box.x + box.width + around; ++x) {
      const float distance = shape.distance(float(x) + 0.5f, float(y) + 0.5f);
      blend(x, y, white, 0.75f * std::clamp(halo + 0.5f - distance, 0.f, 1.f), pixels);
      blend(x, y, shape.colour, std::clamp(half + 0.5f - distance, 0.f, 1.f), pixels);
    }
}

void Text_layer::draw_on(std::vector<Colour>& pixels) const {
  const auto fill = [&](const Rectangle& box, Colour colour, float part) {
    for(int y = box.y; y < box.y + box.height; ++y)
      for(int x = box.x; x < box.x + box.width; ++x)
        blend(x, y, colour, part, pixels);
  };
  for(const Ring& ring : rings_)
    draw_shape(ring, box_of(ring), pixels);
  for(const Stroke& leader : leaders_)
    draw_shape(leader, box_of(leader), pixels);
  for(const Rectangle& box : backgrounds_)
    fill(box, white, 0.8f);
  for(const auto& [box, colour] : legend_lines_)
    fill(box, colour, 1.f);
  for(const Stroke& stroke : strokes_)
    draw_shape(stroke, box_of(stroke), pixels);
  for(const Text& text : texts_)
    draw_text(text, pixels);
}

} // namespace htl_picture
