// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Makes noise on generated shapes, and on the closed meshes of a folder, decimates and remeshes
// them, and prints for each change what became of counts, certificates, sides and lengths. A count
// that is not the genus is a failure.
//
//   benchmark_robustness [--faces LIMIT] [--figures FOLDER] [--verbose] [FOLDER | FILE]...

#include "Mesh_changes.h"
#include "Subjects.h"
#include "Surface_drawing.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cstdio>
#include <functional>
#include <iostream>

namespace {

using namespace corpus;
namespace params = CGAL::parameters;
using Tag = CGAL::Parallel_if_available_tag;

struct Change
{
  std::string name;
  std::function<Mesh(const Mesh&)> make;
  double noise = -1.; // if it is noise: in mean edge lengths
};

std::vector<Change> changes() {
  std::vector<Change> changes;
  for(const double noise : {0., 0.05, 0.1, 0.25, 0.5, 1., 2., 4.})
    changes.push_back({"noise, " + svg::number(noise, 2) + " edges",
                       [=](const Mesh& mesh) { return mesh_changes::with_noise(mesh, noise, 1); },
                       noise});
  for(const double part : {0.5, 0.2, 0.1, 0.05, 0.02})
    changes.push_back({"decimated to " + svg::number(100. * part) + "%",
                       [=](const Mesh& mesh) { return mesh_changes::decimated(mesh, part); }});
  for(const double length : {0.5, 1., 2., 4.})
    changes.push_back({"remeshed, edges " + svg::number(length) + " as long",
                       [=](const Mesh& mesh) { return mesh_changes::remeshed(mesh, length); }});
  changes.push_back({"remeshed, edges 2 and 1/2 as long",
                     [](const Mesh& mesh) { return mesh_changes::graded(mesh, 2., 0.5); }});
  for(const double factor : {4., 16.})
    changes.push_back({"remeshed, triangles " + svg::number(factor) + " times as long as wide",
                       [=](const Mesh& mesh) { return mesh_changes::stretched(mesh, factor); }});
  return changes;
}

template <typename ConcurrencyTag> Answer answer_for(const Mesh& mesh) {
  Solver solver(CGAL::Sequential_tag(), mesh, params::default_values());
  return answer_of<ConcurrencyTag>(solver, params::default_values());
}

// The total length of loops where their steps are on another mesh with the same faces.
double carried_length(const Pairs& pairs, const Mesh& mesh) {
  double sum = 0.;
  for(const auto& pair : pairs)
    for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
      Closed_polyline points;
      for(const auto& step : loop->steps()) {
        const Space_point& a = mesh.point(mesh.source(step.halfedge));
        points.push_back(a + step.ratio * (mesh.point(mesh.target(step.halfedge)) - a));
      }
      for(std::size_t i = 0; i < points.size(); ++i)
        sum += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % points.size()]));
    }
  return sum;
}

// What became of all meshes under a change.
struct Outcome
{
  std::size_t meshes = 0, wrong = 0, wrong_reference = 0, crossing = 0;
  std::size_t loops = 0, pure = 0; // on meshes that do not cross themselves
  std::vector<double> faces, lengths, carried,
      over;                              // over those of the clean mesh; over carried ones
  std::vector<double> reference_lengths; // over those of the host solver
};

class Robustness
{
public:
  explicit Robustness(bool is_verbose)
      : is_verbose_(is_verbose) {}

  void run_on(const Subject& subject) {
    const Answer clean = answer_for<Tag>(subject.mesh);
    if(!clean.error.empty())
      throw std::runtime_error(subject.name + ": " + clean.error);
    for(std::size_t i = 0; i < changes_.size(); ++i)
      run_on(subject, clean, changes_[i], outcomes_[i]);
  }

  void print() const {
    std::printf(
        "| change | meshes | faces: median | cross themselves | wrong counts | of the reference "
        "solver | loops that bound on their side, if the mesh does not cross itself | length over "
        "that of the clean mesh: median | least | most | the clean mesh's loops carried along: "
        "median | length over theirs: most | reference over host: median | most |\n|---|");
    for(int i = 1; i < 14; ++i)
      std::printf("---:|");
    std::printf("\n");
    for(std::size_t i = 0; i < changes_.size(); ++i)
      print_row(changes_[i], outcomes_[i]);
  }

  std::size_t wrong() const {
    std::size_t sum = 0;
    for(const Outcome& o : outcomes_)
      sum += o.wrong + o.wrong_reference;
    return sum;
  }

  const std::vector<Change>& all_changes() const { return changes_; }
  const std::vector<Outcome>& outcomes() const { return outcomes_; }

private:
  void run_on(const Subject& subject, const Answer& clean, const Change& change, Outcome& o) {
    const Mesh mesh = change.make(subject.mesh);
    const Answer answer = answer_for<Tag>(mesh), reference = answer_for<CGAL::Reference_tag>(mesh);
    const bool crosses = CGAL::Polygon_mesh_processing::does_self_intersect<Tag>(mesh);
    ++o.meshes;
    o.faces.push_back(double(mesh.number_of_faces()));
    o.crossing += crosses;
    const bool is_right = answer.error.empty() && answer.pairs.size() == subject.genus;
    const bool is_reference_right =
        reference.error.empty() && reference.pairs.size() == subject.genus;
    o.wrong += !is_right;
    o.wrong_reference += !is_reference_right;
    if(is_verbose_)
      std::fprintf(stderr, "%s, %s: %zu faces, %.2f s, %.2f s by the reference %s %s\n",
                   subject.name.c_str(), change.name.c_str(), std::size_t(mesh.number_of_faces()),
                   answer.seconds, reference.seconds, answer.error.c_str(),
                   reference.error.c_str());
    if(!is_right)
      return;
    if(!crosses) {
      o.loops += 2 * subject.genus;
      o.pure += answer.certificate.handles_bound_inside_alone.value_or(0) +
                answer.certificate.tunnels_bound_outside_alone.value_or(0);
    }
    const double length = total_length(answer);
    o.lengths.push_back(length / total_length(clean));
    if(change.noise >= 0.) {
      const double carried = carried_length(clean.pairs, mesh);
      o.carried.push_back(carried / total_length(clean));
      o.over.push_back(length / carried);
    }
    if(is_reference_right)
      o.reference_lengths.push_back(total_length(reference) / length);
  }

