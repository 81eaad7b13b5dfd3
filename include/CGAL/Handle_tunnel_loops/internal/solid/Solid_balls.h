// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SOLID_BALLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SOLID_BALLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/find_breadths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The solid inside a surface, filled with balls from places on the surface: what skeletons are
/// made of.
class Solid_balls
{
public:
  /// \p points are the places of the vertices, hubs included. Around \p loops, balls are close
  /// together. All must outlive it.
  Solid_balls(Execution execution,
              const Flat_mesh& mesh,
              Span<const Vector> points,
              const std::vector<const Crossing_loop*>& loops)
      : execution_(execution)
      , mesh_(mesh)
      , points_(points)
      , faces_(execution, mesh, points)
      , wall_(mesh, points, faces_)
      , area_(area_of(wall_))
      , pieces_(execution, mesh, wall_, spacing())
      , balls_(wall_, inward_sides())
      , paths_(pieces_along(loops))
      , samples_(execution, pieces_, balls_, least_extent(), paths_)
      , neighbors_(samples_.neighbors(execution)) {}

  const Flat_mesh& mesh() const { return mesh_; }
  Span<const Vector> points() const { return points_; }
  const Wall& wall() const { return wall_; }
  const Surface_pieces& pieces() const { return pieces_; }
  const Inner_balls& balls() const { return balls_; }
  const Surface_samples& samples() const { return samples_; }
  /// pairs of samples with regions that meet.
  const std::vector<std::pair<Index, Index>>& neighbors() const { return neighbors_; }

  Ball_graph graph() const {
    Ball_graph graph = graph_builder().build();
    find_breadths(samples_, neighbors_, graph);
    return graph;
  }

  /// joins balls of regions that meet in a graph of the balls, along the wall.
  void join_along_wall(Ball_graph& graph) const { graph_builder().join_along_wall(graph); }

  /// adds ways around the loops, along the wall, to a graph of the balls.
  void add_ways_along_wall(Ball_graph& graph) const {
    graph_builder().add_ways_along_wall(paths_, graph);
  }

  /// the length of pieces. Even faces are pieces, whole; those of needles are not many more. Faces
  /// without any area are not divided.
  double spacing() const {
    constexpr double most_times = 16.;
    const double pieces = number_by_faces(2000., 50000., 0.3);
    double length = 0.;
    for(Index f = 0; f < wall_.size(); ++f)
      if(!wall_.is_of_cap(f))
        length += wall_.length_opposite(f, wall_.apex(f));
    return area_ > 0. ? (std::max)(std::sqrt(area_ / pieces), length / (most_times * pieces))
                      : std::numeric_limits<double>::infinity();
  }

  /// how far a region of a sample extends at least.
  double least_extent() const { return std::sqrt(area_ / number_by_faces(1800., 60000., 0.45)); }

  double diagonal() const {
    Box<3> all = Box<3>::empty();
    for(const Vector& p : points_)
      all.extend({p, p});
    return norm(all.high - all.low);
  }

  /// the sample in whose region a vertex is; none on a surface that crosses itself, or if there are
  /// only faces without area around it.
  Index sample_at(Index vertex) const {
    for(Index u : mesh_.ring(vertex))
      if(const Index f = pieces_.face_left_of(vertex, u); !wall_.is_of_cap(f))
        return samples_.region(pieces_.piece_at(f, points_[vertex]));
    return no_index;
  }

private:
  static double area_of(const Wall& wall) {
    double sum = 0.;
    for(Index f = 0; f < wall.size(); ++f)
      if(!wall.is_of_cap(f))
        sum += 0.5 * norm(wall.normal(f));
    return sum;
  }

  // Few faces have little to say.
  double number_by_faces(double least, double most, double by_face) const {
    return (std::max)(least, (std::min)(most, by_face * static_cast<double>(wall_.size())));
  }

  // Where the bounded side of the components is.
  std::vector<int> inward_sides() const {
    std::vector<int> sides = signs_of_volumes(mesh_.seeds.size(), [this](const auto& add) {
      for(Index f = 0; f < wall_.size(); ++f)
        add(wall_.component(f), faces_.triangle(f));
    });
    for(int& side : sides)
      side = -side;
    return sides;
  }

  Vector place(const Crossing& c) const {
    const double ratio = ratio_on_surface(mesh_, c);
    return (1. - ratio) * points_[c.left] + ratio * points_[c.right];
  }

  std::vector<std::vector<Index>>
  pieces_along(const std::vector<const Crossing_loop*>& loops) const {
    std::vector<std::vector<Index>> paths;
    const double step = 0.25 * spacing();
    for(const Crossing_loop* loop : loops) {
      std::vector<Index> path;
      for(std::size_t i = 0; i < loop->size(); ++i) {
        const Crossing &a = (*loop)[i], &b = (*loop)[i + 1 < loop->size() ? i + 1 : 0];
        const Index f = pieces_.face_left_of(a.left, a.right);
        if(wall_.is_of_cap(f))
          continue;
        const Vector from = place(a), way = place(b) - from;
        const int n = 1 + static_cast<int>(norm(way) / step);
        for(int k = 0; k < n; ++k) {
          const Index piece = pieces_.piece_at(f, from + ((k + 0.5) / n) * way);
          if(path.empty() || path.back() != piece)
            path.push_back(piece);
        }
      }
      paths.push_back(std::move(path));
    }
    return paths;
  }

  Ball_graph_builder graph_builder() const {
    return {execution_, wall_, pieces_, balls_, samples_, neighbors_};
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  Span<const Vector> points_;
  Face_tree faces_;
  Wall wall_;
  double area_;
  Surface_pieces pieces_;
  Inner_balls balls_;
  std::vector<std::vector<Index>> paths_;
  Surface_samples samples_;
  std::vector<std::pair<Index, Index>> neighbors_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SOLID_BALLS_H
