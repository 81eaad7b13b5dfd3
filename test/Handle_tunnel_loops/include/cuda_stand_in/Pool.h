#ifndef HTL_TEST_CUDA_STAND_IN_POOL_H
#define HTL_TEST_CUDA_STAND_IN_POOL_H

#include "Device.h"

#include <cstddef>
#include <iterator>
#include <mutex>
#include <set>

namespace cuda_stand_in {

// A pool of a device's memory. What is given back it keeps, in the pieces in which it was taken; a
// piece is used again for what needs at least half of it.
class Pool
{
public:
  explicit Pool(Device& device)
      : device_(device) {}
  ~Pool() { trim(0); }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  Device& device() { return device_; }
  std::size_t used_bytes() const {
    const Lock lock(mutex_);
    return used_;
  }
  std::size_t reserved_bytes() const {
    const Lock lock(mutex_);
    return used_ + kept_bytes_;
  }

  // The size of a piece for so many bytes, zero if there is none.
  std::size_t take(std::size_t bytes) {
    const Lock lock(mutex_);
    const std::size_t rounded = (bytes + granule - 1) / granule * granule;
    const auto piece = kept_.lower_bound(rounded);
    const bool is_kept = piece != kept_.end() && *piece <= 2 * rounded;
    const std::size_t size = is_kept ? *piece : rounded;
    if(is_kept) {
      kept_bytes_ -= size;
      kept_.erase(piece);
    } else if(!device_.reserve(size))
      return 0;
    used_ += size;
    return size;
  }

  void give_back(std::size_t piece) {
    const Lock lock(mutex_);
    used_ -= piece;
    kept_bytes_ += piece;
    kept_.insert(piece);
  }

  // Gives back to the device what is kept, until so much is left of all that was taken.
  void trim(std::size_t bytes) {
    const Lock lock(mutex_);
    while(!kept_.empty() && used_ + kept_bytes_ > bytes) {
      const auto largest = std::prev(kept_.end());
      device_.give_back(*largest);
      kept_bytes_ -= *largest;
      kept_.erase(largest);
    }
  }

private:
  using Lock = std::lock_guard<std::mutex>;

  static constexpr std::size_t granule = 512;

  Device& device_;
  std::size_t used_ = 0, kept_bytes_ = 0;
  std::multiset<std::size_t> kept_;
  mutable std::mutex mutex_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_POOL_H
