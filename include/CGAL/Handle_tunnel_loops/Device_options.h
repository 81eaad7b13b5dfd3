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

namespace CGAL {
namespace Handle_tunnel_loops {

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
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_DEVICE_OPTIONS_H
