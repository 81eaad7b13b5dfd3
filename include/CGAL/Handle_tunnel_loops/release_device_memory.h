// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_RELEASE_DEVICE_MEMORY_H
#define CGAL_HANDLE_TUNNEL_LOOPS_RELEASE_DEVICE_MEMORY_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <cstddef>

namespace CGAL::Handle_tunnel_loops {

/// \ingroup PkgHandleTunnelLoopsRef
/// The maximal number of bytes of device memory that remain allocated after a computation with
/// `Cuda_tag` or `Cuda_if_available_tag`, for reuse by the next computation.
constexpr std::size_t kept_device_bytes = std::size_t(256) << 20;

/*!
\ingroup PkgHandleTunnelLoopsRef

Releases all device memory that computations with `Cuda_tag` or `Cuda_if_available_tag` keep for
later computations. Memory that is still in use is released when its computation ends. Call this
function before `cudaDeviceReset()`. Any thread may call it at any time.

The library `Handle_tunnel_loops::cuda` defines this function.
*/
void release_device_memory();

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_RELEASE_DEVICE_MEMORY_H
