// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// No value of a document can be changed without `htloops check` saying so, or saying that it does
// not look at it.

#include "Meshes_of_soups.h"
#include "Washer.h"

#include "app/check/claims.h"
#include "app/failure.h"
#include "app/solve/backends.h"
#include "app/solve/details.h"
#include "app/solve/skeleton_solver.h"
#include "app/solve/throat_solver.h"
#include "generators/generators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_htloops_claims {

using namespace htloops;
using htloops::Mesh;

// A document about a mesh.
struct Case
{
  Mended_mesh mended;
  Json document;

  bool is_about_skeleton() const { return document["format"] == "htloops-skeleton/1"; }

  // What is wrong with a document about this mesh.
  std::vector<std::string> problems_of(const Json& changed) const {
    const Input_file file = Input_file::in_memory("a.json", text_of(changed));
    Progress progress;
    try {
      return is_about_skeleton() ? check_skeleton(file, mended.mesh, progress).problems
                                 : check_loops(file, mended, progress).problems;
    } catch(const Failure& failure) {
      return {failure.what()};
    }
  }
};

Mended_mesh mended_mesh_of(const ::Soup& soup) { return {mesh_of<Mesh>(soup), {}, {}, {}, {}}; }
Mended_mesh mended_mesh_of(const Recipe& recipe) { return mended_mesh_of(soup_of(recipe)); }

::Soup open_soup(std::size_t genus) {
  return generators::with_holes(soup_of(Recipe{"multi-torus", {600, genus, 0}}), {3, 8, false});
}

using Complete = std::function<void(const Mesh&, Answer&)>;

Case case_of_loops(
    Mended_mesh mended,
    const Complete& complete = [](const Mesh&, Answer&) {},
    const Solve_options& options = {}) {
  Case made = {std::move(mended), {}};
  const Mesh& mesh = made.mended.mesh;
  Progress progress;
  Answer answer = host_backend.solve(mesh, options, progress);
  add_details(mesh, true, answer);
  answer.unit = made.mended.facts.unit;
  complete(mesh, answer);
  const Json told = {{"basis", CGAL::Handle_tunnel_loops::name_of(options.basis_kind)},
                     {"measure", !answer.measures.empty()},
                     {"removal", !answer.costs.empty()},
                     {"throats", answer.throats.are_wanted},
                     {"seed", nullptr}};
  made.document = loops_document(mesh, answer, {"a.off", told, 0.125, made.mended.cuts});
  return made;
}

Case case_of_skeleton(const ::Soup& soup) {
  Case made = {mended_mesh_of(soup), {}};
  Progress progress;
  made.document = skeleton_document(find_skeleton(made.mended.mesh, {}, progress),
                                    {"a.off", {{"shortest_limb", 1.}}, 0.125});
  return made;
}

// ---- changes

/// Visits the values of a document that are no objects; of arrays the first and the last element.
class Leaf_visitor
{
public:
  using Visit = std::function<void(Json&, const std::vector<std::string>&)>;

  Leaf_visitor(Json& document, const Visit& visit)
      : visit_(visit) {
    go(document);
  }

private:
  void go(Json& value) {
    if(value.is_object())
      for(const auto& [key, member] : value.items()) {
        keys_.push_back(key);
        go(member);
        keys_.pop_back();
      }
    else if(value.is_array() && !value.empty()) {
      go(value.front());
      if(value.size() > 1)
        go(value.back());
    } else if(!value.is_array())
      visit_(value, keys_);
  }

  const Visit& visit_;
  std::vector<std::string> keys_;
};

// Something else, of the same kind. Of an edge that is crossed at its end, another one names the
// same place, so places get vertices that do not exist.
Json changed(const Json& value, const std::string& key) {
  static const std::map<std::string, std::string> others = {
      {"inside", "outside"}, {"outside", "inside"}, {"neither", "inside"}, {"both", "inside"},
      {"handle", "tunnel"},  {"tunnel", "handle"},  {"bore", "handle"},    {"pure", "shortest"},
      {"shortest", "pure"},  {"end", "inlet"},      {"inlet", "end"},      {"joint", "bend"},
      {"bend", "joint"},     {"inch", "meter"}};
  if(value.is_boolean())
    return !value.get<bool>();
  if(value.is_number_float())
    return value.get<double>() + 0.01 * (std::max)(std::abs(value.get<double>()), 1.);
  if(value.is_number())
    return value.get<long long>() + (key == "locations" ? 1000000 : 1);
  if(value.is_string()) {
    const auto found = others.find(value.get<std::string>());
    return found == others.end() ? value.get<std::string>() + "?" : found->second;
  }
  return 7;
}

bool is_named(const std::vector<std::string>& problems, const std::string& key) {
  // What a certificate does not call by its key.
  static const std::map<std::string, std::string> words = {{"locations", "position"},
                                                           {"points", "position"},
                                                           {"polyline", ""},
                                                           {"position", ""},
                                                           {"kind", ""}};
  const auto word = words.find(key);
  return std::any_of(problems.begin(), problems.end(), [&](const std::string& problem) {
    return problem.find(word == words.end() ? key : word->second) != std::string::npos;
  });
}

bool is_not_compared(const std::vector<std::string>& keys) {
  return std::any_of(keys.begin(), keys.end(), [](const std::string& key) {
    const char* reason = why_not_compared(key);
    return reason != nullptr && *reason != '\0';
  });
}

