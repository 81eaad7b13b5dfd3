// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/library_backend.h"

namespace htloops {

const Backend host_backend = library_backend<All_threads_tag>("host", true);

} // namespace htloops
