#ifndef BENCHMARK_RANDOM_SURFACES_H
#define BENCHMARK_RANDOM_SURFACES_H

#include "Random_rotations.h"

#include "generators/Random.h"
#include "generators/generators.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// \file Random_surfaces.h
/// Generated surfaces of all kinds that are embedded, with random parameters, turned at random and
/// some of them with their faces turned over.

namespace random_surfaces {

namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Random;
using generators::Request;
using generators::Soup;

/// A kind, and about how many faces it needs.
struct Recipe
{
  const char* kind;
  std::size_t least_genus, most_genus;
  std::size_t faces, faces_per_handle;
};

inline const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {{"torus", 1, 1, 40, 0},
                                          {"knot", 1, 1, 150, 0},
                                          {"multi-torus", 0, 300, 300, 220},
                                          {"lattice", 0, 300, 500, 300},
                                          {"gyroid", 0, 300, 500, 350},
                                          {"sponge", 0, 300, 100, 40},
                                          {"plates", 1, 300, 60, 20},
                                          {"bars", 1, 300, 60, 20},
                                          {"chain", 1, 300, 0, 100},
                                          {"torus-link", 1, 12, 0, 600},
                                          {"ladder", 1, 60, 8000, 500},
                                          {"shell", 0, 150, 1100, 650},
                                          {"foam", 0, 150, 700, 650},
                                          {"interlaced", 0, 150, 1100, 450},
                                          {"waves", 0, 0, 1500, 0}};
  return all;
}

/// A surface, and the words that say which one it is.
struct Surface
{
  std::string kind, words;
  Soup soup;
};

/// mostly small, up to a bound.
inline std::size_t random_genus(const Recipe& recipe, Random& random) {
  const std::size_t dice = random.below(100);
  const double most = dice < 80 ? 12. : dice < 95 ? 60. : 300.;
  const auto genus = static_cast<std::size_t>(std::exp(random.uniform(0., std::log(most + 1.))));
  return std::clamp(dice < 4 ? 0 : genus, recipe.least_genus, recipe.most_genus);
}

inline Request random_request(const Recipe& recipe, Random& random) {
  Request request;
  request.genus = random_genus(recipe, random);
  request.seed = static_cast<unsigned>(random.below(1000000));
  request.parts =
      1 + random.below((std::min<std::size_t>)((std::max<std::size_t>)(request.genus, 1), 5));
  do {
    request.p = 1 + random.below(4);
    request.q = 1 + random.below(5);
  } while(std::gcd(request.p, request.q) != 1);
  request.frequency = random.below(8) == 0 ? 6 : 1 + random.below(4);
  const std::size_t waves = std::string(recipe.kind) == "waves"
                                ? 400 * request.frequency * request.frequency * request.frequency
                                : 0;
  const double least = double(recipe.faces + waves + recipe.faces_per_handle * request.genus);
  request.faces = static_cast<std::size_t>(least * std::exp(random.uniform(0., std::log(4.))));
  return request;
}

inline const generators::Kind& kind_named(const std::string& name) {
  for(const generators::Kind& kind : generators::kinds())
    if(kind.name == name)
      return kind;
  throw std::runtime_error("no such kind of mesh: " + name);
}

/// the mesh of a request, with more faces where these are too few.
inline Soup make_with_faces_enough(const generators::Kind& kind, Request& request) {
  for(int tries = 0; tries < 12; ++tries)
    try {
      return kind.make(request);
    } catch(const std::invalid_argument&) {
      request.faces += request.faces / 2;
    }
  return kind.make(request);
}

inline std::string words_of(const generators::Kind& kind, const Request& request, bool is_flipped) {
  std::ostringstream words;
  words << kind.name << " --faces " << request.faces << " --seed " << request.seed;
  if((kind.options & generators::GENUS) != 0)
    words << " --genus " << request.genus;
  if((kind.options & generators::PARTS) != 0)
    words << " --parts " << request.parts;
  if((kind.options & generators::TORUS_KNOT) != 0)
    words << " --long-way " << request.p << " --short-way " << request.q;
  if((kind.options & generators::WAVE_FREQUENCY) != 0)
    words << " --frequency " << request.frequency;
  words << (is_flipped ? ", flipped" : "");
  return words.str();
}

/// the surface of a number: kinds in turn, everything else at random.
inline Surface random_surface(std::size_t number, std::size_t seed) {
  Random random(seed * 1000003 + number);
  const Recipe& recipe = recipes()[number % recipes().size()];
  const generators::Kind& kind = kind_named(recipe.kind);
  Request request = random_request(recipe, random);
  Surface surface{kind.name, "", make_with_faces_enough(kind, request)};
  turn(surface.soup, random);
  const bool is_flipped = random.below(4) == 0;
  if(is_flipped)
    surface.soup = generators::reversed(surface.soup);
  surface.words = words_of(kind, request, is_flipped);
  return surface;
}

} // namespace random_surfaces

#endif // BENCHMARK_RANDOM_SURFACES_H
