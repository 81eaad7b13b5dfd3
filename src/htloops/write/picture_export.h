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

#include "write/exported_lines.h"

#include <array>
#include <string>
#include <vector>

namespace htloops {

struct Picture_options
{
  std::string file;
  std::vector<double> view; ///< the direction the picture is seen from; empty for the default
  std::vector<double> up;   ///< the direction that is upright in it; empty for the default
};

#ifdef HTLOOPS_HAS_PICTURE

constexpr bool has_pictures = true;

/// writes a picture of the mesh and lines; with colours of the faces, or with none.
void export_picture(const Picture_options& options,
                    const Mesh& mesh,
                    const Exported_lines& lines,
                    const std::vector<std::array<unsigned char, 3>>& face_colours = {});

/// the content of the file of a picture, seen as by default.
std::string picture_of(const Mesh& mesh, const Exported_lines& lines);

#else

constexpr bool has_pictures = false;

inline void export_picture(const Picture_options&,
                           const Mesh&,
                           const Exported_lines&,
                           const std::vector<std::array<unsigned char, 3>>& = {}) {}

inline std::string picture_of(const Mesh&, const Exported_lines&) { return ""; }

#endif

} // namespace htloops

#endif // HTLOOPS_PICTURE_EXPORT_H
