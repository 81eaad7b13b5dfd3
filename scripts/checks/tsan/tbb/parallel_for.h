#ifndef HTL_TSAN_TBB_PARALLEL_FOR_H
#define HTL_TSAN_TBB_PARALLEL_FOR_H

// Stands in for the header of the same name when the thread sanitizer is on. Debian's oneTBB is not
// compiled with the sanitizer, which therefore does not see how the library hands work from thread
// to thread and takes every such step for a race. These threads it sees: what it still reports is
// a race of this project.

#include <exception>
#include <thread>
#include <vector>

namespace tbb {

/// calls `f(i)` for all i in [first, last), in four threads whatever the machine has. They share no
/// counter: it would order the calls, and so hide races between them.
template <typename Index, typename Function>
void parallel_for(Index first, Index last, const Function& f) {
  constexpr int number_of_threads = 4;
  std::vector<std::exception_ptr> exceptions(number_of_threads);
  std::vector<std::thread> threads;
  for(int t = 0; t < number_of_threads; ++t)
    threads.emplace_back([&f, &exceptions, first, last, t] {
      try {
        for(Index i = first + static_cast<Index>(t); i < last; i += number_of_threads)
          f(i);
      } catch(...) {
        exceptions[t] = std::current_exception();
      }
    });
  for(std::thread& thread : threads)
    thread.join();
  for(const std::exception_ptr& exception : exceptions)
    if(exception)
      std::rethrow_exception(exception);
}

/// calls `body(range)`: for libraries, whose own threads are not what is looked at.
template <typename Range, typename Body> void parallel_for(const Range& range, const Body& body) {
  body(range);
}

} // namespace tbb

#endif // HTL_TSAN_TBB_PARALLEL_FOR_H
