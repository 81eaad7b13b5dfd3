// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "terminal/interrupt.h"

#include <atomic>
#include <csignal>
#include <cstdlib>

namespace htloops {
namespace {

// All that a signal handler may touch.
volatile std::sig_atomic_t noted_signal = 0;
std::atomic<int> number_of_unfinished_files{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) {
  if(noted_signal != 0 && number_of_unfinished_files == 0)
    std::_Exit(128 + signal);
  noted_signal = signal;
  std::signal(signal, note_signal); // some systems forget the handler when it is called
}

// A signal that the parent process chose to ignore stays ignored.
auto install(int signal) {
  const auto previous = std::signal(signal, note_signal);
  if(previous == SIG_IGN)
    std::signal(signal, SIG_IGN);
  return previous;
}

} // namespace

Interrupt_guard::Interrupt_guard()
    : previous_interrupt_(install(SIGINT))
    , previous_terminate_(install(SIGTERM)) {}

Interrupt_guard::~Interrupt_guard() {
  std::signal(SIGINT, previous_interrupt_);
  std::signal(SIGTERM, previous_terminate_);
}

Unfinished_file::Unfinished_file() { ++number_of_unfinished_files; }

Unfinished_file::~Unfinished_file() { --number_of_unfinished_files; }

int interrupting_signal() { return noted_signal; }

void throw_if_interrupted() {
  if(noted_signal != 0)
    throw Interrupted();
}

} // namespace htloops
