#include "app/read/input_file.h"
#include "app/read/meshes/mesh_formats.h"

#include "Mesh_corpus.h"
#include "Number_of_cases.h"
#include "Temporary_folder.h"

#include "app/failure.h"
#include "app/read/soup_diagnosis.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <set>
#include <utility>

namespace test_htloops_soup_reader {

namespace fs = std::filesystem;
using namespace htloops;
using htloops::Soup;

const char byte_order_mark[] = "\xEF\xBB\xBF";
const char points[] = "0 0 0\n1 0 0\n0 1.5 0\n0 0 -2e-1\n";
const char faces[] = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

const char obj_vertices[] = "v 0 0 0\nv 1 0 0\nv 0 1.5 0\nv 0 0 -2e-1\n";
const char obj_faces[] = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string obj_file() { return std::string(obj_vertices) + obj_faces; }

std::string off_file() { return std::string("OFF\n4 4 6\n") + points + faces; }

std::string ply_header(const std::string& format,
                       const std::string& coordinate = "double",
                       const std::string& list = "uchar int") {
  std::string header = "ply\nformat " + format + " 1.0\ncomment a tetrahedron\nelement vertex 4\n";
  for(const char* name : {"x", "y", "z"})
    header += "property " + coordinate + " " + name + "\n";
  return header + "element face 4\nproperty list " + list + " vertex_indices\nend_header\n";
}

template <typename T> std::string bytes_of(T value, bool is_reversed = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(&bytes[0], &value, sizeof value);
  return is_reversed ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

// These tests run on machines that store numbers with the lowest byte first.
std::string binary_ply_file(bool is_big_endian) {
  std::string file = ply_header(is_big_endian ? "binary_big_endian" : "binary_little_endian");
  for(const double value : {0., 0., 0., 1., 0., 0., 0., 1.5, 0., 0., 0., -0.2})
    file += bytes_of(value, is_big_endian);
  const std::int32_t vertices[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for(const auto& face : vertices) {
    file += '\3';
    for(const std::int32_t vertex : face)
      file += bytes_of(vertex, is_big_endian);
  }
  return file;
}

std::string text_stl_file() {
  std::string text = "solid name\n";
  const char* p[] = {"0 0 0", "1 0 0", "0 1.5 0", "0 0 -2e-1"};
  const int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for(const auto& triangle : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for(const int vertex : triangle)
      text += std::string("vertex ") + p[vertex] + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid name\n";
}

std::string binary_stl_file(float last_coordinate) {
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1.5f, 0}, {0, 0, last_coordinate}};
  const int triangles[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::string file = "solid, it says, and is binary";
  file.resize(80, ' ');
  file += bytes_of(std::uint32_t(4));
  for(const auto& triangle : triangles) {
    file += std::string(12, '\0');
    for(const int vertex : triangle)
      for(const float coordinate : p[vertex])
        file += bytes_of(coordinate);
    file += std::string(2, '\0');
  }
  return file;
}

class Soup_reader : public testing::Test
{
protected:
  // the tetrahedron of all these files, but for the rounding of formats that round.
  void expect_tetrahedron(const std::string& name, const std::string& content) {
    SCOPED_TRACE(name);
    const Soup soup = read_soup(folder_.write(name, content));
    ASSERT_EQ(soup.points.size(), 4u);
    ASSERT_EQ(soup.faces.size(), 4u);
    std::size_t corners_at_bottom = 0;
    for(const Soup_face& face : soup.faces) {
      ASSERT_TRUE(face.is_triangle());
      for(const std::uint32_t vertex : face)
        corners_at_bottom += std::abs(soup.points[vertex].z() + 0.2) < 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(corners_at_bottom, 3u);
  }

  void expect_failure(const std::string& name,
                      const std::string& content,
                      const std::string& words,
                      Exit_code code = Exit_code::UNREADABLE_FILE) {
    SCOPED_TRACE(name);
    try {
      read_soup(folder_.write(name, content));
      FAIL() << "it was read";
    } catch(const Failure& failure) {
      EXPECT_EQ(failure.code(), code);
      EXPECT_NE(std::string(failure.what()).find(words), std::string::npos) << failure.what();
    }
  }

  Temporary_folder folder_;
};

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  return text.replace(text.find(old), old.size(), by);
}

std::string with_crlf(const std::string& text) {
  std::string result;
  for(const char c : text)
    result += c == '\n' ? std::string("\r\n") : std::string(1, c);
  return result;
}

std::string with_cr(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '\r');
  return text;
}

std::string in_utf16(const std::string& text, bool is_big_endian) {
  std::string result = is_big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for(const char c : text)
    result += is_big_endian ? std::string({'\0', c}) : std::string({c, '\0'});
  return result;
}

TEST_F(Soup_reader, reads_lines_that_end_with_carriage_returns) {
  const std::string continued = replaced(obj_file(), "f 1 2 4", "# comment\nf 1 \\\n2 4");
  expect_tetrahedron("cr.off", with_cr("# comment\n" + replaced(off_file(), "OFF", "NOFF")));
  expect_tetrahedron("cr.obj", with_cr("# comment\n" + obj_file()));
  expect_tetrahedron("cr.obj", with_cr(continued));
  expect_tetrahedron("cr.ply", with_cr(ply_header("ascii") + points + faces));
  expect_tetrahedron("cr.stl", with_cr(text_stl_file()));
  expect_failure("a.off", with_cr(replaced(off_file(), "3 1 2 3", "3 1 2 3 x")),
                 ":9: 'x' is not a number");
  expect_failure("a.obj", with_cr(continued + "f 1 2 x\n"), ":11: 'x' is not a face corner");
  expect_failure("a.obj", with_crlf(obj_file() + "f 1 2 x\n"), ":9: 'x' is not a face corner");
}

TEST_F(Soup_reader, says_that_a_file_is_utf_16) {
  for(const bool is_big_endian : {false, true}) {
    const std::string words = "the file is UTF-16; save it as UTF-8 or ASCII";
    expect_failure("a.off", in_utf16(off_file(), is_big_endian), words);
    expect_failure("a.obj", in_utf16(obj_file(), is_big_endian), words);
    expect_failure("a.ply", in_utf16(ply_header("ascii"), is_big_endian), words);
    expect_failure("a.stl", in_utf16(text_stl_file(), is_big_endian), words);
  }
  expect_tetrahedron("binary.stl", replaced(binary_stl_file(-0.2f), "soli", "\xFF\xFE##"));
}

TEST_F(Soup_reader, reads_all_forms_of_off) {
  expect_tetrahedron("plain.off", off_file());
  expect_tetrahedron("UPPER.OFF", off_file());
  expect_tetrahedron("crlf.off", with_crlf(off_file()));
  expect_tetrahedron("no_last_line_end.off", off_file().substr(0, off_file().size() - 1));
  expect_tetrahedron("counts.off", replaced(off_file(), "OFF\n", "OFF "));
  expect_tetrahedron("no_keyword.off", replaced(off_file(), "OFF\n", "# of Geomview\n"));
  expect_tetrahedron("comments.off", "# one\n\n" + replaced(off_file(), "1 0 0\n",
                                                            "# two\n\n +1 0 0 # three\n\t\n"));
  expect_tetrahedron("face_colours.off", replaced(off_file(), "3 0 2 1", "3 0 2 1 255 0 0"));
  expect_tetrahedron("colours.off",
                     replaced(replaced(off_file(), "OFF", "COFF"), "1 0 0", "1 0 0 255 0 0 1"));
  expect_tetrahedron("normals.off", replaced(off_file(), "OFF", "NOFF"));
  expect_tetrahedron("end.off", off_file() + "\n# the end\n \t\n");
  expect_tetrahedron("end_of_dos.off", off_file() + '\x1A');
  expect_tetrahedron("byte_order_mark.off", byte_order_mark + off_file());
}

TEST_F(Soup_reader, reads_off_without_a_number_of_edges) {
  expect_tetrahedron("none.off", replaced(off_file(), "4 4 6", "4 4"));
  expect_tetrahedron("each_on_its_line.off", replaced(off_file(), "4 4 6", "4\n4\n6"));
  expect_tetrahedron("on_the_next_line.off", replaced(off_file(), "4 4 6", "4 4\n6"));
}

TEST_F(Soup_reader, reads_off_in_free_form) {
  std::string on_one_line = off_file();
  std::replace(on_one_line.begin(), on_one_line.end(), '\n', ' ');
  expect_tetrahedron("one_line.off", on_one_line);
  expect_tetrahedron("wrapped.off", replaced(replaced(off_file(), "6\n", "6 "), "1 0 0", "1\n0 0"));
  expect_failure("a.off", "C" + on_one_line, "need a line each");
}

TEST_F(Soup_reader, reads_homogeneous_off) {
  const std::string good =
      "4OFF\n4 4 6\n0 0 0 1\n2 0 0 2\n0 1.5 0 1\n0 0 -0.4 2\n" + std::string(faces);
  expect_tetrahedron("homogeneous.off", good);
  expect_failure("a.off", replaced(good, "2 0 0 2", "2 0 0"), ":4: vertex 1 does not have four");
  expect_failure("a.off", "nOFF\n3\n0 0 0\n", "of kind nOFF are not supported");
}

TEST_F(Soup_reader, reads_all_forms_of_ply) {
  expect_tetrahedron("text.ply", ply_header("ascii") + points + faces);
  expect_tetrahedron("crlf.ply", with_crlf(ply_header("ascii") + points + faces));
  expect_tetrahedron("byte_order_mark.ply", byte_order_mark + ply_header("ascii") + points + faces);
  for(const char* list : {"int uint", "uchar short", "uchar uchar", "ushort int8"})
    expect_tetrahedron("lists.ply", ply_header("ascii", "float", list) + points + faces);
  expect_tetrahedron("end.ply", ply_header("ascii") + points + faces + "\n \n");
  expect_tetrahedron("little.ply", binary_ply_file(false));
  expect_tetrahedron("filled_up.ply", binary_ply_file(false) + std::string(7, '\0'));
  expect_tetrahedron("big.ply", binary_ply_file(true));
}

TEST_F(Soup_reader, reads_strips_of_triangles_in_ply) {
  const std::string head =
      replaced(ply_header("ascii", "double", "int int"), "element face 4", "element tristrips 1") +
      points;
  for(const char* strip : {"6 0 1 2 3 0 1\n", "9 0 1 2 3 -1 2 3 0 1\n", "10 0 1 2 3 3 2 2 3 0 1\n"})
  {
    expect_tetrahedron("strips.ply", head + strip);
    const Soup soup = read_soup(folder_.write("strips.ply", head + strip));
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for(std::uint32_t h = 0; h < 12; ++h)
      EXPECT_TRUE(edges.insert({soup.source(h), soup.source(next_in_triangle(h))}).second);
  }
  expect_failure("strips.ply", head + "3 0 1 4\n", "vertex 4");
  expect_failure("strips.ply", head + "3 0 1 -2\n", "vertex -2");
}

TEST_F(Soup_reader, passes_over_what_else_is_in_a_ply_file) {
  std::string header = ply_header("ascii");
  header = replaced(header, "element vertex",
                    "element camera 1\nproperty list int int a\nelement vertex");
  header = replaced(header, "element face", "property uchar red\nelement face");
  header = replaced(header, "end_header", "property list uchar float weights\nend_header");
  expect_tetrahedron("more.ply", header + "2 7 7\n0 0 0 1\n1 0 0 2\n0 1.5 0 3\n0 0 -2e-1 4\n"
                                          "3 0 2 1 0\n3 0 1 3 1 0.5\n3 1 2 3 0\n3 2 0 3 2 1 1\n");
  const std::string integers = replaced(ply_header("ascii"), "double x", "uchar x");
  expect_tetrahedron("integers.ply", integers + points + faces);
}

TEST_F(Soup_reader, reads_both_forms_of_stl_and_merges_points) {
  const std::string text = text_stl_file();
  expect_tetrahedron("text.stl", text);
  expect_tetrahedron("binary.stl", binary_stl_file(-0.2f));
  expect_tetrahedron("more.stl", binary_stl_file(-0.2f) + "more");
  expect_tetrahedron("more.stl", binary_stl_file(-0.2f) + std::string(49, ' '));
  expect_tetrahedron("zeros.stl", replaced(text, "vertex 0 0 0", "vertex -0 0.0 -0e9"));
}

TEST_F(Soup_reader, reads_all_forms_of_text_stl) {
  const std::string text = text_stl_file();
  std::string capitals = text, on_one_line = text;
  for(char& c : capitals)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::replace(on_one_line.begin(), on_one_line.end(), '\n', ' ');
  expect_tetrahedron("capitals.stl", capitals);
  expect_tetrahedron("one_line.stl", on_one_line);
  for(const char* name : {"", " a facet of a solid", " facet", "\tsolid 1"}) {
    const std::string named = std::string("solid") + name;
    expect_tetrahedron("name.stl", replaced(text, "solid name", named));
    expect_tetrahedron("name.stl", replaced(text, "endsolid name", "end" + named));
    expect_tetrahedron("name.stl", replaced(on_one_line, "solid name", named));
    expect_tetrahedron("name.stl", replaced(on_one_line, "endsolid name", "end" + named));
  }
  expect_tetrahedron("solids_on_one_line.stl",
                     "solid endsolid solid a endsolid a " +
                         replaced(on_one_line, "endfacet", "endfacet endsolid solid 1 solid 2"));
  expect_tetrahedron("blanks.stl", "\n  \t" + text);
  expect_tetrahedron("byte_order_mark.stl", byte_order_mark + text);
  expect_tetrahedron("crlf.stl", with_crlf(text));
  expect_tetrahedron("solids.stl", replaced(text, "facet normal 0 0 0\nouter loop\nvertex 1 0 0",
                                            "endsolid\nsolid b\nfacet normal -nan 1.#IND 0\n"
                                            "outer loop\nvertex 1 0 0"));
}

TEST_F(Soup_reader, reads_obj_with_relative_indices_and_slots) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1.5 0\nv 0 0 -0.2\nvn 0 0 1\nvt 0 0\n";
  expect_tetrahedron("relative.obj", vertices + "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n");
  expect_tetrahedron("slots.obj", vertices + "o name\ng group\nf 1/1/1 3/1/1 2/1/1\n"
                                             "f 1//1 2//1 4//1\nf 2/1 3/1 4/1\nf 3 1 4\n");
}

TEST_F(Soup_reader, reads_all_forms_of_obj) {
  const std::string plain = obj_file();
  expect_tetrahedron("plain.obj", plain);
  expect_tetrahedron("byte_order_mark.obj", byte_order_mark + plain);
  expect_tetrahedron("crlf.obj", with_crlf(plain));
  expect_tetrahedron("faces_of_old.obj", replaced(plain, "f 1 2 4", "fo 1 2 4"));
  expect_tetrahedron("lines_and_points.obj", plain + "l 1 2 3\np 1\n");
  expect_tetrahedron("faces_first.obj", obj_faces + std::string(obj_vertices));
  expect_tetrahedron("colours.obj", replaced(plain, "v 1 0 0", "v 1 0 0 0.5 0.5 1"));
  std::string with_tabs = plain;
  std::replace(with_tabs.begin(), with_tabs.end(), ' ', '\t');
  expect_tetrahedron("tabs.obj", with_tabs);
}

TEST_F(Soup_reader, reads_obj_with_continued_lines) {
  const std::string file = replaced(obj_file(), "f 1 2 4", "# not continued \\\nf 1 \\\n2\\\n4");
  expect_tetrahedron("continued.obj", file);
  expect_tetrahedron("crlf.obj", with_crlf(file));
  expect_failure("a.obj", file + "f 1 2 x\n", ":12: 'x' is not a face corner");
}

TEST_F(Soup_reader, keeps_all_corners_of_polygons) {
  const std::string list = "element face 3\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string head = ply_header("ascii");
  const std::pair<const char*, std::string> files[] = {
      {"polygons.off", std::string("OFF\n4 3 0\n") + points + "4 3 2 1 0\n3 0 1 2\n5 0 1 2 3 1\n"},
      {"polygons.obj", std::string(obj_vertices) + "f 4 3 2 1\nf 1 2 3\nf -4 -3/1 3//2 4 2\n"},
      {"polygons.ply", head.substr(0, head.find("element face")) + list + points +
                           "4 3 2 1 0\n3 0 1 2\n5 0 1 2 3 1\n"}};
  for(const auto& [name, content] : files) {
    const Soup soup = read_soup(folder_.write(name, content));
    ASSERT_EQ(soup.faces.size(), 3u) << name;
    EXPECT_EQ(soup.faces[0].size(), 4u);
    EXPECT_EQ(soup.faces[0][0], 3u);
    EXPECT_EQ(soup.faces[2].size(), 5u);
    EXPECT_EQ(soup.further_corners, (std::vector<std::uint32_t>{0, 3, 1})) << name;
  }
}

TEST_F(Soup_reader, says_what_is_wrong_with_an_obj_file) {
  const std::string good = obj_file();
  expect_failure("a.obj", "# nothing\n", "neither vertices nor faces");
  expect_failure("a.obj", "\033[2J" + std::string(50, 'x'),
                 ":1: unknown OBJ keyword '?[2J" + std::string(36, 'x') + "...'");
  expect_failure("a.obj", good + "wrong\n", ":9: unknown OBJ keyword 'wrong'");
  expect_failure("a.obj", replaced(good, "v 1 0 0", "v 1 0"), ":2: a vertex does not have three");
  expect_failure("a.obj", replaced(good, "v 1 0 0", "v 1 0 0 red"), ":2: 'red' is not a number");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1 2.9 4"), ":6: '2.9' is not a face corner");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1 2 4 x"), ":6: 'x' is not a face corner");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1/x 2 4"), ":6: '1/x' is not a face corner");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1/1/1/1 2 4"), "is not a face corner");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1 2 9"),
                 ":6: face 1 uses vertex 9, but there are only 4 (numbered from 1)");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1 2 0"),
                 "face 1 uses vertex 0, but there are only 4");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1 2 -5"),
                 "face 1 uses vertex -5, but there are only 4");
  expect_failure("a.obj", replaced(good, "f 1 2 4", "f 1 2 99999999999"),
                 "uses vertex 99999999999");
}

