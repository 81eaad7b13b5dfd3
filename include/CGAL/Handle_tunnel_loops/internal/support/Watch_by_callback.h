// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_WATCH_BY_CALLBACK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_WATCH_BY_CALLBACK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <utility>

namespace CGAL::Handle_tunnel_loops::internal {

/// Asks a callback whether to go on, by one thread at a time. How much is done is not known.
class Watch_by_callback final : public Watch
{
public:
  explicit Watch_by_callback(std::function<bool(double)> callback)
      : callback_(std::move(callback)) {}

  void look() override {
    if(!callback_)
      return;
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if(lock.owns_lock() && !is_interrupted_)
      is_interrupted_ = !callback_(0.);
    if(is_interrupted_)
      throw Interrupted_exception();
  }

private:
  std::function<bool(double)> callback_;
  std::mutex mutex_;
  std::atomic<bool> is_interrupted_ = false;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_WATCH_BY_CALLBACK_H
