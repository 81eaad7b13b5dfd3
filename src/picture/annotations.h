// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_ANNOTATIONS_H
#define HTL_PICTURE_ANNOTATIONS_H

#include "Camera.h"
#include "layers.h"
#include "picture.h"

#include <string>
#include <vector>

namespace htl_picture {

/// Lines as they are seen on a picture.
struct Seen_lines
{
  const std::vector<Line>& lines;
  const Camera& camera; ///< of the samples
  const Line_layer& layer;
  int width, height; ///< of the picture, in pixels
};

/// What is written on one.
struct Words
{
  bool has_legend;     ///< that of the options, if there is one
  std::string caption; ///< none if empty
};

/// writes legend, labels, caption and scale on a picture, and draws rings around what is small.
void annotate(const Seen_lines& seen,
              const Options& options,
              const Words& words,
              std::vector<Colour>& pixels);

} // namespace htl_picture

#endif // HTL_PICTURE_ANNOTATIONS_H
