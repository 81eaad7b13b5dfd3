// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_FONT_H
#define HTL_PICTURE_FONT_H

#include <cstddef>
#include <string>
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

} // namespace htl_picture

#endif // HTL_PICTURE_FONT_H
