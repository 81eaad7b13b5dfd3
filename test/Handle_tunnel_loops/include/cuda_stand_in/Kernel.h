#ifndef HTL_TEST_CUDA_STAND_IN_KERNEL_H
#define HTL_TEST_CUDA_STAND_IN_KERNEL_H

#include "Device.h"
#include "argument_addresses.h"

#include <boost/core/demangle.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <typeinfo>
#include <vector>

namespace cuda_stand_in {

// A kernel and its arguments, copied as a launch copies them.
struct Kernel
{
  const char* type;
  std::function<void()> thread;          // what each thread does
  std::vector<std::uintptr_t> addresses; // among the arguments

  void complain(const char* of_what) const {
    complaints.add("a kernel of type " + boost::core::demangle(type) + ' ' + of_what);
  }
};

template <typename T> struct Exactly
{
  using type = T;
};

template <typename... Parameters>
Kernel bound_kernel(void (*kernel)(Parameters...),
                    const typename Exactly<Parameters>::type&... arguments) {
  Kernel bound;
  bound.type = typeid(kernel).name();
  bound.thread = [kernel, arguments...] { kernel(arguments...); };
  (append_addresses(arguments, bound.addresses), ...);
  return bound;
}

// Complains of memory of the host, and of memory that has been given back.
inline void check_addresses(const Kernel& kernel, Device& device) {
  for(const std::uintptr_t word : kernel.addresses) {
    const void* const address = reinterpret_cast<const void*>(word);
    if(!device.addresses().contains(address)) {
      if(is_mapped(word))
        kernel.complain("is given memory that is not of its device");
    } else if(!device.addresses().is_allocated(address, 1))
      kernel.complain("is given memory that has been given back");
  }
}

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_KERNEL_H
