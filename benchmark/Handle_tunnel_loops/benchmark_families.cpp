// Measures how times grow with the size of a mesh: families of generated surfaces, each of several
// sizes, and for each command the exponent, the slope of the logarithm of the time over that of the
// number of faces.
//
//   benchmark_families [-n RUNS] [--faces N,N,...] [--limit SECONDS] [--only FAMILY]
//                      [--command COMMAND] [--times]
//
// Times are those of the processor, of one thread, the least of the runs; of random surfaces, the
// mean over several, as one may take several times as long as another. `cut`, `dual`, `remove`
// and `check` are measured beyond finding the loops; `heights` is the Reeb graph of the z axis. A
// command that takes longer than the limit is not tried on larger meshes of its family. Prints a
// table of exponents and one of the times of the largest meshes, in brackets where these are not
// the largest that were asked for; and with --times those of all.

#include "Benchmark_meshes.h"
#include "Mesh_families.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>
#include <CGAL/cut_to_disk.h>
#include <CGAL/dual_cuts.h>
#include <CGAL/handle_tunnel_loops.h>
#include <CGAL/reeb_graph.h>
#include <CGAL/remove_handles.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace HTL = CGAL::Handle_tunnel_loops;
namespace params = CGAL::parameters;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

struct Wish
{
  int number_of_runs = 3;
  double limit = 60.;
  std::vector<std::size_t> faces = {10000, 20000, 40000, 80000};
  std::string family, command; // all if empty
  bool print_times = false;
};

struct Command
{
  const char* name;
  std::function<void(const Mesh&, const Pairs&)> run;
};

void find_loops(const Mesh& mesh, const Pairs&) {
  Pairs pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
}

void cut(const Mesh& mesh, const Pairs& pairs) {
  std::vector<Mesh::Edge_index> edges;
  CGAL::cut_to_disk(mesh, std::back_inserter(edges), params::known_loops(pairs));
}

void find_dual_cuts(const Mesh& mesh, const Pairs& pairs) {
  std::vector<std::vector<std::pair<Mesh::Halfedge_index, std::int64_t>>> cuts;
  CGAL::dual_cuts(mesh, pairs, std::back_inserter(cuts));
}

void remove(const Mesh& mesh, const Pairs& pairs) {
  Mesh copy = mesh;
  CGAL::remove_handles(copy, params::known_loops(pairs));
}

void find_reeb_graph(const Mesh& mesh, const Pairs&) {
  CGAL::Reeb_graph<Mesh> graph;
  CGAL::reeb_graph(mesh, graph);
}

void find_reeb_graph_of_heights(const Mesh& mesh, const Pairs&) {
  CGAL::Reeb_graph<Mesh> graph;
  const auto height = boost::make_function_property_map<Mesh::Vertex_index>(
      [&](Mesh::Vertex_index v) { return mesh.point(v).z(); });
  CGAL::reeb_graph_of_function(mesh, height, graph);
}

void check(const Mesh& mesh, const Pairs& pairs) {
  HTL::Solver_options options;
  options.do_compute_linking = true;
  CGAL::certify_handle_tunnel_loops(mesh, pairs, params::solver_options(options));
  HTL::internal::touches_itself(HTL::internal::execution_of<CGAL::Sequential_tag>(), mesh,
                                get(CGAL::vertex_point, mesh), get(boost::vertex_index, mesh));
}

const Command commands[] = {{"loops", find_loops},     {"cut", cut},
                            {"dual", find_dual_cuts},  {"remove", remove},
                            {"reeb", find_reeb_graph}, {"heights", find_reeb_graph_of_heights},
                            {"check", check}};

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

// The least of the runs; of what takes seconds, there is one.
double measure(const Command& command, const Mesh& mesh, const Pairs& pairs, int runs) {
  double least = HUGE_VAL;
  for(int run = 0; run < runs && (run == 0 || least < 2.); ++run) {
    const double begin = processor_seconds();
    command.run(mesh, pairs);
    least = (std::min)(least, processor_seconds() - begin);
  }
  return (std::max)(least, 1e-6);
}

// What one command takes on the meshes of a family.
struct Times
{
  std::vector<std::pair<double, double>> by_faces;

