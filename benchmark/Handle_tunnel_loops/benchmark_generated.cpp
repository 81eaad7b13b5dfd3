// Finds the loops of many generated surfaces that do not cross themselves, where each handle loop
// can bound inside and each tunnel loop outside, and counts those that do.
//
//   benchmark_generated [-n SURFACES] [--seed N] [--only NUMBER [--write FILE.off]]
//
// Prints a line for each surface of which some loop does not bound on its side of its component, as
// if there were no other component; and a table of sums for all kinds. Fails if any surface has no
// certified answer, or crosses itself.

#include "Corpus_answer.h"
#include "Random_surfaces.h"
#include "generators/mesh_of_field.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>

namespace {

using namespace corpus;
using Tag = CGAL::Parallel_if_available_tag;
namespace params = CGAL::parameters;

struct Options
{
  std::size_t first = 0, number = 1000, seed = 0;
  std::string file; // where to write the only surface
};

Options parse(int argc, char* argv[]) {
  Options options;
  for(int i = 1; i < argc; i += 2) {
    const std::string word = argv[i];
    if(i + 1 == argc)
      throw std::invalid_argument(word + " needs a value");
    if(word == "-n")
      options.number = std::stoul(argv[i + 1]);
    else if(word == "--seed")
      options.seed = std::stoul(argv[i + 1]);
    else if(word == "--only") {
      options.first = std::stoul(argv[i + 1]);
      options.number = 1;
    } else if(word == "--write")
      options.file = argv[i + 1];
    else
      throw std::invalid_argument("usage: benchmark_generated [-n SURFACES] [--seed N] "
                                  "[--only NUMBER [--write FILE.off]]");
  }
  return options;
}

Mesh mesh_of(const random_surfaces::Soup& soup) {
  Mesh mesh;
  for(const auto& [x, y, z] : soup.points)
    mesh.add_vertex({x, y, z});
  for(const auto& [a, b, c] : soup.triangles)
    mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
  return mesh;
}

// What is counted, of one surface or of many.
struct Sums
{
  std::size_t surfaces = 0, certified = 0, crossing = 0, pure_surfaces = 0;
  std::size_t faces = 0, components = 0, pairs = 0, pairs_that_cross_once = 0, undecided = 0;
  // Of their component alone, and with the other components there.
  std::size_t handles_alone = 0, tunnels_alone = 0, handles = 0, tunnels = 0;
  double seconds = 0.;

  Sums() = default;

  Sums(const Mesh& mesh, const Solver& solver, const Answer& answer)
      : surfaces(1)
      , certified(answer.error.empty())
      , faces(mesh.number_of_faces())
      , components(solver.number_of_components())
      , pairs(solver.genus())
      , pairs_that_cross_once(answer.certificate.pairing ? pairs : 0)
      , undecided(answer.undecided())
      , handles(answer.handles_inside())
      , tunnels(answer.tunnels_outside())
      , seconds(answer.seconds) {
    const auto& linking = answer.certificate.linking;
    for(std::size_t i = 0; i < linking.size(); ++i)
      if(i % 2 == 0)
        handles_alone += linking[i].bounds_inside_component;
      else
        tunnels_alone += linking[i].bounds_outside_component;
    pure_surfaces = handles_alone == pairs && tunnels_alone == pairs;
  }

  void add(const Sums& other) {
    surfaces += other.surfaces;
    certified += other.certified;
    crossing += other.crossing;
    pure_surfaces += other.pure_surfaces;
    faces += other.faces;
    components += other.components;
    pairs += other.pairs;
    pairs_that_cross_once += other.pairs_that_cross_once;
    undecided += other.undecided;
    handles_alone += other.handles_alone;
    tunnels_alone += other.tunnels_alone;
    handles += other.handles;
    tunnels += other.tunnels;
    seconds += other.seconds;
  }

  void print(const std::string& name) const {
    std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %zu | "
                "%.2f |\n",
                name.c_str(), surfaces, certified, pure_surfaces, faces, components, pairs,
                pairs_that_cross_once, handles_alone, tunnels_alone, handles, tunnels, undecided,
                seconds);
  }
};

Sums measure(std::size_t number, const random_surfaces::Surface& surface) {
  const Mesh mesh = mesh_of(surface.soup);
  const double began = seconds_now();
  Solver solver(Tag(), mesh, params::default_values());
  const double prepared = seconds_now() - began;
  const Answer answer = answer_of<Tag>(solver, params::default_values());
  Sums sums(mesh, solver, answer);
  sums.seconds += prepared;
  sums.crossing = CGAL::Handle_tunnel_loops::generators::crosses_itself(surface.soup);
  if(sums.pure_surfaces == 0 || sums.certified == 0 || sums.crossing != 0)
    std::printf("%zu: %s: handles %zu, tunnels %zu of %zu%s%s%s\n", number, surface.words.c_str(),
                sums.handles_alone, sums.tunnels_alone, sums.pairs,
                sums.crossing != 0 ? "; crosses itself" : "", sums.certified == 0 ? "; " : "",
                answer.error.c_str());
  std::fflush(stdout);
  return sums;
}

bool run(const Options& options) {
  std::map<std::string, Sums> of_kind;
  Sums all;
  for(std::size_t i = options.first; i < options.first + options.number; ++i) {
    const random_surfaces::Surface surface = random_surfaces::random_surface(i, options.seed);
    if(!options.file.empty()) {
      const Mesh mesh = mesh_of(surface.soup);
      CGAL::IO::write_OFF(options.file, mesh, params::stream_precision(17));
    }
    const Sums sums = measure(i, surface);
    of_kind[surface.kind].add(sums);
    all.add(sums);
  }
  std::printf("\n| kind | surfaces | certified | pure alone | faces | components | pairs | pairs "
              "that cross once | handles inside alone | tunnels outside alone | handles inside | "
              "tunnels outside | undecided loops | seconds |\n"
              "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for(const auto& [kind, sums] : of_kind)
    sums.print(kind);
  all.print("all");
  std::printf("\nsurfaces that cross themselves: %zu; seed %zu\n", all.crossing, options.seed);
  return all.certified == all.surfaces && all.crossing == 0;
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    return run(parse(argc, argv)) ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
