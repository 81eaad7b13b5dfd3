// Measures Reeb graphs against the time that CGAL::IO::read_polygon_mesh takes for the same mesh as
// an OFF file, and, where VTK was found, against its vtkPolyDataToReebGraphFilter with the same
// function, all in one run.
//
//   benchmark_reeb_graph [-n RUNS] [-l SECONDS] [KIND:FACES:GENUS | FILE]...
//
// For each mesh: the height; the height with noise of a hundredth of the size of the mesh; noise
// alone; and the diffusion. Each figure is the median of the runs; VTK is run once, on the first
// two, for at most the given time.

#include "Benchmark_meshes.h"
#include "Counting_allocation.h"
#ifdef BENCHMARK_HAS_VTK
#include "Vtk_reeb_graph.h"
#endif

#include <CGAL/reeb_graph.h>

#include "generators/Random.h"

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

namespace HTL = CGAL::Handle_tunnel_loops;

using Function = std::vector<double>;
using Graph = CGAL::Reeb_graph<Mesh>;
using Tag = CGAL::Parallel_if_available_tag;

struct Settings
{
  int number_of_runs = 3;
  unsigned limit_of_vtk = 120;
};

struct Measured
{
  std::vector<double> seconds, ratio;
  double bytes = 0.;
  HTL::Reeb_statistics statistics;
  std::ptrdiff_t cycles = 0;
};

Function height_with_noise(const Mesh& mesh, double height, double noise) {
  HTL::generators::Random random(1);
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double size = box.xmax() - box.xmin();
  Function function;
  for(const auto& p : mesh.points())
    function.push_back(height * p.x() + noise * size * random.uniform(0., 1.));
  return function;
}

template <typename FindGraph>
void measure(double reading, const FindGraph& find_graph, Measured& measured) {
  if(measured.seconds.empty())
    measured.bytes = double(counting_allocation::peak_bytes([&] {
      Graph graph;
      find_graph(graph);
    }));
  Graph graph;
  const double began = seconds_now();
  measured.statistics = find_graph(graph);
  measured.seconds.push_back(seconds_now() - began);
  measured.ratio.push_back(measured.seconds.back() / reading);
  measured.cycles = static_cast<std::ptrdiff_t>(num_edges(graph) - num_vertices(graph) +
                                                measured.statistics.number_of_components);
}

void print(const std::string& input, const char* function, double reading, const Measured& m) {
  const auto& s = m.statistics;
  std::printf("| %s | %s | %zu | %zu | %td | %zu | %.2f | %.3f | **%.2f** | %.0f | %.3f | %.3f | "
              "%.3f | %.3f | %.2f |",
              input.c_str(), function, s.number_of_faces, s.genus, m.cycles,
              s.number_of_critical_nodes, reading, median(m.seconds), median(m.ratio),
              m.bytes / double(s.number_of_faces), s.seconds_of_adaptor, s.seconds_of_function,
              s.seconds_of_sweep, s.seconds_of_finishing,
              double(s.number_of_steps) / double(3 * s.number_of_faces));
}

#ifdef BENCHMARK_HAS_VTK
void print_vtk(const Mesh& mesh, const Function& function, unsigned limit) {
  std::vector<std::array<double, 3>> points;
  for(const auto& p : mesh.points())
    points.push_back({p.x(), p.y(), p.z()});
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    triangles.push_back(
        {mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  const Vtk_result vtk = vtk_reeb_graph(points, triangles, function, limit);
  if(vtk.is_done)
    std::printf(" %.2f | %.0f | %lld |\n", vtk.seconds, vtk.bytes / double(mesh.number_of_faces()),
                vtk.arcs - vtk.nodes + 1);
  else
    std::printf(" none in %u | | |\n", limit);
}
#else
void print_vtk(const Mesh&, const Function&, unsigned) { std::printf(" | | |\n"); }
#endif

void measure_all(const std::string& input, const Settings& settings) {
  const Off_file file(input);
  const char* names[] = {"height", "height and noise", "noise", "diffusion"};
  std::array<Measured, 4> measured;
  std::array<Function, 3> functions;
  std::vector<double> reading;
  Mesh mesh;
  for(int run = 0; run < settings.number_of_runs; ++run) {
    mesh.clear();
    const double began = seconds_now();
    if(!CGAL::IO::read_polygon_mesh(file.name(), mesh))
      throw std::runtime_error("cannot read " + input);
    reading.push_back(seconds_now() - began);
    functions = {height_with_noise(mesh, 1., 0.), height_with_noise(mesh, 1., 0.01),
                 height_with_noise(mesh, 0., 1.)};
    for(std::size_t i = 0; i < functions.size(); ++i) {
      const Function& function = functions[i];
      const auto map = boost::make_function_property_map<Mesh::Vertex_index, double>(
          [&function](Mesh::Vertex_index v) { return function[v.idx()]; });
      const auto find_graph = [&](Graph& graph) {
        return CGAL::reeb_graph_of_function<Tag>(mesh, map, graph);
      };
      measure(reading.back(), find_graph, measured[i]);
    }
    const auto find_graph = [&](Graph& graph) { return CGAL::reeb_graph<Tag>(mesh, graph); };
    measure(reading.back(), find_graph, measured[3]);
  }
  for(std::size_t i = 0; i < measured.size(); ++i) {
    print(input, names[i], median(reading), measured[i]);
    std::fflush(stdout); // before there are two processes
    if(i < 2 && settings.limit_of_vtk > 0)
      print_vtk(mesh, functions[i], settings.limit_of_vtk);
    else
      std::printf(" | | |\n");
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  Settings settings;
  std::vector<std::string> inputs;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "-n" && i + 1 < argc)
      settings.number_of_runs = (std::max)(1, std::atoi(argv[++i]));
    else if(std::string(argv[i]) == "-l" && i + 1 < argc)
      settings.limit_of_vtk = static_cast<unsigned>((std::max)(0, std::atoi(argv[++i])));
    else
      inputs.push_back(argv[i]);
  if(inputs.empty())
    inputs = {"sphere:1000000:0",       "torus:1000000:1",       "multi-torus:1000000:50",
              "gyroid:1000000:250",     "lattice:1000000:250",   "sponge:1000000:250",
              "multi-torus:100000:100", "multi-torus:500000:100"};
  try {
    std::printf("| mesh | function | faces | genus | cycles | nodes | reading s | Reeb s | ratio | "
                "bytes per face | adaptor | function | sweep | finishing | steps per halfedge | "
                "VTK s | VTK bytes per face | VTK cycles |\n"
                "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for(const std::string& input : inputs)
      measure_all(input, settings);
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
