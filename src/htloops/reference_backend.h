// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REFERENCE_BACKEND_H
#define HTLOOPS_REFERENCE_BACKEND_H

#include "backends.h"

namespace htloops {

/// finds the loops by the method of the paper to the letter, in one thread; logs the events of the
/// fronts.
Answer solve_by_reference(const Mesh& mesh, const Solve_options& options, Progress_bar& bar);

} // namespace htloops

#endif // HTLOOPS_REFERENCE_BACKEND_H
