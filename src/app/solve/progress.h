// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PROGRESS_H
#define HTLOOPS_PROGRESS_H

#include <CGAL/Handle_tunnel_loops/internal/support/Thread_limit.h>

#include <chrono>
#include <functional>
#include <string>

namespace htloops {

/// Is told what is being done, and asked whether to go on. This one does nothing and always goes
/// on.
class Progress
{
public:
  virtual ~Progress() = default;

  /// names what is being done.
  virtual void start(const std::string& /* what */) {}

  /// is told how much is done, from 0 to 1, from any thread and often; whether to go on.
  virtual bool update(double /* fraction */) { return true; }

  /// is told that all is done.
  virtual void end() {}

  /// what the functions of the library call.
  std::function<bool(double)> callback() {
    return [this](double fraction) { return update(fraction); };
  }
};

/// The wall time since an object was made.
class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

using CGAL::Handle_tunnel_loops::internal::Thread_limit;

/// what asks for all threads there are.
using All_threads_tag = CGAL::Handle_tunnel_loops::internal::Threads_if_available_tag;

} // namespace htloops

#endif // HTLOOPS_PROGRESS_H
