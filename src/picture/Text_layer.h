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

#include "Stroke.h"
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
Words on a picture: a legend in a corner, and labels, none of which lies on another, and what
belongs to them.

A label is written beside that of its places where it hides least; or further away, with a thin line
that leads to it, which crosses no other. There may be no room at all: then it is left out, so that
the rest can be read.
*/
class Text_layer
{
public:
  using Pixel = std::array<int, 2>;

  /// tells how much would be hidden by a rectangle.
  using Cost = std::function<double(const Rectangle&)>;

  Text_layer(int width, int height, double text_height);

  /// puts it into the corner where it hides least.
  void add_legend(const std::vector<Legend_entry>& entries, const Cost& cost);

  /// returns whether there was room. A legend comes before all labels.
  bool add_label(const std::string& text,
                 Colour colour,
                 const std::vector<Pixel>& places,
                 const Cost& cost);

  /// adds a circle around what is too small to be found. Labels do not lie on it.
  void add_ring(const Ring& ring);

  /// adds a bar of a length in pixels, with a text, in the lower left corner.
  void add_scale_bar(int length, const std::string& text);

  /// writes in the middle below.
  void add_caption(const std::string& text);

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
  bool is_free(const Stroke& leader) const;
  std::optional<Rectangle>
  beside(const std::vector<Pixel>& places, int width, int height, const Cost& cost) const;
  std::optional<Rectangle>
  further_away(const Pixel& place, int width, int height, const Cost& cost) const;
  Stroke leader_to(const Pixel& place, const Rectangle& box) const;
  void draw_text(const Text& text, std::vector<Colour>& pixels) const;
  template <typename Shape>
  void draw_shape(const Shape& shape, const Rectangle& box, std::vector<Colour>& pixels) const;
  void blend(int x, int y, Colour colour, float part, std::vector<Colour>& pixels) const;

  int width_, height_;
  double text_height_;
  int margin_;
  std::vector<Text> texts_;
  std::vector<Rectangle> taken_;
  std::vector<Rectangle> backgrounds_;
  std::vector<Stroke> strokes_, leaders_;
  std::vector<Ring> rings_;
  std::vector<std::pair<Rectangle, Colour>> legend_lines_;
};

} // namespace htl_picture

#endif // HTL_PICTURE_TEXT_LAYER_H
