// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_ROUGH_SURFACES_H
#define BENCHMARK_ROUGH_SURFACES_H

#include "Needles.h"
#include "Random_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

/// \file Rough_surfaces.h
/// Generated surfaces as no one would wish to have them: coarse, of genus 0 to 100, and some of
/// them flat, noisy, with needles for faces, with holes, inside other ones or inside out.

namespace rough_surfaces {

namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Random;
using generators::Request;
using generators::Soup;
using random_surfaces::Recipe;

inline std::vector<Recipe> recipes() {
  std::vector<Recipe> all = random_surfaces::recipes();
  all.insert(all.end(), {{"hubs", 3, 100, 0, 40}, {"fan", 0, 0, 300, 0}, {"sphere", 0, 0, 12, 0}});
  return all;
}

inline Request request_for(const Recipe& recipe, Random& random) {
  Request request = random_surfaces::random_request(recipe, random);
  const std::size_t genus = random.below(3) == 0 ? random.below(101) : random.below(31);
  request.genus =
      std::clamp(genus, recipe.least_genus, (std::min)(recipe.most_genus, std::size_t(100)));
  request.parts = 1 + random.below((std::min<std::size_t>)(1 + request.genus / 4, 4));
  request.faces = static_cast<std::size_t>(
      random.uniform(1., 2.) * double(recipe.faces + recipe.faces_per_handle * request.genus));
  return request;
}

// ---- changes

inline Soup squeezed(Soup soup, double factor) {
  for(auto& p : soup.points)
    p[2] *= factor;
  return soup;
}

/// with points moved by up to a part of the shortest edge there.
inline Soup with_noise(Soup soup, double part, Random& random) {
  std::vector<double> shortest(soup.points.size(), (std::numeric_limits<double>::infinity)());
  for(const auto& t : soup.triangles)
    for(int k = 0; k < 3; ++k) {
      const auto &p = soup.points[t[k]], &q = soup.points[t[(k + 1) % 3]];
      const double length = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      for(const std::uint32_t v : {t[k], t[(k + 1) % 3]})
        shortest[v] = (std::min)(shortest[v], length);
    }
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(double& x : soup.points[v])
      x += part * shortest[v] * random.uniform(-1., 1.);
  return soup;
}

/// inside spheres, one in the other, all of them inside out or not.
inline Soup nested(const Soup& soup, Random& random) {
  std::array<double, 3> low = soup.points.front(), high = low;
  for(const auto& p : soup.points)
    for(int d = 0; d < 3; ++d) {
      low[d] = (std::min)(low[d], p[d]);
      high[d] = (std::max)(high[d], p[d]);
    }
  double radius = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  std::vector<Soup> all = {soup};
  for(std::size_t n = 1 + random.below(3); n > 0; --n, radius *= 2.) {
    Request request;
    request.genus = 0;
    request.faces = 80 + random.below(400);
    Soup sphere = random_surfaces::kind_named("sphere").make(request);
    for(auto& p : sphere.points)
      for(int d = 0; d < 3; ++d)
        p[d] = 0.5 * (low[d] + high[d]) + radius * p[d];
    all.push_back(random.below(2) == 0 ? sphere : generators::reversed(sphere));
  }
  return generators::joined(all);
}

/// A surface, and the words that say which one it is.
struct Surface
{
  std::string words;
  Soup soup;
};

inline void make_rough(Surface& surface, Random& random) {
  const auto change = [&](std::size_t one_of, const char* words, const auto& changed) {
    if(random.below(one_of) == 0) {
      surface.soup = changed(surface.soup);
      surface.words += std::string(", ") + words;
    }
  };
  change(5, "flat",
         [&](const Soup& s) { return squeezed(s, std::pow(10., -random.uniform(0.5, 3.))); });
  change(6, "noisy", [&](const Soup& s) { return with_noise(s, random.uniform(0., 0.2), random); });
  change(6, "with needles", [&](const Soup& s) { return with_needles(s, random); });
  change(3, "with holes", [&](const Soup& s) {
    generators::Hole_request holes;
    holes.number = 1 + random.below(6);
    holes.faces = 6 + random.below(20);
    holes.is_ragged = random.below(2) == 0;
    holes.seed = static_cast<unsigned>(random.below(1000000));
    holes.may_be_fewer = true;
    return generators::with_holes(s, holes);
  });
  change(10, "nested", [&](const Soup& s) { return nested(s, random); });
  change(4, "inside out", [&](const Soup& s) { return generators::reversed(s); });
}

/// the surface of a number: kinds in turn, everything else at random.
inline Surface rough_surface(std::size_t number, std::size_t seed) {
  Random random(seed * 1000003 + number);
  const std::vector<Recipe> all = recipes();
  const Recipe& recipe = all[number % all.size()];
  const generators::Kind& kind = random_surfaces::kind_named(recipe.kind);
  Request request = request_for(recipe, random);
  Surface surface{"", random_surfaces::make_with_faces_enough(kind, request)};
  surface.words = random_surfaces::words_of(kind, request, false);
  make_rough(surface, random);
  random_surfaces::turn(surface.soup, random);
  return surface;
}

} // namespace rough_surfaces

#endif // BENCHMARK_ROUGH_SURFACES_H
