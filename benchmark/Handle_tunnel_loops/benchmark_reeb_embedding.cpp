// Measures how well Reeb graphs of diffusions are drawn.
//
//   benchmark_reeb_embedding [-t SIMPLIFICATION] [KIND:FACES:GENUS | FILE | FOLDER]...
//
// For each closed mesh that does not cross itself: the share of the lines that is inside the solid,
// by length, cut exactly where they cross the surface; the share of the junctions that are; and how
// far these are from where the limbs part. That is the saddle, the vertex at which the contour of
// the trunk is pinched off. `off` is the distance of a junction from there, as a part of the
// diagonal of the mesh. `centred` is the same over the distance from the surface: it is one if the
// junction is the centre of a ball that touches the surface at the saddle and lies in the solid,
// and the larger the farther the junction is from there. The time is that of the whole graph, and
// what of it is simplification and embedding, the least of some runs.

#include "Benchmark_meshes.h"
#include "Solid.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace {

using Graph = CGAL::Reeb_graph<Mesh>;
namespace parameters = CGAL::parameters;

constexpr int number_of_runs = 3;

Point to_point(const Mesh::Point& p) { return Point(p.x(), p.y(), p.z()); }

struct Quality
{
  double length = 0., length_inside = 0.;
  std::size_t number_inside = 0;
  std::vector<double> off, centred; // by junction; of those inside

  double share() const { return length > 0. ? length_inside / length : 1.; }
};

double share_of_junctions(const Quality& q) {
  return q.off.empty() ? 1. : double(q.number_inside) / double(q.off.size());
}

double middle(const std::vector<double>& values) { return values.empty() ? 0. : median(values); }

double largest(const std::vector<double>& values) {
  return values.empty() ? 0. : *std::max_element(values.begin(), values.end());
}

Quality quality_of(const Mesh& mesh, const Graph& graph, const Solid& solid, double diagonal) {
  Quality quality;
  for(const auto e : CGAL::make_range(edges(graph))) {
    const auto& line = graph[e].polyline;
    for(std::size_t i = 1; i < line.size(); ++i) {
      const Point a = to_point(line[i - 1]), b = to_point(line[i]);
      quality.length += std::sqrt(CGAL::squared_distance(a, b));
      quality.length_inside += solid.length_inside(a, b);
    }
  }
  for(const auto v : CGAL::make_range(vertices(graph)))
    if(graph[v].type == CGAL::Reeb_node_type::SADDLE) {
      const Point p = to_point(graph[v].point), saddle = to_point(mesh.point(graph[v].vertex));
      const double distance = std::sqrt(CGAL::squared_distance(p, saddle));
      quality.off.push_back(distance / diagonal);
      if(solid.contains(p)) {
        ++quality.number_inside;
        quality.centred.push_back(distance / (std::max)(solid.distance(p), 1e-9 * diagonal));
      }
    }
  return quality;
}

struct Total
{
  std::size_t meshes = 0;
  double share = 0., smallest_share = 1., share_of_junctions = 0., off = 0., centred = 0.;
  double seconds = 0.;
};

const char* reason_to_skip(const Mesh& mesh, const Solid_mesh& solid) {
  namespace PMP = CGAL::Polygon_mesh_processing;
  if(mesh.is_empty() || !CGAL::is_closed(mesh) || !CGAL::is_triangle_mesh(mesh))
    return "not closed";
  if(PMP::does_self_intersect<CGAL::Parallel_if_available_tag>(solid))
    return "crosses itself";
  return nullptr;
}

