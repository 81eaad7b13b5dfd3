// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Skeletons of other programs, and what is wrong with them.

#include "app/failure.h"
#include "app/read/skeleton_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace test_htloops_skeleton_reader {

using namespace htloops;

Skeleton_record read(const std::string& name, const std::string& content) {
  const Input_file file = Input_file::in_memory(name, content);
  EXPECT_TRUE(is_skeleton_file(file));
  return read_skeleton(file);
}

// A triangle with a limb, whose end is at a number that only all of its digits tell.
void expect_triangle_with_limb(const Skeleton_lines& lines) {
  ASSERT_EQ(lines.points.size(), 4u);
  EXPECT_EQ(lines.edges.size(), 4u);
  EXPECT_EQ(lines.points[3], Point(0.1, 1. / 3., -1e-17));
  std::array<int, 4> degree = {0, 0, 0, 0};
  for(const auto& edge : lines.edges)
    for(const std::size_t p : edge)
      ++degree[p];
  EXPECT_EQ(degree, (std::array<int, 4>{3, 2, 2, 1}));
}

const std::string limb_end = "0.1 0.33333333333333331 -1e-17";

// The same in JSON; its cycle ends at a node, and passes a point.
std::string skeleton_json(int node, const std::string& passed) {
  return R"({"format": "htloops-skeleton/1", "mesh": {"vertices": 5, "faces": 6},
      "nodes": [{"id": 0, "position": [0, 0, 0], "radius": 1, "kind": "joint"},
                {"id": 1, "position": [0.1, 0.33333333333333331, -1e-17], "radius": 1,
                 "kind": "inlet"}],
      "arcs": [{"source": 0, "target": )" +
         std::to_string(node) + R"(, "polyline": [[0, 0, 0], )" + passed +
         R"(, [0, 1, 0], [0, 0, 0]], "component": 2},
               {"source": 0, "target": 1, "component": 2,
                "polyline": [[0, 0, 0], [0.1, 0.33333333333333331, -1e-17]]}]})";
}

TEST(Skeleton_reader, KnowsAllFormats) {
  expect_triangle_with_limb(read("a.obj", "# lines\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv " + limb_end +
                                              "\nv 7 7 7\no arc_0\nl 1 2 3 1\nl -5 \\\n 4\n")
                                .lines);
  expect_triangle_with_limb(read("a.swc", "# id type x y z radius parent\n1 0 0 0 0 1 -1\n"
                                          "2 0 1 0 0 1 1\n3 0 0 1 0 1 2\n9 7 0 0 0 1 3\n4 0 " +
                                              limb_end + " 1 1\n")
                                .lines);
  expect_triangle_with_limb(
      read("a.polylines.txt", "4 0 0 0 1 0 0 0 1 0 0 0 0\n2 0 0 0 " + limb_end + "\n").lines);
  expect_triangle_with_limb(
      read("a.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\"><PolyData><Piece>"
                    "<PointData><DataArray Name=\"Inlet\" format=\"ascii\">0 0 0 1</DataArray>"
                    "</PointData><Points><DataArray type=\"Float64\" format=\"ascii\">0 0 0\n1 0 0 "
                    "0 1 0 " +
                        limb_end +
                        "</DataArray></Points><Lines><DataArray Name=\"connectivity\" "
                        "format=\"ascii\">0 1 2 0 0 3</DataArray><DataArray Name=\"offsets\" "
                        "format=\"ascii\">4 6</DataArray></Lines></Piece></PolyData></VTKFile>")
          .lines);
  // The same in base64, the numbers of points as 32 bits; headers are coded by themselves or not.
  expect_triangle_with_limb(
      read("a.vtp",
           "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\"><PolyData><Piece><Points>"
           "<DataArray type=\"Float64\" format=\"binary\">\n "
           "YAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPA/AAAAAAAAAAAAAAAAAAAAAA"
           "AAAAAAAAAAAAAAAAAA8D8AAAAAAAAAAJqZmZmZmbk/VVVVVVVV1T+X1EZG9Q5nvA=="
           "</DataArray></Points><Lines><DataArray type=\"Int32\" Name=\"connectivity\" "
           "format=\"binary\">GAAAAA==AAAAAAEAAAACAAAAAAAAAAAAAAADAAAA</DataArray>"
           "<DataArray type=\"Int64\" Name=\"offsets\" "
           "format=\"binary\">EAAAAAQAAAAAAAAABgAAAAAAAAA="
           "</DataArray></Lines></Piece></PolyData></VTKFile>")
          .lines);
  std::string nodes;
  for(const char* node : {"n0 0 0 0", "n1 1 0 0", "n2 0 1 0"}) {
    const std::string text(node);
    nodes += "<node id=\"" + text.substr(0, 2) + "\"><data key=\"d0\">" + text[3] +
             "</data><data key=\"y\">" + text[5] + "</data><data key=\"z\">" + text[7] +
             "</data></node>";
  }
  const std::string graphml =
      "<graphml><key id=\"d0\" for=\"node\" attr.name=\"x\" attr.type=\"double\"/><graph>" + nodes +
      "<node id=\"end\"><data key=\"d0\">0.1</data><data key=\"y\">0.33333333333333331</data><data "
      "key=\"z\">-1e-17</data></node>"
      "<edge source=\"n0\" target=\"n1\"/><edge source=\"n1\" target=\"n2\"/><edge source=\"n2\" "
      "target=\"n0\"/><edge source=\"end\" target=\"n0\"/></graph></graphml>";
  const Skeleton_lines graph = read("a.graphml", graphml).lines;
  expect_triangle_with_limb(graph);
  EXPECT_EQ(graph.names[3], "end");
  const Skeleton_record record = read("a.json", skeleton_json(0, "[1, 0, 0]"));
  const Skeleton_lines& lines = record.lines;
  ASSERT_EQ(lines.points.size(), 4u);
  EXPECT_EQ(lines.points[1], Point(0.1, 1. / 3., -1e-17));
  const std::vector<std::array<std::size_t, 2>> edges = {{0, 2}, {2, 3}, {3, 0}, {0, 1}};
  EXPECT_EQ(lines.edges, edges); // nodes come first
  EXPECT_EQ(record.lines.components, (std::vector<std::size_t>{2, 2, 2, 2}));
  EXPECT_EQ(record.lines.is_inlet, (std::vector<char>{0, 1, 0, 0}));
  EXPECT_EQ((*record.mesh_size)[1], 6u);
  EXPECT_FALSE(is_skeleton_file(Input_file::in_memory("a.json", R"({"format": "htloops/1"})")));
}

