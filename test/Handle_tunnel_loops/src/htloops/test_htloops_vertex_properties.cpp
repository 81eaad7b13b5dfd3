#include "app/read/vertex_data.h"

#include "Temporary_folder.h"

#include "app/mend/mesh_reader.h"
#include "app/solve/removal_solver.h"
#include "app/write/mesh_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace test_htloops_vertex_properties {

using namespace htloops;
using htloops::Mesh;

using Values = std::vector<double>;

const char faces[] = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const char points[4][16] = {"0 0 0", "1 0 0", "0 1.5 0", "0 0 -2e-1"};
const Values reds = {0., 50., 100., 255.};

// A tetrahedron, with something behind each of its points.
std::string off_file(const std::string& keyword, const std::string& behind) {
  std::string file = keyword + "\n4 4 6\n";
  for(int v = 0; v < 4; ++v)
    file += points[v] + (" " + std::to_string(static_cast<int>(reds[v]))) + behind + "\n";
  return file + faces;
}

std::string ply_header(const std::string& format, const std::string& more = "") {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty uchar red\nproperty float y\n"
         "property float z\nproperty short quality\n" +
         more + "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ply_file(const std::string& more_header = "", const std::string& more = "") {
  return ply_header("ascii", more_header) + "0 0 0 0 -7" + more + "\n1 50 0 0 300" + more +
         "\n0 100 1.5 0 0" + more + "\n0 255 0 -0.2 1" + more + "\n" + faces;
}

template <typename T> std::string bytes_of(T value, bool is_reversed) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(&bytes[0], &value, sizeof value);
  return is_reversed ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

// These tests run on machines that store numbers with the lowest byte first.
std::string binary_ply_file(bool is_big_endian) {
  std::string file = ply_header(is_big_endian ? "binary_big_endian" : "binary_little_endian");
  const float coordinates[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1.5f, 0}, {0, 0, -0.2f}};
  const std::int16_t qualities[4] = {-7, 300, 0, 1};
  for(int v = 0; v < 4; ++v)
    file += bytes_of(coordinates[v][0], is_big_endian) +
            bytes_of(static_cast<std::uint8_t>(reds[v]), is_big_endian) +
            bytes_of(coordinates[v][1], is_big_endian) +
            bytes_of(coordinates[v][2], is_big_endian) + bytes_of(qualities[v], is_big_endian);
  return file;
}

class Vertex_properties_test : public testing::Test
{
protected:
  Vertex_properties read(const std::string& name, const std::string& content) {
    return read_vertex_properties(folder_.write(name, content));
  }

  void expect_red_and_quality(const std::string& content) {
    const Vertex_properties properties = read("mesh.ply", content);
    ASSERT_EQ(properties.size(), 2u);
    EXPECT_EQ(properties[0].name + " " + properties[0].type, "red uchar");
    EXPECT_EQ(properties[0].values, reds);
    EXPECT_EQ(properties[1].name + " " + properties[1].type, "quality short");
    EXPECT_EQ(properties[1].values, (Values{-7., 300., 0., 1.}));
  }

  Temporary_folder folder_;
};

TEST_F(Vertex_properties_test, AreReadFromPly) {
  expect_red_and_quality(ply_file());
  expect_red_and_quality(binary_ply_file(false));
  expect_red_and_quality(binary_ply_file(true));
  EXPECT_TRUE(read("mesh.ply", ply_file("property list uchar int more\n", " 1 2")).empty());
}

TEST_F(Vertex_properties_test, AreReadFromOff) {
  for(const char* keyword : {"OFF", "COFF"}) {
    const Vertex_properties colours = read("mesh.off", off_file(keyword, " 0 9"));
    ASSERT_EQ(colours.size(), 3u);
    EXPECT_EQ(colours[0].name + " " + colours[0].type, "red uchar");
    EXPECT_EQ(colours[0].values, reds);
    EXPECT_EQ(colours[2].values, Values(4, 9.));
  }
  EXPECT_EQ(read("mesh.off", off_file("COFF", " 0 9 255")).size(), 4u);
  EXPECT_TRUE(read("mesh.off", off_file("OFF", "")).empty());
  EXPECT_TRUE(read("mesh.off", off_file("NOFF", " 0 9")).empty());
}

