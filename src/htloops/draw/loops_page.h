// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOPS_PAGE_H
#define HTLOOPS_LOOPS_PAGE_H

#include "draw/page_export.h"
#include "solve/answer.h"
#include "write/pair_listing.h"

#include <string>

namespace htloops {

/// what is shown in a page, for `write_page()`, in which a mesh can be turned, with the listed
/// pairs, and what was found at its boundary curves. `choice` is what stands before the numbers of
/// chosen pairs.
htl_window::Scene scene_of_loops(const View& view,
                                 const std::string& mesh_file,
                                 const Mesh& mesh,
                                 const Answer& answer,
                                 const Pair_listing& listing,
                                 const std::string& summary,
                                 const std::string& choice = "--pairs");

} // namespace htloops

#endif // HTLOOPS_LOOPS_PAGE_H
