// What cleaning makes of meshes with something wrong: a closed solid, of what was there, as CGAL
// sees it. Where nothing is wrong nothing changes.

#include "Mesh_corpus.h"
#include "Meshes_of_soups.h"

#include "app/clean/soup_cleaning.h"
#include "app/failure.h"
#include "app/mend/mesh_reader.h"
#include "app/read/soup_diagnosis.h"
#include "app/solve/details.h"
#include "generators/generators.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace test_htloops_cleaning {

namespace PMP = CGAL::Polygon_mesh_processing;
using htloops::Changeable_copy;
using htloops::Clean_options;
using htloops::Clean_record;
using htloops::Clean_step;
using htloops::Cleaned_soup;
using htloops::nothing_before;

Soup recipe(const char* kind, std::size_t faces, std::size_t genus, std::size_t necks = 1) {
  Recipe recipe;
  recipe.kind = kind;
  recipe.request.faces = faces;
  recipe.request.genus = genus;
  recipe.request.necks = necks;
  return soup_of(recipe);
}

Soup sphere(double radius, const std::array<double, 3>& centre, std::size_t faces = 320) {
  Soup soup = recipe("sphere", faces, 0);
  for(auto& p : soup.points)
    for(double& x : p)
      x *= radius;
  return generators::translated(soup, centre);
}

htloops::Soup as_read(const Soup& soup) {
  htloops::Soup read;
  for(const auto& [x, y, z] : soup.points)
    read.points.emplace_back(x, y, z);
  for(const auto& triangle : soup.triangles)
    read.add_face(triangle);
  return read;
}

Clean_options without(std::initializer_list<Clean_step> steps) {
  Clean_options options;
  for(const Clean_step step : steps)
    options.steps.reset(static_cast<std::size_t>(step));
  return options;
}

const Clean_record& record_of(const Cleaned_soup& cleaned, Clean_step step) {
  const auto found = std::find_if(cleaned.records.begin(), cleaned.records.end(),
                                  [&](const Clean_record& r) { return r.step == step; });
  if(found == cleaned.records.end())
    throw std::logic_error("a step has no record");
  return *found;
}

std::size_t number_of_crossings(const htloops::Mesh& mesh) {
  std::vector<std::pair<htloops::Changeable_mesh::Face_index, htloops::Changeable_mesh::Face_index>>
      pairs;
  PMP::self_intersections(Changeable_copy(mesh).mesh, std::back_inserter(pairs));
  return pairs.size();
}

// Whatever it is: what is there was there before, where it is now.
void expect_origins(const Soup& before, const Cleaned_soup& cleaned) {
  ASSERT_EQ(cleaned.vertex_origins.size(), cleaned.mesh.number_of_vertices());
  for(const auto v : cleaned.mesh.vertices())
    if(const std::int64_t origin = cleaned.vertex_origins[v.idx()]; origin != nothing_before) {
      const auto& [x, y, z] = before.points[std::size_t(origin)];
      ASSERT_EQ(cleaned.mesh.point(v), htloops::Point(x, y, z));
    }
  ASSERT_EQ(cleaned.face_origins.size(), cleaned.mesh.number_of_faces());
  for(std::size_t f = 0; f < cleaned.face_origins.size(); ++f) {
    if(cleaned.face_origins[f] == nothing_before)
      continue;
    EXPECT_EQ(cleaned.face_parents[f], cleaned.face_origins[f]);
    std::array<std::int64_t, 3> found{};
    auto h = cleaned.mesh.halfedge(htloops::Mesh::Face_index(std::uint32_t(f)));
    for(std::int64_t& corner : found) {
      corner = cleaned.vertex_origins[cleaned.mesh.source(h).idx()];
      h = cleaned.mesh.next(h);
    }
    const auto& triangle = before.triangles[std::size_t(cleaned.face_origins[f])];
    std::array<std::int64_t, 3> expected = {triangle[0], triangle[1], triangle[2]};
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(found, expected);
  }
}

