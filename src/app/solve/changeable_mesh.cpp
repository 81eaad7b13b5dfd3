// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/changeable_mesh.h"

#include <array>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

using Halfedge = Changeable_mesh::Halfedge_index;
using Exact_point = Changeable_mesh::Point;

Exact_point exact(const Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<Exact_point> exact(const std::vector<Point>& points) {
  std::vector<Exact_point> result;
  for(const Point& p : points)
    result.push_back(exact(p));
  return result;
}

CGAL::Loop_on_surface<Changeable_mesh> loop_on(const std::vector<Halfedge>& halfedges,
                                               const Loop& loop) {
  std::vector<CGAL::Loop_on_surface<Changeable_mesh>::Step> steps;
  for(const Loop::Step& step : loop.steps())
    steps.push_back({halfedges[step.halfedge.idx()], step.ratio});
  return {std::move(steps), exact(loop.points()), loop.length(), loop.type(), loop.pair_index()};
}

std::int64_t origin_of(std::size_t number, std::size_t number_before) {
  return number < number_before ? static_cast<std::int64_t>(number) : nothing_before;
}

} // namespace

Changeable_copy::Changeable_copy(const Mesh& original)
    : halfedges(original.number_of_halfedges()) {
  using Vertex = Changeable_mesh::Vertex_index;
  using Face = Changeable_mesh::Face_index;
  using Size = Changeable_mesh::size_type;

  mesh.set_recycle_garbage(false);
  mesh.reserve(static_cast<Size>(original.number_of_vertices()),
               static_cast<Size>(original.number_of_edges()),
               static_cast<Size>(original.number_of_faces()));
  for(const Point& point : original.points())
    mesh.add_vertex(exact(point));
  for(const Mesh::Edge_index e : original.edges()) {
    const Halfedge h = mesh.add_edge();
    halfedges[original.halfedge(e).idx()] = h;
    halfedges[original.opposite(original.halfedge(e)).idx()] = mesh.opposite(h);
  }
  for(const Mesh::Face_index f : original.faces())
    mesh.set_halfedge(mesh.add_face(), halfedges[original.halfedge(f).idx()]);
  for(const Mesh::Halfedge_index g : original.halfedges()) {
    const Halfedge h = halfedges[g.idx()];
    mesh.set_target(h, Vertex(original.target(g).idx()));
    mesh.set_next(h, halfedges[original.next(g).idx()]);
    if(!original.is_border(g))
      mesh.set_face(h, Face(original.face(g).idx()));
  }
  for(const Mesh::Vertex_index v : original.vertices())
    if(!original.is_isolated(v))
      mesh.set_halfedge(Vertex(v.idx()), halfedges[original.halfedge(v).idx()]);
}

Changeable_pairs Changeable_copy::pairs(const Pairs& pairs) const {
  Changeable_pairs result;
  for(const Pair& pair : pairs)
    result.emplace_back(loop_on(halfedges, pair.handle()), loop_on(halfedges, pair.tunnel()));
  return result;
}

Changed_mesh
changed_mesh(const Changeable_mesh& copy, const Mesh& original, const Face_parents& parents) {
  Changed_mesh changed;
  std::vector<Point> points;
  std::vector<std::uint32_t> number(copy.number_of_vertices() + copy.number_of_removed_vertices());
  for(const Changeable_mesh::Vertex_index v : copy.vertices()) {
    const Exact_point& p = copy.point(v);
    number[v.idx()] = static_cast<std::uint32_t>(points.size());
    points.emplace_back(p.x(), p.y(), p.z());
    changed.vertex_origins.push_back(origin_of(v.idx(), original.number_of_vertices()));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for(const Changeable_mesh::Face_index f : copy.faces()) {
    const Halfedge h = copy.halfedge(f);
    triangles.push_back({number[copy.source(h).idx()], number[copy.target(h).idx()],
                         number[copy.target(copy.next(h)).idx()]});
    changed.face_origins.push_back(origin_of(f.idx(), original.number_of_faces()));
    const auto parent = parents.find(f);
    changed.face_parents.push_back(parent == parents.end() ? changed.face_origins.back()
                                                           : std::int64_t(parent->second.idx()));
    changed.faces.push_back(f.idx());
  }
  changed.mesh = Mesh(std::move(points), triangles);
  return changed;
}

Changed_mesh unchanged_mesh(const Mesh& mesh) {
  Changed_mesh same{mesh, Origins(mesh.number_of_vertices()), Origins(mesh.number_of_faces()), {}};
  std::iota(same.vertex_origins.begin(), same.vertex_origins.end(), std::int64_t(0));
  std::iota(same.face_origins.begin(), same.face_origins.end(), std::int64_t(0));
  same.face_parents = same.face_origins;
  return same;
}

Changed_mesh composed(const Changed_mesh& first, Changed_mesh second) {
  const auto trace = [](const Origins& before, Origins& origins) {
    for(std::int64_t& origin : origins)
      if(origin != nothing_before)
        origin = before[static_cast<std::size_t>(origin)];
  };
  trace(first.vertex_origins, second.vertex_origins);
  trace(first.face_origins, second.face_origins);
  trace(first.face_parents, second.face_parents);
  return second;
}

} // namespace htloops
