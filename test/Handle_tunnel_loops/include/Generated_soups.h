#ifndef HTL_TEST_GENERATED_SOUPS_H
#define HTL_TEST_GENERATED_SOUPS_H

#include "Number_of_cases.h"

#include "generators/generators.h"

#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Request;
using generators::Soup;

// What a generated mesh is made from; printed where a test fails with it.
struct Recipe
{
  std::string kind;
  Request request;
};

inline std::ostream& operator<<(std::ostream& os, const Recipe& recipe) {
  return os << recipe.kind << " faces " << recipe.request.faces << " genus " << recipe.request.genus
            << " seed " << recipe.request.seed;
}

inline Soup soup_of(const Recipe& recipe) {
  for(const generators::Kind& kind : generators::kinds())
    if(recipe.kind == kind.name)
      return kind.make(recipe.request);
  throw std::logic_error("no kind " + recipe.kind);
}

inline bool has_genus(const std::string& kind, std::size_t genus) {
  if(kind == "sphere")
    return genus == 0;
  if(kind == "torus" || kind == "knot")
    return genus == 1;
  return true;
}

// Small meshes of all kinds that are connected and need few faces.
inline std::vector<Recipe> recipes_of_all_kinds(const std::vector<std::size_t>& genera,
                                                unsigned number_of_seeds) {
  std::vector<Recipe> recipes;
  for(const char* kind :
      {"sphere", "torus", "knot", "multi-torus", "lattice", "gyroid", "sponge", "random"})
    for(const std::size_t genus : genera)
      if(has_genus(kind, genus))
        for(unsigned seed = 0; seed < number_of_seeds; ++seed)
          recipes.push_back({kind, {800 + 400 * genus, genus, seed}});
  return enough_of(recipes);
}

inline void reverse_orientation(Soup& soup) {
  for(auto& triangle : soup.triangles)
    std::swap(triangle[1], triangle[2]);
}

// The soup with x replaced by scale * x + shift, in each coordinate.
inline Soup transformed(Soup soup, double scale, double shift) {
  for(auto& point : soup.points)
    for(double& x : point)
      x = scale * x + shift;
  return soup;
}

#endif // HTL_TEST_GENERATED_SOUPS_H
