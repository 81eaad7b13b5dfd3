// The index of a lattice of integer vectors is the absolute value of its determinant.

#include "Determinant.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Integer_lattice.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace test_integer_lattice {

using CGAL::Handle_tunnel_loops::generators::Random;
using CGAL::Handle_tunnel_loops::internal::Integer_lattice;

Integer_lattice lattice_of(const Integer_matrix& rows, std::size_t dimension) {
  Integer_lattice lattice(dimension);
  for(const auto& row : rows) {
    Integer_lattice::Row sparse;
    for(std::size_t j = 0; j < row.size(); ++j)
      if(row[j] != 0)
        sparse[j] = row[j];
    lattice.add(std::move(sparse));
  }
  return lattice;
}

Integer_matrix random_matrix(Random& random, std::size_t rows, std::size_t columns, int largest) {
  Integer_matrix matrix(rows, std::vector<Integer>(columns, 0));
  for(auto& row : matrix)
    for(Integer& x : row)
      if(random.below(3) != 0)
        x = static_cast<int>(random.below(static_cast<std::size_t>(2 * largest + 1))) - largest;
  return matrix;
}

void expect_index(const Integer_lattice& lattice, const Integer& index, std::size_t dimension) {
  EXPECT_EQ(lattice.index(), index);
  EXPECT_EQ(lattice.is_full(), index == 1);
  EXPECT_EQ(lattice.first_defect() == dimension, index == 1);
}

TEST(Determinant, IsRight) {
  EXPECT_EQ(determinant({}), 1);
  EXPECT_EQ(determinant({{-3}}), -3);
  EXPECT_EQ(determinant({{1, 2}, {3, 4}}), -2);
  EXPECT_EQ(determinant({{0, 1}, {1, 0}}), -1);
  EXPECT_EQ(determinant({{2, 0, 1}, {1, 3, 2}, {1, 1, 1}}), 0);
  EXPECT_EQ(determinant({{0, 2, 1}, {1, 3, 2}, {1, 1, 5}}), -8);
}

TEST(Integer_lattice, OfDimensionZeroIsFull) { expect_index(Integer_lattice(0), 1, 0); }

TEST(Integer_lattice, OfTooFewVectorsHasNoFiniteIndex) {
  expect_index(Integer_lattice(3), 0, 3);
  const Integer_lattice lattice = lattice_of({{1, 0, 0}, {0, 0, 1}, {3, 0, 5}}, 3);
  expect_index(lattice, 0, 3);
  EXPECT_EQ(lattice.first_defect(), 1u);
}

TEST(Integer_lattice, HasTheIndexOfItsDeterminant) {
  Random random(1);
  for(int i = 0; i < 500; ++i) {
    SCOPED_TRACE(i);
    const std::size_t n = 1 + random.below(8);
    const Integer_matrix matrix =
        random_matrix(random, n, n, 1 + static_cast<int>(random.below(9)));
    expect_index(lattice_of(matrix, n), abs(determinant(matrix)), n);
  }
}

TEST(Integer_lattice, DoesNotDependOnTheOrderOfTheVectors) {
  Random random(2);
  for(int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    Integer_matrix matrix = random_matrix(random, 9, 6, 3);
    const Integer index = lattice_of(matrix, 6).index();
    random.shuffle(matrix);
    for(auto& row : matrix)
      if(random.below(2) == 0)
        for(Integer& x : row)
          x = -x;
    expect_index(lattice_of(matrix, 6), index, 6);
  }
}

// The index of the lattice of more vectors is the greatest common divisor of all determinants.
TEST(Integer_lattice, OfManyVectorsIsThatOfAllTheirSubsets) {
  Random random(3);
  for(int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const Integer_matrix matrix = random_matrix(random, 6, 3, 6);
    Integer divisor = 0;
    for(std::size_t a = 0; a < 6; ++a)
      for(std::size_t b = 0; b < a; ++b)
        for(std::size_t c = 0; c < b; ++c)
          divisor = gcd(divisor, determinant({matrix[a], matrix[b], matrix[c]}));
    expect_index(lattice_of(matrix, 3), divisor, 3);
  }
}

// Numbers far beyond 64 bits arise on the way, and in the end.
TEST(Integer_lattice, HoldsNumbersOfAnySize) {
  Random random(4);
  const std::size_t n = 40;
  const Integer_matrix matrix = random_matrix(random, n, n, 1000);
  const Integer index = abs(determinant(matrix));
  EXPECT_GT(index, Integer(1) << 200);
  expect_index(lattice_of(matrix, n), index, n);
}

TEST(Integer_lattice, IsFullForUnimodularVectors) {
  Random random(5);
  for(int i = 0; i < 50; ++i) {
    SCOPED_TRACE(i);
    const std::size_t n = 2 + random.below(10);
    Integer_matrix matrix(n, std::vector<Integer>(n, 0));
    for(std::size_t k = 0; k < n; ++k)
      matrix[k][k] = 1;
    for(int step = 0; step < 100; ++step) {
      const std::size_t a = random.below(n), b = random.below(n);
      for(std::size_t j = 0; a != b && j < n; ++j)
        matrix[a][j] += matrix[b][j];
    }
    expect_index(lattice_of(matrix, n), 1, n);
  }
}

} // namespace test_integer_lattice
