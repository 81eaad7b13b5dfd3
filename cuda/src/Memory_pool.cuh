// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_MEMORY_POOL_CUH
#define HTL_CUDA_MEMORY_POOL_CUH

#include "checks.cuh"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace htl_cuda {

/// A pool of a device's memory. It keeps what is given back until it is trimmed, or ends.
class Memory_pool
{
public:
  explicit Memory_pool(int device) {
    cudaMemPoolProps properties = {};
    properties.allocType = cudaMemAllocationTypePinned;
    properties.location.type = cudaMemLocationTypeDevice;
    properties.location.id = device;
    check(cudaMemPoolCreate(&pool_, &properties), "making a pool of memory");
    // Else it would give back what it does not use whenever somebody waits for the device.
    std::uint64_t all = UINT64_MAX;
    const cudaError_t error = cudaMemPoolSetAttribute(pool_, cudaMemPoolAttrReleaseThreshold, &all);
    if(error != cudaSuccess)
      ignore(cudaMemPoolDestroy(pool_));
    check(error, "telling a pool to keep its memory");
  }
  ~Memory_pool() { ignore(cudaMemPoolDestroy(pool_)); }
  Memory_pool(const Memory_pool&) = delete;
  Memory_pool& operator=(const Memory_pool&) = delete;

  cudaMemPool_t get() const { return pool_; }

  /// what it has of the device's memory and nobody uses. Others may be at it meanwhile.
  std::size_t unused_bytes() const {
    const std::size_t used = attribute(cudaMemPoolAttrUsedMemCurrent);
    const std::size_t reserved = attribute(cudaMemPoolAttrReservedMemCurrent);
    return reserved > used ? reserved - used : 0;
  }

  /// gives back what nobody uses, until it has no more than so many bytes.
  cudaError_t trim(std::size_t bytes) const { return cudaMemPoolTrimTo(pool_, bytes); }

private:
  std::size_t attribute(cudaMemPoolAttr which) const {
    std::uint64_t bytes = 0;
    check(cudaMemPoolGetAttribute(pool_, which, &bytes), "asking a pool for its size");
    return static_cast<std::size_t>(bytes);
  }

  cudaMemPool_t pool_ = nullptr;
};

/// the pool of a device for all computations of the process, made when it is first asked for.
std::shared_ptr<const Memory_pool> shared_pool(int device);

} // namespace htl_cuda

#endif // HTL_CUDA_MEMORY_POOL_CUH
