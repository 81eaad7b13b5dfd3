// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SOLID_BALLS_TMP_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SOLID_BALLS_TMP_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_builder.h>

namespace CGAL::Handle_tunnel_loops::internal {

class Solid_balls_tmp
{
public:
  Solid_balls_tmp(Execution execution, const Flat_mesh& mesh, const std::vector<Vector>& places)
      : mesh_(mesh)
      , exponent_(exponent_of_largest(places))
      , points_(scaled_places(places, exponent_))
      , faces_(execution, mesh, points_)
      , wall_(mesh, points_, faces_)
      , area_(area())
      , pieces_(execution, mesh, wall_, spacing())
      , balls_(wall_, inward_sides())
      , samples_(execution, pieces_, balls_, least_extent(), {})
      , neighbors_(samples_.neighbors(execution))
      , graph_(Ball_graph_builder(execution, wall_, pieces_, balls_, samples_, neighbors_).build()) {
  }

  const Flat_mesh& mesh() const { return mesh_; }
  int exponent() const { return exponent_; }
  const std::vector<Vector>& points() const { return points_; }
  const Wall& wall() const { return wall_; }
  const Surface_pieces& pieces() const { return pieces_; }
  const Inner_balls& balls() const { return balls_; }
  const Surface_samples& samples() const { return samples_; }
  const Ball_graph& graph() const { return graph_; }
  double least_extent() const { return std::sqrt(area_ / 60000.); }

private:
  double area() const {
    double sum = 0.;
    for(Index f = 0; f < wall_.size(); ++f)
      if(!wall_.is_of_cap(f))
        sum += 0.5 * norm(wall_.normal(f));
    return sum;
  }
  double spacing() const {
    return area_ > 0. ? std::sqrt(area_ / 50000.) : std::numeric_limits<double>::infinity();
  }
  std::vector<int> inward_sides() const {
    std::vector<int> sides = signs_of_volumes(mesh_.seeds.size(), [this](const auto& add) {
      for(Index f = 0; f < wall_.size(); ++f)
        add(wall_.component(f), faces_.triangle(f));
    });
    for(int& side : sides)
      side = -side;
    return sides;
  }

  const Flat_mesh& mesh_;
  int exponent_;
  std::vector<Vector> points_;
  Face_tree faces_;
  Wall wall_;
  double area_;
  Surface_pieces pieces_;
  Inner_balls balls_;
  Surface_samples samples_;
  std::vector<std::pair<Index, Index>> neighbors_;
  Ball_graph graph_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SOLID_BALLS_TMP_H
