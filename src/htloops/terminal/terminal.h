// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_TERMINAL_H
#define HTLOOPS_TERMINAL_H

#include "app/solve/progress.h"
#include "app/system/console.h"

#include <chrono>
#include <cstdio>
#include <mutex>
#include <string>

namespace htloops {

/// whether to colour what goes to the stream; `when` is auto, always or never.
bool use_colour(const std::string& when, std::FILE* stream);

/// A line on the standard error that is drawn again and again, and erased at the end; what starts
/// after that begins at 0%. A signal that interrupts ends what it shows.
class Progress_bar final : public Progress
{
public:
  /// A bar that is not visible does nothing.
  explicit Progress_bar(bool is_visible)
      : is_visible_(is_visible) {}

  ~Progress_bar() override { end(); }

  void start(const std::string& what) override;
  bool update(double fraction) override;
  void end() override;

private:
  using Clock = std::chrono::steady_clock;

  void show(double fraction);
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

#endif // HTLOOPS_TERMINAL_H