void measure(const std::string& input, double threshold, Total& total) {
  const Off_file file(input);
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file.name(), mesh)) {
    std::printf("| %s | cannot be read |\n", input.c_str());
    return;
  }
  Solid_mesh solid_mesh;
  CGAL::copy_face_graph(mesh, solid_mesh);
  const std::string name = std::filesystem::path(input).stem().string();
  if(const char* reason = reason_to_skip(mesh, solid_mesh)) {
    std::printf("| %s | %s |\n", name.c_str(), reason);
    return;
  }
  const Solid solid(solid_mesh);
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double diagonal =
      std::sqrt(CGAL::square(box.xmax() - box.xmin()) + CGAL::square(box.ymax() - box.ymin()) +
                CGAL::square(box.zmax() - box.zmin()));
  Graph graph;
  CGAL::Handle_tunnel_loops::Reeb_options options;
  options.threshold = threshold;
  options.allow_parallel_arcs = true;
  CGAL::Handle_tunnel_loops::Reeb_statistics statistics;
  double seconds = std::numeric_limits<double>::infinity(), finishing = seconds;
  for(int run = 0; run < number_of_runs; ++run) {
    const double began = seconds_now();
    statistics = CGAL::reeb_graph<CGAL::Parallel_if_available_tag>(
        mesh, graph, parameters::reeb_options(options));
    seconds = (std::min)(seconds, seconds_now() - began);
    finishing = (std::min)(finishing, statistics.seconds_of_finishing);
  }
  const Quality q = quality_of(mesh, graph, solid, diagonal);
  std::printf(
      "| %s | %zu | %zu | %zu | **%.2f** | %zu | %.0f | %.3f | %.3f | %.2f | %.4f | %.4f |\n",
      name.c_str(), statistics.number_of_faces, statistics.genus, num_edges(graph),
      100. * q.share(), q.off.size(), 100. * share_of_junctions(q), middle(q.off), largest(q.off),
      middle(q.centred), seconds, finishing);
  std::fflush(stdout);
  ++total.meshes;
  total.share += q.share();
  total.smallest_share = (std::min)(total.smallest_share, q.share());
  total.share_of_junctions += share_of_junctions(q);
  total.off += middle(q.off);
  total.centred += middle(q.centred);
  total.seconds += seconds;
}

std::vector<std::string> files_of(const std::string& input) {
  if(!std::filesystem::is_directory(input))
    return {input};
  std::vector<std::string> files;
  for(const auto& entry : std::filesystem::directory_iterator(input))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

int main(int argc, char* argv[]) {
  double threshold = CGAL::Handle_tunnel_loops::default_simplification_threshold;
  std::vector<std::string> inputs;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "-t" && i + 1 < argc)
      threshold = std::atof(argv[++i]);
    else
      for(const std::string& file : files_of(argv[i]))
        inputs.push_back(file);
  if(inputs.empty())
    inputs = {"torus:20000:1",  "knot:20000:1",      "multi-torus:20000:5", "lattice:20000:5",
              "gyroid:20000:5", "sponge:20000:5",    "plates:20000:5",      "bars:20000:5",
              "shell:20000:5",  "foam:20000:5",      "interlaced:20000:5",  "bicycle:20000:14",
              "bores:20000:20", "borromean:20000:3", "cage:20000:36",       "chair:20000:7",
              "coral:20000:6",  "exchanger:20000:7", "mug:20000:1",         "trefoil:20000:1"};
  std::printf(
      "| mesh | faces | genus | arcs | line inside %% | junctions | inside %% | off, median | "
      "off, largest | centred, median | seconds | finishing |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  Total total;
  for(const std::string& input : inputs)
    try {
      measure(input, threshold, total);
    } catch(const std::exception& e) {
      std::printf("| %s | %s |\n", input.c_str(), e.what());
    }
  const double n = double((std::max)(total.meshes, std::size_t(1)));
  std::printf(
      "\n%zu meshes, means: line inside %.2f%% (least %.2f%%), junctions inside %.1f%%, off "
      "%.4f, centred %.2f; %.3f s in all\n",
      total.meshes, 100. * total.share / n, 100. * total.smallest_share,
      100. * total.share_of_junctions / n, total.off / n, total.centred / n, total.seconds);
  return EXIT_SUCCESS;
}