void expect_solid(const Cleaned_soup& cleaned) {
  const Changeable_copy copy(cleaned.mesh);
  EXPECT_TRUE(cleaned.is_closed());
  EXPECT_TRUE(CGAL::is_closed(copy.mesh));
  EXPECT_EQ(number_of_crossings(cleaned.mesh), cleaned.after.crossings);
  EXPECT_LE(cleaned.after.crossings, cleaned.before.crossings);
  EXPECT_EQ(cleaned.after.faces, cleaned.mesh.number_of_faces());
  EXPECT_EQ(cleaned.after.vertices, cleaned.mesh.number_of_vertices());
  EXPECT_NEAR(cleaned.after.volume, PMP::volume(copy.mesh), 1e-9 * cleaned.after.volume);
  EXPECT_TRUE(cleaned.after.crossings > 0 || PMP::does_bound_a_volume(copy.mesh));
  EXPECT_GT(cleaned.after.volume, 0.);
}

void expect_solid(const Soup& before, const Cleaned_soup& cleaned) {
  expect_solid(cleaned);
  expect_origins(before, cleaned);
}

Cleaned_soup cleaned(const Soup& soup, const Clean_options& options = {}) {
  htloops::Progress progress;
  return htloops::clean(as_read(soup), options, std::nullopt, progress);
}

TEST(Cleaning, leaves_what_is_sound) {
  for(const Soup& soup : {recipe("torus", 600, 1), recipe("gyroid", 8000, 6)}) {
    const Cleaned_soup result = cleaned(soup);
    expect_solid(soup, result);
    ASSERT_EQ(result.mesh.number_of_faces(), soup.triangles.size());
    for(std::size_t f = 0; f < soup.triangles.size(); ++f)
      EXPECT_EQ(result.face_origins[f], std::int64_t(f));
    for(const Clean_record& record : result.records)
      EXPECT_EQ(record.count, 0u) << name_of(record.step);
    EXPECT_EQ(record_of(result, Clean_step::HANDLES).left.size(), 1u);
  }
}

TEST(Cleaning, closes_channels_and_drops_the_inner_wall) {
  for(const std::size_t channels : {1, 3}) {
    const Soup soup = recipe("hollow", 60000, 0, channels);
    Clean_options options;
    options.channel_length = {0.1, true};
    const Cleaned_soup result = cleaned(soup, options);
    expect_solid(soup, result);
    EXPECT_EQ(record_of(result, Clean_step::CHANNELS).count, channels);
    EXPECT_EQ(record_of(result, Clean_step::SHELLS).count, 1u);
    EXPECT_EQ(result.after.parts, 1u);
    EXPECT_EQ(result.after.genus, 0u);
    EXPECT_GT(result.after.volume, 2. * result.before.volume);
  }
}

// The ball is so far away that the channels are short, beside the diagonal.
TEST(Cleaning, fills_large_hollows_only_if_that_is_asked_for) {
  const Soup soup =
      generators::joined({recipe("hollow", 60000, 0, 2), sphere(1., {20., 0., 0.}, 1280)});
  const Cleaned_soup left = cleaned(soup);
  EXPECT_EQ(left.mesh.number_of_faces(), soup.triangles.size());
  EXPECT_EQ(record_of(left, Clean_step::CHANNELS).count, 0u);
  ASSERT_EQ(record_of(left, Clean_step::CHANNELS).left.size(), 1u);
  const std::string& words = record_of(left, Clean_step::CHANNELS).left.front();
  EXPECT_NE(words.find("2 channels"), std::string::npos) << words;
  EXPECT_NE(words.find("use --channels 3% to do it"), std::string::npos) << words;
  Clean_options dry;
  dry.is_dry_run = true;
  EXPECT_EQ(cleaned(soup, dry).after.volume, left.after.volume);
  Clean_options sure, asked;
  sure.is_sure = true;
  asked.channel_length = {0.03, true};
  for(const Clean_options& options : {sure, asked}) {
    const Cleaned_soup filled = cleaned(soup, options);
    expect_solid(soup, filled);
    EXPECT_EQ(record_of(filled, Clean_step::SHELLS).count, 1u);
    EXPECT_EQ(filled.after.parts, 2u);
    EXPECT_GT(filled.after.volume, left.after.volume + 1.);
  }
}

