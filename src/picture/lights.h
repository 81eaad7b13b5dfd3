// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_LIGHTS_H
#define HTL_PICTURE_LIGHTS_H

#include "Vector_3.h"
#include "picture.h"

namespace htl_picture {

// Light adds up in linear space; pictures store sRGB.
Vector_3 to_linear(const Colour& srgb);
Colour to_srgb(Vector_3 linear);

/// the light that a surface reflects to the eye, in a camera's frame: a key light from the upper
/// left, a fill light from the right, and the sky. `openness` in [0, 1] is the share of the sky
/// that is not covered.
Vector_3 shade_surface(Vector_3 colour, Vector_3 normal, float openness);

/// the same for a line, seen at a distance `across` in [0, 1] from its middle.
Vector_3 shade_line(Vector_3 colour, float across);

} // namespace htl_picture

#endif // HTL_PICTURE_LIGHTS_H
