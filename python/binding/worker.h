// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_WORKER_H
#define HTL_PYTHON_WORKER_H

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace htl_python {

/// A thread that computes for another one. Threads are kept for what comes next: the allocator of
/// TBB loses some memory with each one that ends.
class Worker
{
public:
  /// one that is idle, or a new one; throws `std::bad_alloc` if there can be none.
  static Worker& take();

  /// it is idle, and another one may take it.
  static void give_back(Worker& worker);

  /// begins to compute, which must not throw.
  void start(std::function<void()> compute);

  /// whether it has finished, after a while at most.
  bool wait(std::chrono::milliseconds time);

private:
  Worker() = default;
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> compute_; // none: it is idle
};

} // namespace htl_python

#endif // HTL_PYTHON_WORKER_H
