#ifndef BENCHMARK_VERTEX_LOOPS_H
#define BENCHMARK_VERTEX_LOOPS_H

#include "Corpus_answer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// \file Vertex_loops.h
/// Loops that another program found, as closed walks from vertex to vertex.

namespace corpus {

/// Lines of a text: `handle` or `tunnel` and the vertices of a loop, in the order of the mesh file.
class Vertex_loops
{
public:
  explicit Vertex_loops(const std::string& file, const Mesh& mesh)
      : mesh_(mesh) {
    std::ifstream in(file);
    if(!in)
      throw std::runtime_error("cannot read " + file);
    for(std::string line; std::getline(in, line);)
      add(line);
  }

  std::size_t number_of_handles() const { return handles_.size(); }
  std::size_t number_of_tunnels() const { return tunnels_.size(); }

  /// handle k with tunnel k, whether or not they cross; what has no partner is left out.
  Pairs pairs() const {
    Pairs pairs;
    for(std::size_t k = 0; k < (std::min)(handles_.size(), tunnels_.size()); ++k)
      pairs.emplace_back(loop(handles_[k], CGAL::Loop_type::HANDLE, k),
                         loop(tunnels_[k], CGAL::Loop_type::TUNNEL, k));
    return pairs;
  }

private:
  using Walk = std::vector<Mesh::Vertex_index>;
  using Loop = Solver::Pair::Loop;

  void add(const std::string& line) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if(kind != "handle" && kind != "tunnel")
      return;
    Walk walk;
    for(std::size_t v = 0; words >> v;) {
      if(v >= mesh_.number_of_vertices())
        throw std::runtime_error("there is no vertex " + std::to_string(v));
      walk.emplace_back(static_cast<Mesh::size_type>(v));
    }
    if(!words.eof() || walk.size() < 3)
      throw std::runtime_error("no loop: " + line);
    (kind == "handle" ? handles_ : tunnels_).push_back(std::move(walk));
  }

  Loop loop(const Walk& walk, CGAL::Loop_type type, std::size_t pair) const {
    std::vector<Loop::Step> steps;
    std::vector<Loop::Point> points;
    double length = 0.;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      const Mesh::Vertex_index u = walk[i], v = walk[(i + 1) % walk.size()];
      const Mesh::Halfedge_index h = mesh_.halfedge(u, v);
      if(!h.is_valid())
        throw std::runtime_error("there is no edge from vertex " + std::to_string(u) + " to " +
                                 std::to_string(v));
      steps.push_back({h, 0.});
      points.push_back(mesh_.point(u));
      length += std::sqrt(CGAL::squared_distance(mesh_.point(u), mesh_.point(v)));
    }
    return Loop(std::move(steps), std::move(points), length, type, pair);
  }

  const Mesh& mesh_;
  std::vector<Walk> handles_, tunnels_;
};

} // namespace corpus

#endif // BENCHMARK_VERTEX_LOOPS_H
