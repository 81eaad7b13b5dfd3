#ifndef HTL_TEST_SMALL_ANSWER_H
#define HTL_TEST_SMALL_ANSWER_H

#include "app/solve/answer.h"

#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

// A tetrahedron and two pairs of closed lines on it, for tests of what is done with an answer. They
// are no handles and tunnels, as a tetrahedron has none.
inline htloops::Mesh small_mesh() {
  using Triangle = std::array<std::uint32_t, 3>;
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          std::vector<Triangle>{{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
}

// The line around a face that crosses its edges at `ratio`.
inline htloops::Loop small_loop(const htloops::Mesh& mesh,
                                std::uint32_t face,
                                double ratio,
                                CGAL::Loop_type type,
                                std::size_t pair) {
  using namespace htloops;
  using htloops::Mesh;
  std::vector<Loop::Step> steps;
  std::vector<Point> points;
  for(const Mesh::Halfedge_index h :
      CGAL::halfedges_around_face(mesh.halfedge(Mesh::Face_index(face)), mesh))
  {
    steps.push_back({h, ratio});
    const Point& p = mesh.point(mesh.source(h));
    points.push_back(p + ratio * (mesh.point(mesh.target(h)) - p));
  }
  double length = 0.;
  for(std::size_t i = 0; i < 3; ++i)
    length += std::sqrt(CGAL::squared_distance(points[i], points[(i + 1) % 3]));
  return Loop(steps, points, length, type, pair);
}

inline htloops::Answer small_answer(const htloops::Mesh& mesh) {
  using CGAL::Loop_type;
  htloops::Answer answer;
  for(std::uint32_t i = 0; i < 2; ++i)
    answer.pairs.emplace_back(small_loop(mesh, i, 1. / 3., Loop_type::HANDLE, i),
                              small_loop(mesh, i + 1, 1., Loop_type::TUNNEL, i));
  answer.statistics.number_of_components = 1;
  answer.statistics.genus = 2;
  answer.certificate.closed_on_surface = answer.certificate.basis = true;
  answer.statistics.seconds[1] = 0.25;
  answer.backend = "host";
  answer.number_of_threads = 3;
  answer.total_seconds = 0.5;
  return answer;
}

#endif // HTL_TEST_SMALL_ANSWER_H
