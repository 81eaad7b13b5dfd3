#include "app/write/documents.h"

#include "Small_answer.h"
#include "Temporary_folder.h"

#include "app/failure.h"
#include "app/read/loops_reader.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_htloops_loops_json {

using namespace htloops;
using htloops::Mesh;
using nlohmann::json;

class Loops_json : public testing::Test
{
protected:
  Loops_json() {
    write_loops_json(folder_.path("a.json"), mesh_, answer_, {"a.off", Json::object(), 0.125});
    document_ = json::parse(folder_.read("a.json"));
  }

  Loops_record read_again() { return read_loops_json(folder_.write("b.json", document_.dump())); }

  // what is said of the document after a change that leaves it readable.
  std::vector<std::string> problems_after(const std::function<void(json&)>& change) {
    const json original = document_;
    change(document_);
    const auto problems = bind_loops(read_again(), mesh_).problems;
    document_ = original;
    return problems;
  }

  void expect_problem(const std::string& words, const std::function<void(json&)>& change) {
    const auto problems = problems_after(change);
    ASSERT_FALSE(problems.empty()) << words;
    EXPECT_NE(problems[0].find(words), std::string::npos) << problems[0];
  }

  void expect_unreadable(const std::string& words, const std::function<void(json&)>& change) {
    const json original = document_;
    change(document_);
    try {
      read_again();
      ADD_FAILURE() << "it was read: " << words;
    } catch(const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit_code::UNREADABLE_FILE);
      EXPECT_NE(std::string(failure.what()).find(words), std::string::npos) << failure.what();
    }
    document_ = original;
  }

  Temporary_folder folder_;
  const Mesh mesh_ = small_mesh();
  const Answer answer_ = small_answer(mesh_);
  json document_;
};

TEST_F(Loops_json, has_the_fields_of_the_format) {
  EXPECT_EQ(document_["format"], "htloops/1");
  EXPECT_EQ(std::string(document_["tool"]).substr(0, 8), "htloops ");
  const json mesh = {{"vertices", 4},   {"faces", 4}, {"components", 1},
                     {"boundaries", 0}, {"genus", 2}, {"file", "a.off"}};
  EXPECT_EQ(document_["mesh"], mesh);
  EXPECT_EQ(document_["backend"], "host");
  EXPECT_EQ(document_["threads"], 3);
  // Of all stages but that of Reeb graphs.
  const json timings = {{"read", 0.125},     {"adaptor", 0.},  {"initial", 0.25}, {"tunnel", 0.},
                        {"refine", 0.},      {"shorten", 0.},  {"classes", 0.},   {"convert", 0.},
                        {"certificate", 0.}, {"classify", 0.}, {"total", 0.5}};
  EXPECT_EQ(document_["timings"], timings);
  const json certificate = {{"closed_on_surface", true},
                            {"basis", true},
                            {"pairing", false},
                            {"types", false},
                            {"handles_bound_inside", nullptr},
                            {"tunnels_bound_outside", nullptr},
                            {"handles_bound_inside_alone", nullptr},
                            {"tunnels_bound_outside_alone", nullptr}};
  EXPECT_EQ(document_["certificate"], certificate);
  EXPECT_EQ(document_["basis"], "pure");
  EXPECT_EQ(document_["pairs"].size(), 2u);
  EXPECT_EQ(document_["pairs"][0]["handle"]["component"], 0);
  EXPECT_EQ(document_["boundaries"], json::array());
  EXPECT_FALSE(document_.contains("linking"));
  EXPECT_FALSE(document_["pairs"][0]["handle"].contains("bounds"));
}

