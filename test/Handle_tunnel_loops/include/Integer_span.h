#ifndef HTL_TEST_INTEGER_SPAN_H
#define HTL_TEST_INTEGER_SPAN_H

#include "Determinant.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

// What integer vectors span.

// Vectors modulo a large prime, one after the other, and whether each is independent of those
// before.
class Independence
{
public:
  // Keeps the vector if it is.
  bool add(const std::vector<int>& vector) {
    std::vector<std::int64_t> rest(vector.begin(), vector.end());
    for(std::int64_t& x : rest)
      x = ((x % prime) + prime) % prime;
    for(const Row& row : rows_)
      if(const std::int64_t factor = rest[row.pivot]; factor != 0)
        for(std::size_t i = 0; i < rest.size(); ++i)
          rest[i] = (rest[i] + (prime - factor) * row.vector[i]) % prime;
    for(std::size_t i = 0; i < rest.size(); ++i)
      if(rest[i] != 0) {
        const std::int64_t factor = inverse(rest[i]);
        for(std::int64_t& x : rest)
          x = x * factor % prime;
        rows_.push_back({i, std::move(rest)});
        return true;
      }
    return false;
  }

private:
  static constexpr std::int64_t prime = 2147483647;

  struct Row
  {
    std::size_t pivot; // the vector is 1 there
    std::vector<std::int64_t> vector;
  };

  // By Fermat's little theorem.
  static std::int64_t inverse(std::int64_t x) {
    std::int64_t result = 1;
    for(std::int64_t exponent = prime - 2; exponent > 0; exponent /= 2) {
      if(exponent % 2 == 1)
        result = result * x % prime;
      x = x * x % prime;
    }
    return result;
  }

  std::vector<Row> rows_;
};

// Whether the rows are independent, and each integer vector that is a rational combination of them
// is an integer one: by row and column operations the matrix becomes diagonal, with units.
inline bool is_saturated(Integer_matrix m) {
  for(std::size_t k = 0; k < m.size(); ++k)
    for(bool is_clear = false; !is_clear;) {
      std::size_t row = k, column = k;
      for(std::size_t i = k; i < m.size(); ++i)
        for(std::size_t j = k; j < m[i].size(); ++j)
          if(m[i][j] != 0 && (m[row][column] == 0 || abs(m[i][j]) < abs(m[row][column]))) {
            row = i;
            column = j;
          }
      if(column >= m[k].size() || m[row][column] == 0)
        return false;
      std::swap(m[k], m[row]);
      for(auto& r : m)
        std::swap(r[k], r[column]);
      is_clear = true;
      for(std::size_t i = k + 1; i < m.size(); ++i) {
        const Integer factor = m[i][k] / m[k][k];
        for(std::size_t j = k; j < m[i].size(); ++j)
          m[i][j] -= factor * m[k][j];
        is_clear = is_clear && m[i][k] == 0;
      }
      for(std::size_t j = k + 1; j < m[k].size(); ++j) {
        const Integer factor = m[k][j] / m[k][k];
        for(std::size_t i = k; i < m.size(); ++i)
          m[i][j] -= factor * m[i][k];
        is_clear = is_clear && m[k][j] == 0;
      }
      if(is_clear && abs(m[k][k]) != 1)
        return false;
    }
  return true;
}

// The inverse of a matrix with determinant 1 or -1, by Cramer's rule.
inline Integer_matrix unimodular_inverse(const Integer_matrix& m) {
  const Integer det = determinant(m);
  Integer_matrix inverse(m.size(), std::vector<Integer>(m.size()));
  for(std::size_t i = 0; i < m.size(); ++i)
    for(std::size_t j = 0; j < m.size(); ++j) {
      Integer_matrix minor = m;
      minor.erase(minor.begin() + i);
      for(auto& row : minor)
        row.erase(row.begin() + j);
      inverse[j][i] = ((i + j) % 2 == 0 ? 1 : -1) * det * determinant(minor);
    }
  return inverse;
}

inline Integer_matrix product(const Integer_matrix& a, const Integer_matrix& b) {
  Integer_matrix result(a.size(), std::vector<Integer>(b.front().size(), 0));
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t k = 0; k < b.size(); ++k)
      for(std::size_t j = 0; j < b[k].size(); ++j)
        result[i][j] += a[i][k] * b[k][j];
  return result;
}

inline Integer_matrix transposed(const Integer_matrix& m) {
  Integer_matrix result(m.front().size(), std::vector<Integer>(m.size()));
  for(std::size_t i = 0; i < m.size(); ++i)
    for(std::size_t j = 0; j < m[i].size(); ++j)
      result[j][i] = m[i][j];
  return result;
}

#endif // HTL_TEST_INTEGER_SPAN_H
