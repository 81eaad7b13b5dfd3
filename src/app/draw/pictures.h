// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PICTURES_H
#define HTLOOPS_PICTURES_H

#include "scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// How a picture is made.
struct Picture_options
{
  std::string file;
  std::vector<double> size;      ///< width and height in pixels; empty for the default
  std::optional<double> opacity; ///< of the surface; none: so that many hidden lines stay pale
  bool has_labels = false;       ///< numbers of what lines stand for
  bool has_legend = false;       ///< what their colours mean, and how large things are
  bool has_tubes = false;        ///< lines that have radii are as thick as these
  std::optional<std::size_t> closeup =
      {};                     ///< the number of the pair that is drawn large, if one is
  bool is_view_given = false; ///< what is drawn large is seen from there, too
};

/// of a surface with lines inside, if no other was asked for.
constexpr double opacity_around_bones_in_pictures = 0.15;

#ifdef HTLOOPS_HAS_PICTURE

constexpr bool has_pictures = true;

/// whether labels and legends can be written.
bool can_write_on_pictures();

/// throws `Failure` if pictures are not made so large.
void check_picture_size(const Picture_options& options);

/// writes a picture of a scene.
void export_picture(const Picture_options& options, const htl_scene::Scene& scene);

#else

constexpr bool has_pictures = false;

inline bool can_write_on_pictures() { return false; }
inline void check_picture_size(const Picture_options&) {}
inline void export_picture(const Picture_options&, const htl_scene::Scene&) {}

#endif

} // namespace htloops

#endif // HTLOOPS_PICTURES_H