TEST_F(Loops_json, says_where_loops_bound) {
  Answer answer = answer_;
  answer.certificate.linking.resize(4);
  answer.certificate.linking[1].row = {{0, -2}, {1, 3}};
  answer.certificate.linking[1].column = {{1, 3}};
  answer.certificate.linking[0].column = {{1, -2}};
  answer.certificate.linking[2].row = {{3, 1}};
  answer.certificate.linking[3].problem = "unknown";
  answer.certificate.handles_bound_inside = 1;
  answer.certificate.tunnels_bound_outside = 0;
  write_loops_json(folder_.path("a.json"), mesh_, answer, {});
  const json document = json::parse(folder_.read("a.json"));
  EXPECT_EQ(document["certificate"]["handles_bound_inside"], 1);
  EXPECT_EQ(document["certificate"]["tunnels_bound_outside"], 0);
  EXPECT_EQ(document["pairs"][0]["handle"]["bounds"], "inside");
  EXPECT_EQ(document["pairs"][0]["tunnel"]["bounds"], "neither");
  EXPECT_EQ(document["pairs"][1]["handle"]["bounds"], "outside");
  EXPECT_EQ(document["pairs"][1]["tunnel"]["bounds"], "undecided");
  EXPECT_EQ(document["linking"], json::parse("[[1,0,-2],[1,1,3],[2,3,1]]"));
  EXPECT_EQ(read_loops_json(folder_.path("a.json")).pairs.size(), 2u);
}

TEST_F(Loops_json, reads_back_as_the_same_loops) {
  const Bound_loops loops = bind_loops(read_loops_json(folder_.path("a.json")), mesh_);
  EXPECT_TRUE(loops.problems.empty()) << loops.problems[0];
  ASSERT_EQ(loops.pairs.size(), answer_.pairs.size());
  for_each_loop(answer_.pairs, [&](const Loop& expected, CGAL::Loop_type type, std::size_t pair) {
    const Loop& found = loops.pairs[pair].loop(type);
    EXPECT_EQ(found.type(), type);
    EXPECT_EQ(found.pair_index(), pair);
    EXPECT_EQ(found.length(), expected.length());
    ASSERT_EQ(found.size(), expected.size());
    for(std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found.steps()[i].halfedge, expected.steps()[i].halfedge);
      EXPECT_EQ(found.steps()[i].ratio, expected.steps()[i].ratio);
    }
  });
}

TEST_F(Loops_json, an_answer_without_pairs_is_one) {
  Answer answer;
  write_loops_json(folder_.path("a.json"), mesh_, answer, {});
  EXPECT_TRUE(read_loops_json(folder_.path("a.json")).pairs.empty());
}

TEST_F(Loops_json, an_infinite_length_is_null) {
  Answer answer = answer_;
  const Loop& loop = answer.pairs[0].handle();
  const double infinity = std::numeric_limits<double>::infinity();
  answer.pairs[0] =
      Pair(Loop(loop.steps(), loop.points(), infinity, loop.type(), 0), answer.pairs[0].tunnel());
  write_loops_json(folder_.path("a.json"), mesh_, answer, {});
  EXPECT_EQ(read_loops_json(folder_.path("a.json")).pairs[0].handle.length, infinity);
}

TEST_F(Loops_json, allows_for_what_the_smallest_numbers_lose) {
  constexpr double smallest = std::numeric_limits<double>::denorm_min();
  Mesh tiny = mesh_;
  for(const Mesh::Vertex_index v : tiny.vertices())
    tiny.point(v) = CGAL::ORIGIN + 2000. * smallest * (tiny.point(v) - CGAL::ORIGIN);
  write_loops_json(folder_.path("a.json"), tiny, small_answer(tiny), {});
  document_ = json::parse(folder_.read("a.json"));
  for(json& pair : document_["pairs"])
    for(const char* loop : {"handle", "tunnel"}) {
      const auto points = pair[loop]["points"].get<std::vector<std::array<double, 3>>>();
      double length = 2. * smallest; // what is lost
      for(std::size_t i = 0; i < points.size(); ++i) {
        const auto &p = points[i], &q = points[(i + 1) % points.size()];
        length += std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
      }
      pair[loop]["length"] = length;
    }
  EXPECT_TRUE(bind_loops(read_again(), tiny).problems.empty());
  document_["pairs"][1]["handle"]["length"] = 6000. * smallest;
  EXPECT_EQ(bind_loops(read_again(), tiny).problems.size(), 1u);
}

