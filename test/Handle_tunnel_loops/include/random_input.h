#ifndef HTL_TEST_RANDOM_INPUT_H
#define HTL_TEST_RANDOM_INPUT_H

#include "Flat_mesh_of_soup.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/Solver_options.h>

#include <cmath>
#include <cstddef>
#include <ostream>

// A coarse surface.
inline Recipe random_recipe(generators::Random& random, std::size_t largest_genus) {
  const std::size_t genus = random.below(largest_genus + 1);
  return {"random",
          {20 + 12 * genus + random.below(400), genus, static_cast<unsigned>(random.next())}};
}

// Valid ones, by many orders of magnitude away from the usual ones.
inline CGAL::Handle_tunnel_loops::Field_constants random_constants(generators::Random& random) {
  CGAL::Handle_tunnel_loops::Field_constants c;
  c.mobility = std::pow(10., random.uniform(-3., 3.));
  c.gradient_coefficient = std::pow(10., random.uniform(-6., 6.));
  c.penalty = std::pow(10., random.uniform(-6., 3.));
  c.driving_force = c.penalty * (1. + std::pow(10., random.uniform(-3., 6.)));
  c.step = random.uniform(0.05, 1.);
  return c;
}

namespace CGAL::Handle_tunnel_loops {

inline std::ostream& operator<<(std::ostream& out, const Field_constants& c) {
  return out << c.mobility << ' ' << c.driving_force << ' ' << c.gradient_coefficient << ' '
             << c.penalty << ' ' << c.step;
}

} // namespace CGAL::Handle_tunnel_loops

#endif // HTL_TEST_RANDOM_INPUT_H
