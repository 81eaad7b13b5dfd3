// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/cut_solver.h"

#include "solve/boundaries.h"

#include <CGAL/Handle_tunnel_loops_solver.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/cut_to_disk.h>
#include <CGAL/dual_cuts.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <iterator>
#include <limits>

namespace htloops {
namespace {

// V - E + F = 2 c - 2 g - b.
std::size_t genus_of(const Mesh& mesh) {
  std::vector<std::size_t> component(mesh.number_of_faces());
  const std::size_t components = CGAL::Polygon_mesh_processing::connected_components(
      mesh, boost::make_iterator_property_map(component.begin(), get(CGAL::face_index, mesh)));
  std::size_t vertices = 0;
  for(const Mesh::Vertex_index v : mesh.vertices())
    vertices += !mesh.is_isolated(v);
  std::vector<Mesh::Halfedge_index> boundaries; // a halfedge of each
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(boundaries));
  return (2 * components + mesh.number_of_edges() - mesh.number_of_faces() - vertices -
          boundaries.size()) /
         2;
}

double length_of(const Mesh& mesh, Mesh::Edge_index e) {
  return std::sqrt(
      CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
}

// The loops of the pairs, and of each component all boundary curves but the last: as
// `CGAL::dual_cuts()` has them.
std::vector<Loop> basis_of(const Mesh& mesh,
                           const Pairs& pairs,
                           const std::vector<Loop>& curves,
                           std::size_t number_of_components) {
  std::vector<Loop> basis;
  for_each_loop(pairs, [&](const Loop& loop, Loop_type, std::size_t) { basis.push_back(loop); });
  const std::vector<std::size_t> components = components_of_vertices(mesh, number_of_components);
  const auto component = [&](const Loop& curve) {
    return components[mesh.source(curve.steps().front().halfedge).idx()];
  };
  std::vector<std::size_t> last(mesh.number_of_vertices() + 1);
  for(const Loop& curve : curves)
    last[component(curve)] = curve.pair_index();
  for(const Loop& curve : curves)
    if(last[component(curve)] != curve.pair_index())
      basis.push_back(curve);
  return basis;
}

std::vector<Mesh::Edge_index> edges_of_cut(const Mesh& mesh,
                                           const Cut_options& options,
                                           const std::vector<char>& is_cone,
                                           Progress& progress) {
  namespace parameters = CGAL::parameters;
  std::vector<Mesh::Edge_index> edges;
  const auto cones =
      boost::make_iterator_property_map(is_cone.begin(), get(CGAL::vertex_index, mesh));
  const auto np = parameters::do_cut_spheres(
      options.do_cut_spheres,
      parameters::callback(progress.callback()).vertex_is_constrained_map(cones));
  if(options.avoided.empty()) {
    CGAL::cut_to_disk<All_threads_tag>(mesh, std::back_inserter(edges), np);
    return edges;
  }
  const auto weight = [&](Mesh::Edge_index e) {
    return options.avoided[e.idx()] ? (std::numeric_limits<double>::infinity)()
                                    : length_of(mesh, e);
  };
  CGAL::cut_to_disk<All_threads_tag>(
      mesh, std::back_inserter(edges),
      parameters::edge_weight_map(boost::make_function_property_map<Mesh::Edge_index>(weight), np));
  return edges;
}

// A sphere that is cut along a single edge is no disk of triangles: a third vertex makes it one,
// which is a neighbor of an end. Whether there are such.
bool add_cones_at_lone_edges(const Mesh& mesh,
                             const Cut_options& options,
                             const std::vector<Mesh::Edge_index>& cut,
                             std::vector<char>& is_cone) {
  std::vector<std::size_t> degree(mesh.number_of_vertices(), 0);
  for(const Mesh::Edge_index e : cut)
    for(const int i : {0, 1})
      ++degree[mesh.vertex(e, i).idx()];
  const auto is_on_border = [&](Mesh::Vertex_index v) { return mesh.is_border(mesh.halfedge(v)); };
  bool has_any = false;
  for(const Mesh::Edge_index e : cut) {
    const Mesh::Vertex_index u = mesh.vertex(e, 0), v = mesh.vertex(e, 1);
    if(degree[u.idx()] != 1 || degree[v.idx()] != 1 || is_on_border(u) || is_on_border(v))
      continue;
    has_any = true;
    is_cone[u.idx()] = is_cone[v.idx()] = 1;
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
      const bool is_avoided = !options.avoided.empty() && options.avoided[mesh.edge(h).idx()] != 0;
      if(!is_avoided && mesh.source(h) != u) {
        is_cone[mesh.source(h).idx()] = 1;
        break;
      }
    }
  }
  return has_any;
}

} // namespace

Cut_answer find_cut(const Mesh& mesh, const Cut_options& options, Progress& progress) {
  const Thread_limit limit(options.number_of_threads);
  progress.start("cut");
  Cut_answer answer;
  std::vector<char> is_cone(mesh.number_of_vertices(), 0);
  for(const Mesh::Vertex_index v : options.cones)
    is_cone[v.idx()] = 1;
  answer.edges = edges_of_cut(mesh, options, is_cone, progress);
  if(options.do_cut_spheres && add_cones_at_lone_edges(mesh, options, answer.edges, is_cone))
    answer.edges = edges_of_cut(mesh, options, is_cone, progress);
  progress.end();
  answer.genus = genus_of(mesh);
  for(const Mesh::Edge_index e : answer.edges)
    answer.length += length_of(mesh, e);
  answer.boundary_length = 2. * answer.length;
  for(const Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e))
      answer.boundary_length += length_of(mesh, e);
  return answer;
}

Dual_cuts find_dual_cuts(const Mesh& mesh, int number_of_threads, Progress& progress) {
  const Thread_limit limit(number_of_threads);
  progress.start("dual cuts");
  Dual_cuts result;
  Pairs pairs;
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(All_threads_tag(), mesh,
                                                CGAL::parameters::default_values());
  solver.find_loops<All_threads_tag>(std::back_inserter(pairs),
                                     CGAL::parameters::callback(progress.callback()));
  result.statistics = solver.statistics();
  std::vector<std::vector<std::pair<Mesh::Halfedge_index, std::int64_t>>> cuts;
  CGAL::dual_cuts<All_threads_tag>(mesh, pairs, std::back_inserter(cuts));
  result.boundaries = find_boundaries(mesh, false).curves;
  const std::vector<Loop> basis =
      basis_of(mesh, pairs, result.boundaries, solver.number_of_components());
  for(std::size_t i = 0; i < cuts.size(); ++i)
    result.cuts.push_back({basis[i], std::move(cuts[i])});
  progress.end();
  return result;
}

double length_of(const Mesh& mesh, const Dual_cuts& duals) {
  double length = 0.;
  for(const Dual_cut& cut : duals.cuts)
    for(const auto& [h, times] : cut.edges)
      length += static_cast<double>(times) * length_of(mesh, mesh.edge(h));
  return length;
}

} // namespace htloops
