// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PYTHON_WATCH_H
#define HTL_PYTHON_WATCH_H

#include "app/interrupt.h"
#include "app/solve/progress.h"

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Thread_limit.h>

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>

namespace htl_python {

namespace py = pybind11;

/// What a computation and the thread of Python that waits for it tell each other.
class Watch : public htloops::Progress
{
public:
  /// never goes back, though several threads come here.
  bool update(double fraction) override {
    double known = fraction_;
    while(fraction > known && !fraction_.compare_exchange_weak(known, fraction))
      continue;
    return !is_to_stop_;
  }

  void stop() { is_to_stop_ = true; }
  bool is_to_stop() const { return is_to_stop_; }
  double fraction() const { return fraction_; }

private:
  std::atomic<double> fraction_{0.};
  std::atomic<bool> is_to_stop_{false};
};

/// computes with so many threads at most, or with all for 0, while others of Python run.
template <typename Compute> auto compute(int threads, const Watch& watch, const Compute& answer) {
  const py::gil_scoped_release others_may_run;
  const std::function<bool()> is_to_stop = [&] { return watch.is_to_stop(); };
  const auto answer_if_wanted = [&] {
    try {
      const htloops::Interrupt_question question(is_to_stop);
      htloops::throw_if_interrupted();
      return answer();
    } catch(const htloops::Interrupted&) {
      throw CGAL::Handle_tunnel_loops::Interrupted_exception();
    }
  };
  return CGAL::Handle_tunnel_loops::internal::with_threads(threads, answer_if_wanted);
}

} // namespace htl_python

#endif // HTL_PYTHON_WATCH_H
