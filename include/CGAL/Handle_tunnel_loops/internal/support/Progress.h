// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PROGRESS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PROGRESS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>
#include <utility>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// Tells the visitor of the stages and the callback of the progress, measures the stages, and
/// remembers a wish to stop. The callback is never called by two threads at once.
class Progress
{
public:
  using Stage_function = std::function<void(Stage)>;

  Progress(std::function<bool(double)> callback,
           Stage_function start_stage,
           Stage_function end_stage,
           Statistics& statistics)
      : callback_(std::move(callback))
      , start_stage_(std::move(start_stage))
      , end_stage_(std::move(end_stage))
      , statistics_(statistics) {}

  void start(Stage stage) {
    start_stage_(stage);
    stage_ = stage;
    done_ = 0;
    began_ = Clock::now();
    report(0.);
    throw_if_interrupted();
  }

  void end(Stage stage) {
    const std::chrono::duration<double> seconds = Clock::now() - began_;
    statistics_.seconds[static_cast<std::size_t>(stage)] = seconds.count();
    end_stage_(stage);
    report(1.);
    throw_if_interrupted();
  }

  /// tells how far the stage has come, in [0, 1]; for one thread only.
  void advance(double part) {
    report(part);
    throw_if_interrupted();
  }

  /// tells that one of `number` equal parts of the stage is done; for many threads.
  void advance_one(std::size_t number) {
    const std::size_t done = ++done_;
    if(!callback_)
      return;
    const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
    if(lock.owns_lock())
      report(double(done) / double(number));
  }

  bool is_interrupted() const { return is_interrupted_; }

  void throw_if_interrupted() const {
    if(is_interrupted_)
      throw Interrupted_exception();
  }

private:
  using Clock = std::chrono::steady_clock;

  void report(double part) {
    // What the stages take of the whole, roughly.
    constexpr std::array<double, number_of_stages + 1> begin = {0., 0.1, 0.3, 0.6, 0.85, 0.87, 1.};
    if(!callback_)
      return;
    const std::size_t i = static_cast<std::size_t>(stage_);
    const double now = begin[i] + part * (begin[i + 1] - begin[i]);
    reported_ = (std::max)(reported_, now);
    if(!callback_(reported_))
      is_interrupted_ = true;
  }

  std::function<bool(double)> callback_;
  Stage_function start_stage_, end_stage_;
  Statistics& statistics_;
  Stage stage_ = Stage::ADAPTOR;
  Clock::time_point began_;
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> is_interrupted_{false};
  std::mutex mutex_;
  double reported_ = 0.;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PROGRESS_H
