// Vectors of integers, the lattices that they span and the systems of equations between them,
// against numbers without limits.

#include "Integer_span.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/internal/homology/Class_lattice.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace test_class_vectors {

using namespace CGAL::Handle_tunnel_loops::internal;
using CGAL::Handle_tunnel_loops::generators::Random;

// ---- residues

const Integer field_size_of_test = (Integer(1) << 61) - 1;

std::vector<Residue> some_residues(Random& random) {
  std::vector<Residue> residues = {
      0, 1, 2, field_size - 1, field_size - 2, field_size / 2, field_size / 2 + 1};
  for(int bit = 0; bit < 61; ++bit)
    residues.push_back(Residue(1) << bit);
  for(int i = 0; i < 100; ++i) {
    residues.push_back(random.next() % field_size);
    residues.push_back(field_size - 1 - random.below(std::size_t(1) << 31));
  }
  return residues;
}

TEST(Residues, AreARing) {
  Random random(1);
  const std::vector<Residue> residues = some_residues(random);
  for(const Residue a : residues) {
    EXPECT_EQ(Integer(difference(0, a)), (field_size_of_test - a) % field_size_of_test);
    for(const Residue b : residues) {
      ASSERT_EQ(Integer(difference(a, b)), (field_size_of_test + a - b) % field_size_of_test);
      ASSERT_EQ(Integer(product(a, b)), Integer(a) * b % field_size_of_test) << a << ' ' << b;
    }
  }
}

TEST(Residues, HaveInverses) {
  Random random(2);
  for(const Residue a : some_residues(random))
    if(a != 0) {
      EXPECT_EQ(product(a, inverse(a)), 1u) << a;
    }
}

TEST(Residues, AreClassesOfIntegers) {
  Random random(3);
  constexpr std::int64_t p = static_cast<std::int64_t>(field_size);
  std::vector<std::int64_t> integers = {0, 1, -1, p / 2, -(p / 2)};
  for(int i = 0; i < 1000; ++i)
    integers.push_back(static_cast<std::int64_t>(random.next() % field_size) - p / 2);
  for(const std::int64_t x : integers) {
    EXPECT_EQ(smallest_integer_of(residue_of(x)), x);
    for(const std::int64_t times : {-3, -2, -1, 1, 2, 3})
      EXPECT_EQ(residue_of(x + times * p), residue_of(x)) << x << ' ' << times;
  }
}

// ---- vectors

using Dense = std::vector<std::int64_t>;

Class_vector sparse(const Dense& dense) {
  Class_vector v;
  for(Index i = 0; i < dense.size(); ++i)
    if(dense[i] != 0)
      v.emplace_back(i, dense[i]);
  return v;
}

Dense dense(const Class_vector& v, std::size_t size) {
  Dense result(size, 0);
  for(const auto& [i, value] : v)
    result[i] += value;
  return result;
}

Dense random_vector(Random& random, std::size_t size, std::int64_t largest, double density = 0.5) {
  Dense v(size, 0);
  for(std::int64_t& x : v)
    if(random.uniform(0., 1.) < density)
      x = static_cast<std::int64_t>(random.below(2 * largest + 1)) - largest;
  return v;
}

void expect_normal(const Class_vector& v) {
  for(std::size_t i = 0; i < v.size(); ++i) {
    EXPECT_NE(v[i].second, 0);
    EXPECT_TRUE(i == 0 || v[i - 1].first < v[i].first);
  }
}

TEST(Class_vector, IsASumOfItsEntries) {
  Random random(4);
  for(int round = 0; round < 500; ++round) {
    Class_vector v;
    Dense expected(8, 0);
    for(std::size_t i = random.below(20); i > 0; --i) {
      const Index index = static_cast<Index>(random.below(8));
      const std::int64_t value = static_cast<std::int64_t>(random.below(5)) - 2;
      v.emplace_back(index, value);
      expected[index] += value;
    }
    normalize(v);
    expect_normal(v);
    EXPECT_EQ(dense(v, 8), expected);
    for(Index i = 0; i < 10; ++i)
      EXPECT_EQ(coordinate(v, i), i < 8 ? expected[i] : 0);
  }
}

TEST(Class_vector, CanBeAdded) {
  Random random(5);
  for(int round = 0; round < 2000; ++round) {
    const Dense a = random_vector(random, 8, 3), b = random_vector(random, 8, 3);
    const std::int64_t factor = static_cast<std::int64_t>(random.below(7)) - 3;
    Class_vector v = sparse(a);
    ASSERT_TRUE(add_multiple(v, factor, sparse(b)));
    expect_normal(v);
    Dense expected = a;
    for(std::size_t i = 0; i < a.size(); ++i)
      expected[i] += factor * b[i];
    EXPECT_EQ(dense(v, 8), expected);
  }
}

