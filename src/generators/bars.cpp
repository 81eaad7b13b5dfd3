// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Bored_box.h"
#include "Random.h"
#include "kinds.h"
#include "request_checks.h"

#include <CGAL/number_type_config.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// a bar along the x axis with a bore for each number of corners, along the y or the z axis.
Soup make_bar(const std::vector<std::size_t>& corners,
              double depth,
              double height,
              Random& random) {
  constexpr double least = 0.1, most = 0.46; // of the bar's width, or a bore's part of its length
  const Vector size(double(corners.size()), depth, height);
  std::vector<Bore> bores;
  for(std::size_t i = 0; i < corners.size(); ++i) {
    const double x = double(i) + 0.5;
    const double a = random.uniform(least, most), b = random.uniform(least, most);
    const auto axis = static_cast<int>(1 + random.below(2));
    bores.push_back({axis, Vector(x, depth / 2., height / 2.), Vector(a, b * depth, b * height),
                     corners[i], random.uniform(0., 2. * CGAL_PI)});
  }
  return bored_box(size, bores, random_cut(random));
}

Soup make_bars(const Request& request) {
  require_parts(request, "bars");
  require_faces(request, "bars",
                faces_of_bored_boxes(request.parts, request.genus, 3 * request.genus));
  Random random(request.seed);
  const std::vector<std::size_t> corners =
      choose_corners(request.parts, request.genus, request.faces, random);
  std::vector<Soup> bars;
  double y = 0.;
  for(std::size_t i = 0; i < request.parts; ++i) {
    const auto first = corners.begin() + i * request.genus / request.parts;
    const auto end = corners.begin() + (i + 1) * request.genus / request.parts;
    const double depth = random.uniform(0.4, 1.5), height = random.uniform(0.4, 1.5);
    bars.push_back(translated(make_bar({first, end}, depth, height, random), {0., y, 0.}));
    y += depth + random.uniform(0.05, 0.3);
  }
  return joined(bars);
}

} // namespace

const Kind bars_kind = {
    "bars",
    "a comb of bars with straight bores through them in two directions, of few, long and thin "
    "triangles; any genus g, but no less than there are parts, from 16 g + 12 faces for each part",
    make_bars, GENUS | PARTS};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
