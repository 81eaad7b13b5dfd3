// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_GIRTHS_H
#define HTLOOPS_GIRTHS_H

#include "solve/reeb_answer.h"

#include <vector>

namespace htloops {

/// for each arc how long its contour is half way, by the number of its vertices. Where an arc goes
/// down and up again, or has had limbs, there are several at that level: the longest.
std::vector<double> girths_of(const Mesh& mesh, const Reeb_answer& answer);

} // namespace htloops

#endif // HTLOOPS_GIRTHS_H
