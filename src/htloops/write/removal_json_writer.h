// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REMOVAL_JSON_WRITER_H
#define HTLOOPS_REMOVAL_JSON_WRITER_H

#include <CGAL/Handle_tunnel_loops/Removal_report.h>

#include <string>

namespace htloops {

/// writes what was removed and what was refused in the format "htloops-remove/1"; the name "-" is
/// the standard output.
void write_removal_json(const std::string& file,
                        const CGAL::Handle_tunnel_loops::Removal_report& report);

} // namespace htloops

#endif // HTLOOPS_REMOVAL_JSON_WRITER_H
