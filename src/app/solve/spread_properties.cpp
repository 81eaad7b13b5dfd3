// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/spread_properties.h"

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace htloops {
namespace {

using Vertex = Mesh::Vertex_index;

// Of the neighbours that have a value.
double mean(const Mesh& mesh,
            const std::vector<double>& values,
            const std::vector<bool>& is_known,
            Vertex v) {
  double sum = 0., count = 0.;
  for(const Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    if(is_known[w.idx()]) {
      sum += values[w.idx()];
      count += 1.;
    }
  return sum / count;
}

bool has_known_neighbour(const Mesh& mesh, const std::vector<bool>& is_known, Vertex v) {
  for(const Vertex w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
    if(is_known[w.idx()])
      return true;
  return false;
}

// Those of the vertices in question that are beside known ones; the others stay.
std::vector<Vertex>
take_next(const Mesh& mesh, const std::vector<bool>& is_known, std::vector<Vertex>& unknown) {
  std::vector<Vertex> next, rest;
  for(const Vertex v : unknown)
    (has_known_neighbour(mesh, is_known, v) ? next : rest).push_back(v);
  unknown.swap(rest);
  return next;
}

} // namespace

void spread_properties(const Mesh& mesh, Vertex_properties& properties) {
  if(properties.empty())
    return;
  const std::size_t known = properties.front().values.size();
  const std::size_t count = mesh.number_of_vertices() + mesh.number_of_removed_vertices();
  std::vector<bool> is_known(count);
  std::vector<Vertex> unknown;
  for(const Vertex v : mesh.vertices())
    if(v.idx() < known)
      is_known[v.idx()] = true;
    else if(!mesh.is_isolated(v))
      unknown.push_back(v);
  for(Vertex_property& property : properties)
    property.values.resize(count);
  for(std::vector<Vertex> next; !(next = take_next(mesh, is_known, unknown)).empty();) {
    for(Vertex_property& property : properties)
      for(const Vertex v : next) {
        const double value = mean(mesh, property.values, is_known, v);
        property.values[v.idx()] = property.is_real() ? value : std::round(value);
      }
    for(const Vertex v : next)
      is_known[v.idx()] = true;
  }
}

} // namespace htloops