TEST(Class_vector, HasNoLargeNumbers) {
  constexpr std::int64_t most = largest_coordinate;
  Class_vector v = {{2, most}};
  EXPECT_TRUE(add_multiple(v, -2, {{2, most}}));
  EXPECT_EQ(v, (Class_vector{{2, -most}}));
  EXPECT_TRUE(add_multiple(v, 1, {{1, 1}, {3, 1}}));
  const Class_vector before = v;
  EXPECT_FALSE(add_multiple(v, -1, {{2, 1}}));
  EXPECT_FALSE(add_multiple(v, most, {{0, most}}));
  EXPECT_FALSE(add_multiple(v, most + 1, {{0, 1}}));
  EXPECT_EQ(v, before);
}

// ---- systems of equations

// By row operations and permutations from the unit matrix, so that its determinant is 1 or -1.
std::vector<Dense> random_unimodular(Random& random, std::size_t n, std::size_t operations) {
  std::vector<Dense> m(n, Dense(n, 0));
  for(std::size_t i = 0; i < n; ++i)
    m[i][i] = random.below(2) == 0 ? 1 : -1;
  for(std::size_t k = 0; k < operations && n > 1; ++k) {
    const std::size_t i = random.below(n), j = random.below(n);
    const std::int64_t factor = static_cast<std::int64_t>(random.below(5)) - 2;
    std::int64_t largest = 0;
    Dense row = m[i];
    for(std::size_t c = 0; c < n; ++c) {
      row[c] += factor * m[j][c];
      largest = (std::max)(largest, row[c] < 0 ? -row[c] : row[c]);
    }
    if(i != j && largest < 1000)
      m[i] = row;
  }
  random.shuffle(m);
  return m;
}

std::vector<Class_vector> sparse_rows(const std::vector<Dense>& m) {
  std::vector<Class_vector> rows;
  for(const Dense& row : m)
    rows.push_back(sparse(row));
  return rows;
}

Dense image(const std::vector<Dense>& m, const Dense& x) {
  Dense b(m.size(), 0);
  for(std::size_t i = 0; i < m.size(); ++i)
    for(std::size_t j = 0; j < x.size(); ++j)
      b[i] += m[i][j] * x[j];
  return b;
}

TEST(Unimodular_system, IsSolved) {
  Random random(6);
  for(int round = 0; round < 300; ++round) {
    const std::size_t n = 1 + random.below(30);
    const std::vector<Dense> m = random_unimodular(random, n, random.below(6 * n));
    const Unimodular_system system(sparse_rows(m));
    ASSERT_TRUE(system.is_regular());
    for(int k = 0; k < 5; ++k) {
      const Dense x = random_vector(random, n, k < 3 ? 3 : 1000000);
      const std::optional<Class_vector> solution = system.solve(sparse(image(m, x)));
      ASSERT_TRUE(solution);
      expect_normal(*solution);
      EXPECT_EQ(dense(*solution, n), x);
      Dense modulo(n, 0);
      system.solve_modulo(sparse(image(m, x)), [&](Index column, Residue value) {
        modulo[column] = smallest_integer_of(value);
      });
      EXPECT_EQ(modulo, x);
    }
  }
}

TEST(Unimodular_system, IsNotRegularIfItIsSingular) {
  Random random(7);
  for(int round = 0; round < 200; ++round) {
    const std::size_t n = 1 + random.below(20);
    std::vector<Dense> m = random_unimodular(random, n, 3 * n);
    const std::size_t i = random.below(n);
    Dense row(n, 0);
    for(std::size_t j = 0; j < n; ++j)
      if(j != i && random.below(3) == 0)
        for(std::size_t c = 0; c < n; ++c)
          row[c] += m[j][c];
    m[i] = row;
    EXPECT_FALSE(Unimodular_system(sparse_rows(m)).is_regular());
  }
}

