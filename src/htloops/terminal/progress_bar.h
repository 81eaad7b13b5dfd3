// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PROGRESS_BAR_H
#define HTLOOPS_PROGRESS_BAR_H

#include <chrono>
#include <mutex>
#include <string>

namespace htloops {

/// A line on the standard error that is drawn again and again, and erased at the end.
class Progress_bar
{
public:
  /// A bar that is not visible does nothing.
  explicit Progress_bar(bool is_visible)
      : is_visible_(is_visible) {}

  ~Progress_bar() { erase(); }
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  /// names what is being done.
  void start(const std::string& what);

  /// shows how much is done, from 0 to 1; may be called from any thread and often.
  void update(double fraction);

  void erase();

private:
  using Clock = std::chrono::steady_clock;

  void draw();

  const bool is_visible_;
  const Clock::time_point begin_ = Clock::now();
  std::mutex mutex_; // guards what follows
  Clock::time_point last_drawn_{};
  std::string what_;
  double fraction_ = 0.;
  bool is_drawn_ = false;
};

} // namespace htloops

#endif // HTLOOPS_PROGRESS_BAR_H
