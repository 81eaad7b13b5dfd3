// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_THREAD_LIMIT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_THREAD_LIMIT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#if defined(CGAL_HTL_STD_THREADS)
#include <CGAL/Handle_tunnel_loops/internal/support/Thread_pool.h>
#elif defined(CGAL_LINKED_WITH_TBB)
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>

namespace CGAL::Handle_tunnel_loops::internal {

// What is said below, for the threads that there are.
#if defined(CGAL_HTL_STD_THREADS)

inline int number_of_processors() { return static_cast<int>(Thread_pool::number_of_processors()); }

class Threads_at_most
{
public:
  explicit Threads_at_most(int number)
      : number_(static_cast<std::size_t>(number)) {
    Thread_pool::instance().limit(number_);
  }
  ~Threads_at_most() { Thread_pool::instance().lift_limit(number_); }
  Threads_at_most(const Threads_at_most&) = delete;

private:
  std::size_t number_;
};

template <typename Function> auto in_team(int number, const Function& f) {
  struct Membership
  {
    explicit Membership(Thread_pool::Team& team)
        : before(Thread_pool::join(&team)) {}
    ~Membership() { Thread_pool::join(before); }
    Thread_pool::Team* before;
  };
  Thread_pool::Team team{{static_cast<std::size_t>(number)}};
  const Membership membership(team);
  return f();
}

#elif defined(CGAL_LINKED_WITH_TBB)

inline int number_of_processors() { return tbb::info::default_concurrency(); }

class Threads_at_most
{
public:
  explicit Threads_at_most(int number)
      : control_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(number)) {}

private:
  tbb::global_control control_;
};

template <typename Function> auto in_team(int number, const Function& f) {
  return tbb::task_arena(number).execute(f);
}

#else

constexpr int number_of_processors() { return 1; }

struct Threads_at_most
{
  explicit Threads_at_most(int) {}
};

template <typename Function> auto in_team(int, const Function& f) { return f(); }

#endif

/// While an object lives, parallel work uses no more than a number of threads, whoever does it.
class Thread_limit
{
public:
  /// 0 means as many as there are processors. Where there is one thread it is one, whatever is
  /// asked for.
  explicit Thread_limit(int number_of_threads)
      : number_of_threads_(has_threads && number_of_threads > 0 ? number_of_threads
                                                                : number_of_processors())
      , limit_(number_of_threads_) {}

  int number_of_threads() const { return number_of_threads_; }

private:
  int number_of_threads_;
  Threads_at_most limit_;
};

/// `f()`, for which no more than a number of threads work, or for 0 all; others have as many
/// besides.
template <typename Function> auto with_threads(int number_of_threads, const Function& f) {
  return number_of_threads > 0 && number_of_threads < number_of_processors()
             ? in_team(number_of_threads, f)
             : f();
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_THREAD_LIMIT_H
