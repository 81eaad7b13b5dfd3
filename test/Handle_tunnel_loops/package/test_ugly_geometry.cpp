// Meshes that were deformed until hardly anything of their geometry is left: the answer is what it
// is by definition all the same. HTL_CASES in the environment says how many are tried,
// HTL_FIRST_CASE from which one on; the times are for the reader.

#include "Boundary_definitions.h"
#include "Deformations.h"
#include "Meshes_of_soups.h"

#include "Number_of_cases.h"
#include "generators/Random.h"
#include "generators/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iterator>
#include <vector>

namespace test_ugly_geometry {

using generators::Random;

std::size_t number_from_environment(const char* name, std::size_t otherwise) {
  const char* number = std::getenv(name);
  return number == nullptr ? otherwise : std::strtoul(number, nullptr, 10);
}

// How long the caller was not asked whether to go on.
class Longest_silence
{
public:
  bool operator()(double) {
    const double now = seconds_now();
    longest_ = (std::max)(longest_, now - last_);
    last_ = now;
    return true;
  }

  double longest() const { return longest_; }
  double total() const { return last_ - start_; }

private:
  // Of the processor: others may be at work, too.
  static double seconds_now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

  double start_ = seconds_now(), last_ = start_, longest_ = 0.;
};

// The largest number so far, and the case that has it.
struct Worst
{
  double seconds = 0.;
  std::size_t number = 0;

  void take(double s, std::size_t n) {
    if(s > seconds)
      *this = {s, n};
  }
};

// Some have more than one component.
std::vector<Recipe> recipes() {
  std::vector<Recipe> recipes = recipes_of_all_kinds({1, 4}, 1);
  for(const char* kind : {"chain", "plates", "bars", "shell", "foam"})
    recipes.push_back({kind, {3000, 2, 1}});
  return recipes;
}

Soup with_some_holes(const Soup& soup, Random& random) {
  generators::Hole_request holes;
  holes.number = 1 + random.below(10);
  holes.faces = std::size_t(1) << random.below(9);
  holes.is_ragged = random.below(2) == 0;
  holes.may_be_fewer = true;
  return generators::with_holes(soup, holes);
}

TEST(Ugly_geometry, ChangesNoDefinition) {
  const std::vector<Recipe> all = recipes(), connected = recipes_of_all_kinds({1, 4}, 1);
  Worst time, silence;
  const std::size_t first = number_from_environment("HTL_FIRST_CASE", 0),
                    end = first +
                          number_from_environment("HTL_CASES", are_few_cases_tried() ? 50 : 150);
  for(std::size_t i = first; i < end; ++i) {
    Random random(i);
    const bool has_boundary = i % 3 == 2;
    const std::vector<Recipe>& possible = has_boundary ? connected : all;
    const Recipe& recipe = possible[random.below(possible.size())];
    SCOPED_TRACE(testing::Message() << recipe << ", case " << i);
    Soup soup = soup_of(recipe);
    if(has_boundary)
      soup = with_some_holes(soup, random);
    soup = permute_vertices(soup, static_cast<unsigned>(i));
    deform(soup, random);
    const Mesh mesh = mesh_of(soup);
    Longest_silence watch;
    Pairs pairs;
    ASSERT_NO_THROW(CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs),
                                              CGAL::parameters::callback(std::ref(watch))));
    watch(1.);
    time.take(watch.total(), i);
    silence.take(watch.longest(), i);
    if(has_boundary)
      expect_pairs_with_boundaries(mesh, pairs, recipe.request.genus);
    else
      expect_handle_tunnel_pairs(mesh, pairs, recipe.request.genus);
  }
  std::printf("longest: %.2f s, case %zu; without a call of the callback: %.2f s, case %zu\n",
              time.seconds, time.number, silence.seconds, silence.number);
}

} // namespace test_ugly_geometry
