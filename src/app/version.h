// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VERSION_H
#define HTLOOPS_VERSION_H

namespace htloops {

/// the version of the package, and what this build of the tool rests on.
const char* version();

} // namespace htloops

#endif // HTLOOPS_VERSION_H
