// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_UPRIGHT_H
#define HTLOOPS_UPRIGHT_H

#include "draw/surfaces.h"
#include "scene/scene.h"

namespace htloops {

/// What is right, in front and above, for who stands before a thing. Of length one.
struct Axes
{
  Vector right, front, up;

  /// a vector with these coordinates.
  Vector in_space(const Vector& v) const;
};

/// for an upright direction of length one: where y is upright, z is in front, as in films and
/// games; otherwise -y, as in drawings of machines.
Axes axes_of(const Vector& up);

/*!
an axis that is probably upright: z, unless there is better evidence for another one.

What was made to stand has a flat base on which it does not fall over, and most things that people
scan or model are the same on the left and on the right.
*/
Vector upright_direction(const htl_scene::Surface& surface);

} // namespace htloops

#endif // HTLOOPS_UPRIGHT_H
