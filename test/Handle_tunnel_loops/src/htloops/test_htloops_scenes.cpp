// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "app/draw/pictures.h"
#include "app/draw/scenes.h"
#include "app/failure.h"
#include "app/solve/details.h"
#include "app/solve/reeb_solver.h"
#include "app/solve/removal_solver.h"
#include "app/solve/skeleton_solver.h"

#include "Meshes_of_soups.h"
#include "Temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace test_htloops_scenes {

using htl_scene::Scene;
using htloops::Mesh;

double area(const htl_scene::Surface& surface, const htl_scene::Triangle& triangle) {
  const auto vertex = [&](int i) {
    const auto& [x, y, z] = surface.points[triangle[i]];
    return htloops::Point(x, y, z);
  };
  return std::sqrt(CGAL::squared_area(vertex(0), vertex(1), vertex(2)));
}

// A mesh, and its handles without those that are refused or left.
class Removal : public testing::TestWithParam<Recipe>
{
protected:
  htloops::Removal_answer removed(const htloops::Removal_options& options) const {
    htloops::Progress told;
    return htloops::remove_handles(mesh_, answer_.pairs, options, told);
  }

  htloops::Answer found() const {
    htloops::Answer answer;
    answer.pairs = find_loops(mesh_);
    return answer;
  }

  Scene scene_of(const htloops::Removal_answer& removal, bool is_dry_run = false) const {
    const htloops::Pair_listing listing = list_removals(list_pairs(mesh_, answer_), removal.report);
    const std::string summary = htloops::summary(removal.report, is_dry_run);
    return htloops::scene_of_removal({}, {"mesh.off",
                                          {"--pairs ", ""},
                                          mesh_,
                                          answer_.pairs,
                                          listing,
                                          removal,
                                          summary,
                                          is_dry_run,
                                          htloops::Unit::MILLIMETER});
  }

  const Mesh mesh_ = mesh_of<Mesh>(GetParam());
  const htloops::Answer answer_ = found();
};

// Of those that were removed together, the areas are shared out, and one has the part.
TEST_P(Removal, RowsHaveTheirCaps) {
  const htloops::Removal_answer removal = removed({});
  ASSERT_FALSE(removal.report.removed.empty());
  const Scene scene = scene_of(removal);
  const htl_scene::Table& table = scene.table;
  ASSERT_EQ(table.parts.size(), table.rows.size());
  std::map<std::size_t, double> told, shown;
  std::map<std::size_t, const htloops::Removed_handle*> by_pair;
  for(const htloops::Removed_handle& handle : removal.report.removed)
    by_pair[handle.pair] = &handle;
  for(std::size_t row = 0; row < removal.report.removed.size(); ++row)
    told[table.parts[row]] += by_pair.at(table.numbers[row])->area;
  const htl_scene::Surface& after = scene.surfaces[1];
  ASSERT_EQ(after.triangle_parts.size(), after.triangles.size());
  for(std::size_t t = 0; t < after.triangles.size(); ++t) {
    const std::size_t part = after.triangle_parts[t];
    ASSERT_LT(part, after.part_colours.size());
    EXPECT_EQ(after.part_colours[part], part == 0 ? scene.surface_colour : htloops::colour_of_caps);
    if(part != 0)
      shown[part] += area(after, after.triangles[t]);
  }
  ASSERT_EQ(told.size(), shown.size());
  for(const auto& [part, sum] : told)
    EXPECT_NEAR(shown.at(part) / sum, 1., 0.02) << part;
}

TEST_P(Removal, SaysWhatWasDone) {
  htloops::Removal_options options;
  EXPECT_EQ(scene_of(removed(options)).title, "Handles removed from mesh.off");
  EXPECT_EQ(scene_of(removed(options), true).title, "Handles that would be removed from mesh.off");
  options.pairs = std::vector<std::size_t>();
  const Scene none = scene_of(removed(options)), dry = scene_of(removed(options), true);
  EXPECT_EQ(none.title, "Nothing removed from mesh.off");
  EXPECT_EQ(dry.title, "Nothing would be removed from mesh.off");
  for(const Scene* scene : {&none, &dry}) {
    EXPECT_TRUE(scene->patches.empty());
    EXPECT_TRUE(scene->table.rows.empty());
    EXPECT_NE(scene->table.empty, "");
  }
}

// What is taken away and what is put in have a column each, without a sign.
TEST_P(Removal, TellsVolumesWithoutSigns) {
  const htloops::Removal_answer removal = removed({});
  const Scene scene = scene_of(removal);
  double volume = 0., told = 0.;
  for(const htloops::Removed_handle& handle : removal.report.removed)
    volume += handle.volume;
  for(std::size_t i = 0; i < scene.table.columns.size(); ++i) {
    const std::string& name = scene.table.columns[i].name;
    if(name == "removes" || name == "adds")
      for(const auto& row : scene.table.rows) {
        EXPECT_NE(row[i].substr(0, 1), "-");
        told += (name == "adds" ? -1. : 1.) * (row[i].empty() ? 0. : std::stod(row[i]));
      }
  }
  EXPECT_NEAR(told, volume, 1e-3 * std::abs(volume));
  EXPECT_NE(told, 0.);
}

// Loops of handles that are gone are seen on the mesh as it was alone.
TEST_P(Removal, KeepsLoopsWhereTheyAre) {
  const htloops::Removal_answer removal = removed({});
  const Scene scene = scene_of(removal);
  std::size_t gone = 0;
  for(const htl_scene::Line& line : scene.lines)
    gone += line.surface == 0;
  EXPECT_EQ(scene.lines.size(),
            2 * (removal.report.removed.size() + removal.report.refused.size()));
  EXPECT_GE(gone, 2 * removal.report.removed.size());
  for(const htl_scene::Line& line : scene.lines)
    EXPECT_TRUE(line.surface == 0 || line.row >= removal.report.removed.size());
}

