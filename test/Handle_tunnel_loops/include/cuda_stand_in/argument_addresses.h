#ifndef HTL_TEST_CUDA_STAND_IN_ARGUMENT_ADDRESSES_H
#define HTL_TEST_CUDA_STAND_IN_ARGUMENT_ADDRESSES_H

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

namespace cuda_stand_in {

// On the usual systems of 64 bits, addresses of programs and of their memory; of the numbers that
// are arguments of kernels none looks like that.
inline bool looks_like_address(std::uintptr_t word) {
  return word >= 0x500000000000 && word < 0x800000000000;
}

// Arguments are structures of spans; there is no way to ask for what they point to. Between their
// members there may be anything, which only some compilers can clear away: with others nothing is
// looked for.
template <typename T>
void append_addresses([[maybe_unused]] T argument,
                      [[maybe_unused]] std::vector<std::uintptr_t>& found) {
  static_assert(std::is_trivially_copyable<T>::value, "a launch copies arguments as bytes");
#if defined(__has_builtin)
#if __has_builtin(__builtin_clear_padding)
  __builtin_clear_padding(&argument);
  const char* const bytes = reinterpret_cast<const char*>(&argument);
  for(std::size_t i = 0; i + sizeof(std::uintptr_t) <= sizeof(T); i += sizeof(std::uintptr_t)) {
    std::uintptr_t word;
    std::memcpy(&word, bytes + i, sizeof(word));
    if(looks_like_address(word))
      found.push_back(word);
  }
#endif
#endif
}

inline bool is_mapped(std::uintptr_t word) {
  constexpr std::uintptr_t page = 4096;
  return msync(reinterpret_cast<void*>(word / page * page), page, MS_ASYNC) == 0;
}

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_ARGUMENT_ADDRESSES_H
