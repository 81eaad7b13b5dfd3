// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "worker.h"

#include <memory>
#include <new>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#ifndef _WIN32
#include <unistd.h>
#endif

namespace htl_python {
namespace {

// The process that threads live in: they are not there after a fork.
long process() {
#ifdef _WIN32
  return 0;
#else
  return getpid();
#endif
}

// Of this process; it stays until that ends, as its threads do.
struct Idle_workers
{
  std::mutex mutex;
  std::vector<Worker*> workers;
  long owner = process();
};

Idle_workers& idle_workers() {
  static auto* idle = new Idle_workers;
  if(idle->owner != process())
    idle = new Idle_workers;
  return *idle;
}

} // namespace

Worker& Worker::take() {
  Idle_workers& idle = idle_workers();
  const std::lock_guard<std::mutex> lock(idle.mutex);
  if(!idle.workers.empty()) {
    Worker& worker = *idle.workers.back();
    idle.workers.pop_back();
    return worker;
  }
  std::unique_ptr<Worker> worker(new Worker);
  try {
    std::thread([w = worker.get()] { w->run(); }).detach();
  } catch(const std::system_error&) { // what a thread lacks is memory
    throw std::bad_alloc();
  }
  return *worker.release();
}

void Worker::give_back(Worker& worker) {
  Idle_workers& idle = idle_workers();
  const std::lock_guard<std::mutex> lock(idle.mutex);
  idle.workers.push_back(&worker);
}

void Worker::start(std::function<void()> compute) {
  const std::lock_guard<std::mutex> lock(mutex_);
  compute_ = std::move(compute);
  changed_.notify_all();
}

bool Worker::wait(std::chrono::milliseconds time) {
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, time, [this] { return !compute_; });
}

void Worker::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while(true) {
    changed_.wait(lock, [this] { return bool(compute_); });
    lock.unlock();
    compute_();
    lock.lock();
    compute_ = nullptr;
    changed_.notify_all();
  }
}

} // namespace htl_python
