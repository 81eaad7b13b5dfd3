// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/scenes.h"

#include "draw/skeletons.h"
#include "draw/surfaces.h"
#include "draw/tints.h"
#include "file_names.h"
#include "system/files.h"
#include "words.h"
#include "write/throat_tables.h"

#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/number_utils.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htloops {
namespace {

// The extents of a box are told in fewer letters than where there is room.
std::vector<std::string> narrow_cells_of(const Listed_pair& pair, const Pair_columns& columns) {
  std::vector<std::string> cells = cells_of(pair, columns);
  boost::algorithm::replace_all(cells.back(), " x ", "\u00d7");
  return cells;
}

template <typename Columns> void add_columns(htl_scene::Table& table, const Columns& columns) {
  for(const Table_column& column : columns)
    table.columns.push_back({column.name, column.is_number, column.about});
}

/// adds the sorts of lines that handle loops and tunnel loops are, which come first.
void add_groups_of_loops(htl_scene::Scene& scene) {
  scene.groups = {{"handle loops", colour_of(Loop_type::HANDLE)},
                  {"tunnel loops", colour_of(Loop_type::TUNNEL)}};
}

// adds a line of a group, told of in a row.
void add_line(htl_scene::Scene& scene,
              const std::vector<Point>& points,
              bool is_closed,
              std::size_t group,
              std::size_t row = htl_scene::no_row) {
  scene.lines.push_back({coordinates(points), is_closed, group, row});
}

// Adds both loops of a pair to these, told of in a row.
void add_loops(htl_scene::Scene& scene,
               const Pairs& pairs,
               const Listed_pair& listed,
               std::size_t row) {
  for(std::size_t group = 0; group < 2; ++group) {
    const Loop_type type = loop_types[group];
    add_line(scene, pairs[listed.pair].loop(type).points(), true, group, row);
    scene.lines.back().label = label_of(listed, type);
  }
}

// A surface without parts.
htl_scene::Surface surface_of(const std::string& name, const Drawn_surface& surface) {
  return {name, surface.points, surface.triangles, {}, {}};
}

// Three great circles.
std::vector<Point> circles_of(const Ball& ball) {
  constexpr int corners = 32;
  std::vector<Point> points;
  for(int axis = 0; axis < 3; ++axis)
    for(int i = 0; i <= corners; ++i) {
      const double angle = 2. * CGAL_PI * i / corners;
      std::array<double, 3> p = {0., 0., 0.};
      p[static_cast<std::size_t>(axis)] = ball.diameter / 2. * internal::cosine(angle);
      p[static_cast<std::size_t>((axis + 1) % 3)] = ball.diameter / 2. * internal::sine(angle);
      points.emplace_back(ball.throat.x() + p[0], ball.throat.y() + p[1], ball.throat.z() + p[2]);
    }
  return points;
}

// The ways of the balls that can be threaded, and these at their throats; a slider moves them.
void add_balls(htl_scene::Scene& scene, const Measures& measures, const Pair_listing& listing) {
  if(!has_measures(listing))
    return;
  const std::size_t first = scene.groups.size();
  scene.groups.insert(scene.groups.end(), {{"balls in the solid", {120, 70, 20}},
                                           {"balls through holes", {20, 120, 90}},
                                           {"paths of balls", {120, 120, 130}, 0.6}});
  for(std::size_t group = first; group < scene.groups.size(); ++group)
    scene.groups[group].is_in_pictures = false; // in which they do not move
  for(std::size_t row = 0; row < listing.size(); ++row) {
    const Measure& measure = measures[listing[row].pair];
    std::size_t group = first;
    for(const auto ball : {&measure.thickness, &measure.clear_width}) {
      if(*ball && !(*ball)->curve.empty()) {
        add_line(scene, (*ball)->curve, true, first + 2, row);
        add_line(scene, circles_of(**ball), true, group, row);
        scene.lines.back().way = scene.lines.size() - 2;
      }
      ++group;
    }
  }
}

// What rows may be hidden by.
void add_scales(htl_scene::Table& table, const Pair_listing& listing) {
  const auto add = [&](const char* name, const auto& value_of) {
    table.scales.push_back({name, {}});
    for(const Listed_pair& pair : listing)
      table.scales.back().values.push_back(
          value_of(pair).value_or(std::numeric_limits<double>::quiet_NaN()));
  };
  add("diameter", [](const Listed_pair& pair) { return std::optional(pair.hole.diameter); });
  if(!has_measures(listing))
    return;
  const auto diameter = [](const std::optional<Listed_ball>& ball) {
    return ball ? std::optional(ball->diameter) : std::nullopt;
  };
  add("thickness", [&](const Listed_pair& pair) { return diameter(pair.measure->thickness); });
  add("clear width", [&](const Listed_pair& pair) { return diameter(pair.measure->clear_width); });
}

void add_pairs(htl_scene::Scene& scene,
               const Pairs& pairs,
               const Pair_listing& listing,
               const Choice& choice) {
  const Pair_columns columns(listing);
  add_columns(scene.table, columns_of(columns));
  scene.table.choice = choice;
  add_groups_of_loops(scene);
  for(std::size_t row = 0; row < listing.size(); ++row) {
    const Listed_pair& listed = listing[row];
    scene.table.rows.push_back(narrow_cells_of(listed, columns));
    scene.table.lengths.push_back((std::min)(listed.handle_length, listed.tunnel_length));
    scene.table.numbers.push_back(listed.pair);
    add_loops(scene, pairs, listed, row);
  }
  add_scales(scene.table, listing);
}

std::string why_no_rows(const Answer& answer) {
  if(answer.throats.are_wanted)
    return "There are no throats: the surface has no narrow places.";
  if(!answer.pairs.empty())
    return "None of the " + counted(answer.pairs.size(), "pair", "pairs") +
           " matches the options that select pairs: omit them to see all.";
  return "This surface has no handles (its genus is 0), so there are no handle loops and no "
         "tunnel loops. Use --throats to show its narrow places, or 'htloops skeleton' for its "
         "curve skeleton.";
}

void add_group(htl_scene::Scene& scene,
               const std::string& name,
               htl_scene::Colour colour,
               const std::vector<Loop>& loops) {
  if(loops.empty())
    return;
  scene.groups.push_back({name, colour});
  for(const Loop& loop : loops)
    add_line(scene, loop.points(), true, scene.groups.size() - 1);
}

// In place of pairs.
void add_throats(htl_scene::Scene& scene, const Throats& throats) {
  add_columns(scene.table, throat_columns);
  scene.groups = {{"handle loops", colour_of(Loop_type::HANDLE)},
                  {"tunnel loops", colour_of(Loop_type::TUNNEL)},
                  {"loops of other classes", colour_of(Loop_type::BOUNDARY)},
                  {"separating loops", colour_of_separating}};
  for(const Throat& throat : throats.all) {
    const std::size_t group = throat.is_separating                      ? 3
                              : !throat.pair                            ? 2
                              : throat.loop.type() == Loop_type::TUNNEL ? 1
                                                                        : 0;
    add_line(scene, throat.loop.points(), true, group, scene.table.rows.size());
    scene.lines.back().label = std::to_string(throat.loop.pair_index());
    scene.table.rows.push_back(cells_of(throats, throat));
    scene.table.lengths.push_back(throat.loop.length());
  }
}

// The numbers of groups are those of the kinds of bones. Arcs are told of in rows.
void add_bones(htl_scene::Scene& scene,
               const Exported_lines& bones,
               const std::vector<std::size_t>& row_of_arc) {
  for(const Bone_kind& kind : bone_kinds)
    scene.groups.push_back({kind.many, kind.colour, kind.width});
  for(const Exported_line& bone : bones.lines) // what these are depends on the graph
    scene.groups[static_cast<std::size_t>(bone.kind_number)].name = bone.kind;
  for(const Exported_line& bone : bones.lines) {
    const bool is_ball = bone.points.size() == 1;
    add_line(scene, bone.points, bone.is_closed || is_ball,
             static_cast<std::size_t>(bone.kind_number),
             is_ball ? htl_scene::no_row : row_of_arc[bone.index]);
    scene.lines.back().radii = bone.radii;
    if(!is_ball)
      scene.lines.back().label = std::to_string(bone.index);
  }
}

void add_arcs(htl_scene::Scene& scene,
              const Mesh& mesh,
              const Reeb_answer& answer,
              const std::vector<Listed_arc>& arcs) {
  add_columns(scene.table, arc_columns);
  std::vector<std::size_t> row_of(arcs.size());
  for(const Listed_arc& arc : arcs) {
    row_of[arc.arc] = scene.table.rows.size();
    scene.table.rows.push_back(cells_of(arc));
    scene.table.lengths.push_back(arc.length);
    scene.table.parts.push_back(arc.arc);
  }
  add_bones(scene, bones_of(mesh, answer, answer.embedding.has_value()), row_of);
}

void add_arcs(htl_scene::Scene& scene, const Skeleton_answer& answer) {
  add_columns(scene.table, skeleton_columns);
  std::vector<std::size_t> row_of(answer.arcs.size());
  for(const std::size_t arc : arcs_by_length(answer)) {
    row_of[arc] = scene.table.rows.size();
    scene.table.rows.push_back(cells_of(answer, arc));
    scene.table.lengths.push_back(answer.arcs[arc].length);
    scene.table.parts.push_back(arc);
  }
  add_bones(scene, bones_of(answer, true), row_of);
}

/// What is shown of a removal: a row for each handle, and for each neck, those that were removed
/// first. The caps of a row are a part of the second surface.
class Removal_rows
{
public:
  Removal_rows(const Removal_shown& shown, htl_scene::Scene& scene)
      : shown_(shown)
      , scene_(scene)
      , is_left_(shown.before.number_of_faces(), false)
      , part_of_patch_(report().removed.size() + report().removed_necks.size()) {
    for(const std::int64_t origin : shown.removal.face_origins)
      if(origin != nothing_before)
        is_left_[static_cast<std::size_t>(origin)] = true;
  }

