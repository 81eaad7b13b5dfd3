#ifndef HTL_TEST_CUDA_STAND_IN_ADDRESS_SPACE_H
#define HTL_TEST_CUDA_STAND_IN_ADDRESS_SPACE_H

#include "Complaints.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <map>
#include <mutex>
#include <new>
#include <string>

namespace cuda_stand_in {

// The addresses of a device's memory. Whoever touches them while no work of the device runs ends
// by a signal, as with a device. What is new is full of rubbish; what is given back is not used
// again as long as anything else is in use.
class Address_space
{
public:
  Address_space()
      : begin_(static_cast<char*>(
            mmap(nullptr, size_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0))) {
    if(begin_ == MAP_FAILED)
      throw std::bad_alloc();
  }
  ~Address_space() { munmap(begin_, size_); }
  Address_space(const Address_space&) = delete;
  Address_space& operator=(const Address_space&) = delete;

  void* allocate(std::size_t bytes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::size_t all = (bytes + fence + page - 1) / page * page;
    if(all > size_ - used_)
      throw std::bad_alloc();
    char* const data = begin_ + used_;
    used_ += all;
    protect(data, all, PROT_READ | PROT_WRITE);
    std::memset(data, rubbish, all);
    if(number_of_users_ == 0)
      protect(data, all, PROT_NONE);
    sizes_[data] = bytes;
    return data;
  }

  void give_back(void* address) {
    open();
    close_after([&] {
      char* const data = static_cast<char*>(address);
      const std::size_t bytes = sizes_.at(data);
      if(std::any_of(data + bytes, data + bytes + fence, [](char c) { return c != rubbish; }))
        complaints.add("something was written past the end of an array");
      madvise(data, (bytes + fence + page - 1) / page * page, MADV_DONTNEED);
      sizes_.erase(data);
    });
  }

  bool contains(const void* address) const { return address >= begin_ && address < begin_ + size_; }

  // Whether so many bytes from there on are allocated in one piece.
  bool is_allocated(const void* address, std::size_t bytes) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const char* const data = static_cast<const char*>(address);
    const auto after = sizes_.upper_bound(data);
    if(after == sizes_.begin())
      return false;
    const auto [begin, size] = *std::prev(after);
    return data + bytes <= begin + size;
  }

  // Between these two the memory may be touched.
  void open() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(number_of_users_++ == 0)
      protect(begin_, used_, PROT_READ | PROT_WRITE);
  }
  void close() {
    close_after([] {});
  }

private:
  template <typename Function> void close_after(const Function& f) {
    const std::lock_guard<std::mutex> lock(mutex_);
    f();
    if(--number_of_users_ == 0)
      protect(begin_, used_, PROT_NONE);
    if(sizes_.empty() && number_of_users_ == 0)
      used_ = 0;
  }

  static void protect(char* data, std::size_t bytes, int protection) {
    if(bytes != 0 && mprotect(data, bytes, protection) != 0)
      throw std::bad_alloc();
  }

  static constexpr std::size_t size_ = std::size_t(1) << 34;
  static constexpr std::size_t page = 4096, fence = 64;
  static constexpr char rubbish = 0x55;

  char* begin_;
  std::size_t used_ = 0;
  int number_of_users_ = 0;
  std::map<const char*, std::size_t> sizes_;
  mutable std::mutex mutex_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_ADDRESS_SPACE_H
