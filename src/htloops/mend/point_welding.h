// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_POINT_WELDING_H
#define HTLOOPS_POINT_WELDING_H

#include "mend/mended_soup.h"

namespace htloops {

/// makes one vertex of those at the same place, exactly, where an edge without a second face lies
/// on another edge. Faces with the same sides count as one. What touches in points stays apart, and
/// a mesh without such edges as it is.
void weld_points(Mended_soup& mended);

} // namespace htloops

#endif // HTLOOPS_POINT_WELDING_H
