// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/Dual_walks.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// How a device is used, for benchmarks and tests to vary: no answer depends on it.
struct Tuning
{
  int threads_at_barrier = 640;    ///< of each multiprocessor, at most, in kernels of many steps
  Time steps_per_run = 512;        ///< of an initial pass, between two looks at callback and band
  Time steps_per_look = 64;        ///< of the loop passes, at most, between two looks; no more than
                                   ///< `Step_coefficients::patience`
  Time steps_per_look_if_met = 16; ///< at least, where fronts have met
  bool times_kernels = false;      ///< see `Costs::kernels`; waits for each of them
};

/// What all launches of a kernel cost.
struct Kernel_cost
{
  std::uint64_t number_of_launches = 0;
  double seconds = 0.;
};

/// What the passes cost.
struct Costs
{
  std::uint64_t number_of_updates = 0;
  std::uint64_t number_of_steps = 0;
  double seconds_of_sweeps = 0.; ///< of the fields over the whole mesh
  std::uint64_t number_of_batches = 0;
  std::size_t largest_batch = 0;              ///< loop passes at a time
  std::size_t largest_bytes = 0;              ///< in use at one time
  std::map<std::string, Kernel_cost> kernels; ///< by the name of their type, if they were timed
};

/// Computes the fields of the passes on a device; see `Field_passes`.
class Solver
{
public:
  virtual ~Solver() = default;

  /// finds the first cells of the mesh, and what is around them. Returns false where that is better
  /// done by the processor.
  virtual bool find_first_cells(First_cells& cells) = 0;

  /// the field of the initial pass: what its saddles offer as handles, in their order.
  ///
  /// \param seeds the vertices to start from, one in each component
  /// \param callback is called by the calling thread
  virtual std::vector<Handle_candidate> initial_field(const std::vector<Index>& seeds,
                                                      const Step_coefficients& k,
                                                      const Callback& callback) = 0;

  /// the arrival times of the last initial field.
  virtual std::vector<Time> arrival_times() = 0;

  /// the layers of the last initial field, and what happened to its fronts.
  virtual Front_log front_log() = 0;

  /// the arrival times of one field from both sides of all loops, none of which it crosses.
  virtual std::vector<Time> times_from_loops(const std::vector<Crossing_loop>& loops,
                                             const Crossing_index& index,
                                             const Step_coefficients& k) = 0;

  /// the arrival times of one field from vertices, the same one more than once or not: these first,
  /// their neighbours next; `never` where it does not come.
  ///
  /// \param callback is called by the calling thread
  virtual std::vector<Time> times_from_vertices(const std::vector<Index>& vertices,
                                                const Step_coefficients& k,
                                                const Callback& callback) = 0;

  /// the fields of the loop passes: what is found for each of the numbers of the query.
  ///
  /// \param callback may be called by several threads at a time
  virtual std::vector<Dual_walks> dual_walks(const Dual_loop_query& query,
                                             const Step_coefficients& k,
                                             const Callback& callback) = 0;

  /// says what it is, and what it took.
  virtual void report(Statistics& statistics) const = 0;

  /// what all of that has cost.
  virtual Costs costs() const = 0;
};

/// brings a mesh, which must outlive the solver, to a device. Defined in the library
/// `Handle_tunnel_loops::cuda`. Throws `No_device_exception`, `Out_of_device_memory_exception` or
/// `Device_exception`.
std::unique_ptr<Solver>
make_cuda_solver(const Flat_mesh& mesh, const Device_options& options, const Tuning& tuning = {});

/// the number of the current device of the calling thread. Throws as the above.
int current_cuda_device();

/// does what a process has to do before it uses a device for the first time. Throws as the above.
void start_cuda_device(const Device_options& options);

/// What a device can do at most, measured; for benchmarks. Defined in the library
/// `Handle_tunnel_loops::cuda`.
struct Ceilings
{
  std::string device;    ///< its name
  std::string versions;  ///< of the driver and of the runtime
  double seconds_to_map; ///< so many bytes of its memory, if the process keeps none of it
  std::size_t mapped_bytes;
  double bytes_per_second;   ///< of a copy within its memory, read and written
  double seconds_per_launch; ///< of kernels that do nothing, one after the other
  double seconds_per_step;   ///< of a barrier of the grid that the passes use
};

/// measures the given device, or the current one if the number is negative.
Ceilings measure_ceilings(int device);

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_SOLVER_H
