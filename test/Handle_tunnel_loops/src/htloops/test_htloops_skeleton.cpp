#include "app/draw/skeletons.h"
#include "app/draw/tints.h"

#include "Meshes_of_soups.h"
#include "Temporary_folder.h"

#include "app/failure.h"
#include "app/write/documents.h"
#include "app/write/skeleton_formats.h"
#include "app/write/tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_htloops_skeleton {

using namespace htloops;
using htloops::Mesh;

std::size_t add_point(Skeleton_graph& graph, const Point& point, double radius) {
  const std::size_t v = add_vertex(graph);
  graph[v].point = point;
  graph[v].radius = radius;
  return v;
}

// A square 0-1-2-3 with a limb 1-4-5 and another 1-6, in component 1 a triangle 7-8-9, in component
// 2 a lone point 10.
Skeleton_answer small_skeleton() {
  Skeleton_answer answer;
  Skeleton_graph& graph = answer.graph;
  for(const auto& [x, y] :
      {std::pair(0., 0.), std::pair(3., 0.), std::pair(3., 3.), std::pair(0., 3.),
       std::pair(5., 0.), std::pair(5., -1. / 3.), std::pair(3., -3.), std::pair(10., 0.),
       std::pair(11., 0.), std::pair(10., 1.), std::pair(20., 0.)})
    add_point(graph, Point(x, y, 0.1), 1. / (1. + double(num_vertices(graph))));
  for(const auto& [a, b] :
      {std::pair(0, 1), std::pair(2, 1), std::pair(2, 3), std::pair(3, 0), std::pair(1, 4),
       std::pair(4, 5), std::pair(6, 1), std::pair(7, 8), std::pair(8, 9), std::pair(9, 7)})
    add_edge(std::size_t(a), std::size_t(b), graph);
  graph[6].is_inlet = true;
  for(const std::size_t v : {7, 8, 9})
    graph[v].component = 1;
  graph[10].component = 2;
  answer.arcs = arcs_of(graph);
  answer.statistics.genus = 2;
  answer.statistics.number_of_components = 3;
  answer.vertex_point = {0, 0, Skeleton_answer::none};
  return answer;
}

std::vector<std::vector<double>> rows_of(const std::string& text) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text);
  for(std::string line; std::getline(lines, line);) {
    if(line.empty() || line[0] == '#')
      continue;
    std::istringstream words(line);
    rows.emplace_back();
    for(std::string word; words >> word;)
      rows.back().push_back(std::stod(word));
  }
  return rows;
}

class Skeletons : public testing::Test
{
protected:
  std::string saved(const std::string& name) {
    save_skeleton(folder_.path(name), answer_, {"a.off", Json::object()});
    return folder_.read(name);
  }

  Temporary_folder folder_;
  const Skeleton_answer answer_ = small_skeleton();
};

TEST_F(Skeletons, have_arcs_between_nodes) {
  std::set<std::vector<std::size_t>> found;
  for(const Skeleton_arc& arc : answer_.arcs)
    found.insert(arc.points);
  const std::set<std::vector<std::size_t>> expected = {
      {1, 0, 3, 2, 1}, {1, 4, 5}, {1, 6}, {7, 8, 9, 7}};
  EXPECT_EQ(found, expected);
  EXPECT_EQ(number_of_cycles(answer_.graph), 2u);
  for(const Skeleton_arc& arc : answer_.arcs) {
    EXPECT_EQ(arc.is_on_cycle, arc.is_closed());
    EXPECT_EQ(arc.component, arc.points.front() == 7 ? 1u : 0u);
    if(arc.points.size() == 5) {
      EXPECT_EQ(arc.length, 12.);
      EXPECT_EQ(arc.smallest_radius, 1. / 4.);
      EXPECT_NEAR(arc.mean_radius, (1. + 1. / 2. + 1. / 3. + 1. / 4.) / 4., 1e-15);
      EXPECT_EQ(chord_of(answer_.graph, arc), 0.);
    }
  }
}

TEST_F(Skeletons, on_arcs_of_two_ways_are_cycles) {
  Skeleton_answer theta;
  for(int i = 0; i < 4; ++i)
    add_point(theta.graph, Point(i, i % 2, 0), 1.);
  for(const auto& [a, b] :
      {std::pair(0, 1), std::pair(1, 3), std::pair(0, 2), std::pair(2, 3), std::pair(0, 3)})
    add_edge(std::size_t(a), std::size_t(b), theta.graph);
  theta.arcs = arcs_of(theta.graph);
  EXPECT_EQ(theta.arcs.size(), 3u);
  EXPECT_EQ(number_of_cycles(theta.graph), 2u);
  for(const Skeleton_arc& arc : theta.arcs)
    EXPECT_TRUE(arc.is_on_cycle);
}