  double exponent() const {
    double n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    for(const auto& [faces, seconds] : by_faces) {
      const double u = std::log(faces), v = std::log(seconds);
      n += 1., x += u, y += v, xx += u * u, xy += u * v;
    }
    return (n * xy - x * y) / (n * xx - x * x);
  }
};

using Row = std::map<std::string, Times>;

// A mesh of a family, and its loops.
struct Surface
{
  Mesh mesh;
  Pairs pairs;
};

std::vector<Surface> surfaces_of(const mesh_families::Family& family, std::size_t faces) {
  std::vector<Surface> surfaces(family.number_of_seeds);
  for(unsigned int i = 0; i < surfaces.size(); ++i) {
    auto& [mesh, pairs] = surfaces[i];
    mesh = mesh_of<Mesh>(family.make(faces, i + 1));
    CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  }
  return surfaces;
}

// The mean of `f` over surfaces.
template <typename Function> double mean(const std::vector<Surface>& surfaces, const Function& f) {
  double sum = 0.;
  for(const Surface& surface : surfaces)
    sum += f(surface);
  return sum / double(surfaces.size());
}

Row measure(const mesh_families::Family& family, const Wish& wish) {
  Row row;
  std::map<std::string, bool> is_too_slow;
  for(const std::size_t faces : wish.faces) {
    const std::vector<Surface> surfaces = surfaces_of(family, faces);
    const double mean_faces =
        mean(surfaces, [](const Surface& s) { return double(s.mesh.number_of_faces()); });
    for(const Command& command : commands) {
      if((!wish.command.empty() && wish.command != command.name) || is_too_slow[command.name])
        continue;
      const double seconds = mean(surfaces, [&](const Surface& s) {
        return measure(command, s.mesh, s.pairs, wish.number_of_runs);
      });
      is_too_slow[command.name] = seconds > wish.limit;
      row[command.name].by_faces.emplace_back(mean_faces, seconds);
      if(wish.print_times)
        std::fprintf(stderr, "%s, %.0f faces, %s: %.4f s\n", family.name.c_str(), mean_faces,
                     command.name, seconds);
    }
  }
  return row;
}

template <typename Cell>
void print(const char* title,
           const std::vector<std::pair<std::string, Row>>& rows,
           const Cell& cell) {
  std::printf("\n| %s |", title);
  for(const Command& command : commands)
    std::printf(" %s |", command.name);
  std::printf("\n|---|");
  for(std::size_t i = 0; i < std::size(commands); ++i)
    std::printf("---|");
  for(const auto& [name, row] : rows) {
    std::printf("\n| %s |", name.c_str());
    for(const Command& command : commands) {
      const auto times = row.find(command.name);
      std::printf(" %s |", times == row.end() ? "" : cell(times->second).c_str());
    }
  }
  std::printf("\n");
}

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

void run(const Wish& wish) {
  std::vector<std::pair<std::string, Row>> rows;
  for(const mesh_families::Family& family : mesh_families::families())
    if(wish.family.empty() || family.name.find(wish.family) != std::string::npos)
      rows.emplace_back(family.name, measure(family, wish));
  print("exponents", rows, [](const Times& times) { return formatted("%.2f", times.exponent()); });
  print("seconds", rows, [&](const Times& times) {
    const bool is_whole = times.by_faces.size() == wish.faces.size();
    return formatted(is_whole ? "%.3f" : "(%.3f)", times.by_faces.back().second);
  });
}

std::vector<std::size_t> numbers_in(const std::string& text) {
  std::vector<std::size_t> numbers;
  std::istringstream in(text);
  for(std::string number; std::getline(in, number, ',');)
    numbers.push_back(std::stoul(number));
  return numbers;
}

Wish parse(int argc, char* argv[]) {
  Wish wish;
  for(int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if(word == "--times") {
      wish.print_times = true;
      continue;
    }
    if(i + 1 == argc)
      throw std::invalid_argument(word + " needs a value");
    const std::string value = argv[++i];
    if(word == "-n")
      wish.number_of_runs = (std::max)(1, std::stoi(value));
    else if(word == "--faces")
      wish.faces = numbers_in(value);
    else if(word == "--limit")
      wish.limit = std::stod(value);
    else if(word == "--only")
      wish.family = value;
    else if(word == "--command")
      wish.command = value;
    else
      throw std::invalid_argument("no such option: " + word);
  }
  return wish;
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    run(parse(argc, argv));
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
