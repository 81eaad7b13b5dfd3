// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_PROCESSOR_EXECUTOR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_PROCESSOR_EXECUTOR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace CGAL::Handle_tunnel_loops::internal {

/// What executors have in common whose memory is that of the host.
struct Host_memory
{
  template <typename T> static void upload(const Span<T>& to, const T* from) {
    std::copy(from, from + to.size(), to.begin());
  }
  template <typename T> static void download(T* to, const Span<T>& from) {
    std::copy(from.begin(), from.end(), to);
  }
  template <typename T> static void fill(const Span<T>& span, const T& value) {
    std::fill(span.begin(), span.end(), value);
  }
};

/// Runs on the processor what is written for the processor and for a device alike.
class Processor_executor : public Host_memory
{
public:
  explicit Processor_executor(Execution execution)
      : execution_(execution) {}

  template <typename T> class Buffer
  {
  public:
    explicit Buffer(std::size_t size)
        : data_(new T[size])
        , size_(size) {}

    Span<T> span() const { return {data_.get(), size_}; }

  private:
    std::unique_ptr<T[]> data_;
    std::size_t size_;
  };

  template <typename T> Buffer<T> make(std::size_t size) { return Buffer<T>(size); }

  /// calls `f(i)` for i in [0, n).
  template <typename Function> void for_each(std::size_t n, const Function& f) {
    // A few items may be as much work as many are.
    const std::size_t grain = (std::min<std::size_t>)(n / 256 + 1, 4096);
    for_each_index(
        execution_, n, [&](std::size_t i) { f(static_cast<Index>(i)); }, grain);
  }

  /// runs a program of many steps, see `run_steps()`.
  template <typename Program> void run(const Program& program, std::size_t = 0) {
    Threads threads = {*this};
    run_steps(program, threads);
  }

private:
  // All threads of a step, seen from the one that waits for them.
  struct Threads
  {
    Processor_executor& executor;

    bool is_first() const { return true; }
    void wait() const {}
    template <typename Program, typename State>
    void for_each(Index n, const Program& program, const State& state) {
      executor.for_each(n, [&](Index i) { program(i, state); });
    }
  };

  Execution execution_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_PROCESSOR_EXECUTOR_H
