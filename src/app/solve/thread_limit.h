// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_THREAD_LIMIT_H
#define HTLOOPS_THREAD_LIMIT_H

#include <memory>

namespace htloops {

/// While an object lives, parallel work uses no more than a number of threads.
class Thread_limit
{
public:
  /// 0 means as many as the machine has. Without TBB there is one thread, whatever is asked for.
  explicit Thread_limit(int number_of_threads);
  ~Thread_limit();

  int number_of_threads() const { return number_of_threads_; }

private:
  struct Control;

  int number_of_threads_;
  std::unique_ptr<Control> control_;
};

} // namespace htloops

#endif // HTLOOPS_THREAD_LIMIT_H
