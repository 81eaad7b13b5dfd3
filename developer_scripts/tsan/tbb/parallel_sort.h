#ifndef HTL_TSAN_TBB_PARALLEL_SORT_H
#define HTL_TSAN_TBB_PARALLEL_SORT_H

// Stands in for the header of the same name when the thread sanitizer is on, as parallel_for.h
// does.

#include <algorithm>
#include <thread>

namespace tbb {

/// sorts, in two threads.
template <typename Iterator, typename Less>
void parallel_sort(Iterator first, Iterator last, const Less& less) {
  const Iterator middle = first + (last - first) / 2;
  std::thread thread([&] { std::sort(first, middle, less); });
  std::sort(middle, last, less);
  thread.join();
  std::inplace_merge(first, middle, last, less);
}

} // namespace tbb

#endif // HTL_TSAN_TBB_PARALLEL_SORT_H
