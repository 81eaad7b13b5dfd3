// Measures the computation on a CUDA device, from arrays on the host to loops on the host, stage by
// stage, and the initial pass against its floor: the bytes that its updates move at least, at the
// bandwidth of the device, and its steps, at the cost of a barrier; beside the host solver on all
// threads and on two. The first cells of the coarse mesh by themselves, by the host and by the
// device.
//
//   benchmark_device [-n RUNS] [--kernels] [--knobs] [--no-host] [--no-sweep] [KIND:FACES:GENUS]...
//
// --kernels: what each kernel takes; --knobs: the same with other choices of how the device is
// used;
// --no-host, --no-sweep: without the host solver, without the initial pass by itself. Without
// requests: a suite of generated meshes. Each figure is the median of the runs. Fails if there is
// no device.

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh_builder.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_tunnel_loops.h>

#include "Tuned_passes.h"

#include "generators/generators.h"

#include <cxxabi.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <iterator>
#include <memory>
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

/// What is measured.
struct Choices
{
  int runs = 3;
  bool with_sweep = true, with_kernels = false, with_knobs = false, with_host = true;
};

std::vector<std::string> read_arguments(int argc, char** argv, Choices& choices) {
  std::vector<std::string> requests;
  for(int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if(argument == "-n" && i + 1 < argc)
      choices.runs = (std::max)(1, std::atoi(argv[++i]));
    else if(argument == "--kernels")
      choices.with_kernels = true;
    else if(argument == "--knobs")
      choices.with_knobs = true;
    else if(argument == "--no-host")
      choices.with_host = false;
    else if(argument == "--no-sweep")
      choices.with_sweep = false;
    else if(argument.substr(0, 1) == "-")
      throw std::invalid_argument("there is no option " + argument);
    else
      requests.push_back(argument);
  }
  if(requests.empty())
    requests = {"torus:1000000:1", "gyroid:1000000:250", "torus:10000000:1", "lattice:10000000:3",
                "lattice:10000000:1000"};
  return requests;
}

// What a kernel does, without the namespaces.
std::string short_name(const std::string& type) {
  int status = 0;
  char* demangled = abi::__cxa_demangle(type.c_str(), nullptr, nullptr, &status);
  std::string name = status == 0 ? demangled : type;
  std::free(demangled);
  for(const char* space :
      {"CGAL::Handle_tunnel_loops::internal::device::", "CGAL::Handle_tunnel_loops::internal::"})
    for(auto at = name.find(space); at != std::string::npos; at = name.find(space))
      name.erase(at, std::string(space).size());
  return name;
}

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
void measure_sweep(const impl::Flat_mesh& mesh, const impl::device::Ceilings& ceilings, int runs) {
  const auto solver = impl::device::make_cuda_solver(mesh, {});
  std::vector<double> seconds, seconds_of_field;
  for(int i = 0; i <= runs; ++i) {
    const double before = solver->costs().seconds_of_sweeps;
    const auto began = Clock::now();
    solver->initial_field(mesh.seeds, impl::step_coefficients({}), [](double) { return true; });
    if(i == 0)
      continue; // the first run loads the code
    seconds.push_back(seconds_since(began));
    seconds_of_field.push_back(solver->costs().seconds_of_sweeps - before);
  }
  const double sweeps = runs + 1;
  const double updates = double(solver->costs().number_of_updates) / sweeps;
  const double steps = double(solver->costs().number_of_steps) / sweeps;
  const double moving = updates * bytes_per_update / ceilings.bytes_per_second;
  const double waiting = steps * ceilings.seconds_per_step;
  std::printf("  initial pass: %.4f s; its field %.4f s, %.4g updates, %.0f steps; floor of the "
              "field %.4f s (memory %.4f, steps %.4f), ratio %.2f\n",
              median(seconds), median(seconds_of_field), updates, steps, moving + waiting, moving,
              waiting, median(seconds_of_field) / (moving + waiting));
}