  void add() {
    add_handles(true);
    add_handles(false);
    add_necks(report().removed_necks);
    add_necks(report().refused_necks);
    colour_caps();
  }

private:
  const Removal_report& report() const { return shown_.removal.report; }

  void add_handles(bool are_removed) {
    for(const Listed_pair& listed : shown_.listing) {
      const auto& [done, refused] = *listed.removal;
      if(done.has_value() != are_removed)
        continue;
      add_loops(scene_, shown_.pairs, listed, scene_.table.rows.size());
      const std::size_t last = scene_.lines.size();
      for(const std::size_t i : {0, 1})
        if(done || !is_left(shown_.pairs[listed.pair].loop(loop_types[i])))
          scene_.lines[last - 2 + i].surface = 0;
      const std::string name = std::to_string(listed.pair);
      if(done)
        add_row(*done, name);
      else
        add_row(*refused, name);
      scene_.table.numbers.push_back(listed.pair);
    }
  }

  // Whether the faces along it are, on both sides of the edges that it crosses.
  bool is_left(const Loop& loop) const {
    const auto& steps = loop.steps();
    return std::all_of(steps.begin(), steps.end(), [&](const Loop::Step& step) {
      const Mesh::Halfedge_index other = shown_.before.opposite(step.halfedge);
      return (shown_.before.is_border(step.halfedge) ||
              is_left_[shown_.before.face(step.halfedge).idx()]) &&
             (shown_.before.is_border(other) || is_left_[shown_.before.face(other).idx()]);
    });
  }

