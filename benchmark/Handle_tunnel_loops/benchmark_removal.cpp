// Removes handles, and measures that as a multiple of the time that CGAL::IO::read_polygon_mesh
// takes for the same mesh as an OFF file, in one run, beyond finding the loops; and the memory that
// it takes beyond the mesh. With --check, what comes out is put through programs of others.
//
//   benchmark_removal [-n RUNS] [--genus G | --half | --necks LENGTH] [--check]
//                     [KIND:FACES:GENUS | FILE | FOLDER]...
//
// Each time is the median of the runs. With --judge, what becomes of the shape is measured on the
// meshes before and after instead, and stands beside what is aimed at; with --ways, the first
// handles of each mesh are also removed one by one, by default, cut and filled.
//
//   benchmark_removal --judge [--ways] [-n RUNS] [FILE | FOLDER]...
//   benchmark_removal --judge-itself

#include "Benchmark_meshes.h"
#include "Command_line.h"
#include "Counting_allocation.h"
#include "Judge_cases.h"
#include "Single_ways.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/remove_handles.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace HTL = CGAL::Handle_tunnel_loops;
namespace PMP = CGAL::Polygon_mesh_processing;
namespace params = CGAL::parameters;
using Tag = CGAL::Parallel_if_available_tag;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

namespace {

struct Wish
{
  int number_of_runs = 3;
  std::size_t genus = 0;
  bool half = false;
  double neck_length = 0.;
  bool check = false;
  bool ways = false;
};

struct Sum
{
  std::size_t removed = 0, refused = 0;
  std::map<std::string, std::size_t> reasons;
  std::vector<double> times; // over those for the loops
};

HTL::Removal_options options_of(const Pairs& pairs, const Wish& wish) {
  const std::size_t genus = wish.half ? pairs.size() / 2 : (std::min)(wish.genus, pairs.size());
  HTL::Removal_options options;
  options.target_genus = genus;
  options.maximal_neck_length = wish.neck_length;
  return options;
}

HTL::Removal_report remove(Mesh& mesh, const Pairs& pairs, const Wish& wish) {
  return CGAL::remove_handles<Tag>(
      mesh, params::removal_options(options_of(pairs, wish), params::known_loops(pairs)));
}

Mesh read(const std::string& file) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

Pairs find_loops(const Mesh& mesh) {
  Pairs pairs;
  CGAL::handle_tunnel_loops<Tag>(mesh, std::back_inserter(pairs));
  return pairs;
}

bool crosses_itself(const Mesh& mesh) {
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> copy;
  CGAL::copy_face_graph(mesh, copy);
  return PMP::does_self_intersect<Tag>(copy);
}

// In words, what is wrong with the result.
std::string check(const Mesh& before, const Mesh& after) {
  if(!CGAL::is_valid_polygon_mesh(after) || !CGAL::is_closed(after))
    return "not valid";
  if(crosses_itself(before))
    return "crossed itself before";
  if(crosses_itself(after))
    return "NEW INTERSECTIONS";
  return PMP::does_bound_a_volume(after) == PMP::does_bound_a_volume(before) ? "good" : "NO VOLUME";
}

void measure(const std::string& input, const Wish& wish, Sum& sum) {
  const Off_file off(input);
  std::vector<double> reading, finding, removing, ratio;
  HTL::Removal_report report;
  Mesh mesh;
  double bytes = 0.;
  for(int run = 0; run < wish.number_of_runs; ++run) {
    const double t0 = seconds_now();
    mesh = read(off.name());
    const double t1 = seconds_now();
    const Pairs pairs = find_loops(mesh);
    const double t2 = seconds_now();
    report = remove(mesh, pairs, wish);
    const double t3 = seconds_now();
    reading.push_back(t1 - t0);
    finding.push_back(t2 - t1);
    removing.push_back(t3 - t2);
    ratio.push_back((t3 - t2) / (t1 - t0));
    if(run == 0) {
      Mesh copy = read(off.name());
      const std::size_t faces = copy.number_of_faces();
      bytes = double(counting_allocation::peak_bytes([&] { remove(copy, pairs, wish); })) /
              double(faces);
    }
  }
  const Mesh before = read(off.name());
  sum.times.push_back(median(removing) / median(finding));
  const std::string state = wish.check ? check(before, mesh) : "";
  if(state != "crossed itself before") {
    sum.removed += report.removed.size();
    sum.refused += report.refused.size();
    for(const HTL::Refused_handle& handle : report.refused)
      ++sum.reasons[handle.reason];
  }
  std::printf("| %s | %zu | %zu -> %zu | %zu | %zu | %.2f | %.2f | %.2f | **%.2f** | %.0f | %s |\n",
              input.substr(input.rfind('/') + 1).c_str(), std::size_t(mesh.number_of_faces()),
              report.genus_before, report.genus_after, report.refused.size(),
              report.removed_necks.size(), median(reading), median(finding), median(removing),
              median(ratio), bytes, state.c_str());
  std::fflush(stdout);
}

void measure_all(const std::vector<std::string>& inputs, const Wish& wish) {
  Sum sum;
  std::printf("| mesh | faces after | genus | refused | necks | reading s | loops s | removing s | "
              "removing / reading | bytes per face | result |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for(const std::string& input : inputs)
    try {
      measure(input, wish, sum);
    } catch(const std::exception& e) {
      std::cerr << "Error: " << input << ": " << e.what() << '\n';
    }
  std::printf("\n%zu removed, %zu refused\n", sum.removed, sum.refused);
  for(const auto& [reason, number] : sum.reasons)
    std::printf("%zu %s\n", number, reason.c_str());
  if(!sum.times.empty())
    std::printf("removing / finding the loops: median %.2f, most %.2f\n", median(sum.times),
                *std::max_element(sum.times.begin(), sum.times.end()));
}

// With the medians of the times of all runs.
void judge_mesh(const std::string& input, const Wish& wish, judge::Removal_targets& targets) {
  const std::string name = std::filesystem::path(input).stem().string();
  const Mesh mesh = std::filesystem::exists(input) ? read(input) : read(Off_file(input).name());
  std::vector<double> finding, removing;
  Pairs pairs;
  std::unique_ptr<judge::Judged_removal> removal;
  for(int run = 0; run < wish.number_of_runs; ++run) {
    const double start = seconds_now();
    pairs = find_loops(mesh);
    finding.push_back(seconds_now() - start);
    removal = std::make_unique<judge::Judged_removal>(mesh, pairs, options_of(pairs, wish));
    removing.push_back(removal->seconds());
  }
  const double start = seconds_now();
  const judge::Removal_judge judged = removal->judge();
  targets.add(name, removal->report(), judged);
  targets.add_times(name, median(removing) / median(finding));
  targets.print_row(name, mesh.number_of_faces(), removal->report(), judged);
  std::printf(" %.2f | %.2f | %.2f |\n", median(finding), median(removing), seconds_now() - start);
  std::fflush(stdout);
  if(wish.ways)
    judge::compare_ways(name, mesh, pairs, targets);
}

void judge_all(const std::vector<std::string>& inputs, const Wish& wish) {
  judge::Removal_targets targets;
  targets.print_head();
  std::printf(
      " loops s | removing s | judging s |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for(const std::string& input : inputs)
    try {
      judge_mesh(input, wish, targets);
    } catch(const std::exception& e) {
      std::cerr << "Error: " << input << ": " << e.what() << '\n';
    }
  targets.print();
}

// A folder stands for the meshes in it.
std::vector<std::string> meshes_of(const std::vector<std::filesystem::path>& files) {
  const std::set<std::string> endings = {".off", ".obj", ".ply", ".stl"};
  std::vector<std::string> meshes;
  for(const std::filesystem::path& file : files)
    if(!std::filesystem::exists(file) || endings.count(file.extension().string()) != 0)
      meshes.push_back(file.string());
  if(meshes.empty())
    meshes = {"gyroid:1000000:250", "scan:1000000:3", "lattice:1000000:250"};
  return meshes;
}

int run(int argc, char* argv[]) {
  const corpus::Command_line line(argc, argv,
                                  {"--half", "--check", "--judge", "--ways", "--judge-itself"},
                                  {"-n", "--genus", "--necks"});
  if(line.has("--judge-itself"))
    return judge::Judge_cases()() == 0 ? 0 : 1;
  Wish wish;
  const bool judged = line.has("--judge") || line.has("--ways");
  wish.number_of_runs = (std::max)(1, int(line.number("-n", judged ? 1 : 3)));
  wish.genus = line.number("--genus", 0);
  wish.half = line.has("--half");
  wish.check = line.has("--check");
  wish.ways = line.has("--ways");
  if(line.has("--necks"))
    wish.neck_length = std::stod(line.text("--necks"));
  const std::vector<std::string> inputs = meshes_of(line.files());
  judged ? judge_all(inputs, wish) : measure_all(inputs, wish);
  return 0;
}

} // namespace

int main(int argc, char* argv[]) try
{
  return run(argc, argv);
} catch(const std::exception& e) {
  std::cerr << "Error: " << e.what() << '\n';
  return 1;
}
