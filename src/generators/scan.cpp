// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Random.h"
#include "Rounded_body.h"
#include "Small_bridges.h"
#include "kinds.h"
#include "mesh_of_field.h"
#include "request_checks.h"
#include "vertex_normals.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Rounded_body random_body(std::size_t handles, Random& random) {
  std::vector<Rounded_body::Ball> bumps;
  for(const double side : {-1., 1., 1.}) {
    const double angle = random.uniform(0., 2. * CGAL_PI), radius = random.uniform(0.45, 0.6);
    bumps.push_back(
        {Vector(0.3 * std::cos(angle), 0.3 * std::sin(angle), side * random.uniform(0.5, 0.7)),
         radius});
  }
  return Rounded_body(handles, random.uniform(0., 2. * CGAL_PI), bumps);
}

/// Waves in random directions, with a height that keeps their slopes small.
class Random_relief
{
public:
  explicit Random_relief(Random& random) {
    for(Wave& wave : waves_) {
      const double steepness = random.uniform(6., 30.);
      for(double& x : wave.steps)
        x = steepness * random.uniform(-1., 1.);
      wave.phase = random.uniform(0., 2. * CGAL_PI);
      wave.height = 0.1 / steepness;
    }
  }

  double operator()(const std::array<double, 3>& p) const {
    double sum = 0.;
    for(const Wave& wave : waves_)
      sum += wave.height * std::sin(wave.steps[0] * p[0] + wave.steps[1] * p[1] +
                                    wave.steps[2] * p[2] + wave.phase);
    return sum;
  }

private:
  struct Wave
  {
    std::array<double, 3> steps;
    double phase, height;
  };
  std::array<Wave, 10> waves_;
};

/// a relief, and what a scanner gets wrong at each point.
void roughen(Soup& soup, double edge_length, Random& random) {
  const Random_relief relief(random);
  const std::vector<Vector> normals = vertex_normals(soup);
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const double height = relief(soup.points[v]) + edge_length * random.uniform(-0.1, 0.1);
    const Vector by = height / length(normals[v]) * normals[v];
    for(int i = 0; i < 3; ++i)
      soup.points[v][i] += by[i];
  }
}

Soup with_small_bridges(const Soup& soup,
                        double edge_length,
                        const Request& request,
                        Random& random) {
  std::vector<char> is_tunnel(request.bridges + request.tunnels, 0);
  std::fill_n(is_tunnel.begin(), request.tunnels, char(1));
  random.shuffle(is_tunnel);
  std::vector<std::uint32_t> places(soup.points.size());
  std::iota(places.begin(), places.end(), 0u);
  random.shuffle(places);

  Small_bridges bridges(soup, edge_length);
  std::size_t built = 0;
  for(std::size_t i = 0; i < places.size() && built < is_tunnel.size(); ++i)
    built += bridges.build(places[i], is_tunnel[built] != 0, random);
  if(built < is_tunnel.size())
    throw std::invalid_argument(std::to_string(request.faces) + " faces have room for only " +
                                std::to_string(built) + " small bridges and tunnels");
  return bridges.take();
}

Soup make_scan(const Request& request) {
  constexpr std::size_t faces_of_bridge = 80;
  const std::size_t planted = request.bridges + request.tunnels;
  require_faces(request, "scan", Rounded_body::least_faces(request.genus) + 600 * planted);
  Random random(request.seed);
  Soup soup = mesh_of_field(random_body(request.genus, random),
                            {request.faces - faces_of_bridge * planted, request.genus}, "scan");
  const double edge_length = mean_edge_length(soup);
  roughen(soup, edge_length, random);
  return with_small_bridges(soup, edge_length, request, random);
}

} // namespace

const Kind scan_kind = {
    "scan",
    "a body like a pot with g large handles, rough as if it were scanned, and on it small bridges "
    "and just below it small tunnels, a handle each; loops of the body are longer than 1, those "
    "of the bridges and tunnels shorter than 20 mean edges, and so than 0.9; from 25000 faces, "
    "more for more than 8 handles, and 600 for each bridge and tunnel",
    make_scan, GENUS | SMALL_BRIDGES, 60000};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
