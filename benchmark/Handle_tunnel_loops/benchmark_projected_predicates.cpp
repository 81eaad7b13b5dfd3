// What the filter of Projected_points costs, beside predicates of CGAL's kernels: in which sense
// midpoints of edges, projected along a direction, turn.
//
//   benchmark_projected_predicates [FACES]
//
// The projections have no double coordinates, so that they have to be constructed: with intervals
// and, where these do not decide, exactly, as Filtered_predicate does it, or by Epeck. Epick on
// rounded projections is what a predicate costs that does not construct, but its answers are about
// other points. Nanoseconds of the processor for each predicate, points included. Ends with an
// error if exact answers differ.

#include "Benchmark_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Projected_points.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace impl = CGAL::Handle_tunnel_loops::internal;
using Edge = std::array<impl::Index, 2>;

constexpr impl::Projected_points::Direction direction = {0.2718, -0.5772};

// Three edges at a time: two that follow each other, and one a little further on.
struct Turns
{
  std::vector<impl::Vector> vertices;
  std::vector<Edge> edges;

  explicit Turns(const Mesh& mesh) {
    for(const auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      vertices.push_back({p.x(), p.y(), p.z()});
    }
    for(const auto e : mesh.edges())
      edges.push_back({impl::Index(mesh.vertex(e, 0)), impl::Index(mesh.vertex(e, 1))});
  }

  template <typename Turn> std::vector<int> answers(const char* name, const Turn& turn) const {
    std::vector<int> signs;
    signs.reserve(edges.size());
    const std::clock_t began = std::clock();
    for(std::size_t i = 0; i + 7 < edges.size(); ++i)
      signs.push_back(turn(edges[i], edges[i + 1], edges[i + 7]));
    const double seconds = double(std::clock() - began) / CLOCKS_PER_SEC;
    std::printf("| %s | %zu | %.0f |\n", name, signs.size(), 1e9 * seconds / double(signs.size()));
    return signs;
  }

  // Twice the midpoint of an edge, projected.
  template <typename Kernel> typename Kernel::Point_2 projected(const Edge& e) const {
    using FT = typename Kernel::FT;
    const impl::Vector &u = vertices[e[0]], &v = vertices[e[1]];
    const FT z = FT(u[2]) + FT(v[2]);
    return {FT(u[0]) + FT(v[0]) - FT(direction.a) * z, FT(u[1]) + FT(v[1]) - FT(direction.b) * z};
  }

  std::vector<int> answers_of_intervals() const {
    using Interval = CGAL::Interval_nt<false>;
    return answers("intervals", [this](const Edge& a, const Edge& b, const Edge& c) {
      {
        const CGAL::Protect_FPU_rounding<true> protection;
        using K = CGAL::Simple_cartesian<Interval>;
        const CGAL::Uncertain<CGAL::Orientation> sign =
            CGAL::orientation(projected<K>(a), projected<K>(b), projected<K>(c));
        if(CGAL::is_certain(sign))
          return int(CGAL::get_certain(sign));
      }
      using K = CGAL::Simple_cartesian<CGAL::Exact_rational>;
      return int(CGAL::orientation(projected<K>(a), projected<K>(b), projected<K>(c)));
    });
  }

  template <typename Kernel> std::vector<int> answers_of(const char* name) const {
    return answers(name, [this](const Edge& a, const Edge& b, const Edge& c) {
      return int(
          CGAL::orientation(projected<Kernel>(a), projected<Kernel>(b), projected<Kernel>(c)));
    });
  }
};

void compare(const std::string& input) {
  const Off_file off(input);
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(off.name(), mesh))
    throw std::runtime_error("cannot read " + off.name());
  const Turns turns(mesh);
  const impl::Projected_points points(turns.vertices, direction);
  const auto own = turns.answers("own filter", [&](const Edge& a, const Edge& b, const Edge& c) {
    return points.turn(points.midpoint(a[0], a[1]), points.midpoint(b[0], b[1]),
                       points.midpoint(c[0], c[1]));
  });
  turns.answers_of<CGAL::Exact_predicates_inexact_constructions_kernel>("Epick, rounded");
  if(turns.answers_of_intervals() != own ||
     turns.answers_of<CGAL::Exact_predicates_exact_constructions_kernel>("Epeck") != own)
    throw std::runtime_error("the answers differ");
}

} // namespace

int main(int argc, char* argv[]) {
  try {
    std::printf("| | predicates | ns |\n|---|---|---|\n");
    compare("gyroid:" + std::string(argc > 1 ? argv[1] : "200000") + ":50");
  } catch(const std::exception& e) {
    std::cerr << "Error: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
