#include "app/write/clean_report.h"
#include "app/write/documents.h"
#include "app/write/rows.h"

#include "Meshes_of_soups.h"
#include "Small_answer.h"
#include "Temporary_folder.h"
#include "Washer.h"

#include "app/clean/soup_cleaning.h"
#include "app/solve/backends.h"
#include "app/solve/cut_solver.h"
#include "app/solve/details.h"
#include "app/solve/reeb_solver.h"
#include "app/solve/removal_solver.h"
#include "app/solve/skeleton_solver.h"
#include "generators/generators.h"

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_htloops_schema {

using namespace htloops;
using htloops::Mesh;
using nlohmann::json;

class Schema
{
public:
  explicit Schema(const std::string& name) {
    const json document = json::parse(std::ifstream(HTL_SCHEMAS "/" + name + ".schema.json"));
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(document),
                                            schema_);
  }

  // What is wrong with a document, in words; empty if nothing is.
  std::string problems(const json& document) const {
    valijson::ValidationResults results;
    const valijson::adapters::NlohmannJsonAdapter target(document);
    if(valijson::Validator().validate(schema_, target, &results))
      return "";
    std::string words;
    for(valijson::ValidationResults::Error error; results.popError(error);)
      words += error.description + "\n";
    return words.empty() ? "?" : words;
  }

  void expect_fits(const json& document) const { EXPECT_EQ(problems(document), ""); }

  void expect_refuses(const json& document,
                      const std::vector<std::function<void(json&)>>& changes) const {
    for(const auto& change : changes) {
      json changed = document;
      change(changed);
      EXPECT_NE(problems(changed), "") << json::diff(document, changed);
    }
  }

private:
  valijson::Schema schema_;
};

class Loops_schema : public testing::Test
{
protected:
  json written(const Mesh& mesh, const Answer& answer) {
    write_loops_json(folder_.path("a.json"), mesh, answer,
                     {"a.off", {{"basis", "pure"}, {"seed", nullptr}}, 0.125});
    return json::parse(folder_.read("a.json"));
  }

  const Temporary_folder folder_;
  const Schema schema_{"loops"};
};

::Soup soup_with_holes() {
  return CGAL::Handle_tunnel_loops::generators::with_holes(
      soup_of(Recipe{"multi-torus", {3000, 2, 0}}), {3, 20, false});
}
Mesh mesh_with_holes() { return mesh_of<Mesh>(soup_with_holes()); }

Answer solved(const Mesh& mesh, Solve_options options = {}) {
  Progress told;
  Answer answer = host_backend.solve(mesh, options, told);
  add_details(mesh, true, answer);
  return answer;
}

Mesh bored_mesh() { return mesh_of<Mesh>(washer()); }

TEST_F(Loops_schema, fits_what_is_written) {
  const Mesh closed = mesh_of<Mesh>(Recipe{"multi-torus", {3000, 3, 0}});
  schema_.expect_fits(written(closed, solved(closed)));
  Solve_options shortest;
  shortest.basis_kind = CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST;
  shortest.do_compute_linking = false;
  schema_.expect_fits(written(closed, solved(closed, shortest)));
  const Mesh open = mesh_with_holes();
  const json document = written(open, solved(open));
  EXPECT_EQ(document["boundaries"].size(), 3u);
  schema_.expect_fits(document);
  Solve_options hasty;
  hasty.maximum_running_time = 0.;
  const json ended = written(closed, solved(closed, hasty));
  EXPECT_TRUE(ended["ended_by_time"].get<bool>());
  schema_.expect_fits(ended);
  const Mesh sphere = mesh_of<Mesh>(Recipe{"sphere", {320, 0, 0}});
  schema_.expect_fits(written(sphere, solved(sphere)));
}

