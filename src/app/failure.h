// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FAILURE_H
#define HTLOOPS_FAILURE_H

#include <stdexcept>
#include <string>

namespace htloops {

/// The exit codes of the tool. An interrupted run ends with 128 plus the number of the signal.
enum class Exit_code {
  DONE = 0,
  NOT_CERTIFIED = 1,
  WRONG_USAGE = 2,
  UNREADABLE_FILE = 3,
  UNACCEPTABLE_MESH = 4,
  NO_BACKEND = 5
};

/// What ends a command: a message for the user and the code that the program exits with.
class Failure : public std::runtime_error
{
public:
  Failure(Exit_code code, const std::string& message)
      : std::runtime_error(message)
      , code_(code) {}

  Exit_code code() const { return code_; }

private:
  Exit_code code_;
};

/// A file that cannot be written.
class Unwritable : public Failure
{
public:
  explicit Unwritable(const std::string& message)
      : Failure(Exit_code::WRONG_USAGE, message) {}
};

inline Failure wrong_usage(const std::string& message) { return {Exit_code::WRONG_USAGE, message}; }

} // namespace htloops

#endif // HTLOOPS_FAILURE_H
