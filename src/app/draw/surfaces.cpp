// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/surfaces.h"

#include <algorithm>
#include <optional>

namespace htloops {

Drawn_surface drawn_surface(const Mesh& mesh) {
  Drawn_surface surface{coordinates(mesh.points()), {}, {}};
  surface.triangles.reserve(mesh.number_of_faces());
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    surface.triangles.push_back(
        {mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return surface;
}

void Level_cutter::add_polygon(const Polygon& polygon, std::size_t arc, bool is_turned) {
  for(std::size_t i = 2; i < polygon.size(); ++i) {
    const std::uint32_t a = polygon[i - 1], b = polygon[i];
    surface_.triangles.push_back({polygon[0], is_turned ? b : a, is_turned ? a : b});
    surface_.triangle_arcs.push_back(static_cast<std::uint32_t>(arc));
  }
}

std::vector<Mesh::Edge_index> edges_by_vertices(const Mesh& mesh) {
  const auto edges = mesh.edges();
  std::vector<Mesh::Edge_index> sorted(edges.begin(), edges.end());
  const auto ends = [&mesh](Mesh::Edge_index e) {
    return std::minmax({mesh.vertex(e, 0).idx(), mesh.vertex(e, 1).idx()});
  };
  std::sort(sorted.begin(), sorted.end(),
            [&ends](Mesh::Edge_index a, Mesh::Edge_index b) { return ends(a) < ends(b); });
  return sorted;
}

Level_cutter::Corners Level_cutter::corners_of(Mesh::Face_index f) const {
  const Mesh::Halfedge_index h = mesh_.halfedge(f);
  Corners corners = {mesh_.source(h), mesh_.target(h), mesh_.target(mesh_.next(h))};
  std::sort(corners.begin(), corners.end(), [this](Vertex v, Vertex w) { return is_before(v, w); });
  return corners;
}

bool Level_cutter::has_orientation(Mesh::Face_index f, const Corners& corners) const {
  Mesh::Halfedge_index h = mesh_.halfedge(f);
  while(mesh_.source(h) != corners[0])
    h = mesh_.next(h);
  return mesh_.target(h) == corners[1];
}

Level_cutter::Polygon Level_cutter::polygon(const Corners& corners, double low, double high) {
  Polygon polygon;
  const auto add = [&](std::uint32_t p) {
    if(polygon.empty() || (polygon.back() != p && polygon.front() != p))
      polygon.push_back(p);
  };
  for(int i = 0; i < 3; ++i) {
    const Vertex v = corners[i], w = corners[(i + 1) % 3];
    if(low <= value(v) && value(v) <= high)
      add(v.idx());
    const bool is_up = value(v) < value(w);
    for(const double level : {is_up ? low : high, is_up ? high : low})
      if((std::min)(value(v), value(w)) < level && level < (std::max)(value(v), value(w)))
        add(is_up ? point_at(v, w, level) : point_at(w, v, level));
  }
  return polygon;
}

std::uint32_t Level_cutter::point_at(Vertex low, Vertex high, double level) {
  const auto next = static_cast<std::uint32_t>(surface_.points.size());
  const auto [position, is_new] = cuts_.try_emplace({low, high, level}, next);
  if(is_new) {
    const double ratio = (level - value(low)) / (value(high) - value(low));
    surface_.points.push_back(
        coordinates(mesh_.point(low) + ratio * (mesh_.point(high) - mesh_.point(low))));
  }
  return position->second;
}

std::uint32_t Level_cutter::add_middle(Mesh::Face_index f) {
  const Mesh::Halfedge_index h = mesh_.halfedge(f);
  const Point& p = mesh_.point(mesh_.source(h));
  const auto to = [&](Vertex v) { return mesh_.point(v) - p; };
  surface_.points.push_back(
      coordinates(p + (to(mesh_.target(h)) + to(mesh_.target(mesh_.next(h)))) / 3.));
  return static_cast<std::uint32_t>(surface_.points.size() - 1);
}

Arc_surface arc_surface(const Mesh& mesh, const Reeb_answer& answer) {
  if(answer.is_contracted) // borders are no contours
    return surface_of_labels(mesh, answer.vertex_arc);
  const internal::Vertices_on_arcs vertices(mesh, get(boost::vertex_index, mesh),
                                            map_of_vertices(mesh, answer.vertex_arc),
                                            map_of_vertices(mesh, answer.values));
  internal::Face_arcs arcs(vertices, answer.graph);
  return Level_cutter(mesh, answer.values).cut(arcs);
}

Drawn_surface drawn_surface(const Arc_surface& surface,
                            const std::function<Colour(std::size_t)>& colour_of_part) {
  Drawn_surface drawn{surface.points, surface.triangles, {}};
  drawn.colours.reserve(drawn.triangles.size());
  for(const std::uint32_t arc : surface.triangle_arcs)
    drawn.colours.push_back(colour_of_part(arc));
  return drawn;
}

namespace {

/// Cuts faces between vertices of different labels, at places of edges that slide to where the cuts
/// are straight.
class Label_cutter
{
public:
  Label_cutter(const Mesh& mesh, const std::vector<std::size_t>& labels)
      : mesh_(mesh)
      , labels_(labels) {}

  Arc_surface cut() {
    for(const Mesh::Face_index f : mesh_.faces())
      cut_face(mesh_.halfedge(f));
    straighten_cuts();
    return std::move(surface_);
  }

private:
  /// Where an edge, or a face, is cut.
  struct Cut
  {
    std::uint32_t point;
    std::optional<Mesh::Edge_index> edge;
    std::vector<std::uint32_t> beside; ///< points on the same cuts
  };

  std::size_t label(Mesh::Vertex_index v) const { return labels_[v.idx()]; }

  void add(std::size_t part, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    surface_.triangles.push_back({a, b, c});
    surface_.triangle_arcs.push_back(static_cast<std::uint32_t>(part));
  }

  // A face with one label is left whole; else each corner that is alone is cut off, with the middle
  // of the face if all are.
  void cut_face(Mesh::Halfedge_index h) {
    for(int i = 0; i < 3; ++i, h = mesh_.next(h)) { // the source of h is to be the one alone
      const Mesh::Vertex_index a = mesh_.source(h), b = mesh_.target(h),
                               c = mesh_.target(mesh_.next(h));
      if(label(b) != label(c))
        continue;
      if(label(a) == label(b))
        return add(label(a), a.idx(), b.idx(), c.idx());
      const std::uint32_t ab = cut_of(h), ca = cut_of(mesh_.prev(h));
      join(ab, ca);
      const std::uint32_t p = cuts_[ab].point, q = cuts_[ca].point;
      add(label(a), a.idx(), p, q);
      add(label(b), p, b.idx(), c.idx());
      return add(label(b), p, c.idx(), q);
    }
    const std::uint32_t middle =
        add_cut(CGAL::centroid(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h)),
                               mesh_.point(mesh_.target(mesh_.next(h)))),
                std::nullopt);
    const std::uint32_t m = cuts_[middle].point;
    for(int i = 0; i < 3; ++i, h = mesh_.next(h)) {
      const Mesh::Vertex_index a = mesh_.source(h);
      const std::uint32_t after = cut_of(h), before = cut_of(mesh_.prev(h));
      join(after, middle);
      add(label(a), a.idx(), cuts_[after].point, m);
      add(label(a), a.idx(), m, cuts_[before].point);
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    cuts_[a].beside.push_back(cuts_[b].point);
    cuts_[b].beside.push_back(cuts_[a].point);
  }

  std::uint32_t cut_of(Mesh::Halfedge_index h) {
    const Mesh::Edge_index e = mesh_.edge(h);
    const auto [position, is_new] =
        cut_of_edge_.try_emplace(e, static_cast<std::uint32_t>(cuts_.size()));
    if(is_new)
      add_cut(CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))), e);
    return position->second;
  }

