#ifndef HTL_TEST_NUMBER_OF_CASES_H
#define HTL_TEST_NUMBER_OF_CASES_H

#include <cstddef>
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

#ifdef HTL_TEST_FEWER_CASES
constexpr int fewer_cases = 10;
#else
constexpr int fewer_cases = 1;
#endif

// Of a property that is tested with random input.
constexpr int number_of_cases(int n) { return n < fewer_cases ? 1 : n / fewer_cases; }

// Of a list: the first and others, spread over all of it.
template <typename Case> std::vector<Case> enough_of(const std::vector<Case>& all) {
  // Odd, and so for lists with two or four variants of each kind they are of all variants.
  constexpr std::size_t step = fewer_cases > 1 ? 7 : 1;
  std::vector<Case> cases;
  for(std::size_t i = 0; i < all.size(); i += step)
    cases.push_back(all[i]);
  return cases;
}

#endif // HTL_TEST_NUMBER_OF_CASES_H
