#include "app/draw/lines.h"

#include "Small_answer.h"
#include "Temporary_folder.h"

#include "app/failure.h"
#include "app/read/input_file.h"
#include "app/read/meshes/mesh_formats.h"
#include "app/read/skeleton_reader.h"
#include "app/write/mesh_writer.h"
#include "app/write/tables.h"

#include <gtest/gtest.h>

#include <sstream>

namespace test_htloops_exports {

using namespace htloops;
using htloops::Mesh;
using htloops::Soup;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for(std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

class Exports : public testing::Test
{
protected:
  std::string exported(const std::string& name) {
    export_lines(folder_.path(name), lines_of(answer_.pairs));
    return folder_.read(name);
  }

  Temporary_folder folder_;
  const Mesh mesh_ = small_mesh();
  const Answer answer_ = small_answer(mesh_); // two pairs of loops of three points
};

TEST_F(Exports, ply_has_a_vertex_and_an_edge_for_each_point) {
  const std::string text = exported("a.ply");
  EXPECT_EQ(count_of(text, "element vertex 12\n"), 1u);
  EXPECT_EQ(count_of(text, "element edge 12\n"), 1u);
  EXPECT_EQ(count_of(text, "\n2 0\n"), 1u); // the first loop is closed
  EXPECT_EQ(count_of(text, "\n"), 14u + 12u + 12u);
}

TEST_F(Exports, obj_has_a_closed_line_for_each_loop) {
  const std::string text = exported("a.obj");
  EXPECT_EQ(count_of(text, "\nv "), 12u);
  EXPECT_EQ(count_of(text, "\no handle_"), 2u);
  EXPECT_EQ(count_of(text, "\nl 4 5 6 4\n"), 1u);
}

TEST_F(Exports, polylines_repeat_the_first_point) {
  std::istringstream lines(exported("a.polylines.txt"));
  std::string line;
  std::size_t number_of_lines = 0;
  while(std::getline(lines, line)) {
    std::istringstream words(line);
    std::size_t count;
    words >> count;
    std::vector<Point> points(count);
    for(Point& point : points)
      words >> point;
    EXPECT_TRUE(words);
    EXPECT_EQ(count, 4u);
    EXPECT_EQ(points.front(), points.back());
    ++number_of_lines;
  }
  EXPECT_EQ(number_of_lines, 4u);
}

TEST_F(Exports, vtp_has_data_for_each_line) {
  const std::string text = exported("a.vtp");
  EXPECT_EQ(count_of(text, "NumberOfPoints=\"12\""), 1u);
  EXPECT_EQ(count_of(text, "NumberOfLines=\"4\""), 1u);
  EXPECT_EQ(count_of(text, "\n4\n8\n12\n16\n"), 1u); // offsets
  EXPECT_EQ(count_of(text, "\n0\n1\n0\n1\n"), 1u);   // kinds
  EXPECT_EQ(count_of(text, "\n0\n0\n1\n1\n"), 1u);   // pairs
  EXPECT_EQ(count_of(text, "<DataArray"), count_of(text, "</DataArray>"));
}

TEST_F(Exports, vtp_of_bytes_says_the_same) {
  const auto lines = [this](const std::string& name) {
    exported(name);
    return read_skeleton(Input_file(folder_.path(name))).lines;
  };
  const Skeleton_lines text = lines("a.vtp"), bytes = lines("a.binary.vtp");
  EXPECT_EQ(folder_.read("a.vtp").find("\"binary\""), std::string::npos);
  EXPECT_NE(folder_.read("a.binary.vtp").find("\"binary\""), std::string::npos);
  EXPECT_EQ(text.points, bytes.points);
  EXPECT_EQ(text.edges, bytes.edges);
  EXPECT_EQ(bytes.edges.size(), 12u);
}

TEST_F(Exports, open_lines_do_not_come_back) {
  Exported_lines lines = {"arcs", "arc", {}};
  lines.lines.push_back(
      {{Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)}, false, {1, 2, 3}, "arc", 0, 7, 2.});
  const auto written = [&](const std::string& name) {
    export_lines(folder_.path(name), lines);
    return folder_.read(name);
  };
  EXPECT_EQ(written("b.polylines.txt"), "3 0 0 0 1 0 0 1 1 0\n");
  EXPECT_EQ(count_of(written("b.ply"), "element edge 2\n"), 1u);
  EXPECT_EQ(count_of(written("b.ply"), "\n0 1\n1 2\n"), 1u);
  EXPECT_EQ(count_of(written("b.obj"), "o arc_7\n"), 1u);
  EXPECT_EQ(count_of(written("b.obj"), "\nl 1 2 3\n"), 1u);
  EXPECT_EQ(count_of(written("b.vtp"), "\n0 1 2\n"), 1u);
  EXPECT_EQ(count_of(written("b.vtp"), "Name=\"arc\""), 1u);
}

TEST_F(Exports, other_formats_are_refused_beforehand) {
  EXPECT_NO_THROW(check_lines_format("a.polylines.txt"));
  for(const char* name : {"a.txt", "a.png", "ply", ".ply"})
    EXPECT_THROW(check_lines_format(name), Failure) << name;
  EXPECT_THROW(check_mesh_format("a.png"), Failure);
}

TEST_F(Exports, meshes_read_back_as_they_were) {
  CGAL::Handle_tunnel_loops::generators::Soup mesh;
  mesh.points = {{0., 0., 0.}, {1. / 3., 0., 0.}, {0., 1e-300, 0.}, {0., 0., 0.1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for(const char* name : {"a.off", "a.obj", "a.ply", "a.ascii.stl"}) {
    SCOPED_TRACE(name);
    write_mesh(folder_.path(name), mesh);
    const Soup soup = read_soup(folder_.path(name));
    ASSERT_EQ(soup.points.size(), 4u);
    ASSERT_EQ(soup.faces.size(), 4u);
    for(std::size_t f = 0; f < 4; ++f)
      for(std::size_t i = 0; i < 3; ++i)
        for(int k = 0; k < 3; ++k) {
          const auto& expected = mesh.points[mesh.triangles[f][i]];
          EXPECT_EQ(soup.points[soup.faces[f][i]][k], expected[static_cast<std::size_t>(k)]);
        }
  }
}

TEST_F(Exports, noise_is_decided_by_what_is_known) {
  const auto ball = [](double diameter, double error) { return Ball{diameter, error, {}, {}}; };
  Answer answer = answer_;
  answer.measures.resize(2);
  answer.measures[0].thickness = ball(0.1, 0.01); // nothing is known of its hole
  answer.measures[1].thickness = ball(0.3, 0.001);
  answer.measures[1].clear_width = ball(0.4, 0.1);
  const auto noisy = [&](double below) {
    return noisy_pairs(answer.pairs, answer.measures, below);
  };
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(noisy(0.2).below, Numbers{0});
  EXPECT_EQ(noisy(0.2).undecided, Numbers{});
  EXPECT_EQ(noisy(0.1).below, Numbers{});
  EXPECT_EQ(noisy(0.1).undecided, Numbers{0});
  EXPECT_EQ(noisy(0.3).undecided, Numbers{1});
  EXPECT_EQ(noisy(0.302).below, (Numbers{0, 1}));
  const std::string table = table_of_pairs(list_pairs(mesh_, answer), {});
  EXPECT_EQ(count_of(table, " 0.3  "), 1u) << table;
  EXPECT_EQ(count_of(table, "0.09 to 0.11"), 1u) << table;
  Listing_options options;
  options.noise_below = 0.1; // or may be
  EXPECT_EQ(list_pairs(mesh_, answer, options).size(), 1u);
}

TEST_F(Exports, a_long_table_is_abbreviated) {
  Pair_listing pairs = list_pairs(mesh_, answer_);
  EXPECT_EQ(count_of(table_of_pairs(pairs, {}), "\n"), 3u); // with the header
  EXPECT_EQ(table_of_pairs({}, {}), "");
  pairs.resize(100, pairs[0]);
  const std::string abbreviated = table_of_pairs(pairs, {});
  EXPECT_EQ(count_of(abbreviated, "... 75 more (--all-rows shows them)"), 1u);
  EXPECT_EQ(count_of(abbreviated, "\n"), 1u + 20u + 1u + 5u);
  Table_options all;
  all.show_all = true;
  EXPECT_EQ(count_of(table_of_pairs(pairs, all), "\n"), 101u);
  EXPECT_EQ(count_of(abbreviated, "\033"), 0u);
}

} // namespace test_htloops_exports
