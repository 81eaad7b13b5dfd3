// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_CORE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_CORE_H

#include <CGAL/license/Handle_tunnel_loops.h>

// What knows no type of mesh is defined in headers *_impl.h. The headers that declare it include
// these, and all is inline; or else the program is linked with Handle_tunnel_loops::core, which
// defines the macro CGAL_LINKED_WITH_HTL_CORE, and where they are compiled once: with assertions if
// the library is, whatever the program is compiled with.
#ifdef CGAL_LINKED_WITH_HTL_CORE
#define CGAL_HTL_CORE
#else
#define CGAL_HTL_CORE inline
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_CORE_H
