// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_THREAD_NUMBERS_CUH
#define HTL_CUDA_THREAD_NUMBERS_CUH

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>

#include <cstddef>

namespace htl_cuda {

using CGAL::Handle_tunnel_loops::internal::Index;

constexpr unsigned warp_size = 32;

/// The first of the elements that a thread of the grid works on, and how far apart they are. Warps
/// are dealt out to the blocks in turn: what is too little for all threads keeps all
/// multiprocessors busy. A block has less than a warp or whole ones.
__device__ inline std::size_t thread_number() {
  const unsigned width = blockDim.x < warp_size ? blockDim.x : warp_size;
  const unsigned warp = threadIdx.x / width, lane = threadIdx.x % width;
  return (std::size_t(warp) * gridDim.x + blockIdx.x) * width + lane;
}
__device__ inline std::size_t number_of_threads() { return std::size_t(gridDim.x) * blockDim.x; }

} // namespace htl_cuda

#endif // HTL_CUDA_THREAD_NUMBERS_CUH
