// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_STOPWATCH_H
#define HTLOOPS_STOPWATCH_H

#include <chrono>

namespace htloops {

/// The wall time since an object was made.
class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
};

} // namespace htloops

#endif // HTLOOPS_STOPWATCH_H
