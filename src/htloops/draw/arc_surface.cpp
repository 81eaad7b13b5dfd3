// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/arc_surface.h"

#include "draw/level_cutter.h"
#include "solve/face_arcs.h"

#include <cstddef>
#include <utility>

namespace htloops {
namespace {

class Surface_cutter
{
  using Vertex = Mesh::Vertex_index;
  using Corners = Level_cutter::Corners;
  using Polygon = Level_cutter::Polygon;

public:
  Surface_cutter(const Mesh& mesh, const Reeb_answer& answer)
      : mesh_(mesh)
      , answer_(answer)
      , arcs_(mesh, answer)
      , cutter_(mesh, answer.values) {}

  Arc_surface cut() {
    for(const Mesh::Face_index f : mesh_.faces())
      add_face(f);
    result_.points = cutter_.take_points();
    return std::move(result_);
  }

private:
  void add_face(Mesh::Face_index f) {
    const Corners corners = arcs_.vertices_of(f);
    const bool is_turned = !cutter_.has_orientation(f, corners);
    if(arcs_.is_of_one_arc(corners))
      add_polygon(whole(corners), answer_.vertex_arc[corners[0].idx()], is_turned);
    else
      add_divided_face(f, corners, is_turned);
  }

  void add_divided_face(Mesh::Face_index f, const Corners& corners, bool is_turned) {
    const std::vector<Face_part> parts = arcs_.parts_of(corners);
    if(parts != arcs_.parts_of(corners[0], corners[2]))
      add_fan(f);
    else if(parts.front().low < parts.back().high)
      for(const Face_part& part : parts)
        add_polygon(cutter_.polygon(corners, part.low, part.high), part.arc, is_turned);
    else // all of it is at one level
      add_polygon(whole(corners), parts.front().arc, is_turned);
  }

  // Where the three sides of a face do not tell the same, each has a third of it.
  void add_fan(Mesh::Face_index f) {
    const Mesh::Halfedge_index h = mesh_.halfedge(f);
    const Point& p = mesh_.point(mesh_.source(h));
    const auto to = [&](Mesh::Vertex_index v) { return mesh_.point(v) - p; };
    const std::uint32_t middle =
        cutter_.add_point(p + (to(mesh_.target(h)) + to(mesh_.target(mesh_.next(h)))) / 3.);
    for(const Mesh::Halfedge_index side : mesh_.halfedges_around_face(h))
      add_side(side, middle);
  }

  void add_side(Mesh::Halfedge_index side, std::uint32_t middle) {
    Vertex low = mesh_.source(side), high = mesh_.target(side);
    const bool is_turned = std::make_pair(value(high), high) < std::make_pair(value(low), low);
    if(is_turned)
      std::swap(low, high);
    const std::vector<Face_part> parts = arcs_.parts_of(low, high);
    std::uint32_t from = low.idx();
    for(const Face_part& part : parts) {
      const bool is_last = part.high == value(high);
      if(!is_last && !(part.low < part.high))
        continue;
      const std::uint32_t to =
          is_last ? std::uint32_t(high.idx()) : cutter_.point_at(low, high, part.high);
      add_polygon({from, to, middle}, part.arc, is_turned);
      from = to;
      if(is_last)
        break;
    }
  }

  static Polygon whole(const Corners& corners) {
    return {corners[0].idx(), corners[1].idx(), corners[2].idx()};
  }

  double value(Vertex v) const { return answer_.values[v.idx()]; }

  void add_polygon(const Polygon& polygon, std::size_t arc, bool is_turned) {
    for_each_triangle(polygon, is_turned, [&](const std::array<std::uint32_t, 3>& triangle) {
      result_.triangles.push_back(triangle);
      result_.triangle_arcs.push_back(static_cast<std::uint32_t>(arc));
    });
  }

  const Mesh& mesh_;
  const Reeb_answer& answer_;
  Face_arcs arcs_;
  Level_cutter cutter_;
  Arc_surface result_;
};

} // namespace

Arc_surface arc_surface(const Mesh& mesh, const Reeb_answer& answer) {
  return Surface_cutter(mesh, answer).cut();
}

Drawn_surface drawn_surface(const Arc_surface& surface) {
  Drawn_surface drawn{surface.points, surface.triangles, {}};
  drawn.colours.reserve(drawn.triangles.size());
  for(const std::uint32_t arc : surface.triangle_arcs)
    drawn.colours.push_back(colour_of_arc(arc));
  return drawn;
}

} // namespace htloops
