// One step of benchmark/python/compare_loops.py, in a process of its own so that its memory can be
// measured. Prints an object of JSON on a line.
//
//   benchmark_judged_loops write MESH FILE.off    what other programs are given, if it is closed
//   benchmark_judged_loops find MESH              finds loops, in one thread
//   benchmark_judged_loops judge MESH LOOPS       loops of another program, see Vertex_loops.h
//
// Loops are right if they are a basis of H1 with integer coefficients, all handle loops bound
// inside and all tunnel loops outside. That the loops of a pair cross once is not asked of others.

#include "Corpus_answer.h"
#include "Vertex_loops.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>

namespace {

using namespace corpus;
namespace params = CGAL::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

Mesh mesh_of(const std::string& file) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) && !PMP::IO::read_polygon_mesh(file, mesh))
    throw std::runtime_error("cannot read " + file);
  return mesh;
}

const char* word(bool value) { return value ? "true" : "false"; }

// The genus is that of the solver, which refuses what is no surface.
void write(const std::string& from, const std::string& to) {
  const Mesh mesh = mesh_of(from);
  if(!CGAL::is_closed(mesh))
    throw std::runtime_error("not closed");
  const Solver solver(CGAL::Sequential_tag(), mesh, params::default_values());
  if(!CGAL::IO::write_polygon_mesh(to, mesh, params::stream_precision(17)))
    throw std::runtime_error("cannot write " + to);
  std::printf(R"({"faces": %zu, "genus": %zu, "components": %zu, "crosses_itself": %s})",
              std::size_t(mesh.number_of_faces()), solver.genus(), solver.number_of_components(),
              word(PMP::does_self_intersect<CGAL::Parallel_if_available_tag>(mesh)));
}

void print(const Pairs& pairs,
           std::size_t number_of_handles,
           std::size_t number_of_tunnels,
           const HTL::Certificate& certificate,
           double seconds) {
  Answer sums;
  sums.pairs = pairs;
  const auto lengths = sums.lengths();
  const std::size_t inside = certificate.handles_bound_inside.value_or(0),
                    outside = certificate.tunnels_bound_outside.value_or(0);
  const bool is_right =
      certificate.basis && inside == number_of_handles && outside == number_of_tunnels;
  std::printf(R"({"handles": %zu, "tunnels": %zu, "inside": %zu, "outside": %zu, "basis": %s, )"
              R"("right": %s, "length": %.9g, "seconds": %.6f})",
              number_of_handles, number_of_tunnels, inside, outside, word(certificate.basis),
              word(is_right), lengths[0] + lengths[1], seconds);
}

// Time of the processor: other programs on the machine do not count.
void find(const std::string& file) {
  using Tag = CGAL::Sequential_tag;
  const Mesh mesh = mesh_of(file);
  const std::clock_t began = std::clock();
  Solver solver(Tag(), mesh, params::default_values());
  const Answer answer = answer_of<Tag>(solver, params::default_values());
  const double seconds = double(std::clock() - began) / CLOCKS_PER_SEC;
  if(!answer.error.empty())
    throw std::runtime_error(answer.error);
  print(answer.pairs, answer.pairs.size(), answer.pairs.size(), answer.certificate, seconds);
}

void judge(const std::string& file, const std::string& loops_file) {
  const Mesh mesh = mesh_of(file);
  const Vertex_loops loops(loops_file, mesh);
  const Pairs pairs = loops.pairs();
  print(pairs, loops.number_of_handles(), loops.number_of_tunnels(),
        CGAL::certify_handle_tunnel_loops(mesh, pairs), 0.);
}

} // namespace

int main(int argc, char* argv[]) {
  const std::string step = argc > 2 ? argv[1] : "";
  try {
    if(step == "write" && argc == 4)
      write(argv[2], argv[3]);
    else if(step == "find" && argc == 3)
      find(argv[2]);
    else if(step == "judge" && argc == 4)
      judge(argv[2], argv[3]);
    else
      throw std::runtime_error("usage: write MESH FILE.off | find MESH | judge MESH LOOPS");
  } catch(const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return EXIT_FAILURE;
  }
  std::printf("\n");
  return EXIT_SUCCESS;
}