impl::Flat_mesh flat_mesh_of(const Mesh& mesh) {
  const auto index = get(boost::vertex_index, mesh);
  const auto point = get(CGAL::vertex_point, mesh);
  return impl::Flat_mesh_builder<Mesh, std::decay_t<decltype(index)>,
                                 std::decay_t<decltype(point)>>(
             impl::execution_of<CGAL::Parallel_if_available_tag>(), mesh, index, point)
      .build();
}

// What is before the fields: labelling the cells of a coarse mesh, and a first look at each of
// them.
void measure_cells(const impl::Flat_mesh& mesh, int runs) {
  const auto seconds = [&](const auto& find_first_cells) {
    std::vector<double> all;
    for(int i = 0; i <= runs; ++i) {
      const auto began = Clock::now();
      impl::Coarse_mesh_builder(impl::execution_of<CGAL::Parallel_if_available_tag>(), mesh,
                                impl::vertices_of_cell, mesh.seeds, find_first_cells);
      if(i > 0) // the first run loads the code
        all.push_back(seconds_since(began));
    }
    return median(all);
  };
  std::unique_ptr<impl::device::Solver> solver;
  const auto send_and_find = [&](impl::First_cells& cells) {
    solver.reset();
    solver = impl::device::make_cuda_solver(mesh, {});
    return solver->find_first_cells(cells);
  };
  const double of_host = seconds(impl::Find_first_cells()), with_sending = seconds(send_and_find);
  const double alone = seconds([&](impl::First_cells& c) { return solver->find_first_cells(c); });
  std::printf("  first cells: host %.4f s; device %.4f s, without sending the mesh %.4f s\n",
              of_host, with_sending, alone);
}

// A line for a run, and one for each kernel that takes a hundredth of the device's time.
void print(const char* name, const benchmark_device::Tuned_run& run) {
  std::printf("  %s:", name);
  for(const Stage stage : {Stage::INITIAL, Stage::TUNNEL, Stage::REFINE, Stage::SHORTEN})
    std::printf(" %s %.4f,", HTL::stage_name(stage), run.statistics.seconds_of(stage));
  std::printf(" all %.4f s; %.4g updates, %llu steps, %llu batches\n",
              run.statistics.total_seconds(), double(run.costs.number_of_updates),
              static_cast<unsigned long long>(run.costs.number_of_steps),
              static_cast<unsigned long long>(run.costs.number_of_batches));
  double all = 0.;
  for(const auto& kernel : run.costs.kernels)
    all += kernel.second.seconds;
  for(const auto& [type, cost] : run.costs.kernels)
    if(cost.seconds > 0.01 * all)
      std::printf("    %8.4f s %7llu launches %5.1f%%  %s\n", cost.seconds,
                  static_cast<unsigned long long>(cost.number_of_launches),
                  100. * cost.seconds / all, short_name(type).c_str());
}

// One after the other, what may be chosen of the way in which a device is used.
void measure_knobs(const impl::Flat_mesh& mesh) {
  using impl::device::Tuning;
  const auto run = [&](const std::string& name, void (*change)(Tuning&, int), int value) {
    Tuning tuning;
    change(tuning, value);
    print((name + " " + std::to_string(value)).c_str(), benchmark_device::run_tuned(mesh, tuning));
  };
  for(const int threads : {128, 256, 384, 512})
    run(
        "threads at barrier", [](Tuning& t, int n) { t.threads_at_barrier = n; }, threads);
  for(const int steps : {16, 256})
    run(
        "steps per look", [](Tuning& t, int n) { t.steps_per_look = n; }, steps);
  for(const int steps : {4, 64})
    run(
        "steps per look if met", [](Tuning& t, int n) { t.steps_per_look_if_met = n; }, steps);
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
                              statistics.seconds_of(Stage::CERTIFICATE) -
                              statistics.seconds_of(Stage::CLASSIFY));
  }
  return measured;
}