TEST_P(Removal, IsDrawnLargeBeforeAndAfter) {
  if(!htloops::has_pictures)
    GTEST_SKIP() << "no pictures here";
  const Scene scene = scene_of(removed({}));
  const Temporary_folder folder;
  htloops::Picture_options options;
  options.size = {300., 100.};
  const auto content = [&](std::optional<std::size_t> pair) {
    options.file = folder.path("a.png");
    options.closeup = pair;
    export_picture(options, scene);
    return folder.read("a.png");
  };
  const std::string whole = content({}), first = content(scene.table.numbers[0]),
                    second = content(scene.table.numbers[1]);
  for(const std::string& picture : {whole, first, second})
    EXPECT_EQ(picture.substr(16, 8), std::string("\0\0\1\54\0\0\0\144", 8)) << "300 x 100";
  EXPECT_NE(whole, first);
  EXPECT_NE(first, second);
  try {
    content(12345);
    FAIL() << "there is no such pair";
  } catch(const htloops::Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find("--closeup: pair 12345 is not one of those"),
              std::string::npos);
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes,
                         Removal,
                         testing::Values(Recipe{"multi-torus", {6000, 4, 0}},
                                         Recipe{"gyroid", {9000, 9, 1}},
                                         Recipe{"plates", {9000, 12, 0}},
                                         Recipe{"foam", {12000, 15, 0}}));

void expect_explanations(const Scene& scene) {
  EXPECT_FALSE(scene.table.columns.empty());
  for(const htl_scene::Column& column : scene.table.columns)
    EXPECT_GT(column.explanation.size(), column.name.size()) << column.name;
}

std::string legend_of(const Scene& scene) {
  std::string legend;
  for(std::size_t group = 0; group < scene.groups.size(); ++group)
    if(std::any_of(scene.lines.begin(), scene.lines.end(),
                   [&](const htl_scene::Line& line) { return line.group == group; }))
      legend += scene.groups[group].name + "\n";
  return legend;
}

class Explained_scenes : public testing::Test
{
protected:
  const Mesh mesh_ = mesh_of<Mesh>(Recipe{"multi-torus", {3000, 2, 0}});
  htloops::Progress told_;
};

TEST_F(Explained_scenes, LoopsWithAllThatIsKnownOfThem) {
  htloops::Answer answer;
  answer.pairs = find_loops(mesh_);
  answer.measures = htloops::find_measures(mesh_, answer.pairs, told_);
  answer.costs = htloops::find_costs(mesh_, answer.pairs, told_);
  const Scene scene =
      htloops::scene_of_loops({}, "a.off", mesh_, answer, htloops::list_pairs(mesh_, answer), "");
  EXPECT_EQ(scene.table.columns.size(), 17u);
  expect_explanations(scene);
  answer.throats.are_wanted = true;
  expect_explanations(htloops::scene_of_loops({}, "a.off", mesh_, answer, {}, ""));
}

TEST_F(Explained_scenes, ReebGraphs) {
  htloops::Reeb_options options;
  options.do_draw_inside = true;
  const htloops::Reeb_answer answer = htloops::find_reeb_graph(mesh_, options, told_);
  const Scene scene = htloops::scene_of_reeb_graph({}, "a.off", mesh_, answer,
                                                   htloops::list_arcs(mesh_, answer), "");
  expect_explanations(scene);
  const std::string legend = legend_of(scene);
  EXPECT_NE(legend.find("joints (saddles)\n"), std::string::npos) << legend;
  EXPECT_NE(legend.find("arcs on cycles\n"), std::string::npos) << legend;
}

TEST_F(Explained_scenes, Skeletons) {
  const htloops::Skeleton_answer answer = htloops::find_skeleton(mesh_, {}, told_);
  const Scene scene = htloops::scene_of_skeleton({}, "a.off", mesh_, answer, "");
  expect_explanations(scene);
  const std::string legend = legend_of(scene);
  EXPECT_NE(legend.find("joints\n"), std::string::npos) << legend;
  EXPECT_EQ(legend.find("bone"), std::string::npos) << legend;
}

// A knotted tube cannot be filled.
TEST(Refused_removal, LeavesLoopsOnBothSurfaces) {
  const Mesh mesh = mesh_of<Mesh>(Recipe{"knot", {1500, 1, 0}});
  htloops::Answer answer;
  answer.pairs = find_loops(mesh);
  htloops::Removal_options options;
  options.method = htloops::Removal_method::FILL;
  htloops::Progress told;
  const htloops::Removal_answer removal =
      htloops::remove_handles(mesh, answer.pairs, options, told);
  ASSERT_EQ(removal.report.refused.size(), 1u);
  const std::string summary = htloops::summary(removal.report);
  const Scene scene =
      htloops::scene_of_removal({}, {"knot.off",
                                     {"--pairs ", ""},
                                     mesh,
                                     answer.pairs,
                                     list_removals(list_pairs(mesh, answer), removal.report),
                                     removal,
                                     summary});
  EXPECT_EQ(scene.title, "Nothing removed from knot.off");
  ASSERT_EQ(scene.lines.size(), 2u);
  for(const htl_scene::Line& line : scene.lines)
    EXPECT_EQ(line.surface, htl_scene::every_surface);
  EXPECT_EQ(scene.table.parts, std::vector<std::size_t>{htl_scene::no_part});
  EXPECT_EQ(scene.table.columns.back().name, "why not");
  expect_explanations(scene);
  EXPECT_NE(scene.table.rows[0].back(), "");
}

} // namespace test_htloops_scenes
