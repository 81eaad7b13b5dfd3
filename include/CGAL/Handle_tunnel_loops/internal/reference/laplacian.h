// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_LAPLACIAN_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_LAPLACIAN_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/// The Laplacian in local edge lengths: four times (mean of the neighbors - value). Its weights are
/// positive and sum up to the same in each row, so that the front moves at the same number of edges
/// per step everywhere; neither holds of the weights of linear elements. Neighbors behind walls do
/// not count.
inline Eigen::SparseMatrix<double, Eigen::RowMajor>
laplacian(const Flat_mesh& mesh, const Barred_edges& walls = Barred_edges()) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.neighbor.size() + mesh.number_of_vertices());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const std::size_t first = entries.size();
    const Ring ring = mesh.ring(v);
    for(Index i = 0; i < ring.size(); ++i)
      if(walls.empty() || !walls[mesh.row_begin[v] + i])
        entries.emplace_back(static_cast<int>(v), static_cast<int>(ring[i]), 4.);
    const double number = static_cast<double>(entries.size() - first);
    for(std::size_t j = first; j < entries.size(); ++j)
      entries[j] = {entries[j].row(), entries[j].col(), 4. / number};
    if(number > 0.)
      entries.emplace_back(static_cast<int>(v), static_cast<int>(v), -4.);
  }
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The Laplacian of linear finite elements, with a mass for each vertex (paper, section 3). Lengths
/// are in mean edge lengths, so that it is the other one on equilateral triangles. Edges with walls
/// have no weight.
inline Eigen::SparseMatrix<double, Eigen::RowMajor>
finite_element_laplacian(const Flat_mesh& mesh, const Barred_edges& walls = Barred_edges()) {
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  std::vector<double> area(mesh.number_of_vertices(), 0.);
  std::vector<Eigen::Triplet<double>> weights;
  double length = 0.;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    for(Index i = 0; i < ring.size(); ++i) { // the triangle (v, a, b), for its edge from a to b
      const Index a = ring[i], b = ring[ring.next(i)];
      const Vector p = mesh.points[a] - mesh.points[v], q = mesh.points[b] - mesh.points[v];
      const double twice_area = norm(cross(p, q));
      area[v] += twice_area / 6.;
      length += norm(p);
      if(!(twice_area > 0.) || (!walls.empty() && walls[slot(mesh, a, b)]))
        continue;
      const double weight = dot(p, q) / twice_area / 2.;
      for(const auto& [u, w] : {std::pair(a, b), std::pair(b, a)}) {
        weights.emplace_back(static_cast<int>(u), static_cast<int>(w), weight);
        weights.emplace_back(static_cast<int>(u), static_cast<int>(u), -weight);
      }
    }
  }
  length /= static_cast<double>(mesh.neighbor.size());
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(n, n);
  matrix.setFromTriplets(weights.begin(), weights.end());
  Eigen::VectorXd scale(n);
  for(Eigen::Index v = 0; v < n; ++v)
    scale[v] = area[v] > 0. ? length * length / area[v] : 0.;
  return scale.asDiagonal() * matrix;
}

/// the one that is asked for.
inline Eigen::SparseMatrix<double, Eigen::RowMajor>
laplacian(const Flat_mesh& mesh, const Literal_rules& rules, const Barred_edges& walls = {}) {
  return rules.finite_elements ? finite_element_laplacian(mesh, walls) : laplacian(mesh, walls);
}

inline void check_rules(const Literal_rules& rules) {
  const auto is_threshold = [](double value) { return value >= 0. && value < 1.; };
  if(!(rules.mean_edge_length > 0.) || !std::isfinite(rules.mean_edge_length) ||
     !is_threshold(rules.band_threshold) || !is_threshold(rules.contact_threshold) ||
     !(rules.offset > 0.) || !std::isfinite(rules.offset))
    throw std::invalid_argument("lengths of literal rules are positive, thresholds in [0, 1)");
}

/// the constants of the fields.
inline Field_constants literal_constants(Field_constants constants, const Literal_rules& rules) {
  if(!rules.gradient_coefficient)
    return constants;
  const double factor =
      constants.gradient_coefficient / (rules.mean_edge_length * rules.mean_edge_length);
  constants.gradient_coefficient *= factor;
  constants.step = (std::min)(constants.step * factor, 1.); // the time step stays if it is stable
  return constants;
}

/// the time step: the given fraction of the largest one for which no neighbor's weight, nor that of
/// the value itself, becomes negative.
inline double time_step(const Field_constants& c) {
  return c.step / (0.5 * c.mobility * 4. * c.gradient_coefficient);
}

/// A number of steps in which a front that moves at all has passed many edges (its speed is that of
/// `Field_constants`); if it has not reached a vertex in so many, it is at rest.
inline std::size_t patience(const Field_constants& c) {
  const double speed = c.mobility * c.driving_force * std::sqrt(c.gradient_coefficient) /
                       (2. * std::sqrt(2. * c.penalty));
  return static_cast<std::size_t>(20. / (speed * time_step(c))) + 20;
}

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_LAPLACIAN_H
