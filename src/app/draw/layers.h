// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LAYERS_H
#define HTLOOPS_LAYERS_H

#include "draw/lines.h"
#include "draw/surfaces.h"
#include "mesh_types.h"
#include "solve/answer.h"

#include <cstddef>
#include <string>

namespace htloops {

/// the colour of a layer where it is lightest.
Colour colour_of_layer(std::size_t layer);

/// the colour with so much of its light, 0 to 1.
Colour darkened(Colour colour, double light);

/// into how many bands the contours divide the time in which a mesh is covered.
constexpr int number_of_time_bands = 40;

/// the light of the darker bands.
constexpr double light_of_dark_bands = 0.86;

/// the time at which the last vertex was reached.
double last_time(const Vertex_layers& layers);

/// writes the mesh as PLY, each vertex with its layer and its time, and in the colour of the layer,
/// lighter and darker along the contours of the times. Throws `Failure` if that cannot be.
void export_layers(const std::string& file, const Mesh& mesh, const Vertex_layers& layers);

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

#endif // HTLOOPS_LAYERS_H