TEST(Cleaning, keeps_the_hollow_with_drains_of_a_case) {
  const auto file = mesh_corpus() / "cases" / "hollow200_drains2mm.stl";
  if(!std::filesystem::exists(file))
    GTEST_SKIP() << "there are no meshes in " << mesh_corpus();
  constexpr double volume = 470452.;
  htloops::Progress progress;
  Clean_options options;
  const auto volume_after = [&] {
    return htloops::clean(htloops::read_whole_soup(file.string()), options, std::nullopt, progress)
        .after.volume;
  };
  EXPECT_NEAR(volume_after(), volume, 1e-6 * volume);
  options.channel_length = {0.03, true};
  EXPECT_GT(volume_after(), 10. * volume);
}

// A wall amid solid goes; a hollow, and what is in it, if it is small, or if that is asked for.
TEST(Cleaning, drops_shells_that_bound_a_large_hollow_only_if_that_is_asked_for) {
  const Soup outer = sphere(1., {0., 0., 0.}, 1280), inner = sphere(0.5, {0.1, 0., 0.}),
             ball = sphere(0.2, {0.1, 0., 0.}), wall = sphere(0.1, {-0.7, 0., 0.});
  const Soup soup = generators::joined({outer, generators::reversed(inner), ball, wall});
  const Cleaned_soup left = cleaned(soup);
  expect_solid(soup, left);
  EXPECT_EQ(record_of(left, Clean_step::SHELLS).count, 1u);
  ASSERT_EQ(record_of(left, Clean_step::SHELLS).left.size(), 1u);
  const std::string& words = record_of(left, Clean_step::SHELLS).left.front();
  EXPECT_NE(words.find("2 shells"), std::string::npos) << words;
  EXPECT_NE(words.find("use --yes"), std::string::npos) << words;
  EXPECT_EQ(left.after.parts, 3u);
  Clean_options sure;
  sure.is_sure = true;
  EXPECT_EQ(cleaned(soup, sure).after.parts, 1u);
  const Cleaned_soup small =
      cleaned(generators::joined({outer, generators::reversed(sphere(0.3, {0.1, 0., 0.}))}));
  EXPECT_EQ(small.after.parts, 1u);
  // Of four walls around a hollow two are amid solid.
  const Soup reversed_walls = generators::reversed(
      generators::joined({sphere(0.6, {0., 0., 0.}), sphere(0.5, {0., 0., 0.})}));
  const Cleaned_soup doubled =
      cleaned(generators::joined({outer, sphere(0.9, {0., 0., 0.}, 1280), reversed_walls}));
  expect_solid(doubled);
  EXPECT_EQ(doubled.after.parts, 2u);
  EXPECT_LT(doubled.after.volume, small.after.volume - 0.3);
}

TEST(Cleaning, tells_of_channels_that_are_too_wide) {
  const Soup soup = recipe("hollow", 60000, 0, 2);
  Clean_options options;
  options.channel_length = {0.03, true};
  const Cleaned_soup result = cleaned(soup, options);
  const Clean_record& record = record_of(result, Clean_step::CHANNELS);
  EXPECT_EQ(record.count, 0u);
  ASSERT_EQ(record.left.size(), 1u);
  EXPECT_NE(record.left.front().find("2 channels"), std::string::npos) << record.left.front();
  EXPECT_EQ(result.mesh.number_of_faces(), soup.triangles.size());
}

TEST(Cleaning, keeps_the_hollow_if_it_is_told_to) {
  const Soup soup = recipe("hollow", 60000, 0, 2);
  Clean_options options = without({Clean_step::SHELLS});
  options.channel_length = {0.1, true};
  const Cleaned_soup result = cleaned(soup, options);
  expect_solid(soup, result);
  EXPECT_EQ(result.after.parts, 2u);
  EXPECT_NEAR(result.after.volume, result.before.volume, 0.01 * result.before.volume);
}