  template <typename Neck> void add_necks(const std::vector<Neck>& necks) {
    for(const Neck& neck : necks)
      add_row(neck, "neck");
  }

  // The first row of a patch names its part; others that share it tell of the same.
  void add_row(const Removed_handle& handle, const std::string& name) {
    htl_scene::Table& table = scene_.table;
    std::size_t& part = part_of_patch_[handle.patch];
    if(part == 0)
      part = table.rows.size() + 1;
    table.parts.push_back(part);
    table.rows.push_back(cells_of(handle, name, diagonal_of(shown_.before)));
    table.rows.back().resize(table.columns.size());
    table.lengths.push_back(handle.length);
  }

  void add_row(const Refused_handle& handle, const std::string& name) {
    std::vector<std::string> cells = {name, "refused", formatted("%.6g", handle.length)};
    cells.resize(std::size(removal_columns));
    cells.push_back(handle.reason);
    scene_.table.parts.push_back(htl_scene::no_part);
    scene_.table.rows.push_back(std::move(cells));
    scene_.table.lengths.push_back(handle.length);
  }

  // Part 0 is what was there before, part i + 1 the caps of row i.
  void colour_caps() {
    htl_scene::Surface& after = scene_.surfaces[1];
    for(const std::size_t patch : shown_.removal.patches)
      after.triangle_parts.push_back(
          patch == Removal_answer::no_patch ? 0 : std::uint32_t(part_of_patch_[patch]));
    after.part_colours.assign(scene_.table.rows.size() + 1, colour_of_caps);
    after.part_colours[0] = scene_.surface_colour;
    if(!report().removed.empty() || !report().removed_necks.empty())
      scene_.patches = {{"new faces at removed handles", colour_of_caps}};
  }

