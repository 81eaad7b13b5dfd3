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

#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// a bore along the z axis somewhere in a square of side one.
Bore bore_in_square(double x, double y, std::size_t corners, Random& random) {
  constexpr double least = 0.06, most = 0.46;
  const double a = random.uniform(least, most), b = random.uniform(least, most);
  const double dx = random.uniform(a - most, most - a), dy = random.uniform(b - most, most - b);
  return {2, Vector(x + 0.5 + dx, y + 0.5 + dy, 0), Vector(a, b, 0), corners,
          random.uniform(0., 2. * CGAL_PI)};
}

/// a plate, or block, with a bore for each number of corners, in rows.
Soup make_plate(const std::vector<std::size_t>& corners, double thickness, Random& random) {
  const auto square_root = static_cast<std::size_t>(std::sqrt(double(corners.size())));
  const std::size_t rows = 1 + random.below(square_root);
  const std::size_t columns = (corners.size() + rows - 1) / rows;
  std::vector<Bore> bores;
  for(std::size_t i = 0; i < corners.size(); ++i)
    bores.push_back(bore_in_square(double(i / rows), double(i % rows), corners[i], random));
  return bored_box(Vector(double(columns), double(rows), thickness), bores, random_cut(random));
}

Soup make_plates(const Request& request) {
  require_parts(request, "plates");
  require_faces(request, "plates",
                faces_of_bored_boxes(request.parts, request.genus, 3 * request.genus));
  Random random(request.seed);
  const std::vector<std::size_t> corners =
      choose_corners(request.parts, request.genus, request.faces, random);
  std::vector<Soup> plates;
  double height = 0.;
  for(std::size_t i = 0; i < request.parts; ++i) {
    const auto first = corners.begin() + i * request.genus / request.parts;
    const auto end = corners.begin() + (i + 1) * request.genus / request.parts;
    // From sheets to blocks.
    const double thickness = std::exp(random.uniform(std::log(0.05), std::log(3.)));
    plates.push_back(translated(make_plate({first, end}, thickness, random), {0., 0., height}));
    height += thickness + random.uniform(0.05, 0.5);
  }
  return joined(plates);
}

} // namespace

const Kind plates_kind = {
    "plates",
    "a stack of plates and blocks with straight bores of random sizes through them, of few, long "
    "and thin triangles; any genus g, but no less than there are parts, from 16 g + 12 faces for "
    "each part",
    make_plates, GENUS | PARTS};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
