// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REMOVAL_TABLE_H
#define HTLOOPS_REMOVAL_TABLE_H

#include <CGAL/Handle_tunnel_loops/Removal_report.h>

#include <string>

namespace htloops {

/// the word for a way, as it stands in files and messages.
const char* name_of(CGAL::Handle_tunnel_loops::Removal_way way);

/// tables of the handles and necks that were removed, and of those that were refused, for a person.
std::string table_of_removals(const CGAL::Handle_tunnel_loops::Removal_report& report,
                              bool show_all);

/// lines that sum them up.
std::string summary(const CGAL::Handle_tunnel_loops::Removal_report& report);

} // namespace htloops

#endif // HTLOOPS_REMOVAL_TABLE_H
