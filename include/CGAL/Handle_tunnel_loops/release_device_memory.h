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
/// So many bytes of a device's memory are kept, at most, when a computation with `Cuda_tag` or
/// `Cuda_if_available_tag` has ended, so that the next one finds them ready for use.
constexpr std::size_t kept_device_bytes = std::size_t(256) << 20;

/*!
\ingroup PkgHandleTunnelLoopsRef

gives back all of the devices' memory that computations with `Cuda_tag` or `Cuda_if_available_tag`
have left behind for later ones; what computations still use, when they end. It is to be called
before `cudaDeviceReset()`, and may be called at any time, by any thread.

Defined in the library `Handle_tunnel_loops::cuda`.
*/
void release_device_memory();

} // namespace CGAL::Handle_tunnel_loops

#endif // CGAL_HANDLE_TUNNEL_LOOPS_RELEASE_DEVICE_MEMORY_H
