// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/meshes/single_precision.h"

#include "write/tables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace htloops {

void check_single_precision(const Written_mesh& written, double scale) {
  constexpr double most = (std::numeric_limits<float>::max)(), largest_share = 1e-4;
  double largest = 0., farthest = 0.;
  CGAL::Bbox_3 box;
  for(const auto& point : written.mesh.points) {
    for(std::size_t i = 0; i < 3; ++i) {
      const double x = scale * point[i];
      largest = std::isfinite(x) ? (std::max)(largest, std::abs(x)) : 2. * most;
      if(largest > most)
        throw wrong_usage("the coordinates are too large for the single precision of this format: "
                          "use .off .obj .ply .3mf .vtp .vtu or .msh");
      farthest = (std::max)(farthest, std::abs(x - static_cast<double>(static_cast<float>(x))));
    }
    const auto& [x, y, z] = point;
    box += CGAL::Bbox_3(x, y, z, x, y, z);
  }
  const double diagonal = scale * diagonal_of(box);
  if(farthest > largest_share * diagonal)
    throw wrong_usage(
        formatted("the single precision of this format would move points by up to %.3g (the "
                  "diagonal is %.3g): ",
                  farthest, diagonal) +
        "use .off .obj .ply .3mf .vtp .vtu .msh or .ascii.stl");
}

double scale_to_millimeters(const Written_mesh& written) {
  const Unit unit = written.facts.unit;
  return unit == Unit::NONE || unit == Unit::MILLIMETER ? 1. : words_of(unit).metres / 1e-3;
}

} // namespace htloops
