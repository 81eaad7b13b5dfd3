// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_WRITE_PNG_H
#define HTL_PICTURE_WRITE_PNG_H

#include "picture.h"

#include <string>
#include <vector>

namespace htl_picture {

/// writes pixels, row by row from the top. Throws `std::runtime_error` on failure.
void write_png(const std::string& file, int width, int height, const std::vector<Colour>& pixels);

/// the same as the content of a file.
std::string encode_png(int width, int height, const std::vector<Colour>& pixels);

} // namespace htl_picture

#endif // HTL_PICTURE_WRITE_PNG_H
