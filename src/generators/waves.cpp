// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Field.h"
#include "Random.h"
#include "kinds.h"
#include "mesh_of_field.h"
#include "request_checks.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// a direction, all equally likely.
Vector random_direction(Random& random) {
  const double z = random.uniform(-1., 1.), angle = random.uniform(0., 2. * CGAL_PI);
  const double r = std::sqrt(1. - z * z);
  return Vector(r * std::cos(angle), r * std::sin(angle), z);
}

/// Where a sum of random plane waves is negative, in a cube of side two.
class Waves_in_box : public Field
{
public:
  Waves_in_box(double frequency, Random& random)
      : level_(random.uniform(-0.7, 0.7)) {
    for(Wave& wave : waves_) {
      wave.direction = CGAL_PI * frequency * random.uniform(0.5, 1.) * random_direction(random);
      wave.phase = random.uniform(0., 2. * CGAL_PI);
      steepest_ += length(wave.direction);
    }
  }

  Box box() const override { return Box{Vector(0, 0, 0), Vector(0, 0, 0)}.grown(1.); }

  double operator()(const Vector& p) const override {
    const double beyond_box = (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z())}) - 1.;
    double sum = level_;
    for(const Wave& wave : waves_)
      sum += std::sin(wave.direction * p + wave.phase);
    return (std::max)(beyond_box, sum / steepest_);
  }

private:
  struct Wave
  {
    Vector direction;
    double phase;
  };

  std::array<Wave, 12> waves_;
  double level_, steepest_ = 0.;
};

Soup make_waves(const Request& request) {
  const std::size_t f = (std::max<std::size_t>)(request.frequency, 1);
  require_faces(request, "waves", 1000. + 400. * std::pow(f, 3));
  Random random(request.seed);
  return mesh_of_field(Waves_in_box(static_cast<double>(f), random), request.faces);
}

} // namespace

const Kind waves_kind = {
    "waves",
    "a level set of a sum of random waves in a box; the genus and the number of components are "
    "what comes out, from 1000 + 400 f^3 faces for frequency f",
    make_waves, WAVE_FREQUENCY, 20000};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
