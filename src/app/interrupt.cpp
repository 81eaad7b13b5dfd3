// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "interrupt.h"

#include <atomic>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <iterator>

namespace htloops {
namespace {

// All that a signal handler may touch.
volatile std::sig_atomic_t noted_signal = 0;
thread_local const std::function<bool()>* question = nullptr;
std::atomic<int> number_of_unfinished_files{0};
static_assert(std::atomic<int>::is_always_lock_free);

extern "C" void note_signal(int signal) {
  if(noted_signal != 0 && number_of_unfinished_files == 0)
    std::_Exit(128 + signal);
  noted_signal = signal;
#ifndef SA_RESTART
  std::signal(signal, note_signal); // some systems forget the handler when it is called
#endif
}

using Handler = void (*)(int);

#ifdef SA_RESTART
// Without that flag a call that waits, for what comes through a pipe say, ends when a signal comes.
Handler set_handler(int number, Handler handler) {
  struct sigaction action = {}, previous = {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  return sigaction(number, &action, &previous) == 0 ? previous.sa_handler : SIG_ERR;
}
#else
Handler set_handler(int number, Handler handler) { return std::signal(number, handler); }
#endif

struct Guarded_signal
{
  int number;
  Handler handler;
};

const Guarded_signal guarded_signals[] = {
    {SIGINT, note_signal},  {SIGTERM, note_signal},
#ifdef SIGHUP
    {SIGHUP, note_signal},
#endif
#ifdef SIGPIPE
    {SIGPIPE, note_signal},
#endif
#ifdef SIGXFSZ
    {SIGXFSZ, SIG_IGN},
#endif
};

// A signal that the parent process chose to ignore stays ignored.
auto install(const Guarded_signal& signal) {
  const Handler previous = set_handler(signal.number, signal.handler);
  if(previous == SIG_IGN)
    set_handler(signal.number, SIG_IGN);
  return previous;
}

} // namespace

Interrupt_guard::Interrupt_guard() {
  static_assert(std::size(guarded_signals) <= sizeof(previous_) / sizeof(*previous_));
  for(std::size_t i = 0; i < std::size(guarded_signals); ++i)
    previous_[i] = install(guarded_signals[i]);
}

Interrupt_guard::~Interrupt_guard() {
  for(std::size_t i = 0; i < std::size(guarded_signals); ++i)
    set_handler(guarded_signals[i].number, previous_[i]);
}

Unfinished_file::Unfinished_file() { ++number_of_unfinished_files; }

Unfinished_file::~Unfinished_file() { --number_of_unfinished_files; }

int interrupting_signal() { return noted_signal; }

Interrupt_question::Interrupt_question(const std::function<bool()>& is_to_stop) {
  question = &is_to_stop;
}

Interrupt_question::~Interrupt_question() { question = nullptr; }

void throw_if_interrupted() {
  if(noted_signal != 0 || (question != nullptr && (*question)()))
    throw Interrupted();
}

} // namespace htloops
