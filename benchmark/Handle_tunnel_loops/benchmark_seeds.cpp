// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Starts from random vertices of generated shapes, and of the closed meshes of a folder, and prints
// how much the loops differ: in number, which is a failure, in length, and in place.
//
//   benchmark_seeds [--seeds N] [--faces LIMIT] [--figures FOLDER] [FOLDER | FILE]...
//
// Loops are those of the host solver as it is called by default; and as the passes of the paper
// leave them, of the host solver and of the reference solver.

#include "Loop_places.h"
#include "Subjects.h"
#include "Surface_drawing.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/Reference_tag.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <cstdio>
#include <functional>
#include <iostream>

namespace {

using namespace corpus;
namespace params = CGAL::parameters;
using Tag = CGAL::Parallel_if_available_tag;

std::vector<Mesh::Vertex_index> random_seeds(const Mesh& mesh, std::size_t number) {
  std::vector<Mesh::Vertex_index> all;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      all.push_back(v);
  HTL::generators::Random(1).shuffle(all);
  all.resize((std::min)(number, all.size()));
  return all;
}

// Of whom the loops are, and the answer from a vertex.
struct Way
{
  const char* name;
  const char* colour;
  std::function<Answer(Solver&, Mesh::Vertex_index)> answer;
};

// Nothing follows the passes.
std::vector<Way> ways() {
  return {{"by default", svg::blue,
           [](Solver& solver, Mesh::Vertex_index seed) {
             return answer_of<Tag>(solver, params::seed_vertex(seed));
           }},
          {"of the passes of the host solver alone", svg::orange,
           [](Solver& solver, Mesh::Vertex_index seed) {
             return answer_of<Tag>(solver,
                                   params::seed_vertex(seed, params::solver_options(untouched())));
           }},
          {"of the passes of the reference alone", svg::purple,
           [](Solver& solver, Mesh::Vertex_index seed) {
             return answer_of<CGAL::Reference_tag>(
                 solver, params::seed_vertex(seed, params::solver_options(untouched())));
           }}};
}

// What the answers for one mesh have in common.
class Spread
{
public:
  Spread(const Subject& subject, const std::vector<Answer>& answers) {
    for(const Answer& answer : answers)
      if(!answer.error.empty() || answer.pairs.size() != subject.genus)
        ++wrong;
      else
        right_.push_back(&answer);
    if(right_.empty())
      return;
    compare_lengths();
    compare_places(subject.mesh);
  }

  std::size_t wrong = 0;           // answers without as many certified pairs as handles
  std::vector<double> totals;      // over the least
  std::vector<double> ratios;      // of each loop, longest over shortest
  std::vector<double> distances;   // from the corresponding loop of the first answer, in diagonals
  std::size_t same = 0, close = 0; // of these, within half an edge and within two edges

private:
  void compare_lengths() {
    std::vector<std::vector<double>> of_rank(2 * right_[0]->pairs.size());
    for(const Answer* answer : right_) {
      std::vector<double> lengths;
      for(const auto& pair : answer->pairs)
        lengths.insert(lengths.end(), {pair.handle().length(), pair.tunnel().length()});
      std::sort(lengths.begin(), lengths.end());
      for(std::size_t i = 0; i < lengths.size(); ++i)
        of_rank[i].push_back(lengths[i]);
      totals.push_back(total_length(*answer));
    }
    for(const auto& lengths : of_rank)
      ratios.push_back(quantile(lengths, 1.) / quantile(lengths, 0.));
    const double least = quantile(totals, 0.);
    for(double& total : totals)
      total /= least;
  }

  void compare_places(const Mesh& mesh) {
    const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
    const double diagonal =
        std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    const double edge = mean_edge_length(mesh);
    for(std::size_t i = 1; i < right_.size(); ++i)
      for(const double d : distances_of_corresponding(right_[0]->pairs, right_[i]->pairs)) {
        same += d <= edge / 2.;
        close += d <= 2. * edge;
        distances.push_back(d / diagonal);
      }
  }

