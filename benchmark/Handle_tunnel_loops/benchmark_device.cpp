// Measures the computation on a CUDA device, from arrays on the host to loops on the host, stage by
// stage, and the initial pass against its floor: the bytes that its updates move at least, at the
// bandwidth of the device, and its steps, at the cost of a barrier; beside the host solver on two
// threads.
//
//   benchmark_device [-n RUNS] [KIND:FACES:GENUS]...
//
// Without arguments: a suite of generated meshes. Each figure is the median of the runs. Fails if
// there is no device.

#include <CGAL/Handle_tunnel_loops/internal/device/ceilings.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_tunnel_loops.h>

#include "generators/generators.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace HTL = CGAL::Handle_tunnel_loops;
namespace impl = HTL::internal;
using HTL::Stage;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

Mesh make_mesh(const std::string& request) {
  std::istringstream in(request);
  std::string kind, faces, genus;
  std::getline(in, kind, ':');
  std::getline(in, faces, ':');
  std::getline(in, genus, ':');
  for(const HTL::generators::Kind& k : HTL::generators::kinds())
    if(kind == k.name) {
      const auto soup = k.make({std::stoull(faces), std::stoull(genus), 0});
      Mesh mesh;
      mesh.reserve(soup.points.size(), soup.triangles.size() * 3 / 2, soup.triangles.size());
      for(const auto& p : soup.points)
        mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
      for(const auto& t : soup.triangles)
        mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
      return mesh;
    }
  throw std::invalid_argument("there is no kind of mesh " + request);
}

// What one update moves at least: its place in two lists of the band, its state, its row, two
// values, and its neighbours' values once for all of them.
constexpr double bytes_per_update = 2 * 4 + 4 + 4 + 6 * 4 + 2 * 4 + 4;

// The field alone against its floor, and all of the pass: its memory, the saddles and the contours.
void measure_sweep(const impl::Flat_mesh& mesh,
                   bool in_graph,
                   const impl::device::Ceilings& ceilings,
                   int runs) {
  const double waiting_for_step =
      in_graph ? ceilings.seconds_per_graph_step : ceilings.seconds_per_step;
  if(waiting_for_step == 0.)
    return;
  const auto solver = impl::device::make_cuda_solver(mesh, {}, in_graph);
  std::vector<double> seconds, seconds_of_field;
  for(int i = 0; i <= runs; ++i) {
    const double before = solver->costs().seconds_of_sweeps;
    const auto began = Clock::now();
    solver->sweep(mesh.seeds, impl::step_coefficients({}), [](double) { return true; });
    if(i == 0)
      continue; // the first run loads the code
    seconds.push_back(seconds_since(began));
    seconds_of_field.push_back(solver->costs().seconds_of_sweeps - before);
  }
  const double sweeps = runs + 1;
  const double updates = double(solver->costs().number_of_updates) / sweeps;
  const double steps = double(solver->costs().number_of_steps) / sweeps;
  const double moving = updates * bytes_per_update / ceilings.bytes_per_second;
  const double waiting = steps * waiting_for_step;
  std::printf(
      "  initial pass, %s: %.4f s; its field %.4f s, %.4g updates, %.0f steps; floor of the "
      "field %.4f s (memory %.4f, steps %.4f), ratio %.2f\n",
      in_graph ? "steps in a graph" : "steps in one kernel", median(seconds),
      median(seconds_of_field), updates, steps, moving + waiting, moving, waiting,
      median(seconds_of_field) / (moving + waiting));
}

void measure_initial_pass(const Mesh& mesh, const impl::device::Ceilings& ceilings, int runs) {
  const auto index = get(boost::vertex_index, mesh);
  const auto point = get(CGAL::vertex_point, mesh);
  using Execution = decltype(impl::execution<CGAL::Parallel_if_available_tag>());
  const impl::Flat_mesh flat =
      impl::Flat_mesh_builder<Mesh, std::decay_t<decltype(index)>, std::decay_t<decltype(point)>,
                              Execution>(mesh, index, point)
          .build();
  for(const bool in_graph : {false, true})
    measure_sweep(flat, in_graph, ceilings, runs);
}