TEST(Cleaning, drops_small_parts_that_touch_nothing) {
  const Soup soup = generators::joined({sphere(1., {0., 0., 0.}, 5120), sphere(0.02, {1.5, 0., 0.}),
                                        sphere(0.02, {1., 0., 0.}), sphere(0.5, {0., 3., 0.})});
  const Cleaned_soup result = cleaned(soup);
  expect_solid(soup, result);
  EXPECT_EQ(record_of(result, Clean_step::FLOATERS).count, 1u);
  EXPECT_EQ(record_of(result, Clean_step::FLOATERS).left.size(), 1u);
  EXPECT_EQ(result.after.parts, 3u);
  EXPECT_EQ(cleaned(soup, without({Clean_step::FLOATERS})).after.parts, 4u);
  Clean_options coarse;
  coarse.floater_share = 0.2;
  EXPECT_EQ(cleaned(soup, coarse).after.parts, 2u);
}

// Many small parts are no crumbs: all of them stay, as nothing tells which are.
TEST(Cleaning, keeps_small_parts_that_are_much_together) {
  std::vector<Soup> balls;
  for(int i = 0; i < 12; ++i)
    for(int j = 0; j < 12; ++j)
      balls.push_back(sphere(0.4, {double(i), double(j), 0.}, 80));
  Clean_options options;
  options.floater_share = 0.01;
  const Cleaned_soup result = cleaned(generators::joined(balls), options);
  EXPECT_EQ(result.after.parts, balls.size());
  EXPECT_EQ(record_of(result, Clean_step::FLOATERS).left.size(), 1u);
}

// Sheets have no volume; little of them goes, much stays, and is named.
TEST(Cleaning, drops_scraps_that_cannot_be_closed) {
  for(const double size : {0.02, 3.}) {
    Soup sheet;
    sheet.points = {{2., 0., 0.}, {2. + size, 0., 0.}, {2., size, 0.}};
    sheet.triangles = {{0, 1, 2}};
    const Soup soup = generators::joined({sphere(1., {0., 0., 0.}, 1280), sheet});
    const Cleaned_soup result = cleaned(soup);
    EXPECT_EQ(result.is_closed(), size < 1.);
    EXPECT_EQ(record_of(result, Clean_step::FLOATERS).count, size < 1. ? 1u : 0u);
    EXPECT_EQ(record_of(result, Clean_step::HOLES).left.size(), size < 1. ? 0u : 1u);
    for(const Clean_record& record : result.records)
      for(const auto* texts : {&record.done, &record.left})
        for(const std::string& text : *texts)
          EXPECT_EQ(text.find("nan"), std::string::npos) << text;
  }
}

// Of a bowl without its rim both walls are closed by caps: one may not go as a shell in the other.
TEST(Cleaning, keeps_walls_that_lack_their_rim) {
  const auto bowl = [](double radius) {
    Soup soup = sphere(radius, {0., 0., 0.}, 1280);
    soup.triangles.erase(std::remove_if(soup.triangles.begin(), soup.triangles.end(),
                                        [&](const auto& triangle) {
                                          return std::any_of(
                                              triangle.begin(), triangle.end(), [&](auto v) {
                                                return soup.points[v][2] > 0.3 * radius;
                                              });
                                        }),
                         soup.triangles.end());
    return soup;
  };
  const Cleaned_soup result =
      cleaned(generators::joined({bowl(1.), generators::reversed(bowl(0.9))}));
  EXPECT_EQ(record_of(result, Clean_step::SHELLS).count, 0u);
  EXPECT_EQ(record_of(result, Clean_step::SHELLS).left.size(), 1u);
}

