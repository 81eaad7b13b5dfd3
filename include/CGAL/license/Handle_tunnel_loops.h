// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_LICENSE_HANDLE_TUNNEL_LOOPS_H
#define CGAL_LICENSE_HANDLE_TUNNEL_LOOPS_H

// The package is distributed under the GPL. This header is where CGAL checks for commercial
// licences; it exists so that the include line of every other header is already the final one.

#endif // CGAL_LICENSE_HANDLE_TUNNEL_LOOPS_H
