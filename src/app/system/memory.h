// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SYSTEM_MEMORY_H
#define HTLOOPS_SYSTEM_MEMORY_H

#include <cstdint>

namespace htloops {

/// how many bytes the machine has; some, where it does not say.
std::uint64_t memory_of_machine();

/// how many of them the program may take, in the container that it runs in, if it is in one, and as
/// the shell has limited it.
std::uint64_t memory_allowed();

} // namespace htloops

#endif // HTLOOPS_SYSTEM_MEMORY_H
