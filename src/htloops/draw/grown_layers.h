// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_GROWN_LAYERS_H
#define HTLOOPS_GROWN_LAYERS_H

#include "draw/exported_lines.h"
#include "draw/mesh_arrays.h"
#include "solve/answer.h"

namespace htloops {

/// The layers as they were at some moment of the first pass.
struct Grown_layers
{
  /// in the colours of the layers, darker in every other band of times, and grey where no front had
  /// come. Faces are cut along contours of the times.
  Drawn_surface surface;
  Exported_lines fronts;
};

/// when this part, 0 to 1, of the time had gone by in which all is covered. The answer has layers.
Grown_layers grown_layers(const Mesh& mesh, const Answer& answer, double part);

} // namespace htloops

#endif // HTLOOPS_GROWN_LAYERS_H
