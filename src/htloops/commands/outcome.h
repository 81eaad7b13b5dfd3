// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OUTCOME_H
#define HTLOOPS_OUTCOME_H

#include <functional>
#include <string>

namespace htloops {

/// How something ended: an exit code, 0 if all is done, and what is said to the user if it is not.
struct Outcome
{
  int exit_code = 0;
  std::string message;
};

/// does something and turns what is thrown into an exit code and a message.
Outcome outcome_of(const std::function<void()>& action);

} // namespace htloops

#endif // HTLOOPS_OUTCOME_H
