// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_INITIAL_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_INITIAL_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/domains.h>
#include <CGAL/Handle_tunnel_loops/internal/device/field_kernels.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Saddle_contours.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// A vertex that is one from the beginning.
struct Source
{
  Index vertex;
  Time time;
};

/// Begins a field: the sources first, then the band beside them.
struct Start_field
{
  enum class Round { SOURCES, BAND };

  Field<Whole_mesh_domain> field;
  Span<const Source> sources;
  Round round;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    const Source& source = sources[i];
    const Located_cell cell = field.domain.located(source.vertex);
    if(round == Round::BAND)
      Neighbors<Whole_mesh_domain>(field, cell).activate(Field_state());
    else if(field.add_source(cell, source.time, 0))
      fetch_add(field.arrays.control->state.number_of_reached, Index(1));
  }
};

/// One field over the whole mesh: its arrival times, and the handles read off them.
template <typename Executor> class Device_initial_pass
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  Device_initial_pass(Executor& executor,
                      const Flat_mesh& host_mesh,
                      const Device_mesh<Executor>& mesh,
                      const Tuning& tuning,
                      Costs& costs)
      : executor_(executor)
      , host_mesh_(host_mesh)
      , mesh_(mesh)
      , steps_per_run_(tuning.steps_per_run)
      , costs_(costs) {}

  /// the bytes that an initial pass needs beside the mesh.
  static std::size_t bytes(std::size_t number_of_vertices) {
    return number_of_vertices *
           (2 * sizeof(float) + sizeof(Time) + sizeof(std::uint32_t) + 2 * sizeof(Index));
  }

  /// a field from vertices: that of the initial pass, if there is one in each component.
  void
  run(const std::vector<Index>& vertices, const Step_coefficients& k, const Callback& callback) {
    run(Whole_mesh_domain(mesh_.view()), with_rings(vertices), k, callback);
  }

  /// a field from both sides of all loops, which are walls to it.
  void run_from_loops(const std::vector<Crossing_loop>& loops,
                      const Crossing_index& index,
                      const Step_coefficients& k) {
    std::vector<Source> sources;
    for(const Crossing_loop& loop : loops)
      for(const Crossing& c : loop) {
        sources.push_back({c.left, 0});
        sources.push_back({c.right, 0});
      }
    const Buffer<Index> begins = uploaded(executor_, index.begins_of_all());
    const Buffer<Crossing_entry> entries = uploaded(executor_, index.entries());
    run(Whole_mesh_domain(mesh_.view(), {begins.span(), entries.span()}), sources, k,
        [](double) { return true; });
  }

  /// takes other arrival times for its own.
  void set_times(const std::vector<Time>& times) {
    time_ = Buffer<Time>();
    time_ = uploaded(executor_, times);
  }

  /// the handles, in the order of their saddles.
  std::vector<Handle_candidate> handles() {
    return Saddle_contours<Executor>(executor_, mesh_.view(), time_.span()).handles();
  }

  /// the arrival times, in the memory of the executor.
  Span<const Time> time_span() const { return time_.span(); }

  std::vector<Time> times() { return downloaded(executor_, time_); }

private:
  // Each vertex once, with its earliest time: they are added in any order.
  std::vector<Source> with_rings(const std::vector<Index>& vertices) const {
    std::vector<Source> sources;
    for(Index v : vertices) {
      sources.push_back({v, 0});
      for(Index u : host_mesh_.ring(v))
        sources.push_back({u, 1});
    }
    std::sort(sources.begin(), sources.end(), [](const Source& a, const Source& b) {
      return a.vertex != b.vertex ? a.vertex < b.vertex : a.time < b.time;
    });
    const auto is_same = [](const Source& a, const Source& b) { return a.vertex == b.vertex; };
    sources.erase(std::unique(sources.begin(), sources.end(), is_same), sources.end());
    return sources;
  }

  void run(const Whole_mesh_domain& domain,
           const std::vector<Source>& sources,
           const Step_coefficients& k,
           const Callback& callback) {
    const std::size_t n = mesh_.number_of_vertices();
    time_ = Buffer<Time>();
    if(executor_.free_bytes() < bytes(n))
      throw Out_of_device_memory_exception(bytes(n), executor_.free_bytes());
    time_ = filled(executor_, n, never);
    const Buffer<float> values[2] = {filled(executor_, n, 0.f), filled(executor_, n, 0.f)};
    const Buffer<std::uint32_t> state = filled(executor_, n, std::uint32_t(0));
    const Buffer<Index> bands[2] = {executor_.template make<Index>(n),
                                    executor_.template make<Index>(n)};
    const Buffer<Time> progress[2] = {filled(executor_, 1, Time(0)), filled(executor_, 1, Time(0))};
    const Buffer<Time> last_step = filled(executor_, 1, never);
    const Buffer<Field_control> control = filled(executor_, 1, Field_control());
    Field<Whole_mesh_domain>::Arrays arrays = {};
    arrays.value[0] = values[0].span();
    arrays.value[1] = values[1].span();
    arrays.time = time_.span();
    arrays.state = state.span();
    arrays.band[0] = bands[0].span();
    arrays.band[1] = bands[1].span();
    arrays.passes.progress[0] = progress[0].span();
    arrays.passes.progress[1] = progress[1].span();
    arrays.passes.last_step = last_step.span();
    arrays.control = control.span().data();
    costs_.largest_bytes = (std::max)(costs_.largest_bytes, executor_.bytes_in_use());
    const Field<Whole_mesh_domain> field = {domain, arrays};
    start(field, sources);
    make_steps(field, k, callback);
  }

  void start(const Field<Whole_mesh_domain>& field, const std::vector<Source>& sources) {
    const Buffer<Source> list = uploaded(executor_, sources);
    using Round = Start_field::Round;
    for(const Round round : {Round::SOURCES, Round::BAND})
      executor_.for_each(sources.size(), Start_field{field, list.span(), round});
  }

  void make_steps(const Field<Whole_mesh_domain>& field,
                  const Step_coefficients& k,
                  const Callback& callback) {
    const Index n = static_cast<Index>(mesh_.number_of_vertices());
    const auto began = std::chrono::steady_clock::now();
    Field_control control = {};
    executor_.download(&control, Span<Field_control>(field.arrays.control, 1));
    control.state.next_list_size = control.counters.added[0].value;
    Time pause = 0;
    do {
      pause += steps_per_run_;
      executor_.run(Field_steps<Whole_mesh_domain>(field, k, {n, pause, pause}),
                    control.state.next_list_size);
      executor_.download(&control, Span<Field_control>(field.arrays.control, 1));
      if(!callback(double(control.state.number_of_reached) / double(n)))
        throw Interrupted_exception();
    } while(control.state.step == pause);
    costs_.number_of_updates += control.state.number_of_updates;
    costs_.number_of_steps += control.state.step;
    costs_.seconds_of_sweeps +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }

  Executor& executor_;
  const Flat_mesh& host_mesh_;
  const Device_mesh<Executor>& mesh_;
  Time steps_per_run_;
  Costs& costs_;
  Buffer<Time> time_;
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_INITIAL_PASS_H