TEST_F(Loops_schema, fits_bores_and_shapes) {
  const Mesh mesh = bored_mesh();
  const json document = written(mesh, solved(mesh));
  schema_.expect_fits(document);
  const json& pair = document["pairs"][0];
  EXPECT_EQ(pair["diameter_of"], "bore");
  EXPECT_NEAR(pair["bore"]["diameter"].get<double>(), 2., 1e-9);
  EXPECT_NEAR(pair["bore"]["axis"][2].get<double>(), 1., 1e-9);
  EXPECT_NEAR(pair["bore"]["depth"].get<double>(), 1., 1e-9);
  // On the axis, though the shorter loop goes around the wall beside the bore.
  EXPECT_LT(pair["handle"]["length"], pair["tunnel"]["length"]);
  for(int i = 0; i < 3; ++i)
    EXPECT_NEAR(pair["centre"][i].get<double>(), i == 2 ? 0.5 : 0., 1e-9);
  EXPECT_NEAR(pair["tunnel"]["shape"]["circle"]["diameter"].get<double>(), 2., 1e-6);
  schema_.expect_refuses(document,
                         {[](json& d) { d["pairs"][0]["diameter_of"] = "drill"; },
                          [](json& d) { d["pairs"][0]["diameter"] = -1.; },
                          [](json& d) { d["pairs"][0]["bore"].erase("axis"); },
                          [](json& d) { d["pairs"][0]["bore"]["depth"] = -1.; },
                          [](json& d) { d["pairs"][0]["wall_diameter"] = -1.; },
                          [](json& d) { d["pairs"][0]["handle"]["shape"].erase("normal"); }});
}

TEST_F(Loops_schema, fits_measures) {
  const Mesh mesh = bored_mesh();
  Answer answer = solved(mesh);
  answer.measures.resize(1);
  answer.measures[0].clear_width = Ball{2., 0.01, Point(0., 0., 0.5), {Point(0., 0., 0.5)}};
  answer.measures[0].why = "unknown";
  const json document = written(mesh, answer);
  schema_.expect_fits(document);
  EXPECT_EQ(document["pairs"][0]["clear_width"]["diameter"], 2.);
  EXPECT_FALSE(document["pairs"][0].contains("thickness"));
  EXPECT_EQ(document["pairs"][0]["not_measured_because"], "unknown");
  schema_.expect_refuses(document, {[](json& d) { d["pairs"][0]["clear_width"].erase("error"); },
                                    [](json& d) { d["pairs"][0]["clear_width"]["throat"] = 1.; }});
}

TEST_F(Loops_schema, fits_costs_of_removal) {
  const Mesh mesh = bored_mesh();
  Answer answer = solved(mesh);
  answer.costs.resize(1);
  answer.costs[0].fill = Removed_handle{0, Removal_way::FILL, 6., 6.2, -0.5};
  answer.costs[0].why_no_cut = "no room";
  const json document = written(mesh, answer);
  schema_.expect_fits(document);
  EXPECT_EQ(document["pairs"][0]["fill"]["volume"], -0.5);
  EXPECT_FALSE(document["pairs"][0].contains("cut"));
  EXPECT_EQ(document["pairs"][0]["no_cut_because"], "no room");
  schema_.expect_refuses(document, {[](json& d) { d["pairs"][0]["fill"].erase("volume"); },
                                    [](json& d) { d["pairs"][0]["fill"]["area"] = -1.; }});
}

TEST_F(Loops_schema, fits_what_is_not_known) {
  const Mesh mesh = small_mesh();
  Answer answer = small_answer(mesh);
  schema_.expect_fits(written(mesh, answer));
  answer.certificate.linking.resize(4);
  answer.certificate.linking[3].problem = "unknown";
  answer.statistics.fallback = "no device";
  const json document = written(mesh, answer);
  EXPECT_EQ(document["pairs"][1]["tunnel"]["undecided_because"], "unknown");
  schema_.expect_fits(document);
}

