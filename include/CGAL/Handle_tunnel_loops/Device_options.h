// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_DEVICE_OPTIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_DEVICE_OPTIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// From so many vertices on (200,000 faces) a device pays: to start one takes some tenths of a
/// second, in which the processor is done with a smaller mesh.
constexpr std::size_t least_vertices_for_device = 100000;

/*!
\ingroup PkgHandleTunnelLoopsRef

Where on which CUDA device a computation with `Cuda_tag` or `Cuda_if_available_tag` runs.
*/
struct Device_options
{
  /// the number of the device; negative for the current one of the calling thread.
  int device = -1;
  /// the `cudaStream_t` on which all work of the device is done, and which belongs to that device;
  /// null for a stream of its own.
  void* stream = nullptr;
  /// a mesh with fewer vertices is left to the processor by `Cuda_if_available_tag`; `Cuda_tag`
  /// does not look at it.
  std::size_t least_vertices = least_vertices_for_device;
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_DEVICE_OPTIONS_H
