// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Memory_pool.cuh"

#include <CGAL/Handle_tunnel_loops/release_device_memory.h>

#include <map>
#include <mutex>

namespace htl_cuda {
namespace {

/// The pools of all devices that were used.
class Shared_pools
{
public:
  std::shared_ptr<const Memory_pool> of_device(int device) {
    const std::lock_guard<std::mutex> lock(mutex_);
    Entry& entry = entries_[device];
    entry.kept = entry.pool.lock();
    if(entry.kept == nullptr)
      entry.kept = std::make_shared<const Memory_pool>(device);
    entry.pool = entry.kept;
    return entry.kept;
  }

  // A pool that computations use ends with the last of them.
  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    for(auto& [device, entry] : entries_) {
      entry.kept.reset();
      if(const auto pool = entry.pool.lock())
        ignore(pool->trim(0));
    }
  }

private:
  struct Entry
  {
    std::weak_ptr<const Memory_pool> pool; // whether it is kept or only in use
    std::shared_ptr<const Memory_pool> kept;
  };

  std::mutex mutex_;
  std::map<int, Entry> entries_; // by device
};

// Never destroyed: when the process ends, the runtime may have ended before.
Shared_pools& shared_pools() {
  static Shared_pools* const pools = new Shared_pools;
  return *pools;
}

} // namespace

std::shared_ptr<const Memory_pool> shared_pool(int device) {
  return shared_pools().of_device(device);
}

} // namespace htl_cuda

namespace CGAL::Handle_tunnel_loops {

void release_device_memory() { htl_cuda::shared_pools().release(); }

} // namespace CGAL::Handle_tunnel_loops