// Thin and wide, it has no volume to speak of.
TEST(Cleaning, keeps_small_volumes_of_large_area) {
  Soup plate = sphere(1., {0., 0., 3.}, 1280);
  for(auto& p : plate.points)
    p[2] = 3. + 1e-4 * (p[2] - 3.);
  const Soup soup = generators::joined({sphere(1., {0., 0., 0.}, 1280), plate});
  const Cleaned_soup result = cleaned(soup);
  expect_solid(soup, result);
  EXPECT_EQ(result.after.parts, 2u);
}

TEST(Cleaning, drops_what_is_inside_whatever_its_orientation) {
  for(const bool is_turned : {false, true}) {
    const Soup inner = sphere(0.5, {0.1, 0., 0.});
    const Soup soup = generators::joined({sphere(1., {0., 0., 0.}, 1280),
                                          is_turned ? generators::reversed(inner) : inner,
                                          sphere(0.2, {0.1, 0., 0.})});
    Clean_options sure;
    sure.is_sure = true;
    const Cleaned_soup result = cleaned(soup, sure);
    expect_solid(soup, result);
    EXPECT_EQ(record_of(result, Clean_step::SHELLS).count, 2u);
    EXPECT_EQ(result.after.parts, 1u);
    const Cleaned_soup whole = cleaned(soup, without({Clean_step::SHELLS}));
    expect_solid(soup, whole);
    EXPECT_EQ(record_of(whole, Clean_step::ORIENT).count, is_turned ? 0u : 1u);
    EXPECT_LT(whole.after.volume, result.after.volume);
  }
}

TEST(Cleaning, drops_copies_at_the_same_place) {
  const Soup ball = sphere(1., {0., 0., 0.}, 1280);
  Soup shuffled = generators::reversed(ball);
  std::reverse(shuffled.triangles.begin(), shuffled.triangles.end());
  for(const Soup& copy : {ball, shuffled}) {
    const Soup soup = generators::joined({ball, copy, sphere(1., {3., 0., 0.}, 1280)});
    const Cleaned_soup result = cleaned(soup);
    expect_solid(soup, result);
    EXPECT_EQ(record_of(result, Clean_step::SHELLS).count, 1u);
    EXPECT_EQ(result.after.parts, 2u);
    EXPECT_EQ(result.after.crossings, 0u);
  }
}

TEST(Cleaning, turns_over_what_is_inside_out) {
  const Soup soup =
      generators::joined({generators::reversed(recipe("torus", 600, 1)), sphere(1., {9., 0., 0.})});
  const Cleaned_soup result = cleaned(soup);
  expect_solid(soup, result);
  EXPECT_EQ(record_of(result, Clean_step::ORIENT).count, 1u);
  EXPECT_LT(cleaned(soup, without({Clean_step::ORIENT})).after.volume, result.after.volume);
}

TEST(Cleaning, closes_boundaries) {
  for(const char* kind : {"sphere", "torus"}) {
    const std::size_t genus = kind == std::string("torus") ? 1 : 0;
    const Soup soup = generators::with_holes(recipe(kind, 5120, genus), {5, 12, true});
    const Cleaned_soup result = cleaned(soup);
    expect_solid(soup, result);
    EXPECT_EQ(record_of(result, Clean_step::HOLES).count, 5u);
    EXPECT_EQ(result.before.genus, genus);
    EXPECT_EQ(result.after.genus, genus);
    EXPECT_EQ(result.after.vertices, result.before.vertices);
    EXPECT_EQ(cleaned(soup, without({Clean_step::HOLES})).after.boundaries, 5u);
  }
}