// Of values in members of these names, or of all if there are none.
void expect_no_change_passes(const Case& original, const std::set<std::string>& within = {}) {
  EXPECT_EQ(original.problems_of(original.document), std::vector<std::string>());
  Json document = original.document;
  std::size_t number = 0;
  Leaf_visitor(document, [&](Json& value, const std::vector<std::string>& keys) {
    if(!within.empty() && std::none_of(keys.begin(), keys.end(), [&](const std::string& key) {
         return within.count(key) != 0;
       }))
      return;
    ++number;
    const Json was = std::exchange(value, changed(value, keys.back()));
    const std::vector<std::string> problems = original.problems_of(document);
    EXPECT_TRUE(is_named(problems, keys.back()) || is_not_compared(keys))
        << keys.back() << " changed from " << text_of(was) << " to " << text_of(value) << ": "
        << (problems.empty() ? "no problem" : problems.front());
    value = was;
  });
  EXPECT_GT(number, 10u);
}

TEST(Claims, are_compared_value_by_value_for_loops) {
  Mended_mesh triangulated = mended_mesh_of(Recipe{"torus", {100, 1, 0}});
  triangulated.facts.unit = Unit::INCH;
  // Edges have the numbers of halfedges.
  triangulated.cuts.assign(triangulated.mesh.number_of_halfedges(), 1);
  expect_no_change_passes(case_of_loops(std::move(triangulated)));
  Case chain = case_of_loops(mended_mesh_of(Recipe{"chain", {400, 2, 0}}));
  expect_no_change_passes(chain);
  Json& linking = chain.document["linking"]; // has no order
  EXPECT_GT(linking.size(), 1u);
  std::reverse(linking.begin(), linking.end());
  EXPECT_EQ(chain.problems_of(chain.document), std::vector<std::string>());
  Solve_options shortest;
  shortest.basis_kind = Basis_kind::SHORTEST;
  expect_no_change_passes(case_of_loops(
      mended_mesh_of(Recipe{"torus", {100, 1, 0}}), [](const Mesh&, Answer&) {}, shortest));
  expect_no_change_passes(case_of_loops(mended_mesh_of(Recipe{"sphere", {100, 0, 0}})));
}

TEST(Claims, are_compared_value_by_value_for_boundary_curves) {
  expect_no_change_passes(case_of_loops(mended_mesh_of(open_soup(1))));
}

TEST(Claims, are_compared_value_by_value_for_bores_costs_and_measures) {
  expect_no_change_passes(case_of_loops(mended_mesh_of(washer())));
  const Case measured =
      case_of_loops(mended_mesh_of(washer()), [](const Mesh& mesh, Answer& answer) {
        Progress progress;
        answer.measures = find_measures(mesh, answer.pairs, progress);
        answer.costs = find_costs(mesh, answer.pairs, progress);
      });
  expect_no_change_passes(measured, {"thickness", "clear_width", "cut", "fill"});
}

TEST(Claims, are_compared_value_by_value_for_throats) {
  expect_no_change_passes(case_of_loops(
      mended_mesh_of(Recipe{"torus", {200, 1, 0}}), [](const Mesh& mesh, Answer& answer) {
        answer.throats = find_throats(mesh, answer.pairs, answer.certificate, {});
      }));
}

TEST(Claims, are_compared_value_by_value_for_skeletons) {
  expect_no_change_passes(case_of_skeleton(soup_of(Recipe{"torus", {200, 1, 0}})));
  expect_no_change_passes(case_of_skeleton(open_soup(0)));
}

// ---- keys

void add_keys(const Json& schema, std::set<std::string>& keys) {
  if(schema.is_array())
    for(const Json& part : schema)
      add_keys(part, keys);
  if(!schema.is_object())
    return;
  for(const auto& [word, part] : schema.items())
    if(word == "properties") {
      for(const auto& [key, value] : part.items()) {
        keys.insert(key);
        if(key != "options" && key != "timings")
          add_keys(value, keys);
      }
    } else
      add_keys(part, keys);
}

TEST(Claims, are_known_by_all_keys_of_the_schemas) {
  for(const char* name : {"loops", "skeleton"}) {
    std::set<std::string> keys;
    add_keys(Json::parse(std::ifstream(HTL_SCHEMAS "/" + std::string(name) + ".schema.json")),
             keys);
    EXPECT_GT(keys.size(), 20u);
    for(const std::string& key : keys)
      EXPECT_NE(why_not_compared(key), nullptr) << key;
  }
}

// A surface that touches itself does so in many places: any of them is a reason, but none is not.
TEST(Claims, of_why_a_loop_is_undecided_may_name_another_place) {
  Case undecided = case_of_loops(mended_mesh_of(Recipe{"random", {60, 2, 0}}));
  Json& loop = undecided.document["pairs"][0]["handle"];
  ASSERT_TRUE(loop.contains("undecided_because"));
  loop["undecided_because"] = "the surface touches itself at the edge 0 - 1";
  EXPECT_EQ(undecided.problems_of(undecided.document), std::vector<std::string>());
  Case decided = case_of_loops(mended_mesh_of(Recipe{"torus", {100, 1, 0}}));
  decided.document["pairs"][0]["handle"]["undecided_because"] = "the surface touches itself";
  EXPECT_TRUE(is_named(decided.problems_of(decided.document), "undecided_because"));
}

TEST(Claims, by_unknown_keys_are_named_as_not_compared) {
  const Case original = case_of_loops(mended_mesh_of(Recipe{"torus", {100, 1, 0}}));
  Json document = original.document;
  document["pairs"][0]["colour"] = "red";
  Progress progress;
  const Checked_loops checked =
      check_loops(Input_file::in_memory("a.json", text_of(document)), original.mended, progress);
  EXPECT_TRUE(checked.problems.empty());
  std::set<std::string> keys;
  for(const auto& [reason, of_reason] : checked.not_compared)
    keys.insert(of_reason.begin(), of_reason.end());
  for(const char* key : {"colour", "timings", "options", "file", "tool", "threads"})
    EXPECT_EQ(keys.count(key), 1u) << key;
}

} // namespace test_htloops_claims