/// What the runs of a solver took.
struct Measured
{
  std::vector<std::vector<double>> stages = std::vector<std::vector<double>>(HTL::number_of_stages);
  std::vector<double> totals; ///< from arrays to loops: no adaptor, no certificate
  HTL::Statistics statistics;
};

template <typename Tag> Measured measure_solver(const Mesh& mesh, int runs) {
  Measured measured;
  for(int i = 0; i < runs; ++i) {
    std::vector<Pair> pairs;
    CGAL::Handle_tunnel_loops_solver<Mesh> solver(CGAL::Parallel_if_available_tag(), mesh,
                                                  CGAL::parameters::default_values());
    solver.find_loops<Tag>(std::back_inserter(pairs));
    const HTL::Statistics& statistics = measured.statistics = solver.statistics();
    for(std::size_t s = 0; s < HTL::number_of_stages; ++s)
      measured.stages[s].push_back(statistics.seconds[s]);
    measured.totals.push_back(statistics.total_seconds() - statistics.seconds_of(Stage::ADAPTOR) -
                              statistics.seconds_of(Stage::CERTIFICATE));
  }
  return measured;
}

void print(const char* backend, const Measured& measured) {
  std::printf("  %s:", backend);
  for(std::size_t s = 0; s < measured.stages.size(); ++s)
    std::printf(" %s %.3f,", HTL::stage_name(static_cast<Stage>(s)), median(measured.stages[s]));
  std::printf(" arrays to loops (all but adaptor and certificate) %.3f s\n",
              median(measured.totals));
}

void measure_all(const Mesh& mesh, int runs) {
  const Measured device = measure_solver<CGAL::Cuda_tag>(mesh, runs);
  print("device", device);
  std::printf("  %.0f bytes of the device per face\n",
              double(device.statistics.device_bytes) / double(mesh.number_of_faces()));
#ifdef CGAL_LINKED_WITH_TBB
  std::printf("  beside the device: %d threads\n", tbb::this_task_arena::max_concurrency());
  const tbb::global_control two_threads(tbb::global_control::max_allowed_parallelism, 2);
#endif
  const Measured host = measure_solver<CGAL::Parallel_if_available_tag>(mesh, 1);
  print("host, at most two threads", host);
  std::printf("  the host takes %.1f times as long\n", median(host.totals) / median(device.totals));
}

void measure(const std::string& request, const impl::device::Ceilings& ceilings, int runs) {
  const Mesh mesh = make_mesh(request);
  std::printf("%s: %zu faces\n", request.c_str(), std::size_t(num_faces(mesh)));
  measure_initial_pass(mesh, ceilings, runs);
  measure_all(mesh, runs);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  int runs = 3, first = 1;
  if(argc > 2 && std::string(argv[1]) == "-n") {
    runs = std::atoi(argv[2]);
    first = 3;
  }
  std::vector<std::string> requests(argv + first, argv + argc);
  if(requests.empty())
    requests = {"gyroid:1000000:250", "torus:1000000:1",    "torus:10000000:1",
                "lattice:10000000:3", "gyroid:10000000:30", "gyroid:10000000:1000"};
  try {
    const impl::device::Ceilings ceilings = impl::device::measure_ceilings(-1);
    std::printf("%s, %s: %.0f GB/s, %.2f us a launch, %.2f us a barrier, %.2f us a "
                "step of a graph\n",
                ceilings.device.c_str(), ceilings.versions.c_str(),
                1e-9 * ceilings.bytes_per_second, 1e6 * ceilings.seconds_per_launch,
                1e6 * ceilings.seconds_per_step, 1e6 * ceilings.seconds_per_graph_step);
    for(const std::string& request : requests)
      measure(request, ceilings, (std::max)(1, runs));
  } catch(const std::exception& e) {
    std::fprintf(stderr, "benchmark_device: %s\n", e.what());
    return 1;
  }
  return 0;
}
