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
#include <CGAL/Handle_tunnel_loops/internal/support/Time_budget.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Tells the visitor of the stages and the callback of the progress, measures the stages, and
/// remembers a wish to stop, and how much time there is. The callback is never called by two
/// threads at once.
class Progress final : public Watch
{
public:
  using Stage_function = std::function<void(Stage)>;

  /// A stage, and about which part of the whole it takes; the parts need not add up to one.
  struct Weighted_stage
  {
    Stage stage;
    double weight;
  };

  /// \p stages are those that may come, in their order.
  Progress(std::function<bool(double)> callback,
           Stage_function start_stage,
           Stage_function end_stage,
           Statistics& statistics,
           std::vector<Weighted_stage> stages)
      : callback_(std::move(callback))
      , start_stage_(std::move(start_stage))
      , end_stage_(std::move(end_stage))
      , statistics_(statistics)
      , stages_(std::move(stages)) {}

  // Weights: mean shares of the time in two threads, on five meshes of a million faces.

  /// the stages on the way to loops.
  static std::vector<Weighted_stage> stages_of_loops() {
    return {{Stage::ADAPTOR, 0.13}, {Stage::INITIAL, 0.20},     {Stage::TUNNEL, 0.06},
            {Stage::REFINE, 0.04},  {Stage::SHORTEN, 0.22},     {Stage::CLASSES, 0.29},
            {Stage::CONVERT, 0.01}, {Stage::CERTIFICATE, 0.04}, {Stage::CLASSIFY, 0.01}};
  }

  /// the stages on the way to a diffusion that starts from loops.
  static std::vector<Weighted_stage> stages_of_diffusion() {
    return {{Stage::ADAPTOR, 0.21},
            {Stage::INITIAL, 0.28},
            {Stage::TUNNEL, 0.09},
            {Stage::REFINE, 0.08},
            {Stage::DIFFUSION, 0.34}};
  }

  void start(Stage stage) {
    start_stage_(stage);
    stage_ = stage;
    done_ = 0;
    began_ = Clock::now();
    report(0.);
    throw_if_interrupted();
  }

  void end(Stage stage) {
    CGAL_precondition_msg(stage == stage_, "the stage that ends is the one that began last");
    const std::chrono::duration<double> seconds = Clock::now() - began_;
    statistics_.seconds[static_cast<std::size_t>(stage)] = seconds.count();
    end_stage_(stage);
    report(1.);
    throw_if_interrupted();
  }

  /// does what a stage consists of.
  template <typename Function> void run(Stage stage, const Function& f) {
    start(stage);
    f();
    end(stage);
  }

  /// tells how far the stage has come, in [0, 1]; for one thread only.
  void advance(double part) {
    CGAL_precondition(part >= 0. && part <= 1.);
    report(part);
    throw_if_interrupted();
  }

  /// tells that one of `number` equal parts of the stage is done; for many threads.
  void advance_one(std::size_t number) { goes_on(double(++done_) / double(number)); }

  /// tells how far the stage has come, at least, and asks whether to go on; for many threads.
  bool goes_on(double part = 0.) {
    if(callback_ && !is_interrupted_ && !is_reporting_.test_and_set(std::memory_order_acquire)) {
      const Reset reset = {is_reporting_};
      if(!is_interrupted_) // nobody is asked again who has said no
        report(part);
    }
    return !is_interrupted_;
  }

  /// asks whether to go on, unless it has been asked just before; for many threads.
  void look() override {
    if(callback_ && Clock::now().time_since_epoch().count() > next_look_)
      goes_on();
    throw_if_interrupted();
  }

  bool is_interrupted() const { return is_interrupted_; }

  /// which began with this.
  Time_budget& time() { return time_; }

  void throw_if_interrupted() const {
    if(is_interrupted_)
      throw Interrupted_exception();
  }

private:
  using Clock = std::chrono::steady_clock;

  // No mutex: the callback may come back here, by a thread that helps with other work meanwhile.
  struct Reset
  {
    std::atomic_flag& flag;
    ~Reset() { flag.clear(std::memory_order_release); }
  };

  void report(double part) {
    if(!callback_)
      return;
    double before = 0., sum = 0.;
    for(const auto& [stage, weight] : stages_) {
      before += (stage < stage_ ? 1. : stage == stage_ ? part : 0.) * weight;
      sum += weight;
    }
    reported_ = (std::max)(reported_, before / sum);
    next_look_ = (Clock::now() + std::chrono::milliseconds(20)).time_since_epoch().count();
    if(!callback_((std::min)(reported_, 1.)))
      is_interrupted_ = true;
  }

  std::function<bool(double)> callback_;
  Stage_function start_stage_, end_stage_;
  Statistics& statistics_;
  std::vector<Weighted_stage> stages_;
  Time_budget time_;
  Stage stage_ = Stage::ADAPTOR;
  Clock::time_point began_;
  std::atomic<std::size_t> done_{0};
  std::atomic<bool> is_interrupted_{false};
  std::atomic<Clock::rep> next_look_{0};
  std::atomic_flag is_reporting_ = ATOMIC_FLAG_INIT; // in a thread
  double reported_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_PROGRESS_H
