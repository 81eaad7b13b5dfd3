// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_HOST_BACKEND_H
#define HTLOOPS_HOST_BACKEND_H

#include "backends.h"

namespace htloops {

/// finds the loops with the processor's own threads.
Answer solve_on_host(const Mesh& mesh, const Solve_options& options, Progress_bar& bar);

} // namespace htloops

#endif // HTLOOPS_HOST_BACKEND_H
