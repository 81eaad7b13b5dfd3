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

#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>
#include <CGAL/Handle_tunnel_loops/release_device_memory.h>

#ifdef CGAL_LINKED_WITH_CUDA
#include <CGAL/Handle_tunnel_loops/internal/device/device_passes.h>
#endif

#include <CGAL/tags.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

A concurrency tag that requests a CUDA device. Use it as the `ConcurrencyTag` of
`CGAL::handle_tunnel_loops()`, `CGAL::Handle_tunnel_loops_solver::find_loops()`,
`CGAL::reeb_graph()` and the other functions that list it.

The fields of all passes and the contours are computed on the device, and contours and closed walks
are copied back. Arrival times are copied back only for tunnel loops that one field from all loops
finds, because the tunnel pass found no dual loop for their handles, and for `vertex_value_map`.
Layers are copied back for `do_log_fronts` and `vertex_layer_map`. For a Reeb graph, the field of
the diffusion is computed on the device as well, and its arrival times are copied back. The
preparation of the mesh, the tightening of the loops and the certificate run on the processor, in
parallel if TBB is linked. The loops are the same as with `Sequential_tag` and `Parallel_tag`.

Set the device and the stream in `Handle_tunnel_loops::Solver_options::device`. The computation
needs at least about 90 bytes of device memory per face: some 50 bytes for the mesh and one field,
and the rest for one loop pass. If more memory is available, the loop passes use it to run more
fields at a time. Some of the memory is kept for the next computation; see
`Handle_tunnel_loops::release_device_memory()`.

The program must be linked with the target `Handle_tunnel_loops::cuda`, which defines the macro
`CGAL_LINKED_WITH_CUDA`. Otherwise code that uses this tag does not compile.

The computation throws `Handle_tunnel_loops::No_device_exception` if there is no device or no
driver, `Handle_tunnel_loops::Out_of_device_memory_exception` if the device memory is too small, and
`Handle_tunnel_loops::Device_exception` for any other failure of the device.
*/
struct Cuda_tag : public Handle_tunnel_loops::internal::Threads_if_available_tag
{};

/*!
\ingroup PkgHandleTunnelLoopsRef

A concurrency tag that requests a CUDA device if one is useful. The computation runs as with
`Cuda_tag` if the program is linked with `Handle_tunnel_loops::cuda`, there is a device with enough
memory, and the mesh is so large that the device is faster than the processor
(`Handle_tunnel_loops::Device_options::least_vertices`). Otherwise it runs on the processor. If the
device fails during the computation, the processor continues from the results so far; no
`Handle_tunnel_loops::Device_exception` is thrown. `Handle_tunnel_loops::Statistics::fallback` gives
the reason if the device was not used or failed.
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

// Depends on a type, so that only programs that use the tag fail to compile.
template <typename Tag> struct Passes_without_cuda : Passes_of_tag<Threads_if_available_tag>
{
  static std::shared_ptr<Passes> make(const Flat_mesh&, std::vector<Index>, const Pass_options&) {
    static_assert(std::is_void<Tag>::value,
                  "Cuda_tag is used but the program is not linked with Handle_tunnel_loops::cuda");
    return nullptr;
  }
};

template <> struct Passes_of_tag<Cuda_tag> : Passes_without_cuda<Cuda_tag>
{};

template <> struct Passes_of_tag<Cuda_if_available_tag> : Passes_of_tag<Threads_if_available_tag>
{
  static std::shared_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return host_passes(execution_of<Cuda_if_available_tag>(), mesh, std::move(seeds), options,
                       "the program is not linked with Handle_tunnel_loops::cuda");
  }
};

#endif

} // namespace Handle_tunnel_loops::internal
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CUDA_TAG_H