  const Removal_shown& shown_;
  htl_scene::Scene& scene_;
  std::vector<bool> is_left_;              // by face
  std::vector<std::size_t> part_of_patch_; // 0 before it has one
};

/// a scene with a title, `title` and the name of the mesh's file, and a surface.
htl_scene::Scene
scene_of(const std::string& title, const std::string& mesh_file, htl_scene::Surface surface) {
  const std::filesystem::path path = path_of(mesh_file);
  htl_scene::Scene scene;
  scene.title = title + " " + printable(path.filename().string());
  scene.name = printable(path.stem().string());
  scene.surfaces.push_back(std::move(surface));
  return scene;
}

// What is told of in rows is to be seen, unless it is inside: all of it at first, and that of a row
// if this is asked for.
void look(const View& given, htl_scene::Scene& scene) {
  std::vector<std::vector<Polyline>> lines_of_rows(scene.table.rows.size());
  for(const htl_scene::Line& line : scene.lines)
    if(line.row != htl_scene::no_row && scene.groups[line.group].is_in_pictures)
      lines_of_rows[line.row].push_back(line.points);
  Views views = views_of(given, scene.surfaces[0], lines_of_rows);
  scene.view = views.whole.from;
  scene.up = views.whole.up;
  scene.table.views = std::move(views.of_groups);
}

// Arcs are inside of what is looked through: no row is seen from outside.
void look_through(const View& given, htl_scene::Scene& scene) {
  std::vector<Polyline> arcs;
  for(const htl_scene::Line& line : scene.lines)
    if(line.row != htl_scene::no_row)
      arcs.push_back(line.points);
  const Whole_view view = view_through(given, scene.surfaces[0], arcs);
  scene.view = view.from;
  scene.up = view.up;
}

// What comes before the name of the file.
std::string title_of(const Removal_shown& shown) {
  const Removal_report& report = shown.removal.report;
  const bool are_necks = report.removed.empty() && !report.removed_necks.empty();
  if(report.removed.empty() && !are_necks)
    return shown.is_dry_run ? "Nothing would be removed from" : "Nothing removed from";
  return std::string(are_necks ? "Necks " : "Handles ") +
         (shown.is_dry_run ? "that would be removed from" : "removed from");
}

std::string why_no_rows(const Removal_shown& shown) {
  return shown.pairs.empty()
             ? "This surface has no handles (its genus is 0): there is nothing to remove."
             : "None of the " + counted(shown.pairs.size(), "handle", "handles") +
                   " was selected for removal: 'htloops loops' shows all.";
}

htl_scene::Scene scene_of_parts(const std::string& title,
                                const std::string& mesh_file,
                                Arc_surface cut,
                                const std::vector<Colour>& tints) {
  htl_scene::Scene scene = scene_of(title, mesh_file,
                                    {"surface", std::move(cut.points), std::move(cut.triangles),
                                     std::move(cut.triangle_arcs), tints});
  scene.opacity = opacity_around_bones;
  scene.has_bones = true;
  scene.table.noun = "arc";
  return scene;
}

// The kind of an edge is its group.
htl_scene::Scene scene_of_edges(const std::string& title,
                                const std::string& mesh_file,
                                const Mesh& mesh,
                                const Exported_lines& edges,
                                const std::string& summary) {
  htl_scene::Scene scene = scene_of(title, mesh_file, surface_of("surface", drawn_surface(mesh)));
  scene.paragraphs = lines_of(summary);
  for(const Exported_line& edge : edges.lines)
    add_line(scene, edge.points, edge.is_closed, static_cast<std::size_t>(edge.kind_number));
  return scene;
}

} // namespace

