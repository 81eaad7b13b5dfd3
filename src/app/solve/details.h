// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DETAILS_H
#define HTLOOPS_DETAILS_H

#include "solve/answer.h"

namespace htloops {

/// by pair, the bore that its tunnel loop goes around, if that is one.
Bores find_bores(const Mesh& mesh, const Pairs& pairs);

/// looks for what is told of a mesh with its loops: boundary curves, if it has some, and bores.
void add_details(const Mesh& mesh, bool do_find_waists, Answer& answer);

} // namespace htloops

#endif // HTLOOPS_DETAILS_H