TEST_F(Loops_schema, refuses_what_is_something_else) {
  const Mesh mesh = small_mesh();
  schema_.expect_refuses(
      written(mesh, small_answer(mesh)),
      {[](json& d) { d["format"] = "htloops/2"; }, //
       [](json& d) { d.erase("certificate"); }, [](json& d) { d["ended_by_time"] = 1; },
       [](json& d) { d["mesh"]["genus"] = -1; }, [](json& d) { d["mesh"].erase("file"); },
       [](json& d) { d["pairs"][0]["handle"].erase("points"); },
       [](json& d) { d["pairs"][0]["handle"].erase("component"); },
       [](json& d) {
         d["pairs"][1]["tunnel"]["locations"][0] = {0, 1};
       },
       [](json& d) { d["pairs"][0]["handle"]["bounds"] = "both"; },
       [](json& d) { d["pairs"][0]["box"].erase(0); },
       [](json& d) { d["timings"]["total"] = "long"; }});
}

TEST(Reeb_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("reeb");
  Progress told;
  json document;
  for(::Soup soup : {soup_of(Recipe{"multi-torus", {3000, 3, 0}}), soup_with_holes()}) {
    soup.points.push_back({0., 0., 0.}); // without faces
    const Mesh mesh = mesh_of<Mesh>(soup);
    Reeb_options options;
    for(const bool has_values : {false, true}) {
      if(has_values)
        for(const Mesh::Vertex_index v : mesh.vertices())
          options.values.push_back(mesh.point(v).z());
      write_reeb_json(folder.path("a.json"), mesh, find_reeb_graph(mesh, options, told), 0.5);
      document = json::parse(folder.read("a.json"));
      schema.expect_fits(document);
      EXPECT_TRUE(document["vertex_arc"].back().is_null());
    }
  }
  schema.expect_refuses(document, {[](json& d) { d["format"] = "htloops-reeb/2"; },
                                   [](json& d) { d["nodes"][0]["type"] = "peak"; },
                                   [](json& d) { d["arcs"][0].erase("girth"); },
                                   [](json& d) { d["arcs"][0]["polyline"].clear(); },
                                   [](json& d) { d["vertex_arc"][0] = -1; },
                                   [](json& d) { d["mesh"].erase("genus"); }});
}

TEST(Skeleton_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("skeleton");
  Progress told;
  json document;
  for(::Soup soup : {soup_of(Recipe{"multi-torus", {3000, 3, 0}}), soup_with_holes()}) {
    soup.points.push_back({0., 0., 0.}); // without faces
    const Mesh mesh = mesh_of<Mesh>(soup);
    write_skeleton_json(folder.path("a.json"), find_skeleton(mesh, {}, told),
                        {"a.off", {{"shortest_limb", 1.}}, 0.5});
    document = json::parse(folder.read("a.json"));
    schema.expect_fits(document);
    EXPECT_TRUE(document["vertex_point"].back().is_null());
  }
  schema.expect_refuses(document, {[](json& d) { d["format"] = "htloops-skeleton/2"; },
                                   [](json& d) { d["certificate"].erase("cycles"); },
                                   [](json& d) { d["certificate"]["edges_outside"] = {1}; },
                                   [](json& d) { d["nodes"][0]["position"].erase(0); },
                                   [](json& d) { d["nodes"][0]["kind"] = "peak"; },
                                   [](json& d) { d["arcs"][0].erase("target"); },
                                   [](json& d) { d["arcs"][0]["polyline"].clear(); },
                                   [](json& d) { d["arcs"][0].erase("mean_radius"); },
                                   [](json& d) { d["vertex_point"][0] = -1; },
                                   [](json& d) { d["mesh"].erase("genus"); }});
}

TEST(Removal_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("removal");
  Progress told;
  Mesh mesh = mesh_of<Mesh>(Recipe{"multi-torus", {3000, 3, 0}});
  Removal_options options;
  options.maximal_neck_length = 0.;
  CGAL::Handle_tunnel_loops::Removal_report report =
      remove_handles(mesh, find_loops(mesh), options, told).report;
  EXPECT_EQ(report.removed.size(), 3u);
  report.refused.push_back({2, 1.5, "too narrow"});
  report.refused_necks.push_back({0, 1.5, "too narrow"});
  write_removal_json(folder.path("a.json"), report);
  const json document = json::parse(folder.read("a.json"));
  schema.expect_fits(document);
  schema.expect_refuses(document, {[](json& d) { d["removed"][0].erase("pair"); },
                                   [](json& d) { d["removed"][0]["by"] = "magic"; },
                                   [](json& d) { d["removed"][0]["change"].erase("cap_ratio"); },
                                   [](json& d) { d["change"]["sharpest_angle"] = 181; },
                                   [](json& d) { d["refused"][0]["reason"] = ""; },
                                   [](json& d) { d["necks"].erase("refused"); },
                                   [](json& d) { d["genus_after"] = 0.5; }});
}

