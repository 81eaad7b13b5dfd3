// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Measures of handles beside what is known of them: shapes whose measures are known, and random
// surfaces and real meshes, whose measures are bounded from both sides by voxels, with code that
// shares nothing with what computes them but the loops (Voxel_measures.h).
//
//   benchmark_measures --analytic
//   benchmark_measures --random N [--first N] [--seed N]
//   benchmark_measures --meshes FOLDER [-n MESHES] [--faces MOST]
//   benchmark_measures --time [KIND:FACES:GENUS | FILE]...
//
// Prints tables. Fails if a measure is farther from what is known than its error, or more than 1%
// from the measure of a shape, or if a curve along which a ball is to go has less room than that.

#include "Benchmark_meshes.h"
#include "Command_line.h"
#include "Judged_measures.h"
#include "Measured_shapes.h"
#include "Random_surfaces.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
namespace generators = CGAL::Handle_tunnel_loops::generators;
using generators::Soup;
using judged_measures::Answer;
using judged_measures::find_loops;
using judged_measures::Measure;
using judged_measures::Truth;
using judged_measures::Verdict;
using Judged_mesh = judged_measures::Mesh;

// The order of magnitude is all that is told of small parts.
std::string percent(double part) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f%%", 100. * part);
  return text;
}

// ---- shapes whose measures are known

std::vector<voxel_measures::Interval> exactly(const std::vector<double>& values) {
  std::vector<voxel_measures::Interval> intervals;
  for(const double v : values)
    intervals.push_back({v, v});
  return intervals;
}

// The largest difference between answers, as a part.
double difference(const Answer& a, const Answer& b) {
  double most = 0.;
  for(const auto list : {&Answer::thickness, &Answer::clear_width})
    for(std::size_t i = 0; i < (a.*list).size(); ++i)
      most = i < (b.*list).size()
                 ? (std::max)(most, std::abs((a.*list)[i].diameter / (b.*list)[i].diameter - 1.))
                 : 1.;
  return most;
}

Answer answer_for(const Soup& soup) {
  const auto mesh = mesh_of<Judged_mesh>(soup);
  return judged_measures::answer(mesh, find_loops(mesh));
}

