// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/cutting/cut_open_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/find_necks_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Removal_rounds_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Shape_judge_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/bores_around_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/membranes_impl.h>
