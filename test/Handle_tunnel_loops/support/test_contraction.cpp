// The same numbers to the last bit, whatever the compiler of the program may make of products and
// sums: a device computes some of them too, and rounds apart.

#include "Flat_mesh_of_soup.h"
#include "contracted.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace {

TEST(Contraction, ChangesNoNumber) {
  std::size_t number_of_lengths = 0;
  std::vector<Recipe> recipes = recipes_of_all_kinds({1, 7}, 1);
  // Times are rounded to ticks: it takes many to see a difference in the last bit of a value.
  recipes.push_back({"multi-torus", {200000, 5, 0}});
  recipes.push_back({"random", {20000, 60, 0}});
  for(const Recipe& recipe : recipes) {
    SCOPED_TRACE(testing::Message() << recipe);
    const auto mesh = flat_mesh_of(recipe);
    const Numbers_of_passes expected = numbers_of_passes(mesh);
    const Numbers_of_passes found = contracted::numbers_of_passes(mesh);
    EXPECT_EQ(found.times, expected.times);
    EXPECT_EQ(found.ratios, expected.ratios);
    EXPECT_EQ(found.lengths, expected.lengths);
    EXPECT_EQ(found.walks, expected.walks);
    number_of_lengths += found.lengths.size();
  }
  EXPECT_GT(number_of_lengths, 100u);
}

TEST(Contraction, ChangesNoAnswer) {
  std::vector<Recipe> recipes = recipes_of_all_kinds({1, 7}, 2);
  recipes.push_back({"gyroid", {20000, 25, 0}});
  recipes.push_back({"random", {2000, 60, 2}});
  for(const Recipe& recipe : recipes) {
    SCOPED_TRACE(testing::Message() << recipe);
    const Soup soup = soup_of(recipe);
    const Numbers_of_answers expected = numbers_of_answers(soup);
    const Numbers_of_answers found = contracted::numbers_of_answers(soup);
    EXPECT_FALSE(expected.loops.empty());
    EXPECT_FALSE(expected.reeb_graph.empty());
    EXPECT_EQ(found.loops, expected.loops);
    EXPECT_EQ(found.reeb_graph, expected.reeb_graph);
  }
}

} // namespace