// A chain of twos: the last coordinate is a power of two.
TEST(Unimodular_system, HasNoSolutionWithLargeNumbers) {
  for(const std::size_t n : {20, 30, 31, 32, 33, 40, 60, 70}) {
    std::vector<Class_vector> rows;
    for(Index i = 0; i < n; ++i)
      rows.push_back(i == 0 ? Class_vector{{0, 1}} : Class_vector{{i - 1, -2}, {i, 1}});
    const Unimodular_system system(std::move(rows));
    ASSERT_TRUE(system.is_regular());
    const std::optional<Class_vector> solution = system.solve({{0, 1}});
    if(n <= 31) {
      ASSERT_TRUE(solution);
      for(Index i = 0; i < n; ++i)
        EXPECT_EQ(coordinate(*solution, i), std::int64_t(1) << i);
    } else
      EXPECT_FALSE(solution);
    EXPECT_TRUE(system.solve({{static_cast<Index>(n - 1), 1}}));
  }
}

// The only solution is one half, which is small modulo no prime.
TEST(Unimodular_system, HasNoSolutionThatIsNoInteger) {
  const Unimodular_system system({{{0, 2}}});
  EXPECT_FALSE(system.solve({{0, 1}}));
  EXPECT_EQ(system.solve({{0, 6}}), (Class_vector{{0, 3}}));
}

// ---- lattices

// The rows of the Hermite normal form: the same for all generators of a lattice.
std::vector<std::vector<Integer>> hermite_form(std::vector<std::vector<Integer>> m) {
  std::size_t rank = 0;
  for(std::size_t c = 0; !m.empty() && c < m.front().size(); ++c) {
    for(;;) {
      std::size_t pivot = m.size(), others = 0;
      for(std::size_t i = rank; i < m.size(); ++i)
        if(m[i][c] != 0) {
          ++others;
          if(pivot == m.size() || abs(m[i][c]) < abs(m[pivot][c]))
            pivot = i;
        }
      if(others == 0)
        break;
      std::swap(m[rank], m[pivot]);
      for(std::size_t i = rank + 1; i < m.size(); ++i) {
        const Integer factor = m[i][c] / m[rank][c];
        for(std::size_t k = 0; k < m[i].size(); ++k)
          m[i][k] -= factor * m[rank][k];
      }
      if(others > 1)
        continue;
      if(m[rank][c] < 0)
        for(Integer& x : m[rank])
          x = -x;
      for(std::size_t i = 0; i < rank; ++i) {
        Integer factor = m[i][c] / m[rank][c];
        if(factor * m[rank][c] > m[i][c])
          --factor;
        for(std::size_t k = 0; k < m[i].size(); ++k)
          m[i][k] -= factor * m[rank][k];
      }
      ++rank;
      break;
    }
  }
  m.resize(rank);
  return m;
}

std::vector<std::vector<Integer>> integers(const std::vector<Class_vector>& rows, std::size_t n) {
  std::vector<std::vector<Integer>> m;
  for(const Class_vector& row : rows) {
    const Dense d = dense(row, n);
    m.emplace_back(d.begin(), d.end());
  }
  return m;
}

void expect_basis_of_span(const std::vector<Class_vector>& generators, std::size_t n) {
  const auto expected = hermite_form(integers(generators, n));
  std::optional<std::vector<Class_vector>> basis = lattice_basis(generators);
  ASSERT_TRUE(basis);
  EXPECT_EQ(basis->size(), expected.size());
  for(const Class_vector& v : *basis)
    expect_normal(v);
  EXPECT_EQ(hermite_form(integers(*basis, n)), expected);
}

TEST(Lattice_basis, SpansWhatTheGeneratorsDo) {
  Random random(8);
  for(int round = 0; round < 2000; ++round) {
    const std::size_t n = 1 + random.below(6), number = random.below(9);
    const std::int64_t largest = 1 + static_cast<std::int64_t>(random.below(6));
    std::vector<Class_vector> generators;
    for(std::size_t i = 0; i < number; ++i)
      generators.push_back(sparse(random_vector(random, n, largest)));
    SCOPED_TRACE(round);
    expect_basis_of_span(generators, n);
  }
}

// Sums of a few multiples of large numbers: there is no unit among the coordinates, although there
// may be one in the lattice.
TEST(Lattice_basis, NeedsNoUnits) {
  Random random(9);
  std::size_t with_units = 0;
  for(int round = 0; round < 1000; ++round) {
    const std::size_t n = 1 + random.below(4);
    std::vector<Class_vector> generators;
    for(std::size_t i = random.below(6) + 1; i > 0; --i) {
      Dense v(n, 0);
      for(std::int64_t& x : v)
        if(random.below(3) != 0)
          x = (random.below(2) == 0 ? 1 : -1) *
              std::vector<std::int64_t>{6, 10, 15, 4, 9}[random.below(5)];
      generators.push_back(sparse(v));
    }
    SCOPED_TRACE(round);
    expect_basis_of_span(generators, n);
    const auto form = hermite_form(integers(generators, n));
    with_units += std::any_of(form.begin(), form.end(), [](const auto& row) {
      return std::find(row.begin(), row.end(), Integer(1)) != row.end();
    });
  }
  EXPECT_GT(with_units, 100u);
}