// In a vertex, which is split when the mesh is made a manifold, and is one again once they are
// closed.
TEST(Cleaning, closes_boundaries_that_touch) {
  Soup ball = sphere(1., {0., 0., 0.}, 1280);
  std::map<std::uint32_t, std::vector<std::size_t>> around;
  for(std::size_t t = 0; t < ball.triangles.size(); ++t)
    for(const auto v : ball.triangles[t])
      around[v].push_back(t);
  const auto& [centre, fan] = *std::find_if(around.begin(), around.end(),
                                            [](const auto& at) { return at.second.size() == 6; });
  const auto is_beside = [&ball, &fan = fan, &centre = centre](std::size_t t) {
    const auto& first = ball.triangles[fan.front()];
    return std::count_if(first.begin(), first.end(), [&, c = centre](auto v) {
             return v != c &&
                    std::count(ball.triangles[t].begin(), ball.triangles[t].end(), v) != 0;
           }) != 0;
  };
  std::vector<std::size_t> out = {fan.front()};
  for(const std::size_t t : fan)
    if(!is_beside(t))
      out.push_back(t); // one of those on the other side
  ASSERT_GT(out.size(), 1u);
  out.resize(2);
  std::sort(out.rbegin(), out.rend());
  for(const std::size_t t : out)
    ball.triangles.erase(ball.triangles.begin() + std::ptrdiff_t(t));
  const Cleaned_soup result = cleaned(ball);
  EXPECT_TRUE(result.is_closed());
  EXPECT_EQ(record_of(result, Clean_step::HOLES).count, 2u);
  EXPECT_EQ(result.after.crossings, 0u);
  EXPECT_EQ(result.after.parts, 1u);
  EXPECT_EQ(result.after.faces, ball.triangles.size() + 2);
  EXPECT_EQ(number_of_crossings(result.mesh), 0u);
}

// A rod through the hole is in the way of its cap.
TEST(Cleaning, leaves_boundaries_where_no_cap_fits) {
  Soup rod = sphere(1., {0., 0., 0.}, 1280);
  for(auto& p : rod.points)
    p = {0.02 * p[0], 0.02 * p[1], 2. * p[2]};
  Soup ball = sphere(1., {0., 0., 0.}, 1280);
  const auto is_at_pole = [&](const auto& triangle) {
    return std::any_of(triangle.begin(), triangle.end(),
                       [&](auto v) { return std::abs(ball.points[v][2]) > 0.95; });
  };
  ball.triangles.erase(std::remove_if(ball.triangles.begin(), ball.triangles.end(), is_at_pole),
                       ball.triangles.end());
  const Soup soup = generators::joined({ball, rod});
  const Cleaned_soup result = cleaned(soup);
  EXPECT_FALSE(result.is_closed());
  EXPECT_EQ(result.after.boundaries, 2u);
  EXPECT_EQ(result.after.crossings, 0u);
  EXPECT_EQ(record_of(result, Clean_step::HOLES).left.size(), 2u);
  expect_origins(soup, result);
}

TEST(Cleaning, keeps_crossings_and_adds_none) {
  const Soup soup =
      generators::joined({sphere(1., {0., 0., 0.}, 1280), sphere(1., {0.987, 0., 0.}, 1280)});
  const Cleaned_soup result = cleaned(soup);
  expect_solid(soup, result);
  EXPECT_GT(result.after.crossings, 0u);
  EXPECT_EQ(result.after.crossings, result.before.crossings);
  EXPECT_EQ(result.mesh.number_of_faces(), soup.triangles.size());
}

TEST(Cleaning, removes_handles_that_it_is_told_of) {
  const Soup soup = recipe("multi-torus", 6000, 3);
  Clean_options options;
  options.genus = 1;
  const Cleaned_soup result = cleaned(soup, options);
  expect_solid(soup, result);
  EXPECT_EQ(result.after.genus, 1u);
  EXPECT_EQ(record_of(result, Clean_step::HANDLES).count, 2u);
  options.genus = 7;
  EXPECT_EQ(cleaned(soup, options).after.genus, 3u);
  Clean_options noise;
  noise.noise_below = {0.5, true};
  EXPECT_THROW(cleaned(soup, noise), htloops::Failure); // which is no noise
  noise.is_sure = true;
  EXPECT_EQ(cleaned(soup, noise).after.genus, 0u);
}

std::string asked_about(const std::vector<double>& sizes, const char* text, double below) {
  try {
    htloops::check_noise(sizes, text, below, 100.);
  } catch(const htloops::Failure& failure) {
    return failure.what();
  }
  return "";
}

