// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_TEST_MESH_CHANGES_H
#define HTL_TEST_MESH_CHANGES_H

#include "mean_edge_length.h"

#include "generators/Random.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

/// \file Mesh_changes.h
/// The same surface with noise, with fewer faces, and with others. The genus stays what it is.
/// Meshes are of the type `CGAL::Surface_mesh`, with a kernel that has exact predicates.

namespace mesh_changes {

namespace PMP = CGAL::Polygon_mesh_processing;

/// a normally distributed number, by the method of Box and Muller.
inline double normal_number(CGAL::Handle_tunnel_loops::generators::Random& random) {
  const double radius = std::sqrt(-2. * std::log(1. - random.uniform(0., 1.)));
  return radius * std::cos(2. * CGAL_PI * random.uniform(0., 1.));
}

/// the mesh with each vertex moved along its normal by a normally distributed number of mean edge
/// lengths, whose standard deviation is given.
template <typename Mesh> Mesh with_noise(Mesh mesh, double deviation, unsigned seed) {
  CGAL::Handle_tunnel_loops::generators::Random random(seed);
  const double unit = deviation * mean_edge_length(mesh);
  std::vector<typename Mesh::Point> points;
  for(const auto v : mesh.vertices())
    points.push_back(mesh.point(v) +
                     unit * normal_number(random) * PMP::compute_vertex_normal(v, mesh));
  auto point = points.begin();
  for(const auto v : mesh.vertices())
    mesh.point(v) = *point++;
  return mesh;
}

/// the mesh with its edges collapsed until no more than a part of them are left, or none can be.
template <typename Mesh> Mesh decimated(Mesh mesh, double part) {
  // Not one of CGAL's, which have other names in later releases.
  const auto stop = [part](const auto&, const auto&, std::size_t edges, std::size_t left) {
    return static_cast<double>(left) < part * static_cast<double>(edges);
  };
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
  return mesh;
}

/// the mesh with edges of a length, in mean edge lengths.
template <typename Mesh> Mesh remeshed(Mesh mesh, double length) {
  PMP::isotropic_remeshing(mesh.faces(), length * mean_edge_length(mesh), mesh,
                           CGAL::parameters::number_of_iterations(3));
  mesh.collect_garbage();
  return mesh;
}

/// the mesh with long edges, and short ones on one side of its middle, with a sudden change.
template <typename Mesh> Mesh graded(const Mesh& mesh, double long_edges, double short_edges) {
  const double length = short_edges * mean_edge_length(mesh);
  Mesh changed = remeshed(mesh, long_edges);
  double middle = 0.;
  for(const auto v : changed.vertices())
    middle += changed.point(v).x() / static_cast<double>(changed.number_of_vertices());
  std::vector<typename Mesh::Face_index> faces;
  for(const auto f : changed.faces())
    if(changed.point(changed.target(changed.halfedge(f))).x() > middle)
      faces.push_back(f);
  PMP::isotropic_remeshing(faces, length, changed, CGAL::parameters::number_of_iterations(3));
  changed.collect_garbage();
  return changed;
}

/// the mesh with triangles that are longer along an axis, by a factor: made of the mesh pressed
/// together.
template <typename Mesh> Mesh stretched(Mesh mesh, double factor) {
  const auto scale = [&mesh](double by) {
    for(const auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      mesh.point(v) = {p.x() * by, p.y(), p.z()};
    }
  };
  scale(1. / factor);
  mesh = remeshed(std::move(mesh), 1.);
  scale(factor);
  return mesh;
}

} // namespace mesh_changes

#endif // HTL_TEST_MESH_CHANGES_H
