// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_CUDA_STOPWATCH_CUH
#define HTL_CUDA_STOPWATCH_CUH

#include "checks.cuh"

namespace htl_cuda {

/// A place in a stream, and when the work came there.
class Event
{
public:
  explicit Event(cudaStream_t stream)
      : stream_(stream) {
    check(cudaEventCreate(&event_), "making an event");
  }
  ~Event() { ignore(cudaEventDestroy(event_)); }
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;

  cudaEvent_t get() const { return event_; }
  void record() { check(cudaEventRecord(event_, stream_), "recording an event"); }

private:
  cudaStream_t stream_;
  cudaEvent_t event_ = nullptr;
};

/// Measures the time between two places in a stream.
class Stopwatch
{
public:
  explicit Stopwatch(cudaStream_t stream)
      : begin_(stream)
      , end_(stream) {
    begin_.record();
  }

  double seconds() {
    end_.record();
    check(cudaEventSynchronize(end_.get()), "measuring");
    float milliseconds = 0.f;
    check(cudaEventElapsedTime(&milliseconds, begin_.get(), end_.get()), "measuring");
    return 1e-3 * milliseconds;
  }

private:
  Event begin_, end_;
};

} // namespace htl_cuda

#endif // HTL_CUDA_STOPWATCH_CUH
