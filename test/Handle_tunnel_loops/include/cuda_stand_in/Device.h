#ifndef HTL_TEST_CUDA_STAND_IN_DEVICE_H
#define HTL_TEST_CUDA_STAND_IN_DEVICE_H

#include "Address_space.h"

#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>

namespace cuda_stand_in {

// What a device is made to be.
struct Device_kind
{
  std::size_t memory = std::size_t(64) << 20;
  int multiprocessors = 2, blocks_per_multiprocessor = 1, threads_per_block = 2;
  int compute_capability = 9;
  bool has_cooperative_launches = true, has_pools = true, has_code = true;
};

// A device: its memory, which pools share, and what it was asked to do.
class Device
{
public:
  explicit Device(const Device_kind& kind)
      : kind_(kind) {}

  const Device_kind& kind() const { return kind_; }
  Address_space& addresses() { return addresses_; }

  std::size_t free_bytes() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return kind_.memory - reserved_;
  }
  std::size_t reserved_bytes() const { return kind_.memory - free_bytes(); }

  // Takes memory for a pool, if there is enough.
  bool reserve(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(bytes > kind_.memory - reserved_)
      return false;
    reserved_ += bytes;
    return true;
  }
  void give_back(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    reserved_ -= bytes;
  }

  std::atomic<unsigned> number_of_kernels{0};

private:
  Device_kind kind_;
  Address_space addresses_;
  std::size_t reserved_ = 0;
  mutable std::mutex mutex_;
};

// While it lives the memory of the device may be touched: work of the device is done.
class Working
{
public:
  explicit Working(Device& device)
      : addresses_(device.addresses()) {
    addresses_.open();
  }
  ~Working() { addresses_.close(); }
  Working(const Working&) = delete;
  Working& operator=(const Working&) = delete;

private:
  Address_space& addresses_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_DEVICE_H