TEST_F(Soup_reader, says_what_is_wrong_with_an_off_file) {
  expect_failure("a.off", "# nothing\n", "begins with the word OFF");
  expect_failure("a.off", "FFO 4 4 6\n" + std::string(points), ":1: an OFF file begins");
  expect_failure("a.off", "OFF BINARY\n", "binary");
  expect_failure("a.off", "OFF\n4 -4 6\n", ":2: expected the numbers");
  expect_failure("a.off", "OFF\n4 4 6\n0 0 0\n1 0\n",
                 ":4: vertex 1 does not have three coordinates");
  expect_failure("a.off", "OFF\n4 4 6\n0 0 0\n1 0 0x\n", ":4: vertex 1");
  expect_failure("a.off", replaced(off_file(), "1 0 0", "1 0 0 red"), ":4: 'red' is not a number");
  expect_failure("a.off", replaced(off_file(), "3 1 2 3", "3 1 2 3 x"), ":9: 'x' is not a number");
  expect_failure("a.off", std::string("OFF\n4 4 6\n0 0 0\n"), "only 1 of 4 vertices");
  expect_failure("a.off", "OFF\n4 4 6\n" + std::string(points) + "3 0 2 1\n",
                 "only 1 of 4 faces; the file ends here");
  expect_failure("a.off", "OFF\n4 4 6\n" + std::string(points) + "3 0 2\n",
                 ":7: face 0 ends after 2 of 3 vertices");
  expect_failure("a.off", replaced(off_file(), "3 1 2 3", "3 1 2 4"),
                 ":9: face 2 uses vertex 4, but there are only 4");
  expect_failure("a.off", replaced(off_file(), "3 1 2 3", "3 1 -2 3"), "face 2 uses vertex -2");
  expect_failure("a.off", off_file() + "\n# more\n3 0 1 2\n",
                 ":13: unexpected '3' after the last of 4 faces");
  std::string in_free_form = replaced(off_file(), "6\n", "6 ");
  in_free_form.back() = ' ';
  expect_failure("a.off", in_free_form + "more", ":9: unexpected 'more' after the last of 4 faces");
  for(const char* number : {"0x10", "-0X1p3"})
    expect_failure("a.off", replaced(off_file(), "1 0 0", std::string("1 0 ") + number),
                   ":4: vertex 1 does not have three coordinates");
  expect_failure("a.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", "only 1 of 2000000000 vertices");
}