TEST_F(Loops_json, says_in_words_what_stands_where_in_a_text_that_is_no_json) {
  const std::pair<const char*, const char*> cases[] = {
      {"{\"a\":}", "line 1, column 6: '}' stands where a value is expected"},
      {"{\n\"a\": [1,2}", "line 2, column 10: '}' stands where a comma or ] is expected"},
      {"{\"a\": 1,}", "line 1, column 9: '}' stands where a name in double quotes is expected"},
      {"{'a': 1}", "line 1, column 2: ''' stands where a name in double quotes is expected"},
      {"{\"a\" \"bcd\"}", "line 1, column 6: '\"bcd\"' stands where a colon is expected"},
      {"{\"a\": 1\n \"b\": 2}", "line 2, column 2: '\"b\"' stands where a comma or } is expected"},
      {"{\"a\":\n  [1, nan, 2]}", "line 2, column 7: 'nan' stands where a value is expected"},
      {"{\"a\": Tru}", "line 1, column 7: 'Tru' stands where a value is expected"},
      {"{\"a\": tru}", "line 1, column 7: 'tru' stands where a value is expected"},
      {"{} 12", "line 1, column 4: '12' stands where the end is expected"},
      {"{\"a\": [1,\n", "line 2, column 1: the text ends where a value is expected"},
      {"{\"a\": 1e999}", "the number 1e999 is too large"},
      {"{\"a\": \"b\nc\"}", "line 1, column 9: invalid string: control character U+000A"},
      {"{\"a\": \"b", "line 1, column 9: the text ends within a string"},
      {"{\"a\": -}", "invalid number"}};
  for(const auto& [text, words] : cases)
    try {
      read_loops_json(folder_.write("d.json", text));
      ADD_FAILURE() << "it was read: " << text;
    } catch(const Failure& failure) {
      EXPECT_NE(std::string(failure.what()).find(words), std::string::npos) << failure.what();
      EXPECT_EQ(std::string(failure.what()).find("exception"), std::string::npos);
    }
}

TEST_F(Loops_json, says_where_a_document_is_malformed) {
  EXPECT_THROW(read_loops_json(folder_.path("none.json")), Failure);
  EXPECT_THROW(read_loops_json(folder_.write("c.json", "{ \"format\": ")), Failure);
  expect_unreadable("the document is not an object", [](json& d) { d = json::array(); });
  expect_unreadable("has no member 'format'", [](json& d) { d.erase("format"); });
  expect_unreadable("format is not a string", [](json& d) { d["format"] = 1; });
  expect_unreadable(
      "the document has the format htloops-reeb/1, not htloops/1; 'htloops loops MESH",
      [](json& d) { d["format"] = "htloops-reeb/1"; });
  expect_unreadable("mesh has no member 'faces'", [](json& d) { d["mesh"].erase("faces"); });
  expect_unreadable("vertices is not a non-negative integer",
                    [](json& d) { d["mesh"]["vertices"] = -1; });
  expect_unreadable("pairs is not an array", [](json& d) { d["pairs"] = 1; });
  expect_unreadable("pair 1 has no member 'tunnel'",
                    [](json& d) { d["pairs"][1].erase("tunnel"); });
  expect_unreadable("handle, length is not a number",
                    [](json& d) { d["pairs"][0]["handle"]["length"] = "long"; });
  expect_unreadable("pair 0, tunnel, locations, position 2 is not an array of three numbers",
                    [](json& d) {
                      d["pairs"][0]["tunnel"]["locations"][2] = {0, 1};
                    });
  expect_unreadable("position 0 has a vertex index that is not an integer",
                    [](json& d) { d["pairs"][0]["tunnel"]["locations"][0][1] = 0.5; });
  expect_unreadable("points, position 1 has an element that is not a number",
                    [](json& d) { d["pairs"][0]["tunnel"]["points"][1][2] = "high"; });
}