htloops::Soup as_read(const Mesh& mesh) {
  htloops::Soup soup{mesh.points(), {}};
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.add_face(
        std::array{mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return soup;
}

TEST(Clean_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("clean");
  Progress told;
  const Mesh mesh = mesh_with_holes();
  json document;
  for(const bool do_close : {false, true}) {
    Clean_options options;
    options.steps.reset(static_cast<std::size_t>(Clean_step::REPAIR));
    options.steps.set(static_cast<std::size_t>(Clean_step::HOLES), do_close);
    write_clean_json(folder.path("a.json"), clean(as_read(mesh), options, std::nullopt, told));
    document = json::parse(folder.read("a.json"));
    schema.expect_fits(document);
    EXPECT_TRUE(document["before"]["volume"].is_null());
    EXPECT_EQ(document["after"]["volume"].is_null(), !do_close);
  }
  EXPECT_EQ(document["before"]["boundaries"], 3);
  EXPECT_EQ(document["steps"][0]["step"], "holes");
  EXPECT_EQ(document["steps"][0]["count"], 3);
  EXPECT_EQ(document["steps"].back()["step"], "handles");
  EXPECT_EQ(document["steps"].back()["left"].size(), 1u);
  schema.expect_refuses(document, {[](json& d) { d["format"] = "htloops-clean/2"; },
                                   [](json& d) { d.erase("after"); },
                                   [](json& d) { d["input"].erase("faces"); },
                                   [](json& d) { d["before"].erase("volume"); },
                                   [](json& d) { d["after"]["crossings"] = -1; },
                                   [](json& d) { d["after"]["volume"] = "large"; },
                                   [](json& d) { d["steps"][0]["step"] = "polish"; },
                                   [](json& d) { d["steps"][0].erase("left"); },
                                   [](json& d) { d["steps"][0]["done"][0] = ""; }});
}

TEST(Map_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("map");
  Progress told;
  const Mesh before = mesh_of<Mesh>(Recipe{"multi-torus", {3000, 3, 0}});
  const Removal_answer answer = remove_handles(before, find_loops(before), {}, told);
  const Mesh& mesh = answer.mesh;
  write_map_json(folder.path("a.json"), before.number_of_vertices(), before.number_of_faces(),
                 answer);
  const json document = json::parse(folder.read("a.json"));
  schema.expect_fits(document);
  schema.expect_refuses(document, {[](json& d) { d["vertices"][0] = -1; },
                                   [](json& d) { d["faces"][0] = "new"; },
                                   [](json& d) { d["face_parents"][0] = -1; },
                                   [](json& d) { d.erase("faces_before"); }});
  ASSERT_EQ(document["vertices"].size(), mesh.number_of_vertices());
  ASSERT_EQ(document["faces"].size(), mesh.number_of_faces());
  ASSERT_EQ(document["face_parents"].size(), mesh.number_of_faces());
  std::size_t number_of_parts = 0;
  for(std::size_t k = 0; k < document["faces"].size(); ++k)
    if(document["faces"][k].is_null())
      number_of_parts += !document["face_parents"][k].is_null();
    else
      EXPECT_EQ(document["face_parents"][k], document["faces"][k]);
  EXPECT_GT(number_of_parts, 0u);
  std::size_t i = 0, number_kept = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(const json& origin = document["vertices"][i++]; !origin.is_null()) {
      EXPECT_EQ(before.point(Mesh::Vertex_index(origin.get<std::uint32_t>())), mesh.point(v));
      ++number_kept;
    }
  EXPECT_GT(2 * number_kept, before.number_of_vertices());
  EXPECT_LT(number_kept, mesh.number_of_vertices());
}

TEST(Dual_cuts_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("dual_cuts");
  Progress told;
  const Mesh mesh = mesh_with_holes();
  write_dual_cuts_json(folder.path("a.json"), mesh, find_dual_cuts(mesh, 1, told));
  const json document = json::parse(folder.read("a.json"));
  EXPECT_EQ(document["cuts"].size(), 6u);
  schema.expect_fits(document);
  schema.expect_refuses(document, {[](json& d) { d["cuts"][0].erase("pair"); },
                                   [](json& d) { d["cuts"][0]["boundary"] = 1; },
                                   [](json& d) { d["cuts"][5]["loop"] = "cut"; },
                                   [](json& d) { d["cuts"][0]["edges"][0].push_back(1); },
                                   [](json& d) { d["cuts"][0]["edges"].clear(); }});
}

TEST(Events_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("events");
  Progress told;
  const Mesh mesh = mesh_of<Mesh>(Recipe{"multi-torus", {3000, 3, 0}});
  json document;
  for(const Backend* backend : {&host_backend, &reference_backend}) {
    Solve_options options;
    options.do_log_fronts = true;
    write_events(folder.path("a.json"), backend->solve(mesh, options, told));
    document = json::parse(folder.read("a.json"));
    EXPECT_GE(document["events"].size(), 6u);
    schema.expect_fits(document);
  }
  EXPECT_TRUE(document.contains("resolution"));
  schema.expect_refuses(document, {[](json& d) { d["format"] = "htloops-events/2"; },
                                   [](json& d) { d["resolution"].erase("rests"); },
                                   [](json& d) { d["events"][0]["type"] = "birth"; },
                                   [](json& d) { d["events"][0].erase("after"); },
                                   [](json& d) { d["events"][0]["before"][0]["layer"] = 0; },
                                   [](json& d) { d["events"][0]["vertex"] = -1; }});
}

TEST(Mesh_line_schema, fits_what_is_written) {
  const Temporary_folder folder;
  const Schema schema("mesh_line");
  const Mesh closed = mesh_of<Mesh>(Recipe{"multi-torus", {3000, 3, 0}}), open = mesh_with_holes();
  {
    Text_writer out(folder.path("a.jsonl"));
    for(const Mesh* const mesh : {&closed, &open}) {
      Mesh_line line = {"a.off"};
      line.number_of_vertices = mesh->number_of_vertices();
      line.number_of_faces = mesh->number_of_faces();
      line.read_seconds = 0.5;
      line.answer = solved(*mesh);
      line.listing = list_pairs(*mesh, line.answer);
      write_mesh_line(out, line);
    }
    write_mesh_line(out, {"no.off", 2, "no such file"});
    out.finish();
  }
  std::istringstream lines(folder.read("a.jsonl"));
  std::vector<json> documents;
  for(std::string line; std::getline(lines, line);) {
    documents.push_back(json::parse(line));
    schema.expect_fits(documents.back());
  }
  ASSERT_EQ(documents.size(), 3u);
  EXPECT_EQ(documents[1]["boundary_lengths"].size(), 3u);
  schema.expect_refuses(documents[0],
                        {[](json& d) { d.erase("mesh"); }, [](json& d) { d.erase("pairs"); },
                         [](json& d) { d["exit"] = 3; }, [](json& d) { d["error"] = "none"; },
                         [](json& d) { d["genus"] = 0.5; },
                         [](json& d) { d["pairs"][0].erase("size"); },
                         [](json& d) { d["pairs"][0]["diameter_of"] = ""; },
                         [](json& d) { d["seconds"].erase("read"); }});
  schema.expect_refuses(documents[2],
                        {[](json& d) { d.erase("error"); }, [](json& d) { d["error"] = ""; }});
}

} // namespace test_htloops_schema