TEST_F(Soup_reader, says_that_a_file_is_empty) {
  for(const std::string& ending : endings_of_meshes())
    expect_failure("a" + ending, "", ": the file is empty");
  expect_failure("a.json", "", "a.json: the file is empty");
}

TEST_F(Soup_reader, says_which_other_format_a_file_looks_like) {
  const auto& endings = endings_of_meshes();
  if(std::count(endings.begin(), endings.end(), ".glb") != 0)
    expect_failure("a.stl", "glTF" + std::string(80, '\0') + std::string(80, '\1'),
                   "it is not STL, but looks like GLB; try --format glb");
  expect_failure("a.obj", off_file(), "it is not OBJ, but looks like OFF; try --format off");
  expect_failure("a.off", obj_file(), ":1: an OFF file begins"); // no mark of OBJ
  expect_failure("a.off", ply_header("ascii") + points + faces, "looks like PLY; try --format ply");
  // The header of a binary STL file may begin as it likes.
  std::string binary = binary_stl_file(-0.2f);
  expect_tetrahedron("a.stl", binary.replace(0, 4, "OFF "));
}

TEST_F(Soup_reader, takes_numbers_out_of_range_as_infinite_and_zero) {
  const Soup soup = read_soup(
      folder_.write("a.off", "OFF\n4 0 0\n1e999 -1e999 1e-999\nnan inf 0\n0 0 0\n0 0 0\n"));
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(soup.points[0], Point(infinity, -infinity, 0.));
  EXPECT_NE(soup.points[1].x(), soup.points[1].x());
  EXPECT_EQ(soup.points[1].y(), infinity);
}

