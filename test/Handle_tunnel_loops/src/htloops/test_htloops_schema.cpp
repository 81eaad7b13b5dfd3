#include "htloops/write/loops_json_writer.h"

#include "Meshes_of_soups.h"
#include "Small_answer.h"
#include "Temporary_folder.h"

#include "generators/holes.h"
#include "htloops/solve/solvers.h"

#include <gtest/gtest.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include <fstream>
#include <functional>
#include <string>

using namespace htloops;
using nlohmann::json;

namespace {

class Loops_schema : public testing::Test
{
protected:
  Loops_schema() {
    const json document = json::parse(std::ifstream(HTL_SCHEMA));
    valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(document),
                                            schema_);
  }

  json written(const Mesh& mesh, const Answer& answer) {
    write_loops_json(folder_.path("a.json"), mesh, answer,
                     {"a.off", {{"basis", "pure"}, {"seed", nullptr}}, 0.125});
    return json::parse(folder_.read("a.json"));
  }

  // What is wrong with a document, in words; empty if nothing is.
  std::string problems(const json& document) {
    valijson::ValidationResults results;
    const valijson::adapters::NlohmannJsonAdapter target(document);
    if(valijson::Validator().validate(schema_, target, &results))
      return "";
    std::string words;
    for(valijson::ValidationResults::Error error; results.popError(error);)
      words += error.description + "\n";
    return words.empty() ? "?" : words;
  }

  const Temporary_folder folder_;
  valijson::Schema schema_;
};

Answer solved(const Mesh& mesh, Solve_options options = {}) {
  Progress_bar bar(false);
  Answer answer = solve_on_host(mesh, options, bar);
  if(answer.statistics.number_of_boundaries > 0)
    answer.boundaries = find_boundaries(mesh, true);
  return answer;
}

} // namespace

TEST_F(Loops_schema, fits_what_is_written) {
  const Mesh closed = mesh_of(Recipe{"multi-torus", {3000, 3, 0}});
  EXPECT_EQ(problems(written(closed, solved(closed))), "");
  Solve_options shortest;
  shortest.basis_kind = CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST;
  shortest.do_compute_linking = false;
  EXPECT_EQ(problems(written(closed, solved(closed, shortest))), "");
  const Mesh open = mesh_of(CGAL::Handle_tunnel_loops::generators::with_holes(
      soup_of(Recipe{"multi-torus", {3000, 2, 0}}), {3, 20, false}));
  const json document = written(open, solved(open));
  EXPECT_EQ(document["boundaries"].size(), 3u);
  EXPECT_EQ(problems(document), "");
  const Mesh sphere = mesh_of(Recipe{"sphere", {320, 0, 0}});
  EXPECT_EQ(problems(written(sphere, solved(sphere))), "");
}

TEST_F(Loops_schema, fits_what_is_not_known) {
  const Mesh mesh = small_mesh();
  Answer answer = small_answer(mesh);
  EXPECT_EQ(problems(written(mesh, answer)), "");
  answer.certificate.linking.resize(4);
  answer.certificate.linking[3].problem = "unknown";
  answer.statistics.fallback = "no device";
  const json document = written(mesh, answer);
  EXPECT_EQ(document["pairs"][1]["tunnel"]["undecided_because"], "unknown");
  EXPECT_EQ(problems(document), "");
}

TEST_F(Loops_schema, refuses_what_is_something_else) {
  const Mesh mesh = small_mesh();
  const json document = written(mesh, small_answer(mesh));
  const std::function<void(json&)> changes[] = {
      [](json& d) { d["format"] = "htloops/2"; },
      [](json& d) { d.erase("certificate"); },
      [](json& d) { d["mesh"]["genus"] = -1; },
      [](json& d) { d["mesh"].erase("file"); },
      [](json& d) { d["pairs"][0]["handle"].erase("points"); },
      [](json& d) { d["pairs"][0]["handle"].erase("component"); },
      [](json& d) {
        d["pairs"][1]["tunnel"]["locations"][0] = {0, 1};
      },
      [](json& d) { d["pairs"][0]["handle"]["bounds"] = "both"; },
      [](json& d) { d["pairs"][0]["box"].erase(0); },
      [](json& d) { d["timings"]["total"] = "long"; }};
  for(const auto& change : changes) {
    json changed = document;
    change(changed);
    EXPECT_NE(problems(changed), "") << json::diff(document, changed);
  }
}
