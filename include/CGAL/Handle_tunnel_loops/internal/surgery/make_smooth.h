// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MAKE_SMOOTH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MAKE_SMOOTH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/boost/graph/iterator.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#endif

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Moves some vertices of a `Surface_mesh` so that the surface there is as little curved as it can be
between the others: the sum of the squared Laplacians is least. Those of the others count, so that
the surface continues their directions, but not where it has a crease, at `is_crease(vertex)`, and
so none that could be continued. Edges have equal weights, which suit an even density.

\returns whether that was done: there is a solution, and Eigen to find it
*/
template <typename SurfaceMesh, typename IsCrease>
bool make_smooth(SurfaceMesh& mesh,
                 const std::vector<typename SurfaceMesh::Vertex_index>& free,
                 const IsCrease& is_crease) {
#ifdef CGAL_EIGEN3_ENABLED
  using Vertex = typename SurfaceMesh::Vertex_index;
  std::vector<int> row(mesh.number_of_vertices(), -1);
  for(std::size_t i = 0; i < free.size(); ++i)
    row[free[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(60 * free.size());
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(free.size(), 3);
  const auto add = [&](int i, Vertex v, double weight) {
    if(row[v] >= 0)
      entries.emplace_back(i, row[v], weight);
    else
      right.row(i) -=
          weight * Eigen::RowVector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  };
  const auto add_laplacian = [&](int i, Vertex v, double weight) {
    for(Vertex w : vertices_around_target(mesh.halfedge(v), mesh))
      add(i, w, weight);
    add(i, v, -weight * mesh.degree(v));
  };
  std::vector<signed char> crease(mesh.number_of_vertices(), -1); // -1: not asked yet
  const auto counts = [&](Vertex v) {
    if(row[v] < 0 && crease[v] < 0)
      crease[v] = is_crease(v) ? 1 : 0;
    return row[v] >= 0 || crease[v] == 0;
  };
  for(Vertex v : free) {
    for(Vertex w : vertices_around_target(mesh.halfedge(v), mesh))
      if(counts(w))
        add_laplacian(row[v], w, 1.);
    add_laplacian(row[v], v, -1. * mesh.degree(v));
  }
  Eigen::SparseMatrix<double> matrix(free.size(), free.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if(solver.info() != Eigen::Success)
    return false;
  const Eigen::MatrixX3d places = solver.solve(right);
  for(Vertex v : free)
    mesh.point(v) = {places(row[v], 0), places(row[v], 1), places(row[v], 2)};
  return true;
#else
  (void)mesh;
  (void)free;
  (void)is_crease;
  return false;
#endif
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_MAKE_SMOOTH_H