// Two triangles that a bridge joins, whose ends have four edges and more.
TEST_F(Skeletons, bridges_between_cycles_are_on_none) {
  Skeleton_answer glasses;
  for(int i = 0; i < 8; ++i)
    add_point(glasses.graph, Point(i, i % 3, i % 2), 1.);
  for(const auto& [a, b] :
      {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0), std::pair(3, 4), std::pair(4, 5),
       std::pair(5, 3), std::pair(0, 3), std::pair(0, 6), std::pair(0, 7)})
    add_edge(std::size_t(a), std::size_t(b), glasses.graph);
  std::size_t on_cycle = 0;
  for(const Skeleton_arc& arc : arcs_of(glasses.graph)) {
    EXPECT_EQ(arc.is_on_cycle, arc.is_closed());
    on_cycle += arc.is_on_cycle;
  }
  EXPECT_EQ(on_cycle, 2u);
}

TEST_F(Skeletons, points_have_kinds) {
  const std::vector<std::string> expected = {"bend",  "joint", "bend", "bend", "bend", "end",
                                             "inlet", "bend",  "bend", "bend", "end"};
  for(std::size_t v = 0; v < expected.size(); ++v)
    EXPECT_EQ(name_of_point(answer_.graph, v), expected[v]) << v;
}

TEST_F(Skeletons, are_trees_in_swc) {
  const std::string text = saved("a.swc");
  const auto rows = rows_of(text);
  ASSERT_EQ(rows.size(), 11u + 2u);
  std::size_t roots = 0, copies = 0;
  std::set<std::pair<double, double>> places;
  for(std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 7u);
    EXPECT_EQ(rows[i][0], double(i + 1));
    EXPECT_LT(rows[i][6], rows[i][0]); // parents come before
    roots += rows[i][6] == -1.;
    const bool is_new = places.insert({rows[i][2], rows[i][3]}).second;
    EXPECT_EQ(rows[i][1], is_new ? 0. : 7.);
    copies += !is_new;
    const std::string cut = "# cycle: " + std::to_string(i + 1) + " ";
    EXPECT_EQ(text.find(cut) != std::string::npos, !is_new);
  }
  EXPECT_EQ(roots, 3u);
  EXPECT_EQ(copies, 2u);
}

TEST_F(Skeletons, have_numbers_that_read_back_as_themselves) {
  const std::string obj = saved("a.obj");
  std::istringstream words(obj.substr(obj.find("v 5 -")));
  std::string v;
  double x, y, z;
  words >> v >> x >> y >> z;
  EXPECT_EQ(y, -1. / 3.);
  EXPECT_EQ(z, 0.1);
  EXPECT_NE(obj.find("\np 11\n"), std::string::npos);
  EXPECT_NE(obj.find("\nl 8 9 10 8\n"), std::string::npos);
  EXPECT_NE(obj.find("\nl 2 5 6\n"), std::string::npos);
}

TEST_F(Skeletons, are_cells_in_vtp) {
  const std::string vtp = saved("a.vtp");
  for(const char* part : {"NumberOfPoints=\"11\" NumberOfVerts=\"1\" NumberOfLines=\"4\"",
                          "Name=\"MaximumInscribedSphereRadius\"", "<Verts>", "<Lines>",
                          "\n7 8 9 7\n", "Name=\"Arc\" format=\"ascii\">\n-1\n0\n1\n2\n3\n<"})
    EXPECT_NE(vtp.find(part), std::string::npos) << part;
}

TEST_F(Skeletons, are_graphs_of_all_points) {
  const std::string graphml = saved("a.graphml"), dot = saved("a.dot");
  const auto count = [](const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for(std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at)
      ++n;
    return n;
  };
  EXPECT_EQ(count(graphml, "<node "), 11u);
  EXPECT_EQ(count(graphml, "<edge "), 10u);
  EXPECT_EQ(count(graphml, "<data key=\"inlet\">true"), 1u);
  EXPECT_EQ(count(dot, " -- "), 10u);
}

