#ifndef HTL_TEST_CUDA_STAND_IN_STREAM_H
#define HTL_TEST_CUDA_STAND_IN_STREAM_H

#include "Device.h"

#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <utility>

namespace cuda_stand_in {

// Work of a device, in order. Nothing of it is done before somebody waits for it: whoever reads
// what is not there yet, or lets go of what is still to be copied from, is found out.
class Stream
{
public:
  explicit Stream(Device& device)
      : device_(device) {}
  ~Stream() { run(); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  Device& device() { return device_; }

  // How much work it was given.
  std::size_t length() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return length_;
  }

  void put(std::function<void()> work) {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.push_back(std::move(work));
    ++length_;
  }

  void run() {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Working working(device_);
    for(; !queue_.empty(); queue_.pop_front())
      queue_.front()();
  }

  // As after an error of the device: what was to be done never is. What was to be given back goes
  // with the work that holds it.
  void drop() {
    const std::lock_guard<std::mutex> lock(mutex_);
    queue_.clear();
  }

private:
  Device& device_;
  std::deque<std::function<void()>> queue_;
  std::size_t length_ = 0;
  mutable std::mutex mutex_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_STREAM_H
