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

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <cstddef>
#endif

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

/// While an object lives, parallel work uses no more than a number of threads.
class Thread_limit
{
public:
#ifdef CGAL_LINKED_WITH_TBB
  /// 0 means as many as the machine has.
  explicit Thread_limit(int number_of_threads)
      : number_of_threads_(number_of_threads > 0 ? number_of_threads
                                                 : tbb::info::default_concurrency())
      , control_(tbb::global_control::max_allowed_parallelism,
                 static_cast<std::size_t>(number_of_threads_)) {}
#else
  /// There is one thread, whatever is asked for.
  explicit Thread_limit(int) {}
#endif

  int number_of_threads() const { return number_of_threads_; }

private:
  int number_of_threads_ = 1;
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control control_;
#endif
};

} // namespace htloops

#endif // HTLOOPS_PROGRESS_H
