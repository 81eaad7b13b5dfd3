// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/layer_mesh.h"

#include "draw/vectors.h"
#include "solve/reeb_answer.h"
#include "vertex_properties.h"
#include "write/mesh_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace htloops {
namespace {

// A wave over two bands.
double light_at(double time, double last) {
  constexpr double mean = 0.5 * (1. + light_of_dark_bands);
  const double band = last > 0. ? time / last * number_of_time_bands : 0.;
  return mean + (1. - mean) * std::cos(pi * band);
}

} // namespace

std::array<unsigned char, 3> colour_of_layer(std::size_t layer) {
  return colour_of_arc(layer == 0 ? 0 : layer - 1);
}

std::array<unsigned char, 3> darkened(std::array<unsigned char, 3> colour, double light) {
  for(unsigned char& part : colour)
    part = static_cast<unsigned char>(light * part);
  return colour;
}

double last_time(const Vertex_layers& layers) {
  return layers.times.empty() ? 0. : *std::max_element(layers.times.begin(), layers.times.end());
}

void export_layers(const std::string& file, const Mesh& mesh, const Vertex_layers& layers) {
  Vertex_properties properties = {{"red", "uchar", {}},
                                  {"green", "uchar", {}},
                                  {"blue", "uchar", {}},
                                  {"layer", "int", {}},
                                  {"time", "double", layers.times}};
  const double last = last_time(layers);
  for(std::size_t v = 0; v < layers.layers.size(); ++v) {
    const auto colour =
        darkened(colour_of_layer(layers.layers[v]), light_at(layers.times[v], last));
    for(std::size_t i = 0; i < 3; ++i)
      properties[i].values.push_back(colour[i]);
    properties[3].values.push_back(static_cast<double>(layers.layers[v]));
  }
  write_mesh(file, mesh, properties);
}

} // namespace htloops