TEST_F(Skeletons, have_a_row_for_each_arc) {
  const std::string csv = saved("a.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  EXPECT_NE(csv.find(",1,joint,6,inlet\n"), std::string::npos);
  EXPECT_NE(csv.find(",,1,7,bend,7,bend\n"), std::string::npos); // no tortuosity
  const std::string table = table_of_arcs(answer_, true);
  EXPECT_NE(table.find("joint 1"), std::string::npos);
  EXPECT_LT(table.find("bend 7"), table.find("end 5")); // of length 3.4 and 2.3
}

// The nodes 1, 5, 6, 7 and 10, and then what is within arcs: 0, 3, 2; 4; 8, 9.
TEST_F(Skeletons, are_nodes_and_arcs_in_json) {
  Skeleton_answer answer = answer_;
  answer.statistics.certificate.edges_outside = {{{5, 4}, 7}, {{0, 1}, {}}};
  save_skeleton(folder_.path("a.json"), answer, {"a.off", Json::object()});
  const Json json = Json::parse(folder_.read("a.json"));
  std::vector<std::string> kinds;
  for(const Json& node : json["nodes"]) {
    EXPECT_EQ(node["id"], kinds.size());
    kinds.push_back(node["kind"]);
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"joint", "end", "inlet", "bend", "end"}));
  std::vector<std::vector<int>> arcs;
  for(const Json& arc : json["arcs"]) {
    arcs.push_back({arc["source"], arc["target"], int(arc["polyline"].size())});
    EXPECT_EQ(arc["polyline"].front(), json["nodes"][arcs.back()[0]]["position"]);
    EXPECT_EQ(arc["polyline"].back(), json["nodes"][arcs.back()[1]]["position"]);
    EXPECT_EQ(arc["radii"].size(), arc["polyline"].size());
  }
  EXPECT_EQ(arcs, (std::vector<std::vector<int>>{{0, 0, 5}, {0, 1, 3}, {0, 2, 2}, {3, 3, 4}}));
  EXPECT_EQ(json["vertex_point"], Json({5, 5, nullptr}));
  EXPECT_EQ(json["certificate"]["edges_outside"], Json({{0, 0}, {1, 1}}));
}

TEST_F(Skeletons, are_summed_up_with_what_is_proved) {
  Skeleton_answer answer = small_skeleton();
  Skeleton_certificate& certificate = answer.statistics.certificate;
  certificate.connected = certificate.inside = certificate.embedded = certificate.basis = true;
  EXPECT_NE(summary(answer, 0.)
                .find("genus 2 in 3 components: 4 arcs, 2 cycles, 1 joint, 2 ends, "
                      "1 inlet\ncertified: all 10 edges lie inside"),
            std::string::npos)
      << summary(answer, 0.);
  certificate.inside = false;
  certificate.edges_outside = {{{1, 4}, 7}};
  certificate.failure = "edge 1-4 leaves through face 7";
  EXPECT_NE(summary(answer, 0.)
                .find("not certified:\n  edge 1-4 leaves through face 7\n"
                      "9 of 10 edges lie inside\n"),
            std::string::npos)
      << summary(answer, 0.);
}

TEST_F(Skeletons, other_formats_are_refused) {
  for(const char* name : {"a.txt", "a.png", "swc"}) {
    EXPECT_THROW(check_skeleton_lines_format(name), Failure) << name;
    EXPECT_THROW(saved(name), Failure) << name;
  }
  EXPECT_THROW(check_skeleton_graph_format("a.swc"), Failure);
}

TEST(Tints, differ_between_neighbours) {
  constexpr std::size_t count = 60;
  std::vector<std::pair<std::size_t, std::size_t>> neighbours; // a grid with diagonals
  for(std::size_t i = 0; i < count; ++i)
    for(const std::size_t step : {1, 6, 7})
      if(i + step < count)
        neighbours.emplace_back(i + step, i);
  const std::vector<Colour> tints = tints_of(count, neighbours);
  for(const auto& [a, b] : neighbours)
    EXPECT_NE(tints[a], tints[b]);
  EXPECT_LE(std::set<Colour>(tints.begin(), tints.end()).size(), 4u);
  for(const Colour& tint : tints)
    EXPECT_GT(tint[0] + tint[1] + tint[2], 3 * 200);
  EXPECT_EQ(tints_of(1, {}), std::vector<Colour>{plain_tint});
}

// All of so many parts are neighbours.
TEST(Tints, are_more_where_needed) {
  for(const std::size_t count : {4, 5, 6, 9}) {
    std::vector<std::pair<std::size_t, std::size_t>> neighbours;
    for(std::size_t i = 0; i < count; ++i)
      for(std::size_t j = 0; j < i; ++j)
        neighbours.emplace_back(j, i);
    const std::vector<Colour> tints = tints_of(count, neighbours);
    EXPECT_EQ(std::set<Colour>(tints.begin(), tints.end()).size(),
              (std::min)(count, std::size_t(6)));
  }
}

TEST(Surfaces_of_labels, are_the_surface_itself_cut) {
  const Mesh mesh = mesh_of<Mesh>(Recipe{"torus", {500, 1, 0}});
  std::vector<std::size_t> labels;
  for(const Mesh::Vertex_index v : mesh.vertices())
    labels.push_back(v.idx() % 7 < 2 ? 0 : v.idx() % 3);
  const Arc_surface surface = surface_of_labels(mesh, labels);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> passes;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    for(int i = 0; i < 3; ++i) {
      const std::uint32_t a = surface.triangles[t][i], b = surface.triangles[t][(i + 1) % 3];
      ++passes[{a, b}];
      if(a < labels.size()) {
        EXPECT_EQ(surface.triangle_arcs[t], labels[a]);
      }
    }
  for(const auto& [edge, count] : passes) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(passes.count({edge.second, edge.first}), 1u);
  }
}

} // namespace test_htloops_skeleton
