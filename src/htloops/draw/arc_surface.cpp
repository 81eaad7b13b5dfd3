// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/arc_surface.h"

#include "solve/face_arcs.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

namespace htloops {
namespace {

class Surface_cutter
{
  using Vertex = Mesh::Vertex_index;
  using Corners = std::array<Vertex, 3>;
  using Polygon = std::vector<std::uint32_t>;

public:
  Surface_cutter(const Mesh& mesh, const Reeb_answer& answer)
      : mesh_(mesh)
      , answer_(answer)
      , arcs_(mesh, answer) {}

  Arc_surface cut() {
    result_.points = points_of(mesh_);
    for(const Mesh::Face_index f : mesh_.faces())
      add_face(f);
    return std::move(result_);
  }

private:
  void add_face(Mesh::Face_index f) {
    const Corners corners = arcs_.vertices_of(f);
    const bool is_turned = !has_orientation(f, corners);
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
        add_polygon(polygon(corners, part), part.arc, is_turned);
    else // all of it is at one level
      add_polygon(whole(corners), parts.front().arc, is_turned);
  }

  // Where the three sides of a face do not tell the same, each has a third of it.
  void add_fan(Mesh::Face_index f) {
    const Mesh::Halfedge_index h = mesh_.halfedge(f);
    const auto middle = static_cast<std::uint32_t>(result_.points.size());
    const Point& p = mesh_.point(mesh_.source(h));
    const auto to = [&](Mesh::Vertex_index v) { return mesh_.point(v) - p; };
    result_.points.push_back(
        coordinates(p + (to(mesh_.target(h)) + to(mesh_.target(mesh_.next(h)))) / 3.));
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
      const std::uint32_t to = is_last ? std::uint32_t(high.idx()) : point_at(low, high, part.high);
      add_polygon({from, to, middle}, part.arc, is_turned);
      from = to;
      if(is_last)
        break;
    }
  }

  // Whether the corners follow each other as around the face.
  bool has_orientation(Mesh::Face_index f, const Corners& corners) const {
    Mesh::Halfedge_index h = mesh_.halfedge(f);
    while(mesh_.source(h) != corners[0])
      h = mesh_.next(h);
    return mesh_.target(h) == corners[1];
  }

  static Polygon whole(const Corners& corners) {
    return {corners[0].idx(), corners[1].idx(), corners[2].idx()};
  }

  double value(Vertex v) const { return answer_.values[v.idx()]; }

  // Around what of a face lies between two levels.
  Polygon polygon(const Corners& corners, const Face_part& part) {
    Polygon polygon;
    const auto add = [&](std::uint32_t p) {
      if(polygon.empty() || (polygon.back() != p && polygon.front() != p))
        polygon.push_back(p);
    };
    for(int i = 0; i < 3; ++i) {
      const Vertex v = corners[i], w = corners[(i + 1) % 3];
      if(part.low <= value(v) && value(v) <= part.high)
        add(v.idx());
      const bool is_up = value(v) < value(w);
      for(const double level : {is_up ? part.low : part.high, is_up ? part.high : part.low})
        if((std::min)(value(v), value(w)) < level && level < (std::max)(value(v), value(w)))
          add(is_up ? point_at(v, w, level) : point_at(w, v, level));
    }
    return polygon;
  }

  // The same from both sides of an edge.
  std::uint32_t point_at(Vertex low, Vertex high, double level) {
    const auto next = static_cast<std::uint32_t>(result_.points.size());
    const auto [position, is_new] = cuts_.try_emplace({low, high, level}, next);
    if(is_new) {
      const double ratio = (level - value(low)) / (value(high) - value(low));
      result_.points.push_back(
          coordinates(mesh_.point(low) + ratio * (mesh_.point(high) - mesh_.point(low))));
    }
    return position->second;
  }

  // All of them are convex.
  void add_polygon(Polygon polygon, std::size_t arc, bool is_turned) {
    if(is_turned)
      std::reverse(polygon.begin(), polygon.end());
    for(std::size_t i = 2; i < polygon.size(); ++i) {
      result_.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
      result_.triangle_arcs.push_back(static_cast<std::uint32_t>(arc));
    }
  }

  const Mesh& mesh_;
  const Reeb_answer& answer_;
  Face_arcs arcs_;
  std::map<std::tuple<Vertex, Vertex, double>, std::uint32_t> cuts_;
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
