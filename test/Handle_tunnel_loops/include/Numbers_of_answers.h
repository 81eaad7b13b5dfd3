#ifndef HTL_TEST_NUMBERS_OF_ANSWERS_H
#define HTL_TEST_NUMBERS_OF_ANSWERS_H

#include "Meshes_of_soups.h"

#include <CGAL/reeb_graph.h>

#include <vector>

// All that a caller is given, in numbers.
struct Numbers_of_answers
{
  std::vector<double> loops;
  std::vector<double> reeb_graph;
};

inline Numbers_of_answers numbers_of_answers(const Soup& soup) {
  using Point = Mesh::Point;
  const auto append = [](std::vector<double>& numbers, const Point& p) {
    numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
  };
  const Mesh mesh = mesh_of(soup);
  Numbers_of_answers numbers;

  for(const auto& pair : find_loops(mesh))
    for(const auto* loop : {&pair.handle(), &pair.tunnel()}) {
      numbers.loops.push_back(loop->length());
      for(const auto& step : loop->steps())
        numbers.loops.insert(numbers.loops.end(), {double(step.halfedge.idx()), step.ratio});
      for(const Point& p : loop->points())
        append(numbers.loops, p);
    }

  CGAL::Reeb_graph<Mesh> graph;
  CGAL::reeb_graph(mesh, graph);
  for(const auto v : CGAL::make_range(vertices(graph))) {
    numbers.reeb_graph.insert(numbers.reeb_graph.end(),
                              {double(graph[v].vertex.idx()), graph[v].value});
    append(numbers.reeb_graph, graph[v].point);
  }
  for(const auto e : CGAL::make_range(edges(graph))) {
    numbers.reeb_graph.insert(numbers.reeb_graph.end(),
                              {double(source(e, graph)), double(target(e, graph)), graph[e].length,
                               double(graph[e].vertices.size())});
    for(const Point& p : graph[e].polyline)
      append(numbers.reeb_graph, p);
  }
  return numbers;
}

#endif // HTL_TEST_NUMBERS_OF_ANSWERS_H