void expect_problem(const std::string& name, const std::string& content, const std::string& words) {
  try {
    read(name, content);
    ADD_FAILURE() << content;
  } catch(const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit_code::UNREADABLE_FILE);
    EXPECT_NE(std::string(failure.what()).find(words), std::string::npos) << failure.what();
  }
}

TEST(Skeleton_reader, SaysWhatIsWrong) {
  expect_problem("a.obj", "v 0 0 0\nv 1 0 0\nl 1 3\n", "'3' is not one of the 2 points so far");
  expect_problem("a.obj", "v 0 0 0\nv 1 0 0\n", "it has no lines");
  expect_problem("a.obj", "v 0 0\n", "a point does not have three coordinates");
  expect_problem("a.obj", "v 0 0 inf\nl 1\n", "point 1 is not finite");
  expect_problem("a.swc", "1 0 0 0 0 1 7\n", "the parent 7 of a point does not exist");
  expect_problem("a.swc", "1 0 0 0 0 1 -1\n1 0 0 0 0 1 -1\n", "appears twice");
  expect_problem("a.polylines.txt", "2 0 0 0 1 0\n", "a point does not have three coordinates");
  expect_problem("a.vtp", "<VTKFile><PolyData>", "it is not valid XML");
  expect_problem("a.vtp", "<a/>", "it is not a VTK XML file");
  expect_problem("a.vtp",
                 "<VTKFile><PolyData><Piece><Points><DataArray format=\"binary\">AAAA</DataArray>"
                 "</Points></Piece></PolyData></VTKFile>",
                 "an array has fewer bytes than declared");
  expect_problem("a.vtp", "<VTKFile><UnstructuredGrid/></VTKFile>", "it is not VTK PolyData");
  expect_problem("a.vtp",
                 "<VTKFile><PolyData><Piece><Points><DataArray format=\"appended\"></DataArray>"
                 "</Points></Piece></PolyData></VTKFile>",
                 "an array starts beyond the end of the file");
  // What follows the underscore may be any bytes.
  expect_problem("a.vtp",
                 "<VTKFile><PolyData><Piece/></PolyData><AppendedData encoding=\"raw\">_<&"
                 "</AppendedData></VTKFile>",
                 "it has no lines");
  expect_problem("a.vtp",
                 "<VTKFile compressor=\"vtkLZ4DataCompressor\"><PolyData><Piece><Points><DataArray "
                 "format=\"binary\">AAAAAA==</DataArray></Points></Piece></PolyData></VTKFile>",
                 "compression with 'vtkLZ4DataCompressor' is not supported");
  expect_problem("a.vtp",
                 "<VTKFile><PolyData><Piece><Points><DataArray type=\"String\" format=\"binary\">"
                 "AAAAAA==</DataArray></Points></Piece></PolyData></VTKFile>",
                 "numbers of the type 'String'");
  expect_problem("a.graphml", "<graphml><graph><node id=\"n0\"/></graph></graphml>",
                 "node n0 has no x");
  expect_problem("a.graphml",
                 "<graphml><graph><edge source=\"n0\" target=\"n1\"/></graph></graphml>",
                 "an edge refers to node n0, which does not exist");
  expect_problem("a.json", R"({"format": "htloops-skeleton/1"})", "no member 'nodes'");
  expect_problem("a.json", skeleton_json(2, "[1, 0, 0]"), "arcs, arc 0, target is not a node");
  expect_problem("a.json", skeleton_json(1, "[1, 0, 0]"),
                 "arc 0 has a polyline that does not reach its target");
  expect_problem("a.json", skeleton_json(0, "[1, 0]"), "is not an array of three numbers");
}

} // namespace test_htloops_skeleton_reader
