// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REEB_PAGE_H
#define HTLOOPS_REEB_PAGE_H

#include "draw/view.h"
#include "solve/reeb_answer.h"
#include "write/arc_table.h"

#include <string>
#include <vector>

namespace htloops {

/// writes a page in which a mesh can be turned, with the parts that its arcs sweep, each with its
/// bone.
void write_reeb_page(const std::string& file,
                     const View& view,
                     const std::string& mesh_file,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     const std::vector<Listed_arc>& arcs,
                     const std::string& summary);

} // namespace htloops

#endif // HTLOOPS_REEB_PAGE_H