void print(const char* backend, const Measured& measured) {
  std::printf("  %s:", backend);
  for(std::size_t s = 0; s < measured.stages.size(); ++s)
    std::printf(" %s %.3f,", HTL::stage_name(static_cast<Stage>(s)), median(measured.stages[s]));
  std::printf(" all %.3f s; arrays to loops (all but adaptor, certificate and linking) %.3f s\n",
              measured.statistics.total_seconds(), median(measured.totals));
}

// Starts the device, and says what it can do.
impl::device::Ceilings started_device() {
  const auto began = Clock::now();
  impl::device::start_cuda_device({});
  const double start = seconds_since(began);
  const impl::device::Ceilings c = impl::device::measure_ceilings(-1);
  std::printf("%s, %s: %.2f s to start it, %.1f ms to map a gigabyte, %.0f GB/s, %.2f us a launch, "
              "%.2f us a barrier\n",
              c.device.c_str(), c.versions.c_str(), start,
              1e12 * c.seconds_to_map / double(c.mapped_bytes), 1e-9 * c.bytes_per_second,
              1e6 * c.seconds_per_launch, 1e6 * c.seconds_per_step);
  return c;
}

// By threads of the host: two, as other benchmarks have, and all.
void measure_host(const Mesh& mesh, double seconds_of_device) {
  const auto measure = [&] {
    const Measured host = measure_solver<CGAL::Parallel_if_available_tag>(mesh, 1);
    print("host", host);
    std::printf("  the host takes %.1f times as long\n", median(host.totals) / seconds_of_device);
  };
#ifdef CGAL_LINKED_WITH_TBB
  std::printf("  host, %d threads\n", tbb::this_task_arena::max_concurrency());
  measure();
  const tbb::global_control two_threads(tbb::global_control::max_allowed_parallelism, 2);
  std::printf("  host, at most two threads\n");
#endif
  measure();
}

void measure(const std::string& request,
             const Mesh& mesh,
             const impl::device::Ceilings& ceilings,
             const Choices& choices) {
  std::printf("%s: %zu faces\n", request.c_str(), std::size_t(num_faces(mesh)));
  const Measured device = measure_solver<CGAL::Cuda_tag>(mesh, choices.runs);
  print("device", device);
  std::printf("  %.0f bytes of the device per face\n",
              double(device.statistics.device_bytes) / double(mesh.number_of_faces()));
  const impl::Flat_mesh flat = flat_mesh_of(mesh);
  measure_cells(flat, choices.runs);
  if(choices.with_sweep)
    measure_sweep(flat, ceilings, choices.runs);
  if(choices.with_kernels) {
    impl::device::Tuning tuning;
    print("all kernels waited for", benchmark_device::run_tuned(flat, tuning));
    tuning.times_kernels = true;
    print("all kernels timed", benchmark_device::run_tuned(flat, tuning));
  }
  if(choices.with_knobs)
    measure_knobs(flat);
  std::fflush(stdout);
  if(choices.with_host)
    measure_host(mesh, median(device.totals));
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
  const auto began = Clock::now();
  try {
    Choices choices;
    const std::vector<std::string> requests = read_arguments(argc, argv, choices);
    const impl::device::Ceilings ceilings = started_device();
    std::vector<std::future<Mesh>> meshes; // all made at once
    for(const std::string& request : requests)
      meshes.push_back(std::async(std::launch::async, make_mesh, request));
    for(auto& mesh : meshes)
      mesh.wait();
    for(std::size_t i = 0; i < requests.size(); ++i)
      measure(requests[i], meshes[i].get(), ceilings, choices);
    std::printf("%.0f s in all\n", seconds_since(began));
  } catch(const std::exception& e) {
    std::fprintf(stderr, "benchmark_device: %s\n", e.what());
    return 1;
  }
  return 0;
}
