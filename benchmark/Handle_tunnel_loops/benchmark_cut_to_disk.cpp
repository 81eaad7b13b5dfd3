// Measures cuts of meshes of positive genus: their lengths, and the time for cutting against that
// of finding the loops. Where libigl was found (-DHTL_LIBIGL=FOLDER, the one with igl/ in it), the
// lengths are compared with those of igl::cut_to_disk.
//
//   benchmark_cut_to_disk [-f MOST_FACES] FILE...

#include "Benchmark_meshes.h"

#include <CGAL/cut_to_disk.h>
#include <CGAL/handle_tunnel_loops.h>

#ifdef BENCHMARK_HAS_LIBIGL
#include <Eigen/Core>
#include <igl/cut_to_disk.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double length_of_edge(const Mesh& mesh, Mesh::Vertex_index u, Mesh::Vertex_index v) {
  return std::sqrt(CGAL::squared_distance(mesh.point(u), mesh.point(v)));
}

double length_of(const Mesh& mesh, const std::vector<Mesh::Edge_index>& cut) {
  double sum = 0.;
  for(const auto e : cut)
    sum += length_of_edge(mesh, mesh.vertex(e, 0), mesh.vertex(e, 1));
  return sum;
}

// 0 without libigl.
double length_by_libigl([[maybe_unused]] const Mesh& mesh) {
  double sum = 0.;
#ifdef BENCHMARK_HAS_LIBIGL
  Eigen::MatrixXi faces(mesh.number_of_faces(), 3);
  int row = 0;
  for(const auto f : mesh.faces()) {
    int column = 0;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      faces(row, column++) = static_cast<int>(v.idx());
    ++row;
  }
  std::vector<std::vector<int>> cuts;
  igl::cut_to_disk(faces, cuts);
  std::set<std::pair<int, int>> seen;
  for(const auto& cut : cuts)
    for(std::size_t i = 0; i + 1 < cut.size(); ++i)
      if(seen.insert(std::minmax(cut[i], cut[i + 1])).second)
        sum += length_of_edge(mesh, Mesh::Vertex_index(cut[i]), Mesh::Vertex_index(cut[i + 1]));
#endif
  return sum;
}

struct Sums
{
  std::size_t meshes = 0, longer = 0;
  double logarithms = 0., most = 0., loops = 0., cuts = 0.;
};

void measure(const std::string& file, std::size_t most_faces, Sums& sums) {
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh) || mesh.number_of_faces() > most_faces)
    return;
  const double begin = now();
  Pairs pairs;
  CGAL::handle_tunnel_loops<CGAL::Parallel_if_available_tag>(
      mesh, std::back_inserter(pairs),
      CGAL::parameters::basis_kind(CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST));
  if(pairs.empty())
    return;
  const double middle = now();
  std::vector<Mesh::Edge_index> cut;
  CGAL::cut_to_disk<CGAL::Parallel_if_available_tag>(mesh, std::back_inserter(cut),
                                                     CGAL::parameters::known_loops(pairs));
  const double end = now();
  const double length = length_of(mesh, cut), other = length_by_libigl(mesh);
  std::printf("%s: faces %zu, genus %zu, length %.6g, over libigl's %.3f, time over that of the "
              "loops %.3f\n",
              file.c_str(), std::size_t(mesh.number_of_faces()), pairs.size(), length,
              other > 0. ? length / other : 0., (end - middle) / (middle - begin));
  ++sums.meshes;
  sums.loops += middle - begin;
  sums.cuts += end - middle;
  if(other > 0.) {
    sums.logarithms += std::log(length / other);
    sums.longer += length > other;
    sums.most = (std::max)(sums.most, length / other);
  }
}

} // namespace

int main(int argc, char* argv[]) {
  std::size_t most_faces = 100000;
  Sums sums;
  for(int i = 1; i < argc; ++i)
    if(std::string(argv[i]) == "-f" && i + 1 < argc)
      most_faces = std::strtoul(argv[++i], nullptr, 10);
    else
      measure(argv[i], most_faces, sums);
  if(sums.meshes == 0)
    return EXIT_FAILURE;
  std::printf("%zu meshes: loops %.2f s, cuts %.2f s, ratio %.3f\n", sums.meshes, sums.loops,
              sums.cuts, sums.cuts / sums.loops);
  if(sums.most > 0.)
    std::printf("over libigl's: geometric mean %.4f, most %.4f, longer on %zu\n",
                std::exp(sums.logarithms / static_cast<double>(sums.meshes)), sums.most,
                sums.longer);
  return EXIT_SUCCESS;
}