TEST_F(Soup_reader, says_what_is_wrong_with_a_ply_file) {
  const std::string good = ply_header("ascii") + points + faces;
  expect_failure("a.ply", "\n", "a PLY file begins with the word ply");
  expect_failure("a.ply", good.substr(0, 60), "has no end");
  expect_failure("a.ply", replaced(good, "ascii", "asci"), ":2: unknown PLY format 'asci'");
  expect_failure("a.ply", replaced(good, "1.0", "2.0"), ":2: unknown PLY version '2.0'");
  expect_failure("a.ply", good + "\nmore\n", ":20: unexpected 'more' after the last element");
  expect_failure("a.ply", replaced(good, "double y", "double why"), "no coordinate y");
  expect_failure("a.ply", replaced(good, "double y", "real y"), ":6: unknown property type 'real'");
  expect_failure("a.ply", replaced(good, "uchar int", "float int"), ":9: the length of a list has");
  expect_failure("a.ply", replaced(good, "uchar int", "uchar float"), "of an integer type");
  expect_failure("a.ply", replaced(good, "vertex_indices", "indices"), "no list vertex_indices");
  expect_failure("a.ply", replaced(good, "element face", "element none 9\nelement face"),
                 "none without properties");
  expect_failure("a.ply", good.substr(0, good.size() - 10),
                 ":17: expected vertex_indices of face 2 of 4; the file ends here");
  expect_failure("a.ply", replaced(good, "3 0 2 1", "999999999 0 2 1"),
                 ":15: expected vertex_indices of face 0 of 4");
  expect_failure("a.ply", replaced(good, "3 0 2 1", "-3 0 2 1"), "of face 0 of 4 is negative");
  expect_failure("a.ply", replaced(good, "3 0 2 1", "3 0 2 x"), ":15: expected vertex_indices");
  expect_failure("a.ply", replaced(good, "3 0 2 1", "3 0 2 1 7"),
                 ":15: face 0 of 4 has more values on");
  expect_failure("a.ply", replaced(good, "1 0 0", "1 0 0 x"),
                 ":12: vertex 1 of 4 has more values on");
  expect_failure("a.ply", replaced(good, "1 0 0", "1 0"), ":12: expected z of vertex 1 of 4");
  expect_failure("a.ply", replaced(good, "3 0 2 1", "3 0 2 -1"),
                 ":15: face 0 uses vertex -1, but there are only 4");
  expect_failure("a.ply", replaced(good, "3 0 2 1", "3 0 2 9223372036854775807"), ":15: expected");
  const std::string binary = binary_ply_file(false);
  const std::string number_of_byte = std::to_string(binary.size() - 21);
  expect_failure("a.ply", binary.substr(0, binary.size() - 20),
                 "byte " + number_of_byte +
                     ": expected vertex_indices of face 2 of 4; the file ends");
}

