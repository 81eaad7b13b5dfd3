// Rows are taken if and only if they are a part of a basis of all rows of integers.

#include "Determinant.h"
#include "Number_of_cases.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace test_independent_rows {

using CGAL::Handle_tunnel_loops::generators::Random;
using CGAL::Handle_tunnel_loops::internal::Independent_rows;
using Rows = std::vector<std::vector<int>>;

// The greatest common divisor of the determinants of all choices of as many columns as rows.
Integer divisor_of_minors(const Rows& rows) {
  Integer divisor = 0;
  const std::size_t width = rows.front().size();
  for(std::size_t columns = 0; columns < std::size_t(1) << width; ++columns) {
    Integer_matrix minor(rows.size());
    for(std::size_t i = 0; i < width; ++i)
      if((columns >> i) % 2 != 0)
        for(std::size_t r = 0; r < rows.size(); ++r)
          minor[r].push_back(rows[r][i]);
    if(minor.front().size() == rows.size())
      divisor = gcd(divisor, determinant(minor));
  }
  return divisor;
}

TEST(Independent_rows, AreThosePartsOfABasisThatComeFirst) {
  Random random(1);
  for(int i = 0; i < number_of_cases(2000); ++i) {
    const std::size_t width = 1 + random.below(6);
    const int largest = 1 + static_cast<int>(random.below(7));
    Independent_rows taken(width);
    Rows rows;
    for(std::size_t tries = 0; tries < 4 * width; ++tries) {
      std::vector<int> row;
      for(std::size_t k = 0; k < width; ++k)
        row.push_back(
            random.below(2) == 0 ? 0 : static_cast<int>(random.below(2 * largest + 1)) - largest);
      rows.push_back(row);
      const bool is_part = rows.size() <= width && divisor_of_minors(rows) == 1;
      EXPECT_EQ(taken.add(row), is_part);
      if(!is_part)
        rows.pop_back();
    }
  }
}

TEST(Independent_rows, HaveNoDeterminantOfOtherPrimesThanTwoAndThree) {
  Independent_rows rows(2);
  EXPECT_TRUE(rows.add({1, 2}));
  EXPECT_FALSE(rows.add({-2, 1})); // 5
  EXPECT_FALSE(rows.add({-3, 1})); // 7
  EXPECT_TRUE(rows.add({0, 1}));
  EXPECT_FALSE(rows.add({1, 0}));
}

} // namespace test_independent_rows
