// Meshes that were deformed until hardly anything of their geometry is left: the answer is what it
// is by definition all the same. HTL_CASES in the environment says how many are tried.

#include "Deformations.h"
#include "Loop_definitions.h"
#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <vector>

namespace {

using generators::Random;

std::size_t number_of_cases() {
  const char* number = std::getenv("HTL_CASES");
  return number == nullptr ? 150 : std::strtoul(number, nullptr, 10);
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
  static double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
  }

  double start_ = seconds_now(), last_ = start_, longest_ = 0.;
};

std::vector<Recipe> recipes() {
  std::vector<Recipe> recipes = recipes_of_all_kinds({1, 4}, 1);
  for(const char* kind : {"chain", "plates", "bars", "shell", "foam"})
    recipes.push_back({kind, {3000, 2, 1}});
  return recipes;
}

TEST(Ugly_geometry, ChangesNoDefinition) {
  const std::vector<Recipe> all = recipes();
  double longest_time = 0., longest_silence = 0.;
  std::size_t slowest_case = 0;
  for(std::size_t i = 0; i < number_of_cases(); ++i) {
    Random random(i);
    const Recipe& recipe = all[random.below(all.size())];
    SCOPED_TRACE(testing::Message() << recipe << ", case " << i);
    Soup soup = permute_vertices(soup_of(recipe), static_cast<unsigned>(i));
    deform(soup, random);
    const Mesh mesh = mesh_of(soup);
    Longest_silence silence;
    Pairs pairs;
    ASSERT_NO_THROW(CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs),
                                              CGAL::parameters::callback(std::ref(silence))));
    expect_handle_tunnel_pairs(mesh, pairs, recipe.request.genus);
    if(silence.total() > longest_time)
      slowest_case = i;
    longest_time = (std::max)(longest_time, silence.total());
    longest_silence = (std::max)(longest_silence, silence.longest());
  }
  std::printf("longest: %.2f s, case %zu; without a call of the callback: %.2f s\n", longest_time,
              slowest_case, longest_silence);
}

} // namespace
