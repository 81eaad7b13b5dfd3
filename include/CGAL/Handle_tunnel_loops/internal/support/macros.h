// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MACROS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MACROS_H

#include <CGAL/license/Handle_tunnel_loops.h>

// Threads come from TBB where the program is linked with it, which CGAL's macro
// CGAL_LINKED_WITH_TBB says; or where CGAL_HTL_STD_THREADS is defined, from the package's own
// Thread_pool.

/// \file host_device.h
/// Marks functions that the processor and a CUDA device run alike, and before them such templates
/// as may also be given functions of the processor alone; loops of few rounds whose loads a
/// device is to begin together; and loops and functions
/// that are not to become many copies.

#ifdef __CUDACC__
#define CGAL_HTL_HOST_DEVICE __host__ __device__
#define CGAL_HTL_CALLS_ANY_FUNCTION _Pragma("nv_exec_check_disable")
#define CGAL_HTL_UNROLL _Pragma("unroll")
#define CGAL_HTL_NO_UNROLL _Pragma("unroll 1")
#define CGAL_HTL_NO_INLINE __noinline__
#else
#define CGAL_HTL_HOST_DEVICE
#define CGAL_HTL_CALLS_ANY_FUNCTION
#define CGAL_HTL_UNROLL
#define CGAL_HTL_NO_UNROLL
#define CGAL_HTL_NO_INLINE
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_MACROS_H
