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

#include "Memory_pool.cuh"
#include "checks.cuh"

#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/release_device_memory.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace htl_cuda {

using CGAL::Handle_tunnel_loops::internal::Span;

/// The memory of a device for one computation: its share in the pool of the device. When it ends,
/// nothing of it may be in use, and the pool keeps what the next computation may want.
class Device_memory
{
public:
  explicit Device_memory(int device)
      : pool_(shared_pool(device)) {}
  ~Device_memory() { ignore(pool_->trim(CGAL::Handle_tunnel_loops::kept_device_bytes)); }
  Device_memory(const Device_memory&) = delete;
  Device_memory& operator=(const Device_memory&) = delete;

  /// by this computation.
  std::size_t bytes_in_use() const { return bytes_in_use_; }

  /// what the driver has, and what the pool has and nobody uses.
  std::size_t free_bytes() const {
    std::size_t free = 0, total = 0;
    check(cudaMemGetInfo(&free, &total), "asking for the free memory");
    return free + pool_->unused_bytes();
  }

  /// allocates in the order of a stream. Throws `Out_of_device_memory_exception` if there is too
  /// little.
  void* allocate(std::size_t bytes, cudaStream_t stream) {
    void* data = nullptr;
    cudaError_t error = cudaMallocFromPoolAsync(&data, bytes, pool_->get(), stream);
    if(error == cudaErrorMemoryAllocation) { // what the pool keeps may be in pieces
      cudaGetLastError();
      check(cudaStreamSynchronize(stream), "waiting for the device");
      check(pool_->trim(0), "giving back memory");
      error = cudaMallocFromPoolAsync(&data, bytes, pool_->get(), stream);
    }
    if(error == cudaErrorMemoryAllocation) {
      cudaGetLastError();
      throw CGAL::Handle_tunnel_loops::Out_of_device_memory_exception(bytes, free_bytes());
    }
    check(error, "allocating memory");
    bytes_in_use_ += bytes;
    return data;
  }

  void give_back(void* data, std::size_t bytes, cudaStream_t stream) {
    ignore(cudaFreeAsync(data, stream));
    bytes_in_use_ -= bytes;
  }

private:
  std::shared_ptr<const Memory_pool> pool_;
  std::size_t bytes_in_use_ = 0;
};

/// An array in the memory of a device, in the order of a stream: allocated, used and freed there.
/// The elements are not initialised. The memory and the stream must outlive the buffer.
template <typename T> class Device_buffer
{
public:
  Device_buffer() = default;

  /// throws `Out_of_device_memory_exception` if there is too little.
  Device_buffer(std::size_t size, Device_memory& memory, cudaStream_t stream)
      : size_(size)
      , memory_(&memory)
      , stream_(stream) {
    if(size != 0)
      data_ = static_cast<T*>(memory.allocate(size * sizeof(T), stream));
  }

  Device_buffer(Device_buffer&& other) noexcept { swap(other); }
  Device_buffer& operator=(Device_buffer&& other) noexcept {
    Device_buffer(std::move(other)).swap(*this);
    return *this;
  }
  ~Device_buffer() {
    if(data_ != nullptr)
      memory_->give_back(data_, size_ * sizeof(T), stream_);
  }

  Span<T> span() const { return {data_, size_}; }

private:
  void swap(Device_buffer& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(memory_, other.memory_);
    std::swap(stream_, other.stream_);
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  Device_memory* memory_ = nullptr;
  cudaStream_t stream_ = nullptr;
};

} // namespace htl_cuda

#endif // HTL_CUDA_DEVICE_MEMORY_CUH
