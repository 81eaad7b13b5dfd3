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

#include "draw/samples.h"
#include "draw/surfaces.h"
#include "draw/view.h"
#include "failure.h"
#include "file_names.h"
#include "interrupt.h"
#include "mesh_types.h"
#include "picture/picture.h"
#include "write/files.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace htloops {
namespace {

// Whether a line is in the picture of a surface.
bool is_drawn(const htl_scene::Scene& scene, const htl_scene::Line& line, std::size_t surface) {
  return scene.groups[line.group].is_in_pictures &&
         (line.surface == htl_scene::every_surface || line.surface == surface);
}

// What is drawn of a surface.
struct Drawing
{
  std::vector<htl_picture::Line> lines;
  std::vector<std::size_t> rows; // of the lines
  std::vector<Colour> triangle_colours;
};

Drawing
drawing_of(const htl_scene::Scene& scene, std::size_t surface, const Picture_options& options) {
  Drawing drawing;
  for(const htl_scene::Line& line : scene.lines)
    if(is_drawn(scene, line, surface)) {
      const htl_scene::Line_group& group = scene.groups[line.group];
      drawing.lines.push_back({line.points, group.colour, line.closed,
                               options.has_labels ? line.label : "", group.is_outlined, group.width,
                               options.has_tubes ? line.radii : std::vector<double>()});
      drawing.rows.push_back(line.row);
    }
  const htl_scene::Surface& drawn = scene.surfaces[surface];
  for(const std::uint32_t part : drawn.triangle_parts)
    drawing.triangle_colours.push_back(drawn.part_colours[part]);
  return drawing;
}

// How many lines of each group there are, and what the colours of surfaces mean.
std::vector<htl_picture::Legend_entry> legend_of(const htl_scene::Scene& scene) {
  std::vector<std::size_t> counts(scene.groups.size());
  for(const htl_scene::Line& line : scene.lines)
    counts[line.group] += is_drawn(scene, line, 0) ? 1 : 0;
  std::vector<htl_picture::Legend_entry> legend;
  for(std::size_t i = 0; i < counts.size(); ++i)
    if(const auto& group = scene.groups[i]; counts[i] > 0)
      legend.push_back({group.colour, group.name + " (" + std::to_string(counts[i]) + ")"});
  for(const htl_scene::Patch& patch : scene.patches)
    legend.push_back({patch.colour, patch.name});
  return legend;
}

// Hidden lines are the paler the more there are: what matters is what is in front of them.
double opacity_before(std::size_t lines) {
  constexpr double few = 30.;
  return 1. - 0.5 * (std::min)(1., std::sqrt(few / (std::max)(double(lines), 1.)));
}

htl_picture::Options options_of(const Picture_options& options, const htl_scene::Scene& scene) {
  htl_picture::Options picture;
  picture.view = scene.view;
  picture.up = scene.up;
  picture.surface_colour = scene.surface_colour;
  if(scene.surfaces.size() > 1) { // side by side
    picture.width = 2000;
    picture.height = 1000;
  }
  if(!options.size.empty()) {
    picture.width = static_cast<int>(options.size[0]);
    picture.height = static_cast<int>(options.size[1]);
    picture.line_width_px *= picture.height / 1200.;
    picture.line_width_px = (std::max)(picture.line_width_px, 3.);
  }
  picture.look = throw_if_interrupted;
  picture.has_rings = true;
  if(options.has_legend) {
    picture.legend = legend_of(scene);
    picture.has_scale_bar = true;
    picture.unit = scene.unit;
  }
  return picture;
}

// "0, 2, 5": the first of many.
std::string list_of(std::vector<std::size_t> numbers) {
  constexpr std::size_t most = 10;
  std::sort(numbers.begin(), numbers.end());
  std::string list;
  for(std::size_t i = 0; i < (std::min)(most, numbers.size()); ++i)
    list += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
  return list + (numbers.size() > most ? ", ..." : "");
}

std::size_t row_of(std::size_t pair, const htl_scene::Scene& scene) {
  const std::vector<std::size_t>& numbers = scene.table.numbers;
  const auto row = std::find(numbers.begin(), numbers.end(), pair);
  if(row == numbers.end())
    throw wrong_usage("--closeup: pair " + std::to_string(pair) +
                      (numbers.empty()
                           ? " does not exist: no pairs are listed"
                           : " is not one of those that are listed: " + list_of(numbers)));
  return static_cast<std::size_t>(row - numbers.begin());
}

// Lines that are not of a row become thin, and have no labels.
void mute_others(std::size_t row, Drawing& drawing) {
  for(std::size_t i = 0; i < drawing.lines.size(); ++i)
    if(drawing.rows[i] != row) {
      drawing.lines[i].label.clear();
      drawing.lines[i].width *= 0.4;
    }
}

// The triangles of the surface afterwards that a row tells of.
std::vector<Polyline> caps_of(std::size_t row, const htl_scene::Scene& scene) {
  std::vector<Polyline> caps;
  const htl_scene::Surface& drawn = scene.surfaces[1];
  const std::vector<std::size_t>& parts = scene.table.parts;
  if(row >= parts.size() || parts[row] == htl_scene::no_part)
    return caps;
  for(std::size_t t = 0; t < drawn.triangle_parts.size(); ++t)
    if(drawn.triangle_parts[t] == parts[row]) {
      const auto& [a, b, c] = drawn.triangles[t];
      caps.push_back({drawn.points[a], drawn.points[b], drawn.points[c]});
    }
  return caps;
}

// Of so many lines those that a view is searched for, which are spread over all.
std::vector<Polyline> some_of(const std::vector<Polyline>& lines) {
  constexpr std::size_t many = 200;
  const std::size_t stride = lines.size() / many + 1;
  std::vector<Polyline> some;
  for(std::size_t i = 0; i < lines.size(); i += stride)
    some.push_back(lines[i]);
  return some;
}

// From where a pair is seen, and what is not to be cut away.
struct Look
{
  htl_scene::Point from;
  htl_picture::Focus focus;
};

/*
Where a handle was cut, its caps face each other, and none is seen from outside: the one with the
largest triangle is looked at straight, with all before it cut away.
*/
Look look_into_cut(const std::vector<Polyline>& caps) {
  std::vector<Vector> corners;
  for(const Polyline& cap : caps)
    corners.insert(corners.end(), cap.begin(), cap.end());
  const Ball_around ball(corners);
  const auto normal = [&](const Polyline& t) {
    return normal_of(ball(t[0]), ball(t[1]), ball(t[2]));
  };
  const Polyline& largest =
      *std::max_element(caps.begin(), caps.end(), [&](const Polyline& s, const Polyline& t) {
        return norm(normal(s)) < norm(normal(t));
      });
  const Vector towards = unit(normal(largest));
  Look look = {{0., 0., 0.}, {{}, 0.}};
  for(const Polyline& cap : caps)
    if(const Vector n = normal(cap); dot(n, towards) > 0.) {
      for(std::size_t i = 0; i < 3; ++i)
        look.from[i] += n[i];
      look.focus.points.insert(look.focus.points.end(), cap.begin(), cap.end());
    }
  return look;
}

// A pair as it was, and the caps that are there instead, if there are any.
Look best_look_at(const std::vector<Polyline>& loops,
                  const std::vector<Polyline>& caps,
                  const htl_scene::Scene& scene) {
  if(caps.empty())
    return {best_views(scene.surfaces[0], {loops}, scene.up).front().value_or(scene.view), {}};
  const std::vector<Polyline> some = some_of(caps);
  if(!best_views(scene.surfaces[1], {some}, scene.up).front())
    return look_into_cut(caps);
  return {best_common_view({{scene.surfaces[0], loops}, {scene.surfaces[1], some}}, scene.up), {}};
}

// A pair, as it is seen best if no other view was asked for; what cannot be seen from outside is
// cut free. Beside it, if it was removed, what is there now.
std::string closeup_of(const Picture_options& options,
                       const htl_scene::Scene& scene,
                       const std::vector<htl_picture::Panel>& panels,
                       htl_picture::Options picture) {
  const std::size_t row = row_of(*options.closeup, scene);
  std::vector<Polyline> loops, caps;
  for(const htl_scene::Line& line : scene.lines)
    if(line.row == row && is_drawn(scene, line, 0))
      loops.push_back(line.points);
  if(scene.surfaces.size() > 1)
    caps = caps_of(row, scene);
  Look look = {scene.view, {}};
  if(!options.is_view_given)
    look = best_look_at(loops, caps, scene);
  picture.view = look.from;
  if(look.focus.points.empty())
    for(const auto* lines : {&loops, &caps})
      for(const Polyline& line : *lines)
        look.focus.points.insert(look.focus.points.end(), line.begin(), line.end());
  return htl_picture::encode_closeup(panels, look.focus, picture);
}

std::string content_of(const Picture_options& options, const htl_scene::Scene& scene) {
  std::vector<Drawing> drawings;
  for(std::size_t i = 0; i < scene.surfaces.size(); ++i)
    drawings.push_back(drawing_of(scene, i, options));
  if(options.closeup)
    for(Drawing& drawing : drawings)
      mute_others(row_of(*options.closeup, scene), drawing);
  std::vector<htl_picture::Panel> panels;
  for(std::size_t i = 0; i < drawings.size(); ++i) {
    const htl_scene::Surface& surface = scene.surfaces[i];
    panels.push_back({surface.points, surface.triangles, drawings[i].triangle_colours,
                      drawings[i].lines, scene.surfaces.size() > 1 ? surface.name : ""});
  }
  htl_picture::Options picture = options_of(options, scene);
  picture.surface_opacity =
      options.opacity.value_or(scene.has_bones ? opacity_around_bones_in_pictures
                                               : opacity_before(drawings[0].lines.size()));
  return options.closeup ? closeup_of(options, scene, panels, picture)
                         : htl_picture::encode_picture(panels, picture);
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
  std::string content;
  try {
    content = content_of(options, scene);
  } catch(const Failure&) {
    throw;
  } catch(const std::runtime_error& error) {
    throw wrong_usage("--picture " + printable(options.file) + ": " + error.what());
  }
  // The file is begun when the picture is there, which takes its time, and never by libpng, which
  // would remove what it cannot write to.
  write_text(options.file, content);
}

} // namespace htloops

#endif // HTLOOPS_HAS_PICTURE
