// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/library_backend.h"

#include <CGAL/Handle_tunnel_loops/Cuda_tag.h>

namespace htloops {

const Backend cuda_backend = library_backend<CGAL::Cuda_tag>("cuda", false);
const Backend automatic_backend = library_backend<CGAL::Cuda_if_available_tag>("auto", true);

} // namespace htloops
