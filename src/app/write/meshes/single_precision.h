// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SINGLE_PRECISION_H
#define HTLOOPS_SINGLE_PRECISION_H

#include "write/meshes/writers.h"

namespace htloops {

/// throws `Failure` if single precision, after a change of scale, has no room for the coordinates,
/// or would move points by more than a ten thousandth of the diagonal of the box.
void check_single_precision(const Written_mesh& written, double scale = 1.);

/// by what coordinates are multiplied in a format that counts in millimeters.
double scale_to_millimeters(const Written_mesh& written);

} // namespace htloops

#endif // HTLOOPS_SINGLE_PRECISION_H