// A lattice of a given basis, by many random members of it.
TEST(Lattice_basis, IsOneOfASubspace) {
  Random random(10);
  for(int round = 0; round < 300; ++round) {
    const std::size_t n = 4 + random.below(8), rank = 1 + random.below(n - 1);
    std::vector<Dense> basis = random_unimodular(random, n, n);
    basis.resize(rank);
    const std::int64_t factor = 1 + static_cast<std::int64_t>(random.below(2));
    std::vector<Class_vector> generators;
    for(const Dense& coefficients : random_unimodular(random, rank, 2 * rank)) {
      Dense v(n, 0);
      for(std::size_t i = 0; i < rank; ++i)
        for(std::size_t c = 0; c < n; ++c)
          v[c] += factor * coefficients[i] * basis[i][c];
      generators.push_back(sparse(v));
    }
    std::vector<Class_vector> multiples;
    for(Dense v : basis) {
      for(std::int64_t& x : v)
        x *= factor;
      multiples.push_back(sparse(v));
    }
    const std::optional<std::vector<Class_vector>> found = lattice_basis(generators);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->size(), rank);
    EXPECT_EQ(hermite_form(integers(*found, n)), hermite_form(integers(multiples, n)));
    EXPECT_EQ(is_saturated(integers(*found, n)), factor == 1);
  }
}

// Those that are a basis already are taken as they are.
TEST(Lattice_basis, KeepsVectorsWithUnits) {
  const std::vector<Class_vector> rows = {{{0, 1}}, {{0, 5}, {1, 1}}, {{1, 7}, {2, -1}}};
  EXPECT_EQ(lattice_basis(rows), rows);
}

TEST(Lattice_basis, IsNothingIfNumbersAreTooLarge) {
  constexpr std::int64_t most = largest_coordinate;
  EXPECT_FALSE(lattice_basis({{{0, 1}, {1, most}}, {{0, most}, {1, 3}}}));
}

double weighted_square(const Class_vector& v, const std::vector<double>& weights) {
  double sum = 0.;
  for(const auto& [i, value] : v)
    sum += weights[i] * double(value) * double(value);
  return sum;
}

// Short vectors, mixed until they are long, become short again.
TEST(Lattice_reduction, ShortensABasisOfTheSameLattice) {
  Random random(11);
  double before = 0., after = 0.;
  for(int round = 0; round < 300; ++round) {
    const std::size_t n = 2 + random.below(8);
    std::vector<Class_vector> basis;
    for(const Dense& v : random_unimodular(random, n, 6 * n))
      basis.push_back(sparse(v));
    std::vector<double> weights(n);
    for(double& w : weights)
      w = 1. + double(random.below(9));
    const std::vector<Class_vector> mixed = basis;
    Lattice_reduction(basis, weights).reduce();
    EXPECT_EQ(hermite_form(integers(basis, n)), hermite_form(integers(mixed, n)));
    for(std::size_t i = 0; i < n; ++i) {
      expect_normal(basis[i]);
      EXPECT_LE(weighted_square(basis[i], weights), weighted_square(mixed[i], weights));
      before += weighted_square(mixed[i], weights);
      after += weighted_square(basis[i], weights);
      // No multiple of another one would shorten it much.
      for(std::size_t j = 0; j < n; ++j)
        for(const std::int64_t factor : {-1, 1}) {
          Class_vector sum = basis[i];
          if(j != i && add_multiple(sum, factor, basis[j])) {
            EXPECT_GE(weighted_square(sum, weights), 0.99 * weighted_square(basis[i], weights));
          }
        }
    }
  }
  EXPECT_LT(after, 0.2 * before);
}

// A sum that does not fit is not taken, however much it would help.
TEST(Lattice_reduction, LeavesWhatIsTooLarge) {
  constexpr std::int64_t most = largest_coordinate;
  std::vector<Class_vector> basis = {{{0, 1}, {1, -most}}, {{0, most}, {1, 3}}};
  Lattice_reduction(basis, {1e12, 1.}).reduce();
  EXPECT_EQ(basis[0], (Class_vector{{0, 1}, {1, -most}}));
  for(const Class_vector& v : basis)
    for(const auto& coordinate : v)
      EXPECT_FALSE(is_too_large(coordinate.second));
}

} // namespace test_class_vectors
