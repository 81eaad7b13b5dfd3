#ifndef BENCHMARK_CORPUS_ANSWER_H
#define BENCHMARK_CORPUS_ANSWER_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_tunnel_loops.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file Corpus_answer.h
/// What a solver answers for one mesh of a folder, and what can be counted of it.

namespace corpus {

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Solver = CGAL::Handle_tunnel_loops_solver<Mesh>;
using Pairs = std::vector<Solver::Pair>;
namespace HTL = CGAL::Handle_tunnel_loops;

inline double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// the least value that a given part of the values does not exceed; 0 if there are none.
inline double quantile(std::vector<double> values, double part) {
  if(values.empty())
    return 0.;
  std::sort(values.begin(), values.end());
  return values[(std::min)(values.size() - 1, std::size_t(part * double(values.size())))];
}

struct Answer
{
  Pairs pairs;
  HTL::Certificate certificate;
  HTL::Statistics statistics;
  double seconds = 0.;
  std::string error; ///< empty if the answer was certified

  /// total lengths of the handle loops and of the tunnel loops.
  std::array<double, 2> lengths() const {
    std::array<double, 2> sums{};
    for(const auto& pair : pairs) {
      sums[0] += pair.handle().length();
      sums[1] += pair.tunnel().length();
    }
    return sums;
  }

  std::size_t handles_inside() const { return certificate.handles_bound_inside.value_or(0); }
  std::size_t tunnels_outside() const { return certificate.tunnels_bound_outside.value_or(0); }

  /// whether all handle loops bound inside, and all tunnel loops outside.
  bool is_pure() const {
    return handles_inside() == pairs.size() && tunnels_outside() == pairs.size();
  }

  /// the number of loops of which linking numbers say nothing.
  std::size_t undecided() const {
    return static_cast<std::size_t>(
        std::count_if(certificate.linking.begin(), certificate.linking.end(),
                      [](const HTL::Loop_linking& l) { return !l.problem.empty(); }));
  }

  /// whether linking numbers tell which loop of a pair is the handle.
  bool tells_handle(std::size_t k) const {
    const auto insideness = [this](std::size_t i) {
      const HTL::Loop_linking& l = certificate.linking[i];
      return int(l.bounds_inside_component) - int(l.bounds_outside_component);
    };
    return !certificate.linking.empty() && insideness(2 * k) != insideness(2 * k + 1);
  }
};

/// the loops that a solver finds; what it throws becomes the error.
template <typename ConcurrencyTag, typename NamedParameters>
Answer answer_of(Solver& solver, const NamedParameters& np) {
  Answer answer;
  const double began = seconds_now();
  try {
    solver.find_loops<ConcurrencyTag>(std::back_inserter(answer.pairs), np);
  } catch(const std::exception& e) {
    answer.error = e.what();
  }
  answer.seconds = seconds_now() - began;
  answer.certificate = solver.certificate();
  answer.statistics = solver.statistics();
  return answer;
}

/// vertices with faces, evenly spaced among all of them: at most a given number.
inline std::vector<Mesh::Vertex_index> spaced_seeds(const Mesh& mesh, std::size_t number) {
  std::vector<Mesh::Vertex_index> all, seeds;
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      all.push_back(v);
  number = (std::min)(number, all.size());
  for(std::size_t i = 0; i < number; ++i)
    seeds.push_back(all[i * all.size() / number]);
  return seeds;
}

/// the same surface with its vertices, its faces and the corners of each in another order.
inline Mesh permuted(const Mesh& mesh, CGAL::Random& random) {
  const auto shuffle = [&](auto& elements) {
    for(std::size_t i = elements.size(); i > 1; --i)
      std::swap(elements[i - 1], elements[random.get_int(0, static_cast<int>(i))]);
  };
  std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end()), copy_of;
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  shuffle(vertices);
  shuffle(faces);
  copy_of.resize(mesh.num_vertices());
  Mesh result;
  for(const Mesh::Vertex_index v : vertices)
    copy_of[v] = result.add_vertex(mesh.point(v));
  for(const Mesh::Face_index f : faces) {
    Mesh::Halfedge_index h = mesh.halfedge(f);
    for(int i = random.get_int(0, 3); i > 0; --i)
      h = mesh.next(h);
    result.add_face(copy_of[mesh.source(h)], copy_of[mesh.target(h)],
                    copy_of[mesh.target(mesh.next(h))]);
  }
  if(result.number_of_faces() != mesh.number_of_faces())
    throw std::logic_error("faces cannot be added in any order");
  return result;
}

inline double total_length(const Answer& answer) {
  const auto lengths = answer.lengths();
  return lengths[0] + lengths[1];
}

/// options that leave the loops as the passes find them.
inline CGAL::Handle_tunnel_loops::Solver_options untouched() {
  CGAL::Handle_tunnel_loops::Solver_options options;
  options.do_tighten = options.do_compute_linking = false;
  return options;
}

} // namespace corpus

#endif // BENCHMARK_CORPUS_ANSWER_H
