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

} // namespace

Text_layer::Text_layer(int width, int height, double text_height)
    : width_(width)
    , height_(height)
    , text_height_(text_height)
    , margin_((std::max)(1, static_cast<int>(std::lround(text_height / 9.)))) {}

void Text_layer::add_legend(const std::vector<Legend_entry>& entries) {
  const int row = static_cast<int>(std::lround(1.3 * text_height_)), line = 2 * row;
  const int left = row, top = row;
  Rectangle box = {left / 2, top / 2, line + row, static_cast<int>(entries.size()) * row + row};
  for(std::size_t i = 0; i < entries.size(); ++i) {
    Mask mask = written(entries[i].text, text_height_);
    const int y = top + static_cast<int>(i) * row;
    box.width = (std::max)(box.width, line + 2 * row + mask.width);
    const int thickness = (std::max)(2, row / 5);
    legend_lines_.push_back(
        {{left, y + (row - thickness) / 2, line, thickness}, entries[i].colour});
    texts_.push_back({std::move(mask), left + line + row / 2, y, ink});
  }
  taken_.push_back(box);
  legend_box_ = box;
}

bool Text_layer::is_free(const Rectangle& box) const {
  if(box.x < 0 || box.y < 0 || box.x + box.width > width_ || box.y + box.height > height_)
    return false;
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Rectangle& taken) { return taken.meets(box); });
}

bool Text_layer::add_label(const std::string& text,
                           Colour colour,
                           const std::vector<Pixel>& places,
                           const Cost& cost) {
  Mask mask = written(text, text_height_);
  const int w = mask.width + 2 * margin_, h = mask.height + 2 * margin_;
  const int aside = static_cast<int>(std::lround(0.5 * text_height_));
  double least = std::numeric_limits<double>::infinity();
  std::optional<Rectangle> best;
  for(const auto& [x, y] : places)
    for(const Rectangle& box :
        {Rectangle{x + aside, y - h / 2, w, h}, Rectangle{x - aside - w, y - h / 2, w, h},
         Rectangle{x - w / 2, y - aside - h, w, h}, Rectangle{x - w / 2, y + aside, w, h}})
      if(is_free(box)) {
        if(const double hidden = cost(box); hidden < least) {
          least = hidden;
          best = box;
        }
      }
  if(!best)
    return false;
  taken_.push_back(*best);
  texts_.push_back({std::move(mask), best->x + margin_, best->y + margin_, colour});
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

void Text_layer::draw_on(std::vector<Colour>& pixels) const {
  const auto fill = [&](const Rectangle& box, Colour colour, float part) {
    for(int y = box.y; y < box.y + box.height; ++y)
      for(int x = box.x; x < box.x + box.width; ++x)
        blend(x, y, colour, part, pixels);
  };
  if(legend_box_)
    fill(*legend_box_, white, 0.8f);
  for(const auto& [box, colour] : legend_lines_)
    fill(box, colour, 1.f);
  for(const Text& text : texts_)
    draw_text(text, pixels);
}

} // namespace htl_picture