  std::uint32_t add_cut(const Point& point, std::optional<Mesh::Edge_index> edge) {
    cuts_.push_back({static_cast<std::uint32_t>(surface_.points.size()), edge, {}});
    surface_.points.push_back(coordinates(point));
    return static_cast<std::uint32_t>(cuts_.size() - 1);
  }

  // Each place goes to the middle of those beside it, as near as it can on its edge.
  void straighten_cuts() {
    constexpr int number_of_rounds = 50;
    for(int round = 0; round < number_of_rounds; ++round)
      for(const Cut& cut : cuts_) {
        Vector middle = {};
        for(const std::uint32_t p : cut.beside)
          for(int i = 0; i < 3; ++i)
            middle[i] += surface_.points[p][i] / double(cut.beside.size());
        surface_.points[cut.point] = cut.edge ? nearest_on(*cut.edge, middle) : middle;
      }
  }

  // Not quite to the ends.
  Vector nearest_on(Mesh::Edge_index e, const Vector& p) const {
    constexpr double margin = 0.02;
    const Point &a = mesh_.point(mesh_.vertex(e, 0)), &b = mesh_.point(mesh_.vertex(e, 1));
    const auto way = b - a;
    const double squared = way.squared_length(),
                 t = squared > 0. ? ((Point(p[0], p[1], p[2]) - a) * way) / squared : 0.5;
    return coordinates(a + std::clamp(t, margin, 1. - margin) * way);
  }

  const Mesh& mesh_;
  const std::vector<std::size_t>& labels_;
  std::vector<Cut> cuts_;
  std::map<Mesh::Edge_index, std::uint32_t> cut_of_edge_;
  Arc_surface surface_ = {coordinates(mesh_.points()), {}, {}};
};

} // namespace

Arc_surface surface_of_labels(const Mesh& mesh, const std::vector<std::size_t>& labels) {
  return Label_cutter(mesh, labels).cut();
}

} // namespace htloops
