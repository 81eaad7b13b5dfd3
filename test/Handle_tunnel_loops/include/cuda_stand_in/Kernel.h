#ifndef HTL_TEST_CUDA_STAND_IN_KERNEL_H
#define HTL_TEST_CUDA_STAND_IN_KERNEL_H

#include "Device.h"
#include "argument_addresses.h"

#include <boost/core/demangle.hpp>

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <typeinfo>
#include <utility>
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

// The kernels that a program has asked about, by their addresses: graphs are told the address and
// those of the arguments, but not the types.
class Kernel_types
{
public:
  template <typename... Parameters> void add(void (*kernel)(Parameters...)) {
    const std::lock_guard<std::mutex> lock(mutex_);
    binders_[reinterpret_cast<const void*>(kernel)] = [kernel](void** arguments) {
      return bind(kernel, arguments, std::index_sequence_for<Parameters...>());
    };
  }

  // Null if it is not known.
  std::function<Kernel(void**)> binder(const void* kernel) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = binders_.find(kernel);
    return found == binders_.end() ? nullptr : found->second;
  }

private:
  template <typename... Parameters, std::size_t... I>
  static Kernel bind(void (*kernel)(Parameters...), void** arguments, std::index_sequence<I...>) {
    return bound_kernel(kernel, *static_cast<const Parameters*>(arguments[I])...);
  }

  std::map<const void*, std::function<Kernel(void**)>> binders_;
  mutable std::mutex mutex_;
};

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_KERNEL_H
