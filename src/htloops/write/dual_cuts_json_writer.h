// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DUAL_CUTS_JSON_WRITER_H
#define HTLOOPS_DUAL_CUTS_JSON_WRITER_H

#include "mesh_types.h"
#include "solve/dual_cut_solver.h"

#include <string>

namespace htloops {

/// writes the cuts, with the loops that they cross, as a document of format "htloops-dual/1".
void write_dual_cuts_json(const std::string& target, const Mesh& mesh, const Dual_cuts& cuts);

} // namespace htloops

#endif // HTLOOPS_DUAL_CUTS_JSON_WRITER_H
