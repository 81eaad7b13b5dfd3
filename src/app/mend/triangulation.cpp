// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/steps.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <map>
#include <tuple>
#include <unordered_set>
#include <utility>

namespace htloops {
namespace {

using Plane_point = Exact::Point_2;
using Is_free = std::function<bool(std::uint32_t, std::uint32_t)>;

struct Face_info
{
  bool is_known = false;
  bool is_inside = false;
};

using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Exact>;
using Face_base =
    CGAL::Triangulation_face_base_with_info_2<Face_info,
                                              Exact,
                                              CGAL::Constrained_triangulation_face_base_2<Exact>>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Exact,
    CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
    CGAL::No_constraint_intersection_tag>;

// Along the axis that a polygon faces most: no coordinate is rounded.
class Projection
{
public:
  Projection(const std::vector<Point>& points, const Corners& corners)
      : points_(points) {
    double normal[3] = {0., 0., 0.};
    for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) {
      const Point& o = points[corners[0]];
      const auto p = points[u] - o, q = points[v] - o;
      for(int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        normal[i] += p[j] * q[k] - p[k] * q[j];
      }
    });
    int axis = 0;
    for(const int i : {1, 2})
      if(std::abs(normal[i]) > std::abs(normal[axis]))
        axis = i;
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
    if(normal[axis] < 0.)
      std::swap(x_, y_);
  }

  Plane_point operator()(std::uint32_t v) const { return {points_[v][x_], points_[v][y_]}; }

private:
  const std::vector<Point>& points_;
  int x_, y_;
};

// Which of its two diagonals cuts a quadrangle: one that is free, whose triangles do not overlap,
// the shorter one, in this order.
Triangles
cut_quadrangle(const std::vector<Point>& points, const Corners& c, const Is_free& is_free) {
  const Projection projection(points, c);
  const auto is_left_turn = [&](int i, int j, int k) {
    return CGAL::orientation(projection(c[i]), projection(c[j]), projection(c[k])) ==
           CGAL::LEFT_TURN;
  };
  const auto badness = [&](int i, int j, int k, int l) {
    const bool overlaps = !is_left_turn(i, j, k) || !is_left_turn(i, k, l);
    const bool is_longer =
        CGAL::compare_distance(exact_point(points[c[i]]), exact_point(points[c[k]]),
                               exact_point(points[c[j]]),
                               exact_point(points[c[l]])) == CGAL::LARGER;
    return std::make_tuple(!is_free(c[i], c[k]), overlaps, is_longer);
  };
  if(badness(1, 2, 3, 0) < badness(0, 1, 2, 3))
    return {{c[1], c[2], c[3]}, {c[1], c[3], c[0]}};
  return {{c[0], c[1], c[2]}, {c[0], c[2], c[3]}};
}

// All triangles at one corner.
Triangles cut_as_fan(const Corners& corners, std::size_t apex) {
  Triangles triangles;
  const std::size_t n = corners.size();
  for(std::size_t i = 1; i + 1 < n; ++i)
    triangles.push_back({corners[apex], corners[(apex + i) % n], corners[(apex + i + 1) % n]});
  return triangles;
}

class Delaunay_cutter
{
public:
  // Nothing if the polygon, seen along its axis, touches or crosses itself, but for sides that are
  // there and back again, as those to a hole.
  std::optional<Triangles> cut(const std::vector<Point>& points, const Corners& corners) {
    try {
      if(!insert(points, corners) || delaunay_.dimension() < 2)
        return std::nullopt;
    } catch(const Delaunay::Intersection_of_constraints_exception&) {
      return std::nullopt;
    }
    mark_inside();
    Triangles triangles;
    for(const Delaunay::Face_handle f : delaunay_.finite_face_handles())
      if(f->info().is_inside)
        triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    if(triangles.size() + 2 != corners.size())
      return std::nullopt;
    for(auto& t : triangles)
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

private:
  bool insert(const std::vector<Point>& points, const Corners& corners) {
    const Projection projection(points, corners);
    std::vector<Delaunay::Vertex_handle> handles;
    Delaunay::Face_handle hint;
    for(const std::uint32_t v : corners) {
      const std::size_t before = delaunay_.number_of_vertices();
      const Delaunay::Vertex_handle handle = delaunay_.insert(projection(v), hint);
      if(delaunay_.number_of_vertices() != before)
        handle->info() = v;
      else if(handle->info() != v)
        return false; // two vertices at one place
      handles.push_back(handle);
      hint = handle->face();
    }
    for(std::size_t i = 0; i < handles.size(); ++i) {
      const Delaunay::Vertex_handle next = handles[i + 1 == handles.size() ? 0 : i + 1];
      if(handles[i] == next)
        return false;
      if(++sides_[edge_key(handles[i]->info(), next->info())] == 1)
        delaunay_.insert_constraint(handles[i], next);
    }
    return true;
  }

  // Inside is what an odd number of sides has to be crossed to from outside.
  void mark_inside() {
    std::vector<Delaunay::Face_handle> todo{delaunay_.infinite_face()};
    todo.back()->info().is_known = true;
    while(!todo.empty()) {
      const Delaunay::Face_handle f = todo.back();
      todo.pop_back();
      for(int i = 0; i < 3; ++i) {
        const Delaunay::Face_handle g = f->neighbor(i);
        if(g->info().is_known)
          continue;
        g->info() = {true, f->info().is_inside != is_crossed_oddly(f, i)};
        todo.push_back(g);
      }
    }
  }

  bool is_crossed_oddly(Delaunay::Face_handle f, int i) const {
    if(!f->is_constrained(i))
      return false;
    const auto side = sides_.find(
        edge_key(f->vertex(Delaunay::cw(i))->info(), f->vertex(Delaunay::ccw(i))->info()));
    return side == sides_.end() || side->second % 2 == 1;
  }

  Delaunay delaunay_;
  std::map<std::uint64_t, int> sides_; // how often they are sides
};

bool are_all_free(const Triangles& triangles, const Corners& corners, const Is_free& is_free) {
  std::vector<std::uint64_t> sides;
  for_each_side(corners,
                [&](std::uint32_t u, std::uint32_t v) { sides.push_back(edge_key(u, v)); });
  std::sort(sides.begin(), sides.end());
  for(const auto& t : triangles)
    for(int i = 0; i < 3; ++i) {
      const std::uint32_t u = t[i], v = t[(i + 1) % 3];
      if(!std::binary_search(sides.begin(), sides.end(), edge_key(u, v)) && !is_free(u, v))
        return false;
    }
  return true;
}

// Edges of the faces as they are in the file, each as often as there are faces; sorted.
std::vector<std::uint64_t> edges_of_polygons(const Soup& soup) {
  std::vector<std::uint64_t> edges;
  edges.reserve(3 * soup.faces.size() + soup.further_corners.size());
  for_each_polygon(soup, [&](std::size_t, const Corners& corners) {
    for_each_side(corners,
                  [&](std::uint32_t u, std::uint32_t v) { edges.push_back(edge_key(u, v)); });
  });
  std::sort(edges.begin(), edges.end());
  return edges;
}

class Triangulator
{
public:
  explicit Triangulator(Mended_soup& mended)
      : mended_(mended) {}

