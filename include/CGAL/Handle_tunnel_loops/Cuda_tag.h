// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_CUDA_TAG_H
#define CGAL_HANDLE_TUNNEL_LOOPS_CUDA_TAG_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/release_device_memory.h>

#ifdef CGAL_LINKED_WITH_CUDA
#include <CGAL/Handle_tunnel_loops/internal/device/Passes_on_device.h>
#endif

#include <CGAL/tags.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

As the `ConcurrencyTag` of `CGAL::handle_tunnel_loops()`, of
`CGAL::Handle_tunnel_loops_solver::find_loops()` and of `CGAL::reeb_graph()`, it asks for a CUDA
device: the fields of all passes and the contours run there, and contours and closed walks come
back; arrival times only where no dual loop of a handle was found in the tunnel pass, for the
tunnels that are found by one field from all loops, with `vertex_value_map`, and, with
`do_log_fronts` or `vertex_layer_map`, as layers. For a Reeb graph of a diffusion its field runs
there too, and its arrival times come back. The preparation of the mesh, the tightening of the loops
and the certificate run on the processor, in parallel if TBB is linked. The loops are those of
`Sequential_tag` and `Parallel_tag`.

Which device and which stream is said by `Handle_tunnel_loops::Solver_options::device`. At least
about 90 bytes per face of the device's memory are asked for: some 50 for the mesh and one field,
the rest for one loop pass. Where there is more, the loop passes take more, and run the more at a
time. Some of it is kept for the next computation, see
`Handle_tunnel_loops::release_device_memory()`.

The program must be linked with the target `Handle_tunnel_loops::cuda`, which defines the macro
`CGAL_LINKED_WITH_CUDA`; without, the use of this tag does not compile.

The computation throws `Handle_tunnel_loops::No_device_exception` where there is no device or no
driver, `Handle_tunnel_loops::Out_of_device_memory_exception` where its memory is too small, and
`Handle_tunnel_loops::Device_exception` where something else fails.
*/
struct Cuda_tag : public Handle_tunnel_loops::internal::Threads_if_available_tag
{};

/*!
\ingroup PkgHandleTunnelLoopsRef

The same where the program is linked with `Handle_tunnel_loops::cuda`, there is a device with enough
memory, and the mesh is not so small that the processor is done before a device has started, see
`Handle_tunnel_loops::Device_options::least_vertices`; elsewhere the computation runs on the
processor. Should the device fail in the middle, the processor goes on from what there is; no
`Handle_tunnel_loops::Device_exception` is thrown. `Handle_tunnel_loops::Statistics::fallback` says
why it was not the device.
*/
struct Cuda_if_available_tag : public Handle_tunnel_loops::internal::Threads_if_available_tag
{};

namespace Handle_tunnel_loops::internal {

#ifdef CGAL_LINKED_WITH_CUDA

template <> struct Passes_of_tag<Cuda_tag> : device::Passes_on_device
{};

template <> struct Passes_of_tag<Cuda_if_available_tag> : device::Passes_if_there_is_a_device
{};

#else

// Depends on a type, so that nobody is refused who does not use it.
template <typename Tag> struct Passes_without_cuda : Passes_of_tag<Threads_if_available_tag>
{
  static std::unique_ptr<Passes> make(const Flat_mesh&, std::vector<Index>, const Pass_options&) {
    static_assert(std::is_void<Tag>::value,
                  "Cuda_tag is used but the program is not linked with Handle_tunnel_loops::cuda");
    return nullptr;
  }
};

template <> struct Passes_of_tag<Cuda_tag> : Passes_without_cuda<Cuda_tag>
{};

template <> struct Passes_of_tag<Cuda_if_available_tag> : Passes_of_tag<Threads_if_available_tag>
{
  static std::unique_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return host_passes(execution_of<Cuda_if_available_tag>(), mesh, std::move(seeds), options,
                       "the program is not linked with Handle_tunnel_loops::cuda");
  }
};

#endif

} // namespace Handle_tunnel_loops::internal
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CUDA_TAG_H
