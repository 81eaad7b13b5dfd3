// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_INTERRUPT_H
#define HTLOOPS_INTERRUPT_H

#include <exception>
#include <functional>

namespace htloops {

/// is thrown where work stops because the user asked for it.
class Interrupted : public std::exception
{
public:
  const char* what() const noexcept override { return "interrupted"; }
};

/// While an object lives, Ctrl-C, a request to terminate, the end of the terminal and that of who
/// reads from a pipe are noted instead of ending the program; a second one ends it at once, unless
/// a file is being written. A file that grows beyond a limit is an error of writing, no signal.
/// Guards may be nested.
class Interrupt_guard
{
public:
  Interrupt_guard();
  ~Interrupt_guard();
  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

private:
  using Handler = void (*)(int);
  Handler previous_[5];
};

/// While an object lives, a file exists that would have to be removed: nothing ends the program,
/// whether or not there is a guard besides the one in here.
class Unfinished_file
{
public:
  Unfinished_file();
  ~Unfinished_file();

private:
  Interrupt_guard guard_;
};

/// the number of the signal that was noted, 0 if there was none.
int interrupting_signal();

/// While it lives, what this thread does is interrupted if the function says so, too.
class Interrupt_question
{
public:
  explicit Interrupt_question(const std::function<bool()>& is_to_stop);
  ~Interrupt_question();
  Interrupt_question(const Interrupt_question&) = delete;
  Interrupt_question& operator=(const Interrupt_question&) = delete;
};

/// throws `Interrupted` if a signal was noted, or who asked to be asked says so.
void throw_if_interrupted();

} // namespace htloops

#endif // HTLOOPS_INTERRUPT_H
