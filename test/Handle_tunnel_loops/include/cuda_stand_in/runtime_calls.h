#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_CALLS_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_CALLS_H

#include "Machine.h"

#include <utility>

namespace cuda_stand_in {

// A call of the runtime that does nothing if it is to fail.
template <typename Body> cudaError_t call(const Body& body) {
  return machine.calls.make(body, [] {});
}

// One that does the same even then: it reports the error of something else. So do calls that give
// something back, since a program can do no more than ask for that.
template <typename Body> cudaError_t call_with_effect(const Body& body) {
  return machine.calls.make(body, body);
}

// One that is about an object, which must be there.
template <typename T, typename Body>
cudaError_t call_for(const Owned<T>& objects, const void* handle, const Body& body) {
  return call([&] {
    const std::shared_ptr<T> object = objects.find(handle);
    return object == nullptr ? cudaErrorInvalidResourceHandle : body(object);
  });
}

// Ends an object.
template <typename T> cudaError_t destroy(Owned<T>& objects, const T* handle) {
  return call_with_effect([&] {
    const bool was_there = objects.take(handle) != nullptr;
    if(!was_there)
      complaints.add("something is destroyed that is not there");
    return was_there ? cudaSuccess : cudaErrorInvalidResourceHandle;
  });
}

} // namespace cuda_stand_in

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_CALLS_H
