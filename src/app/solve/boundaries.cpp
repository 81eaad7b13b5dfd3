// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/boundaries.h"

#include "solve/progress.h"

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/boundary_loops.h>

#include <algorithm>
#include <iterator>

namespace htloops {

const Loop* Boundaries::waist(std::size_t curve) const {
  const auto found =
      std::lower_bound(waists.begin(), waists.end(), curve,
                       [](const Loop& waist, std::size_t i) { return waist.pair_index() < i; });
  return found != waists.end() && found->pair_index() == curve ? &*found : nullptr;
}

Boundaries find_boundaries(const Mesh& mesh, bool do_find_waists) {
  Boundaries boundaries;
  CGAL::boundary_loops<All_threads_tag>(mesh, std::back_inserter(boundaries.curves));
  if(do_find_waists)
    CGAL::boundary_loops<All_threads_tag>(mesh, std::back_inserter(boundaries.waists),
                                          CGAL::parameters::basis_kind(Basis_kind::SHORTEST));
  return boundaries;
}

std::vector<std::size_t> components_of_vertices(const Mesh& mesh, std::size_t number) {
  std::vector<std::size_t> component(mesh.number_of_vertices(), 0);
  if(number <= 1)
    return component;
  CGAL::Handle_tunnel_loops::internal::Sets_of_indices sets(component.size());
  for(const Mesh::Edge_index e : mesh.edges())
    sets.unite(mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx());
  std::size_t next = 0;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const std::size_t smallest = sets.find(v.idx());
    if(smallest != v.idx())
      component[v.idx()] = component[smallest];
    else
      component[v.idx()] = mesh.is_isolated(v) ? number : next++;
  }
  return component;
}

std::vector<std::size_t> components_of_pairs(const Mesh& mesh, const Pairs& pairs) {
  const std::vector<std::size_t> of_vertices =
      components_of_vertices(mesh, mesh.number_of_vertices());
  std::vector<std::size_t> components;
  for(const Pair& pair : pairs)
    components.push_back(of_vertices[mesh.source(pair.handle().steps().front().halfedge).idx()]);
  return components;
}

} // namespace htloops
