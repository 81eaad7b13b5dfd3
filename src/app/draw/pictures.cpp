// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/pictures.h"

#ifdef HTLOOPS_HAS_PICTURE

#include "failure.h"
#include "file_names.h"
#include "interrupt.h"
#include "mesh_types.h"
#include "picture/picture.h"
#include "write/files.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace htloops {
namespace {

// What of the lines is in a picture of the first surface.
bool is_drawn(const htl_scene::Scene& scene, const htl_scene::Line& line) {
  return scene.groups[line.group].is_in_pictures &&
         (line.surface == htl_scene::every_surface || line.surface == 0);
}

std::vector<htl_picture::Line> drawn_lines(const htl_scene::Scene& scene,
                                           const Picture_options& options) {
  std::vector<htl_picture::Line> lines;
  for(const htl_scene::Line& line : scene.lines)
    if(is_drawn(scene, line)) {
      const htl_scene::Line_group& group = scene.groups[line.group];
      lines.push_back({line.points, group.colour, line.closed, options.has_labels ? line.label : "",
                       group.is_outlined, group.width,
                       options.has_tubes ? line.radii : std::vector<double>()});
    }
  return lines;
}

// How many lines of each group there are, and what the colours of surfaces mean.
std::vector<htl_picture::Legend_entry> legend_of(const htl_scene::Scene& scene) {
  std::vector<std::size_t> counts(scene.groups.size());
  for(const htl_scene::Line& line : scene.lines)
    counts[line.group] += is_drawn(scene, line) ? 1 : 0;
  std::vector<htl_picture::Legend_entry> legend;
  for(std::size_t i = 0; i < counts.size(); ++i)
    if(const auto& group = scene.groups[i]; counts[i] > 0)
      legend.push_back({group.colour, group.name + " (" + std::to_string(counts[i]) + ")"});
  for(const htl_scene::Patch& patch : scene.patches)
    legend.push_back({patch.colour, patch.name});
  return legend;
}

std::vector<Colour> colours_of_triangles(const htl_scene::Surface& surface) {
  std::vector<Colour> colours;
  for(const std::uint32_t part : surface.triangle_parts)
    colours.push_back(surface.part_colours[part]);
  return colours;
}

// Hidden lines are the paler the more there are: what matters is what is in front of them.
double opacity_before(std::size_t lines) {
  constexpr double few = 30.;
  return 1. - 0.5 * (std::min)(1., std::sqrt(few / (std::max)(double(lines), 1.)));
}

} // namespace

bool can_write_on_pictures() { return htl_picture::has_font(); }

void check_picture_size(const Picture_options& options) {
  if(options.size.empty())
    return;
  try {
    htl_picture::check_size(static_cast<std::size_t>(options.size[0]),
                            static_cast<std::size_t>(options.size[1]));
  } catch(const std::runtime_error& error) {
    throw wrong_usage(std::string("--size: ") + error.what());
  }
}

void export_picture(const Picture_options& options, const htl_scene::Scene& scene) {
  const std::vector<htl_picture::Line> lines = drawn_lines(scene, options);
  htl_picture::Options picture;
  picture.view = scene.view;
  picture.up = scene.up;
  picture.surface_colour = scene.surface_colour;
  if(!options.size.empty()) {
    picture.width = static_cast<int>(options.size[0]);
    picture.height = static_cast<int>(options.size[1]);
    picture.line_width_px *= picture.height / 1200.;
    picture.line_width_px = (std::max)(picture.line_width_px, 3.);
  }
  picture.look = throw_if_interrupted;
  picture.surface_opacity = options.opacity.value_or(
      scene.has_bones ? opacity_around_bones_in_pictures : opacity_before(lines.size()));
  if(options.has_legend)
    picture.legend = legend_of(scene);
  const std::string& file = options.file;
  std::string content;
  try {
    const htl_scene::Surface& surface = scene.surfaces[0];
    content = htl_picture::encode_picture(surface.points, surface.triangles,
                                          colours_of_triangles(surface), lines, picture);
  } catch(const std::runtime_error& error) {
    throw wrong_usage("--picture " + printable(file) + ": " + error.what());
  }
  // The file is begun when the picture is there, which takes its time, and never by libpng, which
  // would remove what it cannot write to.
  write_text(file, content);
}

} // namespace htloops

#endif // HTLOOPS_HAS_PICTURE
