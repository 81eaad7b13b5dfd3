#ifndef HTL_TEST_CUDA_STAND_IN_ARRAY_H
#define HTL_TEST_CUDA_STAND_IN_ARRAY_H

#include "Pool.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace cuda_stand_in {

// An array in the memory of a device. The pool that it is from lives at least as long, though it
// may have been destroyed for the program.
class Array
{
public:
  // Null if there is too little memory.
  static std::shared_ptr<Array> make(std::shared_ptr<Pool> pool, std::size_t bytes) {
    const std::size_t piece = pool->take(bytes);
    return piece == 0 ? nullptr : std::shared_ptr<Array>(new Array(std::move(pool), bytes, piece));
  }
  ~Array() {
    pool_->device().addresses().give_back(data_);
    pool_->give_back(piece_);
  }
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;

  void* data() const { return data_; }

private:
  Array(std::shared_ptr<Pool> pool, std::size_t bytes, std::size_t piece)
      : pool_(std::move(pool))
      , piece_(piece)
      , data_(pool_->device().addresses().allocate(bytes)) {}

  std::shared_ptr<Pool> pool_;
  std::size_t piece_;
  void* data_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_ARRAY_H
