// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_TIME_BUDGET_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_TIME_BUDGET_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <atomic>
#include <chrono>
#include <limits>

namespace CGAL::Handle_tunnel_loops::internal {

/// The time that a computation may take, in seconds of the wall clock: without end unless it is
/// limited. Who has more to do that need not be done asks whether there is some left.
class Time_budget
{
public:
  /// \p seconds from the beginning on.
  void limit(double seconds) { seconds_ = seconds; }

  /// keeps time back for what has to be done later.
  void keep_back(double seconds) { seconds_ -= seconds; }

  /// since the beginning.
  double seconds_spent() const {
    return std::chrono::duration<double>(Clock::now() - began_).count();
  }

  /// for many threads.
  bool is_any_left() {
    if(seconds_ == (std::numeric_limits<double>::infinity)() || seconds_spent() < seconds_)
      return true;
    has_been_refused_ = true;
    return false;
  }

  /// whether something has been left out for want of time.
  bool has_been_refused() const { return has_been_refused_; }

private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point began_ = Clock::now();
  double seconds_ = (std::numeric_limits<double>::infinity)();
  std::atomic<bool> has_been_refused_{false};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_TIME_BUDGET_H