  static void print_row(const Change& change, const Outcome& o) {
    std::printf("| %s | %zu | %.0f | %zu | %zu | %zu | %zu of %zu | %.3f | %.3f | %.3f |",
                change.name.c_str(), o.meshes, quantile(o.faces, 0.5), o.crossing, o.wrong,
                o.wrong_reference, o.pure, o.loops, quantile(o.lengths, 0.5),
                quantile(o.lengths, 0.), quantile(o.lengths, 1.));
    if(change.noise >= 0.)
      std::printf(" %.3f | %.3f |", quantile(o.carried, 0.5), quantile(o.over, 1.));
    else
      std::printf(" | |");
    std::printf(" %.3f | %.3f |\n", quantile(o.reference_lengths, 0.5),
                quantile(o.reference_lengths, 1.));
  }

  bool is_verbose_;
  std::vector<Change> changes_ = changes();
  std::vector<Outcome> outcomes_ = std::vector<Outcome>(changes_.size());
};

// Lengths over those of the clean meshes: of the loops that are found, and of those of the clean
// mesh where they are carried along with the noise.
void draw_lengths(const std::string& file, const Robustness& results) {
  svg::Figure figure(620., 340.);
  svg::Chart chart(figure, {70., 30.}, {530., 260.}, {0., 2.}, {0., 4.});
  for(const int octave : {0, 1, 2, 3, 4})
    chart.mark_y(octave, std::to_string(1 << octave) + " x");
  const auto place_of = [](double noise) { return std::sqrt(noise); };
  for(const double noise : {0., 0.05, 0.25, 0.5, 1., 2., 4.})
    chart.mark_x(place_of(noise), svg::number(noise, 2));
  figure.text({335., 328.}, "noise along the normals, standard deviation in edge lengths");
  const auto draw = [&](auto values_of, const char* colour) {
    std::vector<std::vector<svg::Place>> curves;
    for(std::size_t i = 0; i < results.all_changes().size(); ++i) {
      const double noise = results.all_changes()[i].noise;
      const std::vector<double>& values = values_of(results.outcomes()[i]);
      curves.resize((std::max)(curves.size(), noise < 0. ? 0 : values.size()));
      for(std::size_t k = 0; k < values.size() && noise >= 0.; ++k)
        curves[k].emplace_back(place_of(noise), (std::min)(4., std::log2(values[k])));
    }
    for(const auto& curve : curves)
      chart.curve(curve, colour);
  };
  draw(
      [](const Outcome& o) -> const auto& { return o.carried; }, svg::grey);
  draw(
      [](const Outcome& o) -> const auto& { return o.lengths; }, svg::blue);
  figure.text({80., 20.}, "loops of the clean mesh, carried along", "start", 12, svg::grey);
  figure.text({330., 20.}, "loops found", "start", 12, svg::blue);
  figure.write(file);
}

// One shape and its loops under some of the changes.
void draw_changes(const std::string& file) {
  const Subject subject = generated_subject("multi-torus:1800:2");
  const std::vector<std::pair<std::string, Mesh>> meshes = {
      {"as generated", subject.mesh},
      {"noise, 1/4 of an edge", mesh_changes::with_noise(subject.mesh, 0.25, 1)},
      {"noise, one edge", mesh_changes::with_noise(subject.mesh, 1., 1)},
      {"noise, 4 edges", mesh_changes::with_noise(subject.mesh, 4., 1)},
      {"decimated to 20%", mesh_changes::decimated(subject.mesh, 0.2)},
      {"to 5%", mesh_changes::decimated(subject.mesh, 0.05)},
      {"remeshed, graded", mesh_changes::graded(subject.mesh, 2., 0.7)},
      {"remeshed, stretched", mesh_changes::stretched(subject.mesh, 8.)}};
  constexpr double side = 210.;
  svg::Figure figure(4. * side, 2. * (side + 24.));
  for(std::size_t i = 0; i < meshes.size(); ++i) {
    const double x = side * double(i % 4), y = (side + 24.) * double(i / 4);
    Surface_drawing drawing(figure, meshes[i].second, {x, y}, side);
    drawing.add_loops(answer_for<Tag>(meshes[i].second).pairs, 2.);
    drawing.draw();
    figure.text({x + side / 2., y + side + 10.}, meshes[i].first);
  }
  figure.write(file);
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    const Command_line line(argc, argv, {"--verbose"}, {"--faces", "--figures"});
    Robustness results(line.has("--verbose"));
    for_each_subject(line, 20000, [&](const Subject& subject) { results.run_on(subject); });
    results.print();
    std::printf("\nanswers without as many certified pairs as there are handles: %zu\n",
                results.wrong());
    if(line.has("--figures")) {
      draw_lengths(line.text("--figures") + "/noise_lengths.svg", results);
      draw_changes(line.text("--figures") + "/changes.svg");
    }
    return results.wrong() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