TEST_F(Soup_reader, says_what_is_wrong_with_an_stl_file) {
  const std::string text = text_stl_file(), binary = binary_stl_file(-0.2f);
  expect_failure("a.stl", "\n", "begins with the word solid");
  expect_failure("a.stl", replaced(text, "solid", "polid"), ":1: a text STL file begins");
  expect_failure("a.stl", "solid\nfacet", ":2: face 0: expected outer; the file ends here");
  expect_failure("a.stl", replaced(text, "1 0 0", "1 0 x"),
                 ":6: face 0: expected three coordinates");
  expect_failure("a.stl", replaced(text, "vertex 1 0 0", "vertex 1 0 0 7"),
                 ":6: face 0: expected endloop");
  expect_failure("a.stl", replaced(text, "vertex 1 0 0\n", ""), ":6: face 0: expected vertex");
  expect_failure("a.stl", replaced(text, "endfacet", "facet"), ":8: face 0: expected endfacet");
  expect_failure("a.stl", replaced(text, "endfacet\n", "endfacet\nx"), ":9: unexpected 'xfacet'");
  expect_failure("a.stl", replaced(text, "endsolid name\n", ""), "expected endsolid after 4 faces");
  expect_failure("a.stl", text + "facet", "unexpected 'facet'");
  expect_failure("a.stl", replaced(text, "endsolid name\n", "endsolid name facet normal 0 0 0\n"),
                 ":30: unexpected 'facet'");
  expect_failure("a.stl", binary.substr(0, 83), "too short");
  expect_failure("a.stl", binary.substr(0, 200), "ends after 2 of 4 faces");
  expect_failure("a.stl", binary + std::string(49 + 50, 'x'),
                 "declares 4 faces, but the file holds 5");
  for(const char count : {'\0', '\1'})
    expect_failure("a.stl", std::string(binary).replace(80, 1, 1, count), ", but the file holds 4");
}

