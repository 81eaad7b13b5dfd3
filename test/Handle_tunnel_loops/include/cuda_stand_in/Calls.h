#ifndef HTL_TEST_CUDA_STAND_IN_CALLS_H
#define HTL_TEST_CUDA_STAND_IN_CALLS_H

#include "runtime_types.h"

#include <atomic>
#include <limits>

namespace cuda_stand_in {

// The calls of the runtime from first on, counted from one, that fail whatever they are asked for.
struct Fault
{
  unsigned first, number;
  cudaError_t error;

  bool contains(unsigned call) const { return call >= first && call - first < number; }
};

constexpr unsigned all_later = std::numeric_limits<unsigned>::max();
constexpr Fault no_fault = {1, 0, cudaSuccess};

// Counts the calls of the runtime and lets some of them fail.
class Calls
{
public:
  // Counts from one again.
  void restart(const Fault& fault = no_fault) {
    fault_ = fault;
    number_ = 0;
  }
  unsigned number() const { return number_; }

  // Does what a call is there for, or instead what it does when it fails.
  template <typename Body, typename Instead>
  cudaError_t make(const Body& body, const Instead& instead) {
    const bool fails = fault_.contains(++number_);
    if(fails)
      instead();
    const cudaError_t error = fails ? fault_.error : body();
    if(error != cudaSuccess)
      last_error = error;
    return error;
  }

  static inline thread_local cudaError_t last_error = cudaSuccess;

private:
  Fault fault_ = no_fault;
  std::atomic<unsigned> number_{0};
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_CALLS_H
