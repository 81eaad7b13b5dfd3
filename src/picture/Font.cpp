// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Text_layer.h"

#ifdef HTL_PICTURE_HAS_FONT

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include <algorithm>
#include <cmath>

namespace htl_picture {
namespace {

struct Font
{
  Font() {
    stbtt_InitFont(&info, font_data, 0);
    stbtt_GetFontVMetrics(&info, &ascent, nullptr, nullptr);
  }

  float advance(char c) const {
    int advance, bearing;
    stbtt_GetCodepointHMetrics(&info, c, &advance, &bearing);
    return static_cast<float>(advance);
  }

  void add(char c, float at, float scale, Mask& mask) const {
    const float shift = at - std::floor(at);
    int left, top, right, bottom;
    stbtt_GetCodepointBitmapBoxSubpixel(&info, c, scale, scale, shift, 0.f, &left, &top, &right,
                                        &bottom);
    const int w = right - left, h = bottom - top;
    if(w <= 0 || h <= 0)
      return; // a blank
    std::vector<unsigned char> glyph(std::size_t(w) * h);
    stbtt_MakeCodepointBitmapSubpixel(&info, glyph.data(), w, h, w, scale, scale, shift, 0.f, c);
    const int x0 = static_cast<int>(std::floor(at)) + left;
    const int y0 = static_cast<int>(std::lround(scale * ascent)) + top;
    for(int y = (std::max)(0, -y0); y < h && y0 + y < mask.height; ++y)
      for(int x = (std::max)(0, -x0); x < w && x0 + x < mask.width; ++x) {
        float& covered = mask.covered[std::size_t(y0 + y) * mask.width + x0 + x];
        covered = (std::max)(covered, glyph[std::size_t(y) * w + x] / 255.f);
      }
  }

  stbtt_fontinfo info;
  int ascent = 0;
};

} // namespace

bool has_font() { return true; }

Mask written(const std::string& text, double height) {
  static const Font font;
  const float scale = stbtt_ScaleForPixelHeight(&font.info, static_cast<float>(height));
  float width = 0.f;
  for(const char c : text)
    width += font.advance(c);
  Mask mask;
  mask.width = static_cast<int>(std::ceil(scale * width));
  mask.height = static_cast<int>(std::ceil(height));
  mask.covered.resize(std::size_t(mask.width) * mask.height);
  float x = 0.f;
  for(const char c : text) {
    font.add(c, x, scale, mask);
    x += scale * font.advance(c);
  }
  return mask;
}

} // namespace htl_picture

#else

namespace htl_picture {

bool has_font() { return false; }
Mask written(const std::string&, double) { return {}; }

} // namespace htl_picture

#endif // HTL_PICTURE_HAS_FONT
