#ifndef HTL_TEST_CUDA_STAND_IN_RUNTIME_MEMORY_H
#define HTL_TEST_CUDA_STAND_IN_RUNTIME_MEMORY_H

#include "runtime_calls.h"

#include <cstdint>
#include <cstring>

// NOLINTBEGIN(readability-identifier-naming): CUDA's names

inline cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total) {
  return cuda_stand_in::call([&] {
    *free = cuda_stand_in::machine.current().free_bytes();
    *total = cuda_stand_in::machine.current().kind().memory;
    return cudaSuccess;
  });
}

// ---- pools

inline cudaError_t cudaMemPoolCreate(cudaMemPool_t* pool, const cudaMemPoolProps* properties) {
  using namespace cuda_stand_in;
  return call([&] {
    const int device = properties->location.id;
    if(!machine.has(device) || properties->location.type != cudaMemLocationTypeDevice ||
       properties->allocType != cudaMemAllocationTypePinned)
      return cudaErrorInvalidValue;
    if(!machine.devices[device]->kind().has_pools)
      return cudaErrorNotSupported;
    *pool = machine.pools.add(std::make_shared<Pool>(*machine.devices[device]));
    return cudaSuccess;
  });
}

// The only threshold there is: a pool keeps everything.
inline cudaError_t cudaMemPoolSetAttribute(cudaMemPool_t pool, cudaMemPoolAttr which, void* value) {
  using namespace cuda_stand_in;
  return call_for(machine.pools, pool, [&](const std::shared_ptr<Pool>&) {
    return which == cudaMemPoolAttrReleaseThreshold &&
                   *static_cast<std::uint64_t*>(value) == UINT64_MAX
               ? cudaSuccess
               : cudaErrorInvalidValue;
  });
}

inline cudaError_t cudaMemPoolGetAttribute(cudaMemPool_t pool, cudaMemPoolAttr which, void* value) {
  using namespace cuda_stand_in;
  return call_for(machine.pools, pool, [&](const std::shared_ptr<Pool>& object) {
    if(which != cudaMemPoolAttrReservedMemCurrent && which != cudaMemPoolAttrUsedMemCurrent)
      return cudaErrorInvalidValue;
    *static_cast<std::uint64_t*>(value) =
        which == cudaMemPoolAttrUsedMemCurrent ? object->used_bytes() : object->reserved_bytes();
    return cudaSuccess;
  });
}

inline cudaError_t cudaMemPoolTrimTo(cudaMemPool_t pool, std::size_t bytes_to_keep) {
  using namespace cuda_stand_in;
  return call_for(machine.pools, pool, [&](const std::shared_ptr<Pool>& object) {
    object->trim(bytes_to_keep);
    return cudaSuccess;
  });
}

// What is still in use stays so until it is given back.
inline cudaError_t cudaMemPoolDestroy(cudaMemPool_t pool) {
  return cuda_stand_in::destroy(cuda_stand_in::machine.pools, pool);
}

// ---- arrays

inline cudaError_t
cudaMallocFromPoolAsync(void** data, std::size_t bytes, cudaMemPool_t pool, cudaStream_t stream) {
  using namespace cuda_stand_in;
  return call_for(machine.pools, pool, [&](const std::shared_ptr<Pool>& object) {
    if(machine.streams.find(stream) == nullptr)
      return cudaErrorInvalidResourceHandle;
    const std::shared_ptr<Array> array = Array::make(object, bytes);
    if(array == nullptr)
      return cudaErrorMemoryAllocation;
    *data = array->data();
    machine.arrays.add(*data, array);
    return cudaSuccess;
  });
}

inline cudaError_t cudaFreeAsync(void* data, cudaStream_t stream) {
  using namespace cuda_stand_in;
  return call_with_effect([&] {
    const std::shared_ptr<Stream> in_order_of = machine.streams.find(stream);
    if(in_order_of == nullptr)
      return cudaErrorInvalidResourceHandle;
    std::shared_ptr<Array> array = machine.arrays.take(data);
    if(array == nullptr) {
      complaints.add("memory is given back that is not in use");
      return cudaErrorInvalidValue;
    }
    in_order_of->put([array]() mutable { array.reset(); });
    return cudaSuccess;
  });
}

// ---- copies

namespace cuda_stand_in {

inline void copy_in_turn(Device& device, void* to, const void* from, std::size_t bytes, bool up) {
  const void* const on_device = up ? to : from;
  if(device.addresses().is_allocated(on_device, bytes))
    std::memcpy(to, from, bytes);
  else
    complaints.add("what is copied is not in the memory of the device");
}

} // namespace cuda_stand_in

inline cudaError_t cudaMemcpyAsync(
    void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind, cudaStream_t stream) {
  using namespace cuda_stand_in;
  return call_for(machine.streams, stream, [&](const std::shared_ptr<Stream>& object) {
    const bool up = kind == cudaMemcpyHostToDevice;
    Device& device = object->device();
    if(!device.addresses().contains(up ? to : from) || device.addresses().contains(up ? from : to))
      return cudaErrorInvalidValue;
    object->put([=, &device] { copy_in_turn(device, to, from, bytes, up); });
    return cudaSuccess;
  });
}

// NOLINTEND(readability-identifier-naming)

#endif // HTL_TEST_CUDA_STAND_IN_RUNTIME_MEMORY_H