TEST_F(Loops_json, says_which_place_is_not_on_the_mesh) {
  EXPECT_TRUE(problems_after([](json&) {}).empty());
  expect_problem("a mesh with 5 vertices", [](json& d) { d["mesh"]["vertices"] = 5; });
  for(const json& vertex : {json(4), json(-1), json(18446744073709551615u)})
    expect_problem("pair 1, handle, position 2: vertex ",
                   [&](json& d) { d["pairs"][1]["handle"]["locations"][2][0] = vertex; });
  for(const json& ratio : {json(-0.01), json(1.01)})
    expect_problem("pair 0, tunnel, position 1: the ratio ",
                   [&](json& d) { d["pairs"][0]["tunnel"]["locations"][1][2] = ratio; });
  expect_problem("pair 0, handle, position 0: no edge joins", [](json& d) {
    d["pairs"][0]["handle"]["locations"][0] = {1, 1, 0.5};
  });
  expect_problem("pair 0, handle, position 0: the point does not match",
                 [](json& d) { d["pairs"][0]["handle"]["points"][0][0] = 7; });
  expect_problem("3 locations, but 2 points",
                 [](json& d) { d["pairs"][0]["handle"]["points"].erase(2); });
  expect_problem("pair 1, tunnel: length is given as 7",
                 [](json& d) { d["pairs"][1]["tunnel"]["length"] = 7; });
}

TEST_F(Loops_json, says_the_worst_first_and_all_of_it) {
  const auto problems = problems_after([](json& d) {
    d["pairs"][0]["handle"]["length"] = 7;
    d["pairs"][0]["handle"]["points"][0][0] = 7;
    d["pairs"][1]["tunnel"]["locations"][1][2] = 1.0000000000000002;
  });
  ASSERT_EQ(problems.size(), 3u);
  EXPECT_EQ(problems[0],
            "pair 1, tunnel, position 1: the ratio 1.0000000000000002 is not between 0 and 1");
  EXPECT_NE(problems[1].find("the point does not match"), std::string::npos);
  EXPECT_NE(problems[2].find("length is given as 7"), std::string::npos);
}

TEST_F(Loops_json, says_once_that_the_mesh_was_scaled_or_moved) {
  for(const bool is_moved : {false, true}) {
    Mesh other = mesh_;
    for(const Mesh::Vertex_index v : other.vertices())
      other.point(v) = is_moved ? other.point(v) + (Mesh::Point(0., 5., 0.) - CGAL::ORIGIN)
                                : CGAL::ORIGIN + 1000. * (other.point(v) - CGAL::ORIGIN);
    const Bound_loops loops = bind_loops(read_again(), other);
    EXPECT_FALSE(loops.are_placed);
    ASSERT_EQ(loops.problems.size(), 1u);
    EXPECT_EQ(loops.problems[0],
              "the points of the loops do not lie on this mesh: was it scaled or moved?");
  }
}

TEST_F(Loops_json, rounded_meshes_are_neither_scaled_nor_moved) {
  Mesh other = mesh_;
  for(const Mesh::Vertex_index v : other.vertices()) // the mesh has numbers of few digits
    other.point(v) = CGAL::ORIGIN + (1. + 1e-7) * (other.point(v) - CGAL::ORIGIN);
  const Bound_loops loops = bind_loops(read_again(), other);
  EXPECT_TRUE(loops.are_placed);
  ASSERT_GT(loops.problems.size(), 1u);
  EXPECT_NE(loops.problems[0].find("the point does not match"), std::string::npos);
}

TEST_F(Loops_json, loops_are_complete_where_only_what_is_said_of_them_is_wrong) {
  document_["pairs"][0]["handle"]["length"] = 7;
  const Bound_loops wrong = bind_loops(read_again(), mesh_);
  EXPECT_TRUE(wrong.are_placed);
  EXPECT_EQ(wrong.problems.size(), 1u);
  EXPECT_DOUBLE_EQ(wrong.pairs[0].handle().length(), answer_.pairs[0].handle().length());
  document_["pairs"][0]["handle"]["locations"][0][0] = 18;
  EXPECT_FALSE(bind_loops(read_again(), mesh_).are_placed);
}

} // namespace test_htloops_loops_json
