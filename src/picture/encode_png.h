// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_ENCODE_PNG_H
#define HTL_PICTURE_ENCODE_PNG_H

#include "picture.h"

#include <functional>
#include <string>
#include <vector>

namespace htl_picture {

/// the content of a PNG file; `look` is called between rows.
std::string encode_png(int width,
                       int height,
                       const std::vector<Colour>& pixels,
                       const std::function<void()>& look);

} // namespace htl_picture

#endif // HTL_PICTURE_ENCODE_PNG_H
