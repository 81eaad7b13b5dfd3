// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_THREAD_POOL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_THREAD_POOL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

namespace CGAL::Handle_tunnel_loops::internal {

/// Threads for what can be done in any order. They are started when they are first needed, and
/// kept. Who has work to do takes part in it, and waits for nobody but those who have begun a piece
/// of it: so nothing stands still where work has parts that are such work themselves, and where no
/// thread can be started.
class Thread_pool
{
public:
  using Call = void (*)(const void* function, std::size_t i);

  /// Those who work for one purpose, of whom there are no more than a number.
  struct Team
  {
    std::atomic<std::size_t> most;
    std::size_t helpers = 0; // beside those who have the work
  };

  /// Nobody ends it: a program may end while one of its threads still works.
  static Thread_pool& instance() {
    static Thread_pool& pool = *new Thread_pool;
    return pool;
  }

  /// for how many threads there are processors.
  static std::size_t number_of_processors() {
#if defined(__linux__) && defined(CPU_COUNT)
    cpu_set_t allowed;
    if(sched_getaffinity(0, sizeof(allowed), &allowed) == 0)
      return static_cast<std::size_t>(CPU_COUNT(&allowed));
#endif
    return (std::max)(1u, std::thread::hardware_concurrency());
  }

  /// the team that the calling thread works in.
  Team& team() { return own_team() != nullptr ? *own_team() : everybody_; }

  /// lets the calling thread work in another team, all for null. Returns the one before.
  static Team* join(Team* team) { return std::exchange(own_team(), team); }

  /// limits those who are in no team of their own, until that is lifted. Of several limits the
  /// least holds.
  void limit(std::size_t most) {
    const std::lock_guard<std::mutex> lock(mutex_);
    limits_.insert(most);
    everybody_.most = *limits_.begin();
  }
  void lift_limit(std::size_t most) {
    const std::lock_guard<std::mutex> lock(mutex_);
    limits_.erase(limits_.find(most));
    everybody_.most = limits_.empty() ? number_of_processors() : *limits_.begin();
  }

  /// calls `call(function, i)` for all i below a number. The first exception that comes out of one
  /// is thrown again here; what has not begun by then is left out.
  void run(std::size_t number, const void* function, Call call) {
    Job job{team(), number, function, call};
    const bool is_shared = number > 1 && job.team.most > 1;
    if(is_shared)
      open(job);
    job.take_part();
    if(is_shared)
      close(job);
    if(job.failure)
      std::rethrow_exception(job.failure);
  }

private:
  struct Job
  {
    Team& team;
    const std::size_t number;
    const void* const function;
    const Call call;
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> helpers{0};
    std::atomic<bool> has_failed{false};
    std::exception_ptr failure = nullptr;

    void take_part() {
      for(std::size_t i; (i = next++) < number;)
        try {
          call(function, i);
        } catch(...) {
          if(!has_failed.exchange(true))
            failure = std::current_exception();
          next = number;
        }
    }
  };

  // Work often comes in many small portions: who is out of it looks for more for so long before
  // he sleeps.
  static constexpr int patience = 200;

  template <typename Condition> static void be_patient(const Condition& is_over) {
    for(int i = 0; i < patience && !is_over(); ++i)
      std::this_thread::yield();
  }

  static Team*& own_team() {
    static thread_local Team* team = nullptr;
    return team;
  }

  void open(Job& job) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      jobs_.push_back(&job);
      ++number_opened_;
      const std::size_t most = (std::min)(job.number, job.team.most.load()) - 1;
      while(idle_ + job.team.helpers < most && start_thread())
        ++idle_;
    }
    opened_.notify_all();
  }

  // For a while there may be no thread to be had, but who asks each time does little else.
  bool start_thread() {
    try {
      if(can_start_)
        std::thread([this] { help(); }).detach();
    } catch(const std::system_error&) {
      can_start_ = false;
    }
    return can_start_;
  }

  void close(Job& job) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      jobs_.erase(std::find(jobs_.begin(), jobs_.end(), &job));
    }
    const auto is_done = [&] { return job.helpers == 0; };
    be_patient(is_done);
    if(!is_done()) {
      std::unique_lock<std::mutex> lock(mutex_);
      left_.wait(lock, is_done);
    }
  }

  // What was begun first has the largest parts.
  Job* find_job() const {
    const auto is_open = [](const Job* job) {
      return job->next < job->number && job->team.helpers + 1 < job->team.most;
    };
    const auto it = std::find_if(jobs_.begin(), jobs_.end(), is_open);
    return it == jobs_.end() ? nullptr : *it;
  }

  [[noreturn]] void help() {
    std::unique_lock<std::mutex> lock(mutex_);
    for(;;)
      if(Job* const job = find_job())
        help_with(*job, lock);
      else
        wait_for_jobs(lock);
  }

  void help_with(Job& job, std::unique_lock<std::mutex>& lock) {
    --idle_;
    ++job.team.helpers;
    ++job.helpers;
    lock.unlock();
    join(&job.team);
    job.take_part();
    lock.lock();
    ++idle_;
    --job.team.helpers;
    if(--job.helpers == 0) // and it may be gone
      left_.notify_all();
  }

  void wait_for_jobs(std::unique_lock<std::mutex>& lock) {
    const auto is_there_one = [this, before = number_opened_.load()] {
      return number_opened_ != before;
    };
    lock.unlock();
    be_patient(is_there_one);
    lock.lock();
    opened_.wait(lock, is_there_one);
  }

  std::mutex mutex_;
  std::condition_variable opened_, left_;
  std::vector<Job*> jobs_; // in the order of their beginnings
  std::atomic<std::size_t> number_opened_{0};
  std::size_t idle_ = 0; // threads without a job
  bool can_start_ = true;
  std::multiset<std::size_t> limits_;
  Team everybody_{{number_of_processors()}};
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_THREAD_POOL_H
