// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/boundaries.h"

#include "solve/same_class.h"

#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boundary_loops.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>

namespace htloops {

Boundaries find_boundaries(const Mesh& mesh, bool do_find_waists) {
  using Tag = CGAL::Parallel_if_available_tag;
  const auto kind = CGAL::Handle_tunnel_loops::Basis_kind::SHORTEST;
  Boundaries boundaries;
  CGAL::boundary_loops<Tag>(mesh, std::back_inserter(boundaries.curves));
  if(do_find_waists)
    CGAL::boundary_loops<Tag>(mesh, std::back_inserter(boundaries.waists),
                              CGAL::parameters::basis_kind(kind));
  return boundaries;
}

namespace {

using Corners = std::vector<std::uint32_t>;

// The vertices of a curve along edges, from the smallest one on, in the direction of its smaller
// neighbor; none if the curve is not along edges.
Corners corners_of(const Mesh& mesh, const Loop& curve) {
  Corners corners;
  for(const Loop::Step& step : curve.steps()) {
    if(!step.is_vertex())
      return {};
    const auto v = step.ratio == 0. ? mesh.source(step.halfedge) : mesh.target(step.halfedge);
    corners.push_back(v.idx());
  }
  if(corners.empty())
    return {};
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if(corners.size() > 2 && corners.back() < corners[1])
    std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

bool is_closed_on(const Mesh& mesh, const Loop& loop) {
  namespace internal = CGAL::Handle_tunnel_loops::internal;
  internal::Loop_certifier certifier(mesh, get(boost::vertex_index, mesh),
                                     get(boost::face_index, mesh));
  certifier.set_loops(internal::Execution(), std::vector<const Loop*>{&loop});
  return certifier.are_closed_on_surface();
}

std::vector<std::string> problems_of_waists(const Mesh& mesh,
                                            const std::vector<Loop>& curves,
                                            const std::vector<Loop>& waists) {
  std::vector<std::string> problems;
  std::vector<std::pair<const Loop*, const Loop*>> pairs;
  const auto name = [](const Loop& waist) {
    return "boundary " + std::to_string(waist.pair_index()) + ": its waist ";
  };
  for(const Loop& waist : waists)
    if(is_closed_on(mesh, waist))
      pairs.emplace_back(&curves[waist.pair_index()], &waist);
    else
      problems.push_back(name(waist) + "is no closed curve on the surface");
  for(const std::size_t i : pairs_of_different_class(mesh, pairs))
    problems.push_back(name(*pairs[i].second) + "is not homologous to the curve");
  return problems;
}

} // namespace

std::vector<std::string> problems_of_boundaries(const Mesh& mesh,
                                                const std::vector<Loop>& curves,
                                                const std::vector<Loop>& waists) {
  std::vector<std::string> problems;
  std::map<Corners, std::size_t> times;
  const Boundaries expected = find_boundaries(mesh, false);
  for(const Loop& curve : expected.curves)
    times.emplace(corners_of(mesh, curve), 0);
  for(std::size_t i = 0; i < curves.size(); ++i) {
    const auto found = times.find(corners_of(mesh, curves[i]));
    if(found == times.end())
      problems.push_back("boundary " + std::to_string(i) + " is no boundary curve of the mesh");
    else if(found->second++ > 0)
      problems.push_back("boundary " + std::to_string(i) + " is there twice");
  }
  if(curves.size() < expected.curves.size())
    problems.push_back("it has " + std::to_string(curves.size()) + " of the " +
                       std::to_string(expected.curves.size()) + " boundary curves");
  return problems.empty() ? problems_of_waists(mesh, curves, waists) : problems;
}

std::vector<std::size_t> components_of_vertices(const Mesh& mesh, std::size_t number_of_them) {
  if(number_of_them <= 1)
    return std::vector<std::size_t>(mesh.number_of_vertices(), 0);
  std::vector<std::size_t> of_face(mesh.number_of_faces());
  const std::size_t bound = CGAL::Polygon_mesh_processing::connected_components(
      mesh, boost::make_iterator_property_map(of_face.begin(), get(CGAL::face_index, mesh)));
  std::vector<std::size_t> number(bound, bound), of_vertex(mesh.number_of_vertices(), bound);
  std::size_t next = 0;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    if(mesh.is_isolated(v))
      continue;
    for(const Mesh::Face_index f : CGAL::faces_around_target(mesh.halfedge(v), mesh)) {
      if(f == Mesh::null_face())
        continue;
      std::size_t& c = number[of_face[f.idx()]];
      if(c == bound)
        c = next++;
      of_vertex[v.idx()] = c;
      break;
    }
  }
  return of_vertex;
}

} // namespace htloops