  std::vector<const Answer*> right_;
};

void print_head(const Way& way, std::size_t number) {
  std::printf("\nLoops %s, %zu seeds\n\n", way.name, number);
  std::printf(
      "| mesh | faces | genus | wrong counts | total length: longest/shortest | a loop: median "
      "| most | same place, within half an edge | two edges | distance, %% of the diagonal: "
      "median | most |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
}

void print_row(const Subject& subject, const Spread& spread) {
  const double loops = (std::max)(1., double(spread.distances.size()));
  std::printf("| %s | %zu | %zu | %zu | %.4f | %.4f | %.3f | %.0f%% | %.0f%% | %.2f | %.1f |\n",
              subject.name.c_str(), std::size_t(subject.mesh.number_of_faces()), subject.genus,
              spread.wrong, quantile(spread.totals, 1.), quantile(spread.ratios, 0.5),
              quantile(spread.ratios, 1.), 100. * double(spread.same) / loops,
              100. * double(spread.close) / loops, 100. * quantile(spread.distances, 0.5),
              100. * quantile(spread.distances, 1.));
  std::fflush(stdout);
}

// Total lengths over the shortest, a row for each mesh and way, a dot for each seed.
class Strips
{
public:
  explicit Strips(std::size_t number_of_meshes)
      : figure_(760., 70. + row * double(number_of_meshes))
      , chart_(figure_,
               {130., 24.},
               {600., row * double(number_of_meshes)},
               {-0.01, most},
               {double(number_of_meshes), 0.}) {
    for(const double excess : {0., 0.02, 0.05, 0.1, 0.2, 0.3, 0.4})
      chart_.mark_x(std::sqrt(excess), "+" + svg::number(100. * excess) + "%");
    chart_.mark_x(most, "more");
    double x = 130.;
    for(const Way& way : ways()) {
      figure_.dot({x, 12.}, way.colour, 4.);
      figure_.text({x + 9., 16.}, way.name, "start", 11);
      x += 28. + 5.9 * double(std::string(way.name).size());
    }
  }

  void add(const Subject& subject, std::size_t mesh, std::size_t way, const Spread& spread) {
    const double y = double(mesh) + 0.25 + 0.25 * double(way);
    if(way == 0)
      figure_.text({122., chart_.place(0., double(mesh) + 0.5).second + 4.}, subject.name, "end");
    for(const double total : spread.totals)
      figure_.dot(chart_.place((std::min)(std::sqrt(total - 1.), most), y), ways()[way].colour, 3.,
                  0.5);
  }

  void write(const std::string& file) const { figure_.write(file); }

private:
  static constexpr double row = 36., most = 0.7; // of the root of the excess

  svg::Figure figure_;
  svg::Chart chart_;
};

// The loops from all seeds on one mesh, over each other, for each way.
void draw_overlays(const std::string& file, std::size_t number_of_seeds) {
  const Subject subject = generated_subject("multi-torus:2000:3");
  const auto seeds = random_seeds(subject.mesh, number_of_seeds);
  svg::Figure figure(900., 280.);
  double x = 0.;
  for(const Way& way : ways()) {
    Solver solver(CGAL::Sequential_tag(), subject.mesh, params::default_values());
    Surface_drawing drawing(figure, subject.mesh, {x, -25.}, 300.);
    for(const auto seed : seeds) {
      drawing.add_loops(way.answer(solver, seed).pairs, 1.);
      drawing.add_dot(subject.mesh.point(seed), svg::purple);
    }
    drawing.draw();
    figure.text({x + 150., 268.}, way.name);
    x += 300.;
  }
  figure.write(file);
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    const Command_line line(argc, argv, {}, {"--seeds", "--faces", "--figures"});
    const std::size_t number = line.number("--seeds", 20);
    Strips strips(generated_shapes().size());
    std::size_t wrong = 0;
    for(std::size_t way = 0; way < ways().size(); ++way) {
      print_head(ways()[way], number);
      std::size_t mesh = 0;
      for_each_subject(line, 20000, [&](const Subject& subject) {
        Solver solver(CGAL::Sequential_tag(), subject.mesh, params::default_values());
        std::vector<Answer> answers;
        for(const auto seed : random_seeds(subject.mesh, number))
          answers.push_back(ways()[way].answer(solver, seed));
        const Spread spread(subject, answers);
        print_row(subject, spread);
        wrong += spread.wrong;
        if(mesh < generated_shapes().size())
          strips.add(subject, mesh++, way, spread);
      });
    }
    std::printf("\nanswers without as many certified pairs as there are handles: %zu\n", wrong);
    if(line.has("--figures")) {
      strips.write(line.text("--figures") + "/seeds_lengths.svg");
      draw_overlays(line.text("--figures") + "/seeds_places.svg", number);
    }
    return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