// They are refused later, for nothing but that: they are not where others are.
TEST_F(Soup_reader, does_not_merge_points_that_are_nowhere) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(read_soup(folder_.write("a.stl", binary_stl_file(nan))).points.size(), 6u);
  std::string text = text_stl_file();
  for(const char* point : {"0 0 0", "0 1.5 0", "1 0 0"}) // of the first face
    text = replaced(text, std::string("vertex ") + point, "vertex nan nan nan");
  for(const std::string& content : {text, binary_stl_file(nan)}) {
    const auto defects = diagnose(read_soup(folder_.write("a.stl", content)));
    ASSERT_EQ(defects.size(), 1u);
    EXPECT_EQ(defects[0].kind, Mesh_defect::NON_FINITE_COORDINATE);
    EXPECT_EQ(defects[0].count, 3u);
  }
}

TEST_F(Soup_reader, says_what_is_wrong_with_other_files) {
  expect_failure("a.xyz", off_file(),
                 "does not name a supported format; those are: .off .obj .ply .stl");
  expect_failure("a.ts", "GOCAD TSurf 1\n", "supported format");
  expect_failure("no_extension", off_file(), "supported format");
  EXPECT_THROW(read_soup(folder_.path("none.off")), Failure);
  EXPECT_THROW(read_soup(folder_.path("none.ply")), Failure);
}

