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

#include <CGAL/Handle_tunnel_loops/internal/pipeline/Device_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Device_start.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Fallback_backend.h>
#include <CGAL/Handle_tunnel_loops/internal/pipeline/Loop_pipeline.h>
#include <CGAL/Handle_tunnel_loops/release_device_memory.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <optional>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

As the `ConcurrencyTag` of `CGAL::handle_tunnel_loops()` and of
`CGAL::Handle_tunnel_loops_solver::find_loops()`, it asks for a CUDA device: the fields of all
passes and the contours run there, and only loops come back; the preparation of the mesh, the
tightening of the loops and the certificate run on the processor, in parallel if TBB is linked. The
loops are those of the other tags.

Which device and which stream is said by the named parameter `device_options`. At least about
90 bytes per face of the device's memory are asked for: some 50 for the mesh and one field, the
rest for one loop pass. Where there is more, the loop passes take more, and run the more at a time.
Some of it is kept for the next computation, see `Handle_tunnel_loops::release_device_memory()`.

The program must be linked with the target `Handle_tunnel_loops::cuda`, which defines the macro
`CGAL_LINKED_WITH_CUDA`; without, the use of this tag does not compile.

The computation throws `Handle_tunnel_loops::No_device_exception` where there is no device or no
driver, `Handle_tunnel_loops::Out_of_device_memory_exception` where its memory is too small, and
`Handle_tunnel_loops::Device_exception` where something else fails.
*/
struct Cuda_tag : public Parallel_if_available_tag
{};

/*!
\ingroup PkgHandleTunnelLoopsRef

The same where the program is linked with `Handle_tunnel_loops::cuda`, there is a device with enough
memory, and the mesh is not so small that the processor is done before a device has started, see
`Handle_tunnel_loops::Device_options::least_vertices`; elsewhere the computation runs on the
processor. Should the device fail on the way, the processor goes on from what there is; no
`Handle_tunnel_loops::Device_exception` is thrown. `Handle_tunnel_loops::Statistics::fallback` says
why it was not the device.
*/
struct Cuda_if_available_tag : public Parallel_if_available_tag
{};

namespace Handle_tunnel_loops {
namespace internal {

template <> struct Loop_pipeline_of<Cuda_if_available_tag>
{
  using Execution = decltype(execution<Cuda_if_available_tag>());
  using type = Loop_pipeline<Execution, Fallback_backend<Execution>>;
};

template <> struct Loop_pipeline_of<Cuda_tag>
{
  using Execution = decltype(execution<Cuda_tag>());
  using type = Loop_pipeline<Execution, Device_backend<Execution>>;
};

#ifdef CGAL_LINKED_WITH_CUDA
template <> struct Device_start<Cuda_tag> : Concurrent_device_start
{
  Device_start(const Device_options& options, std::size_t)
      : Concurrent_device_start(options) {}
};

template <> struct Device_start<Cuda_if_available_tag>
{
  Device_start(const Device_options& options, std::size_t number_of_vertices) {
    if(number_of_vertices >= options.least_vertices)
      start_.emplace(options);
  }

private:
  std::optional<Concurrent_device_start> start_;
};
#endif

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_CUDA_TAG_H