// Far below a length that is too much by itself.
TEST(Cleaning, asks_before_noise_is_removed_across_a_gap) {
  const std::vector<double> sizes = {0.1, 2., 0.06, 0.05, 0.11};
  EXPECT_EQ(asked_about(sizes, "1", 1.), "");
  EXPECT_EQ(asked_about({0.1, 0.3, 0.9, 2.}, "3", 3.), "");
  EXPECT_EQ(asked_about({2.}, "3", 3.), "");
  for(const auto& [text, advice] :
      {std::pair("3", "--noise-below 0.47 "), {"3%", "--noise-below 0.47% "}})
  {
    const std::string words = asked_about(sizes, text, 3.);
    for(const char* part : {"would remove 5 handles", "of 2, 0.11, 0.1, 0.06, 0.05. ",
                            "Between 0.11 and 2 ", "only the 4 below", advice, "--yes"})
      EXPECT_NE(words.find(part), std::string::npos) << part << ": " << words;
  }
}

// As of an STL whose corners were rounded.
TEST(Cleaning, welds_what_nearly_is) {
  const Soup sound = recipe("torus", 600, 1);
  Soup loose;
  for(const auto& triangle : sound.triangles)
    for(const auto v : triangle) {
      const double shift = 1e-7 * double(loose.points.size() % 3);
      loose.points.push_back(
          {sound.points[v][0] + shift, sound.points[v][1], sound.points[v][2] - shift});
    }
  for(std::uint32_t v = 0; v < loose.points.size(); v += 3)
    loose.triangles.push_back({v, v + 1, v + 2});
  const Cleaned_soup result = cleaned(loose);
  expect_solid(result);
  EXPECT_EQ(result.after.genus, 1u);
  EXPECT_EQ(result.after.parts, 1u);
  EXPECT_GT(record_of(result, Clean_step::REPAIR).count, 0u);
}

TEST(Cleaning, refuses_what_is_no_surface_if_it_may_not_repair_it) {
  Soup soup = recipe("torus", 600, 1);
  soup.triangles.push_back(soup.triangles.front());
  EXPECT_THROW(cleaned(soup, without({Clean_step::REPAIR})), htloops::Failure);
  expect_solid(soup, cleaned(soup));
}

// All of it at once, in any order.
TEST(Cleaning, makes_solids_of_what_is_thrown_together) {
  for(unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    std::vector<Soup> parts = {
        generators::with_holes(recipe("torus", 3000, 1), {3, 12, true}),
        sphere(0.01, {4., 0., 0.}),
        generators::reversed(sphere(1., {6., 0., 0.}, 1280)),
        sphere(0.3, {6., 0.1, 0.}),
        generators::with_holes(sphere(1., {0., 9., 0.}, 1280), {2, 6, true}),
        sphere(1., {0.5, 9., 0.}, 1280),
    };
    std::rotate(parts.begin(), parts.begin() + seed % parts.size(), parts.end());
    if(seed % 2 == 1)
      std::reverse(parts.begin(), parts.end());
    const Soup soup = generators::joined(parts);
    const Cleaned_soup result = cleaned(soup);
    expect_solid(soup, result);
    EXPECT_EQ(result.after.parts, 4u);
    EXPECT_EQ(result.after.genus, 1u);
  }
}

TEST(Cleaning, does_not_depend_on_the_number_of_threads) {
  const Soup soup = generators::with_holes(recipe("hollow", 60000, 1, 2), {4, 12, true});
  Clean_options options;
  options.channel_length = {0.1, true};
  options.number_of_threads = 1;
  const Cleaned_soup alone = cleaned(soup, options);
  options.number_of_threads = 2;
  const Cleaned_soup together = cleaned(soup, options);
  EXPECT_EQ(alone.mesh.points(), together.mesh.points());
  EXPECT_EQ(alone.face_origins, together.face_origins);
}

} // namespace test_htloops_cleaning
