// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_DEVICE_MEMORY_CUH
#define HTL_CUDA_DEVICE_MEMORY_CUH

#include "checks.cuh"

#include <CGAL/Handle_tunnel_loops/internal/device/Span.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace htl_cuda {

using CGAL::Handle_tunnel_loops::internal::device::Span;

/// A pool of a device's memory. It keeps what is given back, until the pool itself ends.
class Device_memory
{
public:
  explicit Device_memory(int device) {
    cudaMemPoolProps properties = {};
    properties.allocType = cudaMemAllocationTypePinned;
    properties.location.type = cudaMemLocationTypeDevice;
    properties.location.id = device;
    check(cudaMemPoolCreate(&pool_, &properties), "making a pool of memory");
    std::uint64_t all = UINT64_MAX;
    const cudaError_t error = cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &all);
    if(error != cudaSuccess)
      ignore(cudaMemPoolDestroy(pool_));
    check(error, "telling a pool to keep its memory");
  }
  ~Device_memory() { ignore(cudaMemPoolDestroy(pool_)); }
  Device_memory(const Device_memory&) = delete;
  Device_memory& operator=(const Device_memory&) = delete;

  cudaMemPool_t pool() const { return pool_; }

  std::size_t bytes_in_use() const { return attribute(cudaMemPoolAttrUsedMemCurrent); }

  /// what the driver has, and what the pool keeps and does not use.
  std::size_t free_bytes() const {
    std::size_t free = 0, total = 0;
    check(cudaMemGetInfo(&free, &total), "asking for the free memory");
    return free + (attribute(cudaMemPoolAttrReservedMemCurrent) - bytes_in_use());
  }

  void give_back_unused() const { check(cudaMemPoolTrimTo(pool_, 0), "giving back memory"); }

private:
  std::size_t attribute(cudaMemPoolAttr which) const {
    std::uint64_t bytes = 0;
    check(cudaMemPoolGetAttribute(pool_, which, &bytes), "asking a pool for its size");
    return static_cast<std::size_t>(bytes);
  }

  cudaMemPool_t pool_ = nullptr;
};

/// An array in the memory of a device, in the order of a stream: allocated, used and freed there.
/// The elements are not initialised. The memory and the stream must outlive the buffer.
template <typename T> class Device_buffer
{
public:
  Device_buffer() = default;

  /// throws `Out_of_device_memory_exception` if there is too little.
  Device_buffer(std::size_t size, const Device_memory& memory, cudaStream_t stream)
      : size_(size)
      , stream_(stream) {
    if(size == 0)
      return;
    void* data = nullptr;
    cudaError_t error = cudaMallocFromPoolAsync(&data, size * sizeof(T), memory.pool(), stream);
    if(error == cudaErrorMemoryAllocation) { // what the pool keeps may be in pieces
      cudaGetLastError();
      check(cudaStreamSynchronize(stream), "waiting for the device");
      memory.give_back_unused();
      error = cudaMallocFromPoolAsync(&data, size * sizeof(T), memory.pool(), stream);
    }
    if(error == cudaErrorMemoryAllocation) {
      cudaGetLastError();
      throw CGAL::Handle_tunnel_loops::Out_of_device_memory_exception(size * sizeof(T),
                                                                      memory.free_bytes());
    }
    check(error, "allocating memory");
    data_ = static_cast<T*>(data);
  }

  Device_buffer(Device_buffer&& other) noexcept { swap(other); }
  Device_buffer& operator=(Device_buffer&& other) noexcept {
    Device_buffer(std::move(other)).swap(*this);
    return *this;
  }
  ~Device_buffer() {
    if(data_ != nullptr)
      ignore(cudaFreeAsync(data_, stream_));
  }

  Span<T> span() const { return {data_, size_}; }

private:
  void swap(Device_buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(stream_, other.stream_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  cudaStream_t stream_ = nullptr;
};

} // namespace htl_cuda

#endif // HTL_CUDA_DEVICE_MEMORY_CUH
