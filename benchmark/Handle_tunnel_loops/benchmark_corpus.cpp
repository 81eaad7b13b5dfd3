// Finds the loops of all closed meshes in a folder, prints a line for each mesh, and ends with the
// sums that the manual and the design notes quote.
//
//   benchmark_corpus [--seeds N] [--permutations N] [--reference LIMIT] [--self-intersections]
//                    [--lengths TABLE:COLUMN+COLUMN...]... FOLDER | FILE...
//
// Each mesh is computed by all threads from the first vertex; with --seeds also from N
// vertices, evenly spaced, the first among them, with --permutations with its elements in N random
// orders, and with --reference by the reference solver too, where it has at most LIMIT faces.
// --lengths compares total lengths with those of a table. What seeds and orders change, and how
// lengths compare, is told of meshes that do not cross themselves if that is tested.

#include "Corpus_answer.h"
#include "Counting_allocation.h"
#include "Known_lengths.h"
#ifdef CGAL_EIGEN3_ENABLED
#include "Corpus_reference.h"
#endif
#include "mean_edge_length.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>

namespace {

using namespace corpus;
using Tag = CGAL::Parallel_if_available_tag;
namespace params = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

struct Options
{
  std::size_t number_of_seeds = 0, number_of_permutations = 0;
  std::size_t reference_limit = 0;
  bool do_test_crossing = false;
  std::vector<std::string> lengths;
  std::vector<std::filesystem::path> files;
};

Options parse(int argc, char* argv[]) {
  Options options;
  for(int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if(word == "--seeds" && i + 1 < argc)
      options.number_of_seeds = std::stoul(argv[++i]);
    else if(word == "--permutations" && i + 1 < argc)
      options.number_of_permutations = std::stoul(argv[++i]);
    else if(word == "--reference" && i + 1 < argc)
      options.reference_limit = std::stoul(argv[++i]);
    else if(word == "--lengths" && i + 1 < argc)
      options.lengths.push_back(argv[++i]);
    else if(word == "--self-intersections")
      options.do_test_crossing = true;
    else if(std::filesystem::is_directory(word))
      for(const auto& entry : std::filesystem::directory_iterator(word))
        options.files.push_back(entry.path());
    else
      options.files.push_back(word);
  }
  std::sort(options.files.begin(), options.files.end());
  return options;
}

bool read(const std::string& file, Mesh& mesh) {
  return CGAL::IO::read_polygon_mesh(file, mesh) || PMP::IO::read_polygon_mesh(file, mesh);
}

double diagonal(const Mesh& mesh) {
  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// The lengths from several seeds, and with the elements of the mesh in other orders.
struct Seed_sums
{
  std::size_t meshes = 0, answers = 0, certified = 0;
  std::size_t meshes_that_differ = 0;    // by more than a thousandth
  std::size_t meshes_that_are_close = 0; // to a hundredth
  std::vector<double> most_over_least;
  double last = 1.; // the longest over the shortest of the last mesh

  void add(const Mesh& mesh, Solver& solver, const Options& options) {
    ++meshes;
    double least = HUGE_VAL, most = 0.;
    const auto take = [&](const Answer& answer) {
      ++answers;
      if(!answer.error.empty())
        return;
      ++certified;
      least = (std::min)(least, total_length(answer));
      most = (std::max)(most, total_length(answer));
    };
    for(const auto seed : spaced_seeds(mesh, options.number_of_seeds))
      take(answer_of<Tag>(solver, params::seed_vertex(seed)));
    CGAL::Random random(1);
    for(std::size_t i = 0; i < options.number_of_permutations; ++i) {
      const Mesh other = permuted(mesh, random);
      Solver solver_of_other(Tag(), other, params::default_values());
      take(answer_of<Tag>(solver_of_other, params::default_values()));
    }
    if(least > most)
      least = most = 1.; // no answer
    last = most / least;
    most_over_least.push_back(last);
    meshes_that_differ += most > 1.001 * least;
    meshes_that_are_close += most < 1.01 * least;
  }

  void print(const Options& options) const {
    std::printf("\n%zu seeds, %zu permutations%s: certified answers %zu of %zu; total lengths "
                "differ by more than a thousandth on %zu of %zu meshes, by less than a hundredth "
                "on %.1f%%; longest over shortest: median %.4f, 90%% %.3f, most %.2f\n",
                options.number_of_seeds, options.number_of_permutations,
                options.do_test_crossing ? ", meshes that do not cross themselves" : "", certified,
                answers, meshes_that_differ, meshes,
                100. * double(meshes_that_are_close) / double(meshes),
                quantile(most_over_least, 0.5), quantile(most_over_least, 0.9),
                quantile(most_over_least, 1.));
  }
};

class Corpus
{
public:
  explicit Corpus(const Options& options)
      : options_(options)
      , known_(options.lengths.begin(), options.lengths.end()) {}

  void run() {
    std::printf(
        "| mesh | faces | genus | components | reading s | loops s | ratio | bytes per "
        "face | handles inside | tunnels outside | undecided loops | handles / diagonal | "
        "tunnels / diagonal | seeds | error |\n|---|---|---|---|---|---|---|---|---|---|---|---|"
        "---|---|---|\n");
    for(const auto& file : options_.files)
      run_on(file.string(), file.filename().string());
    print();
  }

private:
  void run_on(const std::string& file, const std::string& name) {
    Mesh mesh;
    const double t0 = seconds_now();
    if(!read(file, mesh)) {
      std::printf("| %s | cannot be read |\n", name.c_str());
      return;
    }
    const double t1 = seconds_now();
    try {
      Solver solver(Tag(), mesh, params::default_values());
      if(solver.genus() == 0)
        return;
      const Answer answer = answer_of<Tag>(solver, params::default_values());
      const double t2 = seconds_now();
      const double bytes = double(counting_allocation::peak_bytes([&] {
        Solver again(Tag(), mesh, params::default_values());
        answer_of<Tag>(again, params::default_values());
      }));
      const bool crosses_itself = options_.do_test_crossing && PMP::does_self_intersect<Tag>(mesh);
      crossing_ += crosses_itself;
      count(mesh, solver, answer, crosses_itself);
      if(!crosses_itself)
        compare_lengths(answer, std::filesystem::path(name).stem().string());
      report(name, mesh, answer, t1 - t0, t2 - t1, bytes / double(mesh.number_of_faces()));
    } catch(const HTL::Invalid_mesh_exception& e) {
      std::printf("| %s | refused: %s |\n", name.c_str(), e.what());
    }
    std::fflush(stdout);
  }

  void report(const std::string& name,
              const Mesh& mesh,
              const Answer& answer,
              double reading,
              double loops,
              double bytes) {
    const auto lengths = answer.lengths();
    const double size = diagonal(mesh);
    std::printf("| %s | %zu | %zu | %zu | %.3f | %.3f | %.2f | %.0f | %zu | %zu | %zu | %.3f | "
                "%.3f | %.3f | %s |\n",
                name.c_str(), std::size_t(mesh.number_of_faces()), answer.statistics.genus,
                answer.statistics.number_of_components, reading, loops, loops / reading, bytes,
                answer.handles_inside(), answer.tunnels_outside(), answer.undecided(),
                lengths[0] / size, lengths[1] / size, seeds_.last, answer.error.c_str());
    handle_length_ += lengths[0] / size;
    tunnel_length_ += lengths[1] / size;
    if(mesh.number_of_faces() < 100000)
      return;
    ratios_.push_back(loops / reading);
    bytes_.push_back(bytes);
  }

  void count(const Mesh& mesh, Solver& solver, const Answer& answer, bool crosses_itself) {
    ++meshes_;
    certified_ += answer.error.empty();
    pairs_ += answer.pairs.size();
    least_genus_ = (std::min)(least_genus_, answer.statistics.genus);
    most_genus_ = (std::max)(most_genus_, answer.statistics.genus);
    inside_ += answer.handles_inside();
    outside_ += answer.tunnels_outside();
    pure_ += answer.is_pure();
    const std::size_t inside = answer.certificate.handles_bound_inside_alone.value_or(0),
                      outside = answer.certificate.tunnels_bound_outside_alone.value_or(0);
    inside_alone_ += inside;
    outside_alone_ += outside;
    pure_alone_ += inside == answer.pairs.size() && outside == answer.pairs.size();
    if(answer.undecided() != 0) {
      ++meshes_undecided_;
      undecided_ += answer.undecided();
      loops_of_undecided_ += 2 * answer.pairs.size();
    }
    compare_with_offsets(mesh, answer);
    seeds_.last = 1.;
    if(options_.number_of_seeds + options_.number_of_permutations != 0 && !crosses_itself)
      seeds_.add(mesh, solver, options_);
#ifdef CGAL_EIGEN3_ENABLED
    if(mesh.number_of_faces() <= options_.reference_limit)
      reference_.add(mesh, solver, answer, options_.number_of_seeds);
#endif
  }

  // Whether the growth along the normals gives loops the same names, and the paper's finite offsets
  // do; the faces of most meshes look outwards.
  void compare_with_offsets(const Mesh& mesh, const Answer& answer) {
    const auto point = get(CGAL::vertex_point, mesh);
    using Classifier = HTL::internal::Offset_classifier<Mesh, std::decay_t<decltype(point)>>;
    const int sign = PMP::is_outward_oriented(mesh) ? 1 : -1;
    const double edge = mean_edge_length(mesh);
    for(std::size_t k = 0; k < answer.pairs.size(); ++k)
      told_ += answer.tells_handle(k);
    for(auto& [offset, agree] : agree_) {
      const Classifier classifier(mesh, point, sign * offset * edge);
      for(std::size_t k = 0; k < answer.pairs.size(); ++k)
        if(answer.tells_handle(k)) {
          const int order =
              classifier.compare_growth(answer.pairs[k].handle(), answer.pairs[k].tunnel());
          agree += (offset == 0. ? sign * order : order) > 0;
        }
    }
  }

  void compare_lengths(const Answer& answer, const std::string& name) {
    const auto lengths = answer.lengths();
    for(Known_lengths& known : known_)
      known.compare(name, lengths[0] + lengths[1]);
  }

  void print() const {
    std::printf("\nmeshes: %zu, genus %zu to %zu, pairs of loops: %zu\n", meshes_, least_genus_,
                most_genus_, pairs_);
    std::printf("certified: %zu of %zu\n", certified_, meshes_);
    std::printf("linking numbers tell the handle: %zu of %zu pairs; of these are named the same\n",
                told_, pairs_);
    for(const auto& [offset, agree] : agree_)
      std::printf("  by %s %g: %zu (%.1f%%)\n",
                  offset == 0. ? "the derivative, an offset of" : "an offset in mean edges of",
                  offset, agree, 100. * double(agree) / double(told_));
    std::printf("handles that bound inside: %zu; tunnels that bound outside: %zu; all of both on "
                "%zu meshes\n",
                inside_, outside_, pure_);
    std::printf("each component by itself: handles %zu, tunnels %zu, all of both on %zu meshes\n",
                inside_alone_, outside_alone_, pure_alone_);
    std::printf("undecided: %zu of %zu loops on %zu meshes\n", undecided_, loops_of_undecided_,
                meshes_undecided_);
    if(options_.do_test_crossing)
      std::printf("meshes that touch or cross themselves: %zu\n", crossing_);
    std::printf("total lengths over diagonals: handles %.2f, tunnels %.2f\n", handle_length_,
                tunnel_length_);
    std::printf("%zu meshes of 100,000 faces or more: ratio to reading, median %.2f, most %.2f; "
                "bytes per face, median %.0f, most %.0f\n",
                ratios_.size(), quantile(ratios_, 0.5), quantile(ratios_, 1.),
                quantile(bytes_, 0.5), quantile(bytes_, 1.));
    if(options_.number_of_seeds + options_.number_of_permutations != 0)
      seeds_.print(options_);
    for(const Known_lengths& known : known_)
      known.print();
#ifdef CGAL_EIGEN3_ENABLED
    if(options_.reference_limit != 0)
      reference_.print();
#endif
  }

  Options options_;
  std::size_t meshes_ = 0, certified_ = 0, pairs_ = 0, told_ = 0;
  std::map<double, std::size_t> agree_ = {{0., 0}, {0.01, 0}, {0.1, 0}, {0.3, 0},
                                          {1., 0}, {3., 0},   {10., 0}}; // by offset, in edges
  std::size_t least_genus_ = std::size_t(-1), most_genus_ = 0;
  std::size_t inside_ = 0, outside_ = 0, pure_ = 0, crossing_ = 0;
  std::size_t meshes_undecided_ = 0, undecided_ = 0, loops_of_undecided_ = 0;
  std::size_t inside_alone_ = 0, outside_alone_ = 0, pure_alone_ = 0;
  double handle_length_ = 0., tunnel_length_ = 0.;
  std::vector<double> ratios_, bytes_; // of the larger meshes
  Seed_sums seeds_;
  std::vector<Known_lengths> known_;
#ifdef CGAL_EIGEN3_ENABLED
  Reference_sums reference_;
#endif
};

} // namespace

int main(int argc, char* argv[]) {
  try {
    const Options options = parse(argc, argv);
    if(options.files.empty()) {
      std::cerr
          << "usage: benchmark_corpus [--seeds N] [--permutations N] [--reference LIMIT] "
             "[--self-intersections] [--lengths TABLE:COLUMN+COLUMN...]... FOLDER | FILE...\n";
      return EXIT_FAILURE;
    }
    Corpus(options).run();
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
