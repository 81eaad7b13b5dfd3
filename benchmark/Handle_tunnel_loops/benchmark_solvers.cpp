// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Runs the paper to the letter, the reference solver and the host solver on the same meshes,
// generated shapes and the closed meshes of a folder, and prints what each pass finds, how many
// loops bound on one side, how many have the right name, and how long they are.
//
//   benchmark_solvers [--faces LIMIT] [--verbose] [FOLDER | FILE]...

#include "Subjects.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Handle_tunnel_loops/certificate.h>

#include <cstdio>
#include <functional>
#include <iostream>

namespace {

using namespace corpus;
using HTL::Literal_rules;
namespace params = CGAL::parameters;

struct Kind_of_solver
{
  const char* name;
  std::function<Answer(Solver&)> answer;
};

// Nothing follows the passes.
Kind_of_solver by_rules(const char* name, const Literal_rules& rules) {
  HTL::Solver_options options = untouched();
  options.literal_rules = rules;
  return {name, [options](Solver& solver) {
            return answer_of<CGAL::Reference_tag>(solver, params::solver_options(options));
          }};
}

std::vector<Kind_of_solver> solvers() {
  Literal_rules all_but_bands = Literal_rules::all();
  all_but_bands.bands = false;
  Literal_rules wide_fronts = all_but_bands;
  wide_fronts.finite_elements = false;
  return {by_rules("literal", Literal_rules::all()),
          by_rules("literal, without bands", all_but_bands),
          by_rules("literal, without bands and finite elements", wide_fronts),
          by_rules("reference", {}),
          {"host, its passes alone",
           [](Solver& solver) {
             return answer_of<CGAL::Sequential_tag>(solver, params::solver_options(untouched()));
           }},
          {"host, loops made pure and tightened", [](Solver& solver) {
             return answer_of<CGAL::Sequential_tag>(solver, params::default_values());
           }}};
}

// The sums over the meshes for one solver.
struct Sums
{
  std::size_t answered = 0, pairs = 0; // certified, with as many pairs as handles
  std::size_t swept = 0, exact = 0;    // meetings; meshes with as many as handles
  std::size_t traced = 0, refined = 0;
  std::size_t told = 0, pure = 0, named = 0; // loops
  std::vector<double> ratios;                // of lengths to those of the host solver
  double seconds = 0.;
};

class Comparison
{
public:
  explicit Comparison(bool is_verbose)
      : is_verbose_(is_verbose) {}

  void run_on(const Subject& subject) {
    ++meshes_;
    handles_ += subject.genus;
    faces_ += subject.mesh.number_of_faces();
    Solver solver(CGAL::Sequential_tag(), subject.mesh, params::default_values());
    const double length = total_length(solvers_.back().answer(solver));
    for(std::size_t i = 0; i < solvers_.size(); ++i)
      add(subject, solvers_[i].name, solvers_[i].answer(solver), length, sums_[i]);
  }

  void print() const {
    std::printf("%zu meshes, %zu faces, %zu handles\n\n", meshes_, faces_, handles_);
    std::printf(
        "| solver | meshes answered | handles after the initial pass | meshes with all of them "
        "| tunnels after the tunnel pass | handles replaced by the refinement | loops that "
        "bound on one side | loops with the right name | length over the host's: median | "
        "least | most | seconds |\n|---|");
    for(int i = 1; i < 12; ++i)
      std::printf("---:|");
    std::printf("\n");
    for(std::size_t i = 0; i < solvers_.size(); ++i)
      print_row(solvers_[i].name, sums_[i]);
  }

  /// whether the solvers that are to answer always did.
  bool is_right() const {
    for(std::size_t i = sums_.size() - 3; i < sums_.size(); ++i)
      if(sums_[i].answered != meshes_ || sums_[i].pairs != handles_)
        return false;
    return true;
  }

private:
  void add(const Subject& subject,
           const char* name,
           const Answer& answer,
           double length,
           Sums& sums) const {
    const HTL::Statistics& s = answer.statistics;
    sums.seconds += answer.seconds;
    sums.swept += s.swept_handles;
    sums.exact += s.swept_handles == subject.genus;
    sums.traced += s.traced_tunnels;
    sums.refined += s.refined_handles;
    if(is_verbose_)
      std::fprintf(stderr, "%s, %s: %s\n", subject.name.c_str(), name,
                   answer.error.empty() ? "answered" : answer.error.c_str());
    if(!answer.error.empty())
      return;
    ++sums.answered;
    sums.pairs += answer.pairs.size();
    sums.ratios.push_back(total_length(answer) / length);
    count_sides(subject.mesh, answer, sums);
  }

  // By linking numbers, whoever found the loops; on their component, as if there were no others.
  static void count_sides(const Mesh& mesh, const Answer& answer, Sums& sums) {
    const HTL::Certificate certificate = CGAL::certify_handle_tunnel_loops(mesh, answer.pairs);
    sums.told += certificate.linking.size();
    for(std::size_t i = 0; i < certificate.linking.size(); ++i) {
      const HTL::Loop_linking& l = certificate.linking[i];
      sums.pure += l.problem.empty() && (l.bounds_inside_component || l.bounds_outside_component);
      sums.named += l.problem.empty() &&
                    (i % 2 == 0 ? l.bounds_inside_component : l.bounds_outside_component);
    }
  }

  void print_row(const char* name, const Sums& s) const {
    const auto part = [](std::size_t of, std::size_t all) {
      return all == 0 ? std::string("-") : std::to_string(of) + " of " + std::to_string(all);
    };
    const auto ratio = [&](double q) {
      char text[32];
      std::snprintf(text, sizeof(text), "%.3f", quantile(s.ratios, q));
      return s.ratios.empty() ? std::string("-") : std::string(text);
    };
    std::printf("| %s | %zu | %s | %zu | %s | %zu | %s | %s | %s | %s | %s | %.1f |\n", name,
                s.answered, part(s.swept, handles_).c_str(), s.exact,
                part(s.traced, handles_).c_str(), s.refined, part(s.pure, s.told).c_str(),
                part(s.named, s.told).c_str(), ratio(0.5).c_str(), ratio(0.).c_str(),
                ratio(1.).c_str(), s.seconds);
  }

  bool is_verbose_;
  std::vector<Kind_of_solver> solvers_ = solvers();
  std::vector<Sums> sums_ = std::vector<Sums>(solvers_.size());
  std::size_t meshes_ = 0, handles_ = 0, faces_ = 0;
};

} // namespace

int main(int argc, char* argv[]) {
  try {
    const Command_line line(argc, argv, {"--verbose"}, {"--faces"});
    Comparison comparison(line.has("--verbose"));
    for_each_subject(line, 20000, [&](const Subject& subject) { comparison.run_on(subject); });
    comparison.print();
    return comparison.is_right() ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