  void run() {
    replace_faces(mended_, [&](std::size_t f, const Corners& corners, Soup& soup) {
      if(corners.size() <= 3) {
        add_face(soup, corners);
      } else {
        mended_.log.add_face(Change_kind::FACES_TRIANGULATED, mended_.face_in_file[f]);
        for(const auto& [u, v, w] : triangles_of(corners))
          add_face(soup, {u, v, w});
      }
    });
    keep_diagonals();
  }

private:
  bool is_edge(std::uint32_t u, std::uint32_t v) const {
    return std::binary_search(edges_.begin(), edges_.end(), edge_key(u, v));
  }

  // A duplicate is cut as the first of its kind, so that its triangles are duplicates, too.
  Triangles triangles_of(const Corners& corners) {
    if(!has_crowded_side(corners))
      return cut(corners);
    const Corners standard = in_standard_order(corners);
    const auto [found, is_new] = cut_already_.try_emplace(standard);
    if(is_new)
      found->second = cut(standard);
    Triangles triangles = found->second;
    const auto first = std::min_element(corners.begin(), corners.end()) - corners.begin();
    const bool is_turned =
        corners[(static_cast<std::size_t>(first) + 1) % corners.size()] != standard[1];
    if(is_turned)
      for(auto& t : triangles)
        std::swap(t[1], t[2]);
    return triangles;
  }

  bool has_crowded_side(const Corners& corners) const {
    bool is_crowded = false;
    for_each_side(corners, [&](std::uint32_t u, std::uint32_t v) {
      const auto [begin, end] = std::equal_range(edges_.begin(), edges_.end(), edge_key(u, v));
      is_crowded = is_crowded || end - begin > 2;
    });
    return is_crowded;
  }

  Triangles cut(const Corners& corners) {
    const Triangles triangles =
        triangulate_polygon(mended_.soup.points, corners, [this](std::uint32_t u, std::uint32_t v) {
          return !is_edge(u, v) && diagonals_.count(edge_key(u, v)) == 0;
        });
    for(const auto& t : triangles)
      for(int i = 0; i < 3; ++i)
        if(!is_edge(t[i], t[(i + 1) % 3]))
          diagonals_.insert(edge_key(t[i], t[(i + 1) % 3]));
    return triangles;
  }

  void keep_diagonals() {
    for(const std::uint64_t key : diagonals_)
      mended_.diagonals.push_back(
          {static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)});
    std::sort(mended_.diagonals.begin(), mended_.diagonals.end());
  }

  Mended_soup& mended_;
  const std::vector<std::uint64_t> edges_ = edges_of_polygons(mended_.soup); // sorted
  std::unordered_set<std::uint64_t> diagonals_;
  std::map<Corners, Triangles> cut_already_; // of polygons with an edge of too many faces
};

} // namespace

Triangles triangulate_polygon(const std::vector<Point>& points,
                              const Corners& corners,
                              const Is_free& is_free) {
  if(corners.size() == 4)
    return cut_quadrangle(points, corners, is_free);
  const std::optional<Triangles> best = Delaunay_cutter().cut(points, corners);
  if(best && are_all_free(*best, corners, is_free))
    return *best;
  constexpr std::size_t largest_number_of_trials =
      16; // each takes as long as the polygon has corners
  for(std::size_t i = 0; i < corners.size() && i < largest_number_of_trials; ++i)
    if(Triangles fan = cut_as_fan(corners, i); are_all_free(fan, corners, is_free))
      return fan;
  return best ? *best : cut_as_fan(corners, 0);
}

void triangulate(Mended_soup& mended) {
  if(!mended.soup.further_corners.empty())
    Triangulator(mended).run();
}

} // namespace htloops
