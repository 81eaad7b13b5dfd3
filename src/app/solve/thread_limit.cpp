// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/thread_limit.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/info.h>

#include <cstddef>
#endif

namespace htloops {

#ifdef CGAL_LINKED_WITH_TBB

struct Thread_limit::Control
{
  tbb::global_control control;
};

Thread_limit::Thread_limit(int number_of_threads)
    : number_of_threads_(number_of_threads > 0 ? number_of_threads
                                               : tbb::info::default_concurrency())
    , control_(new Control{{tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(number_of_threads_)}}) {}

#else

struct Thread_limit::Control
{};

Thread_limit::Thread_limit(int)
    : number_of_threads_(1) {}

#endif

Thread_limit::~Thread_limit() = default;

} // namespace htloops
