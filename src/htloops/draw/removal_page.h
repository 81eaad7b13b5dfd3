// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REMOVAL_PAGE_H
#define HTLOOPS_REMOVAL_PAGE_H

#include "draw/page_export.h"
#include "mesh_types.h"

#include <CGAL/Handle_tunnel_loops/Removal_report.h>

#include <string>

namespace htloops {

/// What a page shows: a mesh, its loops, and what became of it.
struct Removal_shown
{
  const std::string& mesh_file;
  const Mesh& before;
  const Pairs& pairs;
  const CGAL::Handle_tunnel_loops::Removal_report& report;
  const Mesh& after;
};

/// the pairs of the handles that were to be removed, refused ones among them.
Pairs pairs_to_remove(const Pairs& pairs, const CGAL::Handle_tunnel_loops::Removal_report& report);

/// writes a page in which both meshes can be turned, with the loops of these pairs and what became
/// of each.
void write_removal_page(const std::string& file, const View& view, const Removal_shown& shown);

} // namespace htloops

#endif // HTLOOPS_REMOVAL_PAGE_H