TEST_F(Vertex_properties_test, ComeBackWhereThereIsRoom) {
  const std::string original = folder_.write("original.ply", ply_file());
  const Mesh mesh = read_mesh(original);
  const Vertex_properties properties = read_vertex_properties(original);
  write_mesh(folder_.path("copy.ply"), mesh, kept_by_format("copy.ply", properties));
  expect_red_and_quality(folder_.read("copy.ply"));
  for(const char* other : {"copy.off", "copy.obj", "copy.stl"})
    EXPECT_TRUE(kept_by_format(other, properties).empty()) << other;

  const Vertex_properties colours = read("coloured.off", off_file("OFF", " 0 9"));
  write_mesh(folder_.path("copy.off"), mesh, kept_by_format("copy.off", colours));
  EXPECT_EQ(read_vertex_properties(folder_.path("copy.off"))[0].values, reds);
  EXPECT_EQ(folder_.read("copy.off").substr(0, 5), "COFF\n");
}

// An integer with an exponent is none.
TEST_F(Vertex_properties_test, LargeIntegersAreWrittenAsSuch) {
  const Mesh mesh = read_mesh(folder_.write("mesh.off", off_file("OFF", "")));
  const Values numbers = {99999., 100000., 1234567., -2000000000.};
  write_mesh(folder_.path("numbered.ply"), mesh, {{"number", "int", numbers}});
  EXPECT_EQ(read_vertex_properties(folder_.path("numbered.ply")).at(0).values, numbers);
  EXPECT_EQ(folder_.read("numbered.ply").find("e+"), std::string::npos);
}

TEST_F(Vertex_properties_test, SpreadToFurtherVertices) {
  const Mesh mesh = read_mesh(folder_.write("mesh.off", off_file("OFF", "")));
  Vertex_properties properties = {{"red", "uchar", {1., 2.}}, {"value", "double", {1., 2.}}};
  spread_properties({mesh, {1, 0, nothing_before, nothing_before}, {}, {}}, properties);
  EXPECT_EQ(properties[0].values, (Values{2., 1., 2., 2.}));
  EXPECT_EQ(properties[1].values, (Values{2., 1., 1.5, 1.5}));
}

TEST_F(Vertex_properties_test, WhatIsNotKeptIsNamed) {
  using Words = std::vector<std::string>;
  const std::string ply = folder_.write("mesh.ply", ply_file());
  EXPECT_EQ(unread_data(ply, {}), Words{"the vertex properties red, quality"});
  EXPECT_EQ(unread_data(ply, {{"red", "uchar", {}}}), Words{"the vertex properties quality"});
  EXPECT_TRUE(unread_data(ply, read_vertex_properties(ply)).empty());

  const std::string off = folder_.write("mesh.off", off_file("COFF", " 0 9"));
  EXPECT_EQ(unread_data(off, {}), Words{"vertex colors"});
  EXPECT_TRUE(unread_data(off, read_vertex_properties(off)).empty());
  const std::string textured = folder_.write("textured.off", off_file("STNOFF", " 0 9 0 1"));
  EXPECT_EQ(unread_data(textured, {}), (Words{"texture coordinates", "normals"}));
  const std::string plain = folder_.write("plain.off", "OFF\n1 1 0\n0 0 0\n3 0 0 0\n");
  EXPECT_TRUE(unread_data(plain, {}).empty());
  const std::string faces_only = folder_.write("faces.off", "OFF\n1 1 0\n0 0 0\n3 0 0 0 255 0 0\n");
  EXPECT_EQ(unread_data(faces_only, {}), Words{"face colors"});

  const std::string obj =
      folder_.write("mesh.obj", "mtllib a.mtl\nv 0 0 0 1 0 0\nvt 0 0\nvt 0 1\nvn 0 0 1\nf 1 1 1\n");
  EXPECT_EQ(unread_data(obj, {}),
            (Words{"materials", "vertex colors", "texture coordinates", "normals"}));
  const std::string lines = folder_.write("lines.obj", "v 0 0 0 \\\n1 0 0\nl 1 1\np 1\n");
  EXPECT_EQ(unread_data(lines, {}), (Words{"vertex colors", "lines", "points"}));
}

} // namespace test_htloops_vertex_properties