htl_scene::Scene scene_of_loops(const View& view,
                                const std::string& mesh_file,
                                const Mesh& mesh,
                                const Answer& answer,
                                const Pair_listing& listing,
                                const std::string& summary,
                                const Choice& choice) {
  htl_scene::Scene scene =
      scene_of("Handle and tunnel loops of", mesh_file, surface_of("surface", drawn_surface(mesh)));
  scene.paragraphs = lines_of(summary);
  scene.unit = words_of(answer.unit).sign;
  if(answer.throats.are_wanted)
    add_throats(scene, answer.throats);
  else {
    add_pairs(scene, answer.pairs, listing, choice);
    add_balls(scene, answer.measures, listing);
  }
  if(scene.table.rows.empty())
    scene.table.empty = why_no_rows(answer);
  add_group(scene, "boundary curves", colour_of_boundary_curve, answer.boundaries.curves);
  add_group(scene, "waists of boundary curves", colour_of(Loop_type::BOUNDARY),
            answer.boundaries.waists);
  look(view, scene);
  return scene;
}

htl_scene::Scene
scene_of_layers(const View& view, const std::string& mesh_file, const Grown_layers& layers) {
  htl_scene::Scene scene = scene_of("Layers of", mesh_file, surface_of("surface", layers.surface));
  std::map<Colour, std::uint32_t> parts; // as they are met
  for(const Colour& colour : layers.surface.colours) {
    const auto [part, is_new] = parts.try_emplace(colour, static_cast<std::uint32_t>(parts.size()));
    if(is_new)
      scene.surfaces[0].part_colours.push_back(colour);
    scene.surfaces[0].triangle_parts.push_back(part->second);
  }
  if(!layers.fronts.lines.empty())
    scene.groups = {{"front", layers.fronts.lines.front().colour, 1., true}};
  for(const Exported_line& line : layers.fronts.lines) {
    add_line(scene, line.points, line.is_closed, 0);
    scene.lines.back().label = std::to_string(line.index);
  }
  look(view, scene);
  return scene;
}

htl_scene::Scene scene_of_reeb_graph(const View& view,
                                     const std::string& mesh_file,
                                     const Mesh& mesh,
                                     const Reeb_answer& answer,
                                     const std::vector<Listed_arc>& arcs,
                                     const std::string& summary) {
  htl_scene::Scene scene =
      scene_of_parts("Reeb graph of", mesh_file, arc_surface(mesh, answer), tints_of(mesh, answer));
  scene.paragraphs = lines_of(summary);
  add_arcs(scene, mesh, answer, arcs);
  look_through(view, scene);
  return scene;
}

htl_scene::Scene scene_of_skeleton(const View& view,
                                   const std::string& mesh_file,
                                   const Mesh& mesh,
                                   const Skeleton_answer& answer,
                                   const std::string& summary) {
  Skeleton_surface around = skeleton_surface(mesh, answer);
  htl_scene::Scene scene =
      scene_of_parts("Skeleton of", mesh_file, std::move(around.surface), around.colours);
  scene.paragraphs = lines_of(summary);
  add_arcs(scene, answer);
  if(scene.table.rows.empty())
    scene.table.empty =
        "The skeleton has no arcs: no part of the surface is longer than it is thick, "
        "or goes around a hole.";
  look_through(view, scene);
  return scene;
}

