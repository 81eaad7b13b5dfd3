// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "terminal/terminal.h"

#include "app/interrupt.h"

#include <algorithm>
#include <cstdlib>

namespace htloops {
namespace {

constexpr int width = 32;
constexpr std::chrono::milliseconds shortest_pause{50};

} // namespace

bool use_colour(const std::string& when, std::FILE* stream) {
  if(when != "auto")
    return when == "always";
  const char* no_colour = std::getenv("NO_COLOR"); // see no-color.org
  return is_terminal(stream) && (no_colour == nullptr || *no_colour == '\0');
}

void Progress_bar::start(const std::string& what) {
  if(!is_visible_)
    return;
  const std::lock_guard<std::mutex> lock(mutex_);
  what_ = what;
  draw();
}

bool Progress_bar::update(double fraction) {
  if(is_visible_)
    show(fraction);
  return interrupting_signal() == 0;
}

void Progress_bar::show(double fraction) {
  // Who comes while another thread draws need not wait: the next call shows the news.
  const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
  if(!lock.owns_lock())
    return;
  fraction_ = (std::min)((std::max)(fraction, fraction_), 1.);
  if(Clock::now() - last_drawn_ >= shortest_pause)
    draw();
}

void Progress_bar::draw() {
  last_drawn_ = Clock::now();
  const double seconds = std::chrono::duration<double>(last_drawn_ - begin_).count();
  const int filled = static_cast<int>(fraction_ * width);
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r[%s] %3d%%  %.1f s  %s\033[K", bar.c_str(),
               static_cast<int>(100. * fraction_), seconds, what_.c_str());
  std::fflush(stderr);
  is_drawn_ = true;
}

void Progress_bar::end() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if(is_drawn_)
    std::fputs("\r\033[K", stderr);
  is_drawn_ = false;
  fraction_ = 0.; // of what comes next
}

} // namespace htloops
