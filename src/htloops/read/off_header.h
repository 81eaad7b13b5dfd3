// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_OFF_HEADER_H
#define HTLOOPS_OFF_HEADER_H

#include "read/text_source.h"

#include <cstddef>

namespace htloops {

/// What an OFF file says before its points: the keyword [ST][C][N][4]OFF, which may be missing, and
/// the counts.
struct Off_header
{
  bool has_texture_coordinates = false;
  bool has_colours = false;
  bool has_normals = false;
  bool is_homogeneous = false; ///< of four coordinates, the last of which divides the others
  std::size_t number_of_points = 0;
  std::size_t number_of_faces = 0;
  bool is_free_form = false; ///< a line may hold several points or faces, and nothing else
};

/// reads the header of an OFF file and goes to what follows it. The number of edges, which nobody
/// needs, may be missing. Throws `Failure` if the header is malformed or of another dialect.
Off_header read_off_header(Text_source& text);

} // namespace htloops

#endif // HTLOOPS_OFF_HEADER_H