htl_scene::Scene scene_of_cut(const View& view,
                              const std::string& mesh_file,
                              const Mesh& mesh,
                              const Exported_lines& cut,
                              const std::string& summary) {
  htl_scene::Scene scene = scene_of_edges("Cut along edges:", mesh_file, mesh, cut, summary);
  if(!cut.lines.empty())
    scene.groups = {{"the cut", cut.lines.front().colour}};
  look(view, scene);
  return scene;
}

htl_scene::Scene scene_of_dual_cuts(const View& view,
                                    const std::string& mesh_file,
                                    const Mesh& mesh,
                                    const Exported_lines& cuts,
                                    const std::string& summary) {
  htl_scene::Scene scene = scene_of_edges("Dual cuts:", mesh_file, mesh, cuts, summary);
  scene.groups = {{"across handle loops", colour_of(Loop_type::HANDLE)},
                  {"across tunnel loops", colour_of(Loop_type::TUNNEL)}};
  if(!scene.lines.empty() && scene.lines.back().group == 2) // they come last
    scene.groups.push_back({"across boundary curves", colour_of(Loop_type::BOUNDARY)});
  for(std::size_t i = 0; i < cuts.lines.size(); ++i)
    scene.lines[i].label = std::to_string(cuts.lines[i].index);
  look(view, scene);
  return scene;
}

htl_scene::Scene scene_of_removal(const View& view, const Removal_shown& shown) {
  htl_scene::Scene scene =
      scene_of(title_of(shown), shown.mesh_file, surface_of("before", drawn_surface(shown.before)));
  scene.paragraphs = lines_of(shown.summary);
  scene.unit = words_of(shown.unit).sign;
  scene.surfaces.push_back(surface_of("after", drawn_surface(shown.removal.mesh)));
  add_groups_of_loops(scene);
  add_columns(scene.table, removal_columns);
  if(!shown.removal.report.refused.empty() || !shown.removal.report.refused_necks.empty())
    scene.table.columns.push_back({"why not", false, "Why the handle was not removed"});
  scene.table.choice = shown.choice;
  Removal_rows(shown, scene).add();
  if(scene.table.rows.empty())
    scene.table.empty = why_no_rows(shown);
  look(view, scene);
  return scene;
}

htl_scene::Scene scene_of_cleaning(const std::string& mesh_file,
                                   const Mesh& before,
                                   const Cleaned_mesh& cleaned,
                                   const std::string& summary) {
  htl_scene::Scene scene =
      scene_of("Cleaned:", mesh_file, surface_of("before", drawn_surface(before)));
  scene.paragraphs = lines_of(summary);
  scene.surfaces.push_back(surface_of("after", drawn_surface(cleaned.mesh)));
  // By fate: kept, replaced, small part, shell; then what is new.
  scene.patches = {{"replaced", {213, 94, 0}},
                   {"small parts", {230, 159, 0}},
                   {"shells", {86, 180, 233}},
                   {"new faces", colour_of_caps}};
  for(htl_scene::Surface& surface : scene.surfaces) {
    surface.part_colours = {scene.surface_colour};
    for(const htl_scene::Patch& patch : scene.patches)
      surface.part_colours.push_back(patch.colour);
  }
  for(const Face_fate fate : cleaned.fates)
    scene.surfaces[0].triangle_parts.push_back(static_cast<std::uint32_t>(fate));
  for(const std::int64_t origin : cleaned.face_parents)
    scene.surfaces[1].triangle_parts.push_back(origin == nothing_before ? 4 : 0);
  scene.groups = {{"closed channels and handles", {170, 0, 90}}};
  for(const std::vector<Point>& loop : cleaned.closed_loops)
    add_line(scene, loop, true, 0);
  scene.table.noun = "step";
  scene.table.columns = {{"step", false, "The step of the cleaning"},
                         {"count", true, "How many were found"},
                         {"done", false, "What was done"},
                         {"left", false, "What was left unchanged"}};
  for(const Clean_record& record : cleaned.records) {
    scene.table.rows.push_back({name_of(record.step), std::to_string(record.count),
                                boost::algorithm::join(record.done, "; "),
                                boost::algorithm::join(record.left, "; ")});
  }
  look({}, scene);
  return scene;
}

} // namespace htloops
