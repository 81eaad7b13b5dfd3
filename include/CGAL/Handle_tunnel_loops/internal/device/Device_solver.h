// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_SOLVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_SOLVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Device_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Device_initial_pass.h>
#include <CGAL/Handle_tunnel_loops/internal/device/Device_search.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Front_layers.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>

#include <algorithm>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// On a device, by an executor that runs what is written for one. The mesh must outlive the object.
template <typename Executor> class Device_solver : public Solver
{
public:
  Device_solver(Executor& executor, const Flat_mesh& mesh, const Tuning& tuning = {})
      : executor_(executor)
      , host_mesh_(mesh)
      , tuning_(tuning)
      , mesh_(uploaded_mesh(executor, mesh))
      , initial_(executor, mesh, mesh_, tuning, costs_) {}

  bool find_first_cells(First_cells& cells) override {
    [[maybe_unused]] const auto scope = executor_.scope();
    return Device_cells<Executor>(executor_, mesh_.view(), costs_).find(cells);
  }

  std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                              const Step_coefficients& k,
                                              const Callback& callback) override {
    [[maybe_unused]] const auto scope = executor_.scope();
    initial_.run(seeds, k, callback);
    return initial_.handles();
  }

  std::vector<Time> arrival_times() override {
    [[maybe_unused]] const auto scope = executor_.scope();
    return initial_.times();
  }

  Front_log front_log() override {
    [[maybe_unused]] const auto scope = executor_.scope();
    return Front_layers<Executor>(executor_, host_mesh_, mesh_.view(), initial_.time_span()).run();
  }

  std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                     const Crossing_index& index,
                                     const Step_coefficients& k) override {
    [[maybe_unused]] const auto scope = executor_.scope();
    Device_initial_pass<Executor> field(executor_, host_mesh_, mesh_, tuning_, costs_);
    field.run_from_loops(loops, index, k);
    return field.times();
  }

  std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                        const Step_coefficients& k,
                                        const Callback& callback) override {
    [[maybe_unused]] const auto scope = executor_.scope();
    Device_initial_pass<Executor> field(executor_, host_mesh_, mesh_, tuning_, costs_);
    field.run(vertices, k, callback);
    return field.times();
  }

  std::vector<Dual_walks> dual_walks(const Dual_loop_query& query,
                                     const Step_coefficients& k,
                                     const Callback& callback) override {
    [[maybe_unused]] const auto scope = executor_.scope();
    if(query.bars_only_own)
      return Device_search<Executor, Only_loop>(executor_, mesh_, host_mesh_, tuning_, costs_)
          .run(query, k, callback);
    return Device_search<Executor, Loops_from>(executor_, mesh_, host_mesh_, tuning_, costs_)
        .run(query, k, callback);
  }

  void report(Statistics& statistics) const override {
    statistics.backend = "cuda";
    statistics.device_bytes = (std::max)(statistics.device_bytes, costs_.largest_bytes);
  }

  Costs costs() const override {
    Costs costs = costs_;
    costs.kernels = executor_.kernels();
    return costs;
  }

private:
  // Refuses the mesh if there would not be room for the passes beside it.
  static Device_mesh<Executor> uploaded_mesh(Executor& executor, const Flat_mesh& mesh) {
    const Mesh_view view = view_of(mesh);
    const std::size_t n = mesh.number_of_vertices();
    const std::size_t needed = Device_mesh<Executor>::bytes(view) + n * sizeof(Time) +
                               (std::max)(Device_initial_pass<Executor>::bytes(n),
                                          Device_search<Executor, Loops_from>::bytes(n));
    if(needed > executor.free_bytes())
      throw Out_of_device_memory_exception(needed, executor.free_bytes());
    return Device_mesh<Executor>(executor, view);
  }

  Executor& executor_;
  const Flat_mesh& host_mesh_;
  Tuning tuning_;
  Costs costs_;
  Device_mesh<Executor> mesh_;
  Device_initial_pass<Executor> initial_;
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_SOLVER_H
