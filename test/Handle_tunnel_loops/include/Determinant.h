#ifndef HTL_TEST_DETERMINANT_H
#define HTL_TEST_DETERMINANT_H

#include <boost/multiprecision/cpp_int.hpp>

#include <cstddef>
#include <utility>
#include <vector>

using Integer = boost::multiprecision::cpp_int;
using Integer_matrix = std::vector<std::vector<Integer>>;

// By Bareiss's elimination: all divisions are exact.
inline Integer determinant(Integer_matrix m) {
  const std::size_t n = m.size();
  Integer sign = 1, previous = 1;
  for(std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    while(pivot < n && m[pivot][k] == 0)
      ++pivot;
    if(pivot == n)
      return 0;
    if(pivot != k) {
      std::swap(m[pivot], m[k]);
      sign = -sign;
    }
    for(std::size_t i = k + 1; i < n; ++i)
      for(std::size_t j = k + 1; j < n; ++j)
        m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) / previous;
    previous = m[k][k];
  }
  return sign * previous;
}

#endif // HTL_TEST_DETERMINANT_H
