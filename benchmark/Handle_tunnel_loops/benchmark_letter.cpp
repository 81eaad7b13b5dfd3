// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Follows rules of the paper to the letter, one at a time and all together, on the closed meshes of
// a folder, or on generated shapes if none is given, and prints where they fail.
//
//   benchmark_letter [--faces LIMIT] [--verbose] [FOLDER | FILE]...

#include "Subjects.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>

#include <cstdio>
#include <functional>
#include <iostream>
#include <map>

namespace {

using namespace corpus;
using HTL::Literal_rules;
using HTL::Stage;
namespace params = CGAL::parameters;

struct Row
{
  const char* name;
  Literal_rules rules;
};

std::vector<Row> rows() {
  std::vector<Row> rows = {{"none", {}}};
  const auto add = [&rows](const char* name, const std::function<void(Literal_rules&)>& set) {
    rows.push_back({name, {}});
    set(rows.back().rules);
  };
  add("finite elements", [](Literal_rules& r) { r.finite_elements = true; });
  for(const auto& [name, length] : {std::pair("a = 1/25, edges of length 1", 1.),
                                    std::pair("a = 1/25, edges of length 1/2", 0.5),
                                    std::pair("a = 1/25, edges of length 1/5", 0.2)})
    add(name, [length = length](Literal_rules& r) {
      r.gradient_coefficient = true;
      r.mean_edge_length = length;
    });
  for(const auto& [name, contact] :
      {std::pair("bands, contact at 0", 0.), std::pair("bands, contact at 0.1", 0.1)})
    add(name, [contact = contact](Literal_rules& r) {
      r.bands = true;
      r.contact_threshold = contact;
    });
  add("covered area", [](Literal_rules& r) { r.covered_area = true; });
  add("first reached", [](Literal_rules& r) { r.first_reached = true; });
  add("refined always", [](Literal_rules& r) { r.refined_always = true; });
  rows.push_back({"all", Literal_rules::all()});
  return rows;
}

// In which stage it is.
struct Stage_visitor : public HTL::Default_visitor
{
  Stage* stage;

  explicit Stage_visitor(Stage& s)
      : stage(&s) {}
  void start_stage(Stage s) const { *stage = s; }
};

// What became of the meshes under one rule.
struct Outcome
{
  std::size_t answered = 0, shorter = 0;
  std::map<Stage, std::size_t> failed;
  std::vector<double> ratios; // of total lengths to those of the reference
  double seconds = 0.;

  std::size_t failed_in(Stage stage) const {
    const auto it = failed.find(stage);
    return it == failed.end() ? 0 : it->second;
  }
};

Answer answer_to(const Mesh& mesh, const Literal_rules& rules, Stage& stage) {
  Answer answer;
  HTL::Solver_options options = untouched();
  options.literal_rules = rules;
  const double start = seconds_now();
  try {
    CGAL::handle_tunnel_loops<CGAL::Reference_tag>(
        mesh, std::back_inserter(answer.pairs),
        params::solver_options(options).visitor(Stage_visitor(stage)));
  } catch(const std::exception& e) {
    answer.error = e.what();
  }
  answer.seconds = seconds_now() - start;
  return answer;
}

class Letter
{
public:
  explicit Letter(bool is_verbose)
      : is_verbose_(is_verbose)
      , rows_(rows())
      , outcomes_(rows_.size()) {}

  void run_on(const Subject& subject) {
    ++meshes_;
    faces_ += subject.mesh.number_of_faces();
    double length = 0.; // by no rule
    for(std::size_t i = 0; i < rows_.size(); ++i)
      run_on(subject.mesh, subject.name, i, length);
  }

  /// whether the solver that follows none of them had an answer for each mesh.
  bool has_all_answers() const { return outcomes_.front().answered == meshes_; }

  void print() const {
    std::printf("%zu meshes, %zu faces in all\n\n", meshes_, faces_);
    std::printf("| rule | answered | initial pass | tunnel pass | refinement | no basis | length: "
                "median | most | seconds |\n|---|---|---|---|---|---|---|---|---|\n");
    for(std::size_t i = 0; i < rows_.size(); ++i) {
      const Outcome& o = outcomes_[i];
      std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %.2f | %.2f | %.0f |\n", rows_[i].name,
                  o.answered, o.failed_in(Stage::INITIAL), o.failed_in(Stage::TUNNEL),
                  o.failed_in(Stage::REFINE),
                  o.failed_in(Stage::CERTIFICATE) + o.failed_in(Stage::CLASSIFY),
                  quantile(o.ratios, 0.5), quantile(o.ratios, 1.), o.seconds);
    }
  }

private:
  void run_on(const Mesh& mesh, const std::string& name, std::size_t i, double& length) {
    Stage stage = Stage::ADAPTOR;
    const Answer answer = answer_to(mesh, rows_[i].rules, stage);
    Outcome& outcome = outcomes_[i];
    outcome.seconds += answer.seconds;
    const auto lengths = answer.lengths();
    if(i == 0)
      length = lengths[0] + lengths[1];
    if(answer.error.empty()) {
      ++outcome.answered;
      if(length > 0.)
        outcome.ratios.push_back((lengths[0] + lengths[1]) / length);
    } else
      ++outcome.failed[stage];
    if(is_verbose_) {
      std::fprintf(stderr, "%s, %s: %s\n", name.c_str(), rows_[i].name,
                   answer.error.empty() ? "answered" : answer.error.c_str());
    }
  }

  bool is_verbose_;
  std::vector<Row> rows_;
  std::vector<Outcome> outcomes_;
  std::size_t meshes_ = 0, faces_ = 0;
};

} // namespace

int main(int argc, char* argv[]) {
  try {
    const Command_line line(argc, argv, {"--verbose"}, {"--faces"});
    Letter letter(line.has("--verbose"));
    const auto run = [&](const Subject& subject) { letter.run_on(subject); };
    if(line.files().empty())
      for_each_generated_subject(run);
    for_each_subject_of_files(line, 60000, run);
    letter.print();
    return letter.has_all_answers() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
