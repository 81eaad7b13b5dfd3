// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/library_backend.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>

namespace htloops {

const Backend reference_backend = library_backend<CGAL::Reference_tag>("reference", false);

} // namespace htloops