// All corners of each face; those from the fourth on stand apart in the soup.
std::vector<std::vector<std::size_t>> corners_of_faces(const Soup& soup) {
  std::vector<std::vector<std::size_t>> corners;
  auto further = soup.further_corners.begin();
  for(const Soup_face& face : soup.faces) {
    corners.emplace_back(face.begin(), face.end());
    for(std::size_t i = 3; i < face.size(); ++i)
      corners.back().push_back(*further++);
  }
  return corners;
}

// CGAL finds the same in the files of a folder of meshes.
TEST_F(Soup_reader, agrees_with_cgal) {
  if(!fs::is_directory(mesh_corpus()))
    GTEST_SKIP() << "no folder " << mesh_corpus();
  std::vector<std::string> files;
  for(const auto& entry : fs::recursive_directory_iterator(mesh_corpus())) {
    const std::string extension = entry.path().extension().string();
    if(extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl")
      files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  for(const std::string& file : enough_of(files)) {
    SCOPED_TRACE(file);
    std::vector<Point> expected_points;
    std::vector<std::vector<std::size_t>> expected_faces;
    if(!CGAL::IO::read_polygon_soup(file, expected_points, expected_faces,
                                    CGAL::parameters::verbose(false)))
    {
      EXPECT_THROW(read_soup(file), Failure);
      continue;
    }
    const Soup soup = read_soup(file);
    EXPECT_TRUE(std::equal(soup.points.begin(), soup.points.end(), expected_points.begin(),
                           expected_points.end()));
    EXPECT_EQ(corners_of_faces(soup), expected_faces);
  }
}

} // namespace test_htloops_soup_reader
