// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Draws curve skeletons in many generated surfaces, and in files, and finds out whether they are
// what they are to be by definition: every edge against every face and every other edge, and
// linking numbers, in exact arithmetic, by code that shares nothing with what draws or certifies
// them (Skeleton_definitions.h).
//
//   benchmark_skeleton_truth [-n SURFACES] [--first N] [--seed N] [--write FOLDER] [FILE]...
//
// Prints a line for each answer that is not certified or not true, with the reason. Fails if there
// is one in a surface that does not cross itself, be it with the caps that close it. --write keeps
// the surfaces of such lines.

#include "Command_line.h"
#include "Meshes_of_soups.h"
#include "Rough_surfaces.h"
#include "Skeleton_definitions.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/curve_skeleton.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Exact_mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using skeleton_definitions::Skeleton;
using skeleton_definitions::Truth;

/// What became of one surface.
struct Result
{
  CGAL::Handle_tunnel_loops::Skeleton_statistics statistics;
  Truth truth;
  bool has_all_inlets = true, crosses = false;
  std::size_t edges = 0;
  double seconds = 0.; // of the answer

  bool is_certified() const { return bool(statistics.certificate); }
  bool is_true() const {
    return truth.is_connected && truth.is_inside && truth.is_embedded && truth.is_basis &&
           has_all_inlets;
  }
};

// With the caps that close it.
bool crosses_itself(const Exact_mesh& mesh, const Skeleton& skeleton) {
  const skeleton_definitions::Capped_surface<Exact_mesh> capped(mesh, skeleton);
  std::vector<Exact_mesh::Point> points;
  std::vector<std::vector<std::size_t>> triangles;
  std::map<Exact_mesh::Point, std::size_t> number;
  for(const auto& triangle : capped.triangles) {
    triangles.emplace_back();
    for(int k = 0; k < 3; ++k) {
      const auto& p = triangle.exact[k];
      const Exact_mesh::Point q(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                CGAL::to_double(p.z()));
      const auto [known, is_new] = number.emplace(q, points.size());
      if(is_new)
        points.push_back(q);
      triangles.back().push_back(known->second);
    }
  }
  if(!PMP::is_polygon_soup_a_polygon_mesh(triangles))
    return true;
  Exact_mesh closed;
  PMP::polygon_soup_to_polygon_mesh(points, triangles, closed);
  return PMP::does_self_intersect(closed);
}

Result result_of(const Exact_mesh& mesh) {
  Result result;
  CGAL::Curve_skeleton<Exact_mesh> graph;
  const std::clock_t began = std::clock();
  result.statistics = CGAL::curve_skeleton(mesh, graph);
  result.seconds = double(std::clock() - began) / CLOCKS_PER_SEC;
  const Skeleton skeleton = skeleton_definitions::skeleton_of(graph);
  result.edges = skeleton.edges.size();
  result.truth = skeleton_definitions::truth(mesh, skeleton, find_loops(mesh));
  result.has_all_inlets = std::size_t(std::count(skeleton.is_inlet.begin(), skeleton.is_inlet.end(),
                                                 true)) == result.statistics.number_of_boundaries;
  if(!result.is_certified() || !result.is_true())
    result.crosses = crosses_itself(mesh, skeleton);
  return result;
}

void print(const std::string& name, const Result& r) {
  std::string reason = r.statistics.certificate.failure.substr(0, 300);
  std::replace(reason.begin(), reason.end(), '\n', ';');
  std::printf(
      "%s (%zu faces, genus %zu, %zu components, %zu boundary curves): %s, %s%s%s%s%s%s%s\n",
      name.c_str(), r.statistics.number_of_faces, r.statistics.genus,
      r.statistics.number_of_components, r.statistics.number_of_boundaries,
      r.crosses ? "crosses itself" : "**WRONG**", r.is_certified() ? "certified" : "not certified",
      r.truth.is_connected ? "" : ", not connected", r.truth.is_inside ? "" : ", not inside",
      r.truth.is_embedded ? "" : ", not embedded", r.truth.is_basis ? "" : ", no basis",
      r.has_all_inlets ? "" : ", inlets are missing",
      reason.empty() ? "" : (": " + reason).c_str());
  std::fflush(stdout);
}

/// Takes one after the other.
class Trial
{
public:
  explicit Trial(std::string folder)
      : folder_(std::move(folder)) {}

  void try_one(const std::string& name, const Exact_mesh& mesh) {
    const Result r = result_of(mesh);
    ++number_;
    faces_ += r.statistics.number_of_faces;
    edges_ += r.edges;
    seconds_ += r.seconds;
    if(r.is_certified() && r.is_true()) {
      ++good_;
      return;
    }
    r.crosses ? ++crossing_ : ++wrong_;
    print(name, r);
    if(!folder_.empty())
      CGAL::IO::write_polygon_mesh(
          (std::filesystem::path(folder_) / (std::to_string(number_ - 1) + ".off")).string(), mesh,
          CGAL::parameters::stream_precision(17));
  }

  /// Returns whether all is well.
  bool print_sums() const {
    std::printf("%zu surfaces, %zu faces: %zu skeletons of %zu edges in %.0f s; %zu certified and "
                "true, %zu in surfaces that cross themselves, %zu wrong\n",
                number_, faces_, number_, edges_, seconds_, good_, crossing_, wrong_);
    return wrong_ == 0;
  }

private:
  std::string folder_;
  std::size_t number_ = 0, faces_ = 0, edges_ = 0, good_ = 0, crossing_ = 0, wrong_ = 0;
  double seconds_ = 0.;
};

bool run(const corpus::Command_line& line) {
  Trial trial(line.text("--write"));
  for(const auto& file : line.files()) {
    Exact_mesh mesh;
    if(!CGAL::IO::read_polygon_mesh(file.string(), mesh))
      throw std::runtime_error(file.string() + " cannot be read");
    trial.try_one(file.stem().string(), mesh);
  }
  const std::size_t first = line.number("--first", 0), seed = line.number("--seed", 0);
  for(std::size_t i = first; i < first + line.number("-n", line.files().empty() ? 1000 : 0); ++i) {
    const auto surface = rough_surfaces::rough_surface(i, seed);
    trial.try_one(std::to_string(i) + " " + surface.words, mesh_of<Exact_mesh>(surface.soup));
  }
  return trial.print_sums();
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    return run(corpus::Command_line(argc, argv, {}, {"-n", "--first", "--seed", "--write"}))
               ? EXIT_SUCCESS
               : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
