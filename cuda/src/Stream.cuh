// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_STREAM_CUH
#define HTL_CUDA_STREAM_CUH

#include "checks.cuh"

namespace htl_cuda {

/// The caller's stream, or one of its own that waits for no other.
class Stream
{
public:
  /// makes one, on the current device, if it is given none.
  explicit Stream(cudaStream_t of_caller)
      : stream_(of_caller)
      , is_own_(of_caller == nullptr) {
    if(is_own_)
      check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "making a stream");
  }
  ~Stream() {
    if(is_own_)
      ignore(cudaStreamDestroy(stream_));
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  cudaStream_t get() const { return stream_; }

private:
  cudaStream_t stream_;
  bool is_own_;
};

} // namespace htl_cuda

#endif // HTL_CUDA_STREAM_CUH
