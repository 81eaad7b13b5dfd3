#ifndef HTL_TEST_NUMBER_OF_CASES_H
#define HTL_TEST_NUMBER_OF_CASES_H

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <vector>

// Under sanitizers a case takes up to twenty times as long, so that fewer are tried: what they
// look for, in code that is the same for all cases, is found in the first ones.
#if defined(__SANITIZE_THREAD__)
#define HTL_TEST_WITH_THREAD_SANITIZER
#elif defined(__SANITIZE_ADDRESS__)
#define HTL_TEST_FEWER_CASES
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define HTL_TEST_WITH_THREAD_SANITIZER
#elif __has_feature(address_sanitizer)
#define HTL_TEST_FEWER_CASES
#endif
#endif
#ifdef HTL_TEST_WITH_THREAD_SANITIZER
#define HTL_TEST_FEWER_CASES
#endif

// A change that breaks something breaks it for many cases: most runs try a part of them, the tests
// with the label "long" all, which they say by HTL_TEST_CASES=all in the environment.
inline bool are_all_cases_tried() {
  const char* cases = std::getenv("HTL_TEST_CASES");
  return cases != nullptr && std::strcmp(cases, "all") == 0;
}

#ifdef HTL_TEST_FEWER_CASES
constexpr bool are_few_cases_tried() { return true; }
#else
inline bool are_few_cases_tried() { return !are_all_cases_tried(); }
#endif

// Of a property that is tested with random input.
inline int number_of_cases(int n) { return are_few_cases_tried() ? (std::max)(1, n / 10) : n; }

// Of a list: the first and others, spread over all of it.
template <typename Case> std::vector<Case> enough_of(const std::vector<Case>& all) {
  // Odd, and so for lists with two or four variants of each kind they are of all variants.
  const std::size_t step = are_few_cases_tried() ? 7 : 1;
  std::vector<Case> cases;
  for(std::size_t i = 0; i < all.size(); i += step)
    cases.push_back(all[i]);
  return cases;
}

#endif // HTL_TEST_NUMBER_OF_CASES_H
