// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_BOUNDARY_TABLE_H
#define HTLOOPS_BOUNDARY_TABLE_H

#include "solve/boundaries.h"

#include <string>

namespace htloops {

/// a table of the boundary curves for a person, the shortest first: how long they and their waists
/// are, and where. The middle of a long one is left out, unless all is to be shown.
std::string table_of_boundaries(const Boundaries& boundaries, bool show_all);

} // namespace htloops

#endif // HTLOOPS_BOUNDARY_TABLE_H
