// Removes handles, and measures that as a multiple of the time that CGAL::IO::read_polygon_mesh
// takes for the same mesh as an OFF file, in one run, beyond finding the loops; and the memory that
// it takes beyond the mesh. With --check, what comes out is put through programs of others. What
// becomes of the shape is summed up at the end: volumes and boxes are those of the meshes, the rest
// is what reports say.
//
//   benchmark_removal [-n RUNS] [--genus G | --half | --necks LENGTH] [--check]
//                     [KIND:FACES:GENUS | FILE]...
//
// Each time is the median of the runs.

#include "Benchmark_meshes.h"
#include "Counting_allocation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/remove_handles.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <map>
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
};

struct Sum
{
  std::size_t removed = 0, refused = 0;
  std::map<std::string, std::size_t> reasons;
  // Of the shapes.
  std::size_t wrong_signs = 0, large_caps = 0;                // handles
  std::size_t sharp = 0, larger_boxes = 0, other_volumes = 0; // meshes
  std::vector<double> displacements; // in lengths of the loop, the largest of each mesh
  std::vector<double> times;         // over those for the loops
};

void add_shape(const Mesh& before, const Mesh& after, const HTL::Removal_report& report, Sum& sum) {
  const double volume = std::abs(PMP::volume(before));
  double displacement = 0., taken = 0.;
  for(const HTL::Removed_handle& handle : report.removed) {
    const HTL::Shape_change& change = handle.change;
    sum.wrong_signs +=
        (handle.by == HTL::Removal_way::CUT && change.volume_added > 1e-9 * volume) ||
        (handle.by == HTL::Removal_way::FILL && change.volume_removed > 1e-9 * volume);
    sum.large_caps += change.cap_ratio > 3.;
    displacement = (std::max)(displacement, change.displacement / handle.length);
    taken += handle.volume;
  }
  sum.sharp += report.change().sharpest_angle < 30.;
  sum.displacements.push_back(displacement);
  sum.other_volumes += std::abs(volume - std::abs(PMP::volume(after)) - taken) > 1e-6 * volume;
  const CGAL::Bbox_3 box = PMP::bbox(before);
  sum.larger_boxes += (box + PMP::bbox(after)) != box;
}

HTL::Removal_report remove(Mesh& mesh, const Pairs& pairs, const Wish& wish) {
  const std::size_t genus = wish.half ? pairs.size() / 2 : (std::min)(wish.genus, pairs.size());
  HTL::Removal_options options;
  options.target_genus = genus;
  options.maximal_neck_length = wish.neck_length;
  return CGAL::remove_handles<Tag>(mesh,
                                   params::removal_options(options, params::known_loops(pairs)));
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
  add_shape(before, mesh, report, sum);
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

} // namespace

int main(int argc, char* argv[]) {
  Wish wish;
  std::vector<std::string> inputs;
  for(int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if(word == "-n" && has_value)
      wish.number_of_runs = (std::max)(1, std::atoi(argv[++i]));
    else if(word == "--genus" && has_value)
      wish.genus = std::strtoul(argv[++i], nullptr, 10);
    else if(word == "--necks" && has_value)
      wish.neck_length = std::atof(argv[++i]);
    else if(word == "--half")
      wish.half = true;
    else if(word == "--check")
      wish.check = true;
    else
      inputs.push_back(word);
  }
  if(inputs.empty())
    inputs = {"gyroid:1000000:250", "scan:1000000:3", "lattice:1000000:250"};
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
  if(sum.times.empty())
    return 0;
  std::printf(
      "\nfills that take solid away, cuts that add some: %zu\ncaps of over 3 circles: %zu\n"
      "meshes with an angle below 30 degrees at a cap: %zu, with a larger box: %zu, with another "
      "change of volume than the report says: %zu\n",
      sum.wrong_signs, sum.large_caps, sum.sharp, sum.larger_boxes, sum.other_volumes);
  std::printf("largest displacement, in lengths of the loop: median %.3f, most %.3f\n",
              median(sum.displacements),
              *std::max_element(sum.displacements.begin(), sum.displacements.end()));
  std::printf("removing / finding the loops: median %.2f, most %.2f\n", median(sum.times),
              *std::max_element(sum.times.begin(), sum.times.end()));
}
