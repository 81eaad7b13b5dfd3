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

#include <CGAL/Handle_tunnel_loops/Field_constants.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
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
