// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PAGE_EXPORT_H
#define HTLOOPS_PAGE_EXPORT_H

#include "draw/view.h"
#include "mesh_types.h"

#include "window/window.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// a scene with a title, `title` and the name of the mesh's file, and a surface.
htl_window::Scene scene_of(const View& view,
                           const std::string& title,
                           const std::string& mesh_file,
                           const std::string& surface_name,
                           const Drawn_surface& surface);

/// a surface without parts.
htl_window::Surface surface_of(const std::string& name, const Drawn_surface& surface);

/// adds a line of a group, told of in a row.
void add_line(htl_window::Scene& scene,
              const std::vector<Point>& points,
              bool is_closed,
              std::size_t group,
              std::size_t row = htl_window::no_row);

/// adds the sorts of lines that handle loops and tunnel loops are, which come first.
void add_groups_of_loops(htl_window::Scene& scene);

/// adds both loops of a pair to these, told of in a row.
void add_loops(htl_window::Scene& scene, const Pair& pair, std::size_t row);

/// adds the paragraphs of a text, a line each.
void add_paragraphs(htl_window::Scene& scene, const std::string& text);

void write_page(const std::string& file, const htl_window::Scene& scene);

} // namespace htloops

#endif // HTLOOPS_PAGE_EXPORT_H
