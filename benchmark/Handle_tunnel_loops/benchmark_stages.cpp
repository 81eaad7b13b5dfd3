// The stages of the computation one by one, on meshes of growing size at fixed genus; Google
// Benchmark fits the complexity. Counters: updates of the field per vertex, and nanoseconds per
// update.

#include <CGAL/Handle_tunnel_loops/internal/field/Narrow_band.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_tunnel_loops.h>

#include "generators/generators.h"

#include <benchmark/benchmark.h>

#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Pair = CGAL::Handle_tunnel_pair<Mesh>;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;
namespace HTL = CGAL::Handle_tunnel_loops;
namespace impl = CGAL::Handle_tunnel_loops::internal;

namespace {

Mesh make_mesh(std::size_t number_of_faces) {
  for(const auto& kind : HTL::generators::kinds())
    if(std::string(kind.name) == "multi-torus") {
      HTL::generators::Request request;
      request.faces = number_of_faces;
      request.genus = 5;
      const auto soup = kind.make(request);
      Mesh mesh;
      for(const auto& p : soup.points)
        mesh.add_vertex(Mesh::Point(p[0], p[1], p[2]));
      for(const auto& t : soup.triangles)
        mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
      return mesh;
    }
  return {};
}

impl::Flat_mesh flatten(const Mesh& mesh) {
  const auto index = get(boost::vertex_index, mesh);
  const auto point = get(CGAL::vertex_point, mesh);
  return impl::Flat_mesh_builder<Mesh, std::decay_t<decltype(index)>,
                                 std::decay_t<decltype(point)>>(impl::Execution(), mesh, index,
                                                                point)
      .build();
}

void adaptor(benchmark::State& state) {
  const Mesh mesh = make_mesh(state.range(0));
  for(auto _ : state)
    benchmark::DoNotOptimize(flatten(mesh));
  state.SetComplexityN(state.range(0));
}

void initial_field(benchmark::State& state) {
  const impl::Flat_mesh mesh = flatten(make_mesh(state.range(0)));
  const impl::Stencils stencils(impl::Execution(), mesh);
  impl::Narrow_band band(mesh, stencils, impl::step_coefficients(HTL::Field_constants()));
  const impl::No_walls walls;
  for(auto _ : state) {
    band.reset();
    band.add_source(mesh.seeds[0], 0);
    for(impl::Index u : mesh.ring(mesh.seeds[0]))
      band.add_source(u, 1);
    band.start(walls);
    while(band.number_of_reached() < mesh.number_of_vertices() && band.step(walls, [](auto) {}))
      ;
  }
  const double updates = double(band.number_of_updates());
  state.counters["updates/vertex"] =
      updates / double(state.iterations()) / double(mesh.number_of_vertices());
  state.counters["time/update"] =
      benchmark::Counter(updates, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.SetComplexityN(state.range(0));
}

void certificate(benchmark::State& state) {
  const Mesh mesh = make_mesh(state.range(0));
  std::vector<Pair> pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  for(auto _ : state)
    benchmark::DoNotOptimize(bool(CGAL::certify_handle_tunnel_loops(mesh, pairs)));
  state.SetComplexityN(state.range(0));
}

void everything(benchmark::State& state) {
  const Mesh mesh = make_mesh(state.range(0));
  for(auto _ : state) {
    std::vector<Pair> pairs;
    CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(pairs));
  }
  state.SetComplexityN(state.range(0));
}

constexpr int smallest = 1 << 14, largest = 1 << 20;

} // namespace

BENCHMARK(adaptor)->RangeMultiplier(4)->Range(smallest, largest)->Complexity();
BENCHMARK(initial_field)->RangeMultiplier(4)->Range(smallest, largest)->Complexity();
BENCHMARK(certificate)->RangeMultiplier(4)->Range(smallest, largest)->Complexity();
BENCHMARK(everything)->RangeMultiplier(4)->Range(smallest, largest)->UseRealTime()->Complexity();

BENCHMARK_MAIN();