bool judge_shapes() {
  std::puts(
      "| shape | faces | measures | missing | farthest from the true value | largest error told "
      "| turned and permuted | voxels agree | wrong curves | s |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
  bool is_right = true;
  for(const auto& shape : measured_shapes::all())
    for(const double density : {1., 1.6, 2.5}) {
      const Soup soup = shape.mesh(density);
      const auto mesh = mesh_of<Judged_mesh>(soup);
      const auto pairs = find_loops(mesh);
      const Answer answer = judged_measures::answer(mesh, pairs);
      const Verdict verdict =
          judged_measures::verdict(answer, {exactly(shape.thickness), exactly(shape.clear_width)});
      random_surfaces::Random random(3);
      Soup other = generators::permute_vertices(soup, 3);
      random_surfaces::turn(other, random);
      const double moved = difference(answer, answer_for(other));
      bool is_bounded = true; // finer meshes take voxels long, and are not other shapes
      if(density == 1.) {
        const Truth truth = judged_measures::truth(mesh, pairs);
        is_bounded = judged_measures::do_agree(truth) &&
                     judged_measures::verdict(answer, truth.fine).apart == 0;
      }
      const std::size_t wrong = judged_measures::wrong_curves(mesh, pairs, answer);
      std::printf("| %s | %zu | %zu | %zu | %s | %s | %s | %s | %zu | %.2f |\n", shape.name,
                  soup.triangles.size(), verdict.number, verdict.missing,
                  percent(verdict.farthest).c_str(), percent(verdict.error).c_str(),
                  percent(moved).c_str(),
                  !is_bounded     ? "**no**"
                  : density == 1. ? "yes"
                                  : "",
                  wrong, answer.seconds);
      std::fflush(stdout);
      is_right = is_right && verdict.missing == 0 && verdict.farthest <= 0.01 && moved <= 0.005 &&
                 is_bounded && wrong == 0;
    }
  return is_right;
}

// ---- others, beside voxels

/// Takes one surface after the other, and keeps count.
class Trial
{
public:
  Trial() {
    std::puts(
        "| surface | faces | genus | measures | missing | beyond their error | farthest from an "
        "interval | widest interval | largest error told | wrong curves | voxels, s | s |\n"
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
  }

  void
  try_one(const std::string& name, const Judged_mesh& mesh, const judged_measures::Pairs& pairs) {
    const Answer answer = judged_measures::answer(mesh, pairs);
    const Truth truth = judged_measures::truth(mesh, pairs);
    const bool is_any_known = !truth.fine.thickness.empty() || !truth.fine.clear_width.empty();
    const Verdict verdict =
        is_any_known ? judged_measures::verdict(answer, truth.fine) : Verdict(); // too many cubes
    const std::size_t wrong = judged_measures::wrong_curves(mesh, pairs, answer);
    const bool is_truth = judged_measures::do_agree(truth);
    std::printf("| %s%s%s | %zu | %zu | %zu | %zu | %zu | %s | %s | %s | %zu | %.1f | %.2f |\n",
                name.c_str(), is_truth ? "" : " (**voxels contradict each other**)",
                is_any_known ? "" : " (voxels tell nothing)", std::size_t(num_faces(mesh)),
                pairs.size(), verdict.number, verdict.missing, verdict.apart,
                percent(verdict.farthest).c_str(), percent(verdict.widest).c_str(),
                percent(verdict.error).c_str(), wrong, truth.seconds, answer.seconds);
    if(verdict.missing + verdict.apart + wrong != 0 || !is_truth)
      print_values(answer, truth);
    std::fflush(stdout);
    ++number_;
    measures_ += verdict.number;
    missing_ += verdict.missing;
    apart_ += verdict.apart;
    wrong_ += wrong;
    contradictions_ += !is_truth;
    if(is_any_known)
      widest_.push_back(verdict.widest);
    absent_ += 2 * pairs.size() - answer.thickness.size() - answer.clear_width.size();
  }

  /// Returns whether all is well.
  bool print_sums() const {
    if(widest_.empty())
      return absent_ + wrong_ == 0;
    std::printf("\n%zu surfaces, %zu measures absent, %zu wrong curves. On %zu of them voxels tell "
                "%zu intervals: %zu measures missing, %zu farther from them than their error; "
                "voxels contradict each other on %zu; the widest interval is %s in the middle of "
                "the surfaces\n",
                number_, absent_, wrong_, widest_.size(), measures_, missing_, apart_,
                contradictions_, percent(median(widest_)).c_str());
    return absent_ + missing_ + apart_ + wrong_ + contradictions_ == 0;
  }

private:
  static void print_values(const Answer& answer, const Truth& truth) {
    const auto print = [](const char* words, const std::vector<Measure>& measures,
                          const std::vector<voxel_measures::Interval>& known) {
      std::printf("%s", words);
      for(std::size_t i = 0; i < (std::max)(measures.size(), known.size()); ++i) {
        if(i < measures.size())
          std::printf(" %.5g (%.2g)", measures[i].diameter, measures[i].error);
        if(i < known.size())
          std::printf(" in [%.5g, %.5g]", known[i].lower, known[i].upper);
        std::printf(";");
      }
      std::puts("");
    };
    print("  thickness:", answer.thickness, truth.fine.thickness);
    print("  clear width:", answer.clear_width, truth.fine.clear_width);
    if(!answer.why.empty())
      std::printf("  why: %s\n", answer.why.c_str());
  }

  std::size_t number_ = 0, measures_ = 0, absent_ = 0, missing_ = 0, apart_ = 0, wrong_ = 0,
              contradictions_ = 0;
  std::vector<double> widest_;
};

bool judge_random(const corpus::Command_line& line) {
  Trial trial;
  std::size_t tried = 0;
  for(std::size_t i = line.number("--first", 0); tried < line.number("--random", 200); ++i) {
    const auto surface = random_surfaces::random_surface(i, line.number("--seed", 0));
    const std::size_t genus = generators::genus(surface.soup);
    if(genus < 1 || genus > 30)
      continue;
    const auto mesh = mesh_of<Judged_mesh>(surface.soup);
    ++tried;
    trial.try_one(std::to_string(i) + " " + surface.words, mesh, find_loops(mesh));
  }
  return trial.print_sums();
}

bool judge_meshes(const corpus::Command_line& line, const std::string& folder) {
  Trial trial;
  std::size_t left = line.number("-n", 40);
  std::vector<std::filesystem::path> files;
  for(const auto& entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string crossing;
  for(const auto& file : files) {
    Judged_mesh mesh;
    if(left == 0)
      break;
    if(!CGAL::IO::read_polygon_mesh(file.string(), mesh) || !CGAL::is_closed(mesh) ||
       num_faces(mesh) > line.number("--faces", 120000))
      continue;
    if(PMP::does_self_intersect(mesh)) {
      crossing += " " + file.stem().string();
      continue;
    }
    const auto pairs = find_loops(mesh);
    if(pairs.empty() || pairs.size() > 30)
      continue;
    --left;
    trial.try_one(file.stem().string(), mesh, pairs);
  }
  const bool is_right = trial.print_sums();
  std::printf("\nThese cross themselves:%s\n", crossing.c_str());
  return is_right;
}

// ---- seconds

void time_one(const std::string& input) {
  const Off_file file(input);
  double began = judged_measures::seconds();
  Judged_mesh mesh;
  CGAL::IO::read_polygon_mesh(file.name(), mesh);
  const double reading = judged_measures::seconds() - began;
  began = judged_measures::seconds();
  const auto pairs = find_loops(mesh);
  const double loops = judged_measures::seconds() - began;
  const Answer answer = judged_measures::answer(mesh, pairs);
  std::printf("| %s | %zu | %zu | %.2f | %.2f | %.2f | %.1f |\n", input.c_str(),
              std::size_t(num_faces(mesh)), pairs.size(), reading, loops, answer.seconds,
              answer.seconds / reading);
  std::fflush(stdout);
}

void time_all(const corpus::Command_line& line) {
  std::puts(
      "| mesh | faces | genus | reading, s | loops, s | measures, s | measures over reading |\n"
      "| --- | --- | --- | --- | --- | --- | --- |");
  std::vector<std::string> inputs;
  for(const auto& file : line.files())
    inputs.push_back(file.string());
  if(inputs.empty())
    inputs = {"torus:100000:1", "gyroid:100000:20", "plates:20000:200", "gyroid:1000000:250"};
  for(const std::string& input : inputs)
    time_one(input);
}

bool run(const corpus::Command_line& line) {
  bool is_right = true;
  if(line.has("--analytic"))
    is_right = judge_shapes() && is_right;
  if(line.has("--random"))
    is_right = judge_random(line) && is_right;
  if(line.has("--meshes"))
    is_right = judge_meshes(line, line.text("--meshes")) && is_right;
  if(line.has("--time"))
    time_all(line);
  return is_right;
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    return run(corpus::Command_line(argc, argv, {"--analytic", "--time"},
                                    {"--random", "--meshes", "--first", "--seed", "-n", "--faces"}))
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
