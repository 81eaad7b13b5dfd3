// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_TEXT_LAYER_H
#define HTL_PICTURE_TEXT_LAYER_H

#include "picture.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htl_picture {

/// How much of each pixel is covered by a text, from 0 to 1, row by row from above.
struct Mask
{
  int width = 0, height = 0;
  std::vector<float> covered;

  /// nothing is covered outside of it.
  float at(int x, int y) const {
    return x < 0 || y < 0 || x >= width || y >= height ? 0.f : covered[std::size_t(y) * width + x];
  }
};

/// a text of ASCII in one row, as high as the font's lines are; empty without a font.
Mask written(const std::string& text, double height);

/// a TrueType font, as the build found it.
extern const unsigned char font_data[];

/// A rectangle of pixels.
struct Rectangle
{
  int x, y, width, height;

  bool meets(const Rectangle& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
  }
};

/*!
Words on a picture: a legend in a corner, and labels, none of which lies on another.

A label is written beside that of its places where it hides least. There may be no room at all: then
it is left out, so that the rest can be read.
*/
class Text_layer
{
public:
  using Pixel = std::array<int, 2>;

  /// tells how much would be hidden by a rectangle.
  using Cost = std::function<double(const Rectangle&)>;

  Text_layer(int width, int height, double text_height);

  void add_legend(const std::vector<Legend_entry>& entries);

  /// returns whether there was room. A legend comes before all labels.
  bool add_label(const std::string& text,
                 Colour colour,
                 const std::vector<Pixel>& places,
                 const Cost& cost);

  /// writes all of it on a picture.
  void draw_on(std::vector<Colour>& pixels) const;

private:
  struct Text
  {
    Mask mask;
    int x, y;
    Colour colour;
  };

  bool is_free(const Rectangle& box) const;
  void draw_text(const Text& text, std::vector<Colour>& pixels) const;
  void blend(int x, int y, Colour colour, float part, std::vector<Colour>& pixels) const;

  int width_, height_;
  double text_height_;
  int margin_;
  std::vector<Text> texts_;
  std::vector<Rectangle> taken_;
  std::optional<Rectangle> legend_box_;
  std::vector<std::pair<Rectangle, Colour>> legend_lines_;
};

} // namespace htl_picture

#endif // HTL_PICTURE_TEXT_LAYER_H
