// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CLAIMS_H
#define HTLOOPS_CLAIMS_H

#include "app/mesh_types.h"
#include "app/read/loops_reader.h"
#include "app/solve/answer.h"

#include <string>
#include <vector>

namespace htloops {

/// what a file says of the surface that is not so: components, boundary curves, genus.
std::vector<std::string> false_claims_on_surface(const Loops_record& record, const Mesh& mesh);

/// what a file says of its loops that is not so, the worse first: on which side they bound, their
/// linking numbers, their sizes. `loops` are those of the file, with a certificate that has linking
/// numbers. What the file does not say is no false claim.
std::vector<std::string> false_claims_on_loops(const Loops_record& record,
                                               const Mesh& mesh,
                                               const Pairs& loops,
                                               const Certificate& certificate);

} // namespace htloops

#endif // HTLOOPS_CLAIMS_H
