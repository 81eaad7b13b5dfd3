// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "waiting.h"

#include "worker.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <set>

namespace htl_python {
namespace {

// What a computation and the thread that waits for it tell each other.
class Watched : public htloops::Progress
{
public:
  bool update(double fraction) override {
    fraction_.store(fraction, std::memory_order_relaxed);
    return !is_to_stop_.load(std::memory_order_relaxed);
  }

  void stop() { is_to_stop_ = true; }
  double fraction() const { return fraction_; }

private:
  std::atomic<double> fraction_{0.};
  std::atomic<bool> is_to_stop_{false};
};

// What is being computed, in any thread.
struct Running
{
  std::mutex mutex;
  std::condition_variable changed;
  std::set<Watched*> computations;
  bool is_ending = false;
};

Running& running() {
  static auto* const running = new Running; // other threads may use it until the process ends
  return *running;
}

class Registration
{
public:
  explicit Registration(Watched& watched)
      : watched_(watched) {
    const std::lock_guard<std::mutex> lock(running().mutex);
    if(running().is_ending)
      throw CGAL::Handle_tunnel_loops::Interrupted_exception();
    running().computations.insert(&watched_);
  }
  ~Registration() {
    const std::lock_guard<std::mutex> lock(running().mutex);
    running().computations.erase(&watched_);
    running().changed.notify_all();
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

private:
  Watched& watched_;
};

// A callable that returns nothing has nothing against it.
bool is_no_refusal(const py::object& answer) { return answer.is_none() || py::bool_(answer); }

// Whether to go on.
bool tell(const py::object& progress, double fraction) {
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
  return progress.is_none() || is_no_refusal(progress(fraction));
}

bool has_finished(Worker& worker) {
  const py::gil_scoped_release others_may_run;
  return worker.wait(std::chrono::milliseconds(50));
}

} // namespace

void wait_for(const py::object& progress, const std::function<void(htloops::Progress&)>& compute) {
  Watched watched;
  const Registration registration(watched);
  std::exception_ptr failure, reason_to_stop;
  Worker& worker = Worker::take();
  worker.start([&] {
    try {
      compute(watched);
    } catch(...) {
      failure = std::current_exception();
    }
  });
  while(!has_finished(worker)) {
    if(reason_to_stop)
      continue;
    try {
      if(!tell(progress, watched.fraction()))
        reason_to_stop =
            std::make_exception_ptr(CGAL::Handle_tunnel_loops::Interrupted_exception());
    } catch(const py::error_already_set&) {
      reason_to_stop = std::current_exception();
    }
    if(reason_to_stop)
      watched.stop();
  }
  Worker::give_back(worker);
  if(reason_to_stop)
    std::rethrow_exception(reason_to_stop);
  if(failure)
    std::rethrow_exception(failure);
  if(!progress.is_none())
    progress(1.);
}

void stop_waiting() {
  const py::gil_scoped_release others_may_run;
  std::unique_lock<std::mutex> lock(running().mutex);
  running().is_ending = true;
  for(Watched* watched : running().computations)
    watched->stop();
  running().changed.wait(lock, [] { return running().computations.empty(); });
}

} // namespace htl_python
