// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PICTURE_EXPORT_H
#define HTLOOPS_PICTURE_EXPORT_H

#include "mesh_types.h"

#include <string>
#include <vector>

namespace htloops {

struct Picture_options
{
  std::string file;
  std::vector<double> view; ///< the direction the picture is seen from; empty for the default
};

#ifdef HTLOOPS_HAS_PICTURE

constexpr bool has_pictures = true;

/// writes a picture of the mesh and the loops.
void export_picture(const Picture_options& options, const Mesh& mesh, const Pairs& pairs);

#else

constexpr bool has_pictures = false;

inline void export_picture(const Picture_options&, const Mesh&, const Pairs&) {}

#endif

} // namespace htloops

#endif // HTLOOPS_PICTURE_EXPORT_H
