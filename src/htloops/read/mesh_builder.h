// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_BUILDER_H
#define HTLOOPS_MESH_BUILDER_H

#include "mesh_types.h"
#include "read/soup.h"
#include "read/soup_diagnosis.h"

namespace htloops {

/// makes a mesh of a soup without defects, given its diagnosis; vertices and faces keep their
/// numbers. As all neighbours are known, nothing has to be searched: this is
/// several times faster than `polygon_soup_to_polygon_mesh()`.
Mesh build_mesh(const Soup& soup, const Diagnosis& diagnosis);

} // namespace htloops

#endif // HTLOOPS_MESH_BUILDER_H
