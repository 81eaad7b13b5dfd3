// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/homology_classes_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/link_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/measure_handles_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Triangle_connectivity_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/draw_inside_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/support/are_collinear_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel_impl.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/find_throats_impl.h>
