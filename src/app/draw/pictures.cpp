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
#include "picture/picture.h"
#include "write/files.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace htloops {
namespace {

std::vector<htl_picture::Line> tubes_along(const Exported_lines& lines, bool has_labels) {
  std::vector<htl_picture::Line> tubes;
  for(const Exported_line& line : lines.lines)
    tubes.push_back({coordinates(line.points), line.colour, line.is_closed,
                     has_labels && line.is_numbered ? std::to_string(line.index) + line.remark : "",
                     line.is_outlined, line.width, line.radii});
  return tubes;
}

// How many lines of each kind there are, in the order in which they come.
std::vector<htl_picture::Legend_entry> legend_of(const Exported_lines& lines) {
  std::vector<std::pair<const Exported_line*, std::size_t>> kinds;
  for(const Exported_line& line : lines.lines) {
    const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const auto& kind) {
      return kind.first->kind == line.kind;
    });
    if(known == kinds.end())
      kinds.push_back({&line, 1});
    else
      ++known->second;
  }
  std::vector<htl_picture::Legend_entry> legend;
  for(const auto& [line, count] : kinds)
    legend.push_back({line->colour, line->kind + " (" + std::to_string(count) + ")"});
  return legend;
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

void export_picture(const Picture_options& options,
                    const View& view,
                    const Drawn_surface& surface,
                    const Exported_lines& lines) {
  htl_picture::Options picture;
  const auto [from, up] = whole_view(view, surface);
  picture.view = from;
  picture.up = up;
  if(!options.size.empty()) {
    picture.width = static_cast<int>(options.size[0]);
    picture.height = static_cast<int>(options.size[1]);
    picture.line_width_px *= picture.height / 1200.;
    picture.line_width_px = (std::max)(picture.line_width_px, 3.);
  }
  picture.look = throw_if_interrupted;
  picture.surface_opacity = options.opacity.value_or(opacity_before(lines.lines.size()));
  if(options.has_legend)
    picture.legend = legend_of(lines);
  const std::string& file = options.file;
  std::string content;
  try {
    content = htl_picture::encode_picture(surface.points, surface.triangles, surface.colours,
                                          tubes_along(lines, options.has_labels), picture);
  } catch(const std::runtime_error& error) {
    throw wrong_usage("--picture " + printable(file) + ": " + error.what());
  }
  // The file is begun when the picture is there, which takes its time, and never by libpng, which
  // would remove what it cannot write to.
  write_text(file, content);
}

} // namespace htloops

#endif // HTLOOPS_HAS_PICTURE
