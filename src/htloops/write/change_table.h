// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHANGE_TABLE_H
#define HTLOOPS_CHANGE_TABLE_H

#include "mend/mended_soup.h"

#include <string>
#include <vector>

namespace htloops {

/// what was done to the mesh of a file before anything was computed: a line for each kind.
std::string table_of_changes(const std::string& file, const std::vector<Change>& changes);

} // namespace htloops

#endif // HTLOOPS_CHANGE_TABLE_H
