// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/near_points.h"

#include "failure.h"
#include "interrupt.h"
#include "mend/steps.h"
#include "read/soup_diagnosis.h"
#include "words.h"

#include <CGAL/Bbox_3.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace htloops {
namespace {

constexpr double near_share = 1e-5; // of the diagonal

using Cell = std::array<double, 3>; // of a grid, by whole numbers

// Vertices that others lie at, in a grid whose cells are as wide as the length.
class Places
{
public:
  Places(const std::vector<Point>& points, const std::vector<std::uint64_t>& edges, double length)
      : points_(points)
      , length_(length) {
    for(const std::uint64_t edge : edges) {
      const auto u = edge >> 32, v = edge & 0xffffffffu;
      directed_edges_.push_back(edge);
      directed_edges_.push_back(v << 32 | u);
    }
    std::sort(directed_edges_.begin(), directed_edges_.end());
  }

  std::uint32_t place_of(std::uint32_t v) {
    const Cell own = cell_of(points_[v]);
    std::uint32_t best = v;
    double least = length_ * length_;
    for_each_cell_around(own, [&](const Cell& cell) {
      const auto found = places_in_.find(cell);
      if(found == places_in_.end())
        return;
      for(const std::uint32_t place : found->second) {
        const double distance = CGAL::squared_distance(points_[place], points_[v]);
        const bool is_nearer =
            distance < least || (distance == least && (best == v || place < best));
        if(distance <= length_ * length_ && is_nearer && !has_edge_to(place, v)) {
          best = place;
          least = distance;
        }
      }
    });
    if(best == v)
      places_in_[own].push_back(v);
    place_at_[v] = best;
    return best;
  }

private:
  Cell cell_of(const Point& p) const {
    const auto number = [this](double x) { return std::floor(x / length_) + 0.; };
    return {number(p.x()), number(p.y()), number(p.z())};
  }

  template <typename Visit> static void for_each_cell_around(const Cell& cell, Visit visit) {
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j)
        for(int k = -1; k <= 1; ++k)
          visit(Cell{cell[0] + i, cell[1] + j, cell[2] + k});
  }

  // Whether a neighbour lies there.
  bool has_edge_to(std::uint32_t place, std::uint32_t v) const {
    const std::uint64_t first = std::uint64_t(v) << 32;
    for(auto edge = std::lower_bound(directed_edges_.begin(), directed_edges_.end(), first);
        edge != directed_edges_.end() && *edge >> 32 == v; ++edge)
    {
      const auto found = place_at_.find(static_cast<std::uint32_t>(*edge));
      if(found != place_at_.end() && found->second == place)
        return true;
    }
    return false;
  }

  const std::vector<Point>& points_;
  std::vector<std::uint64_t> directed_edges_; // from the upper half to the lower one
  const double length_;
  std::unordered_map<Cell, std::vector<std::uint32_t>, boost::hash<Cell>> places_in_;
  std::unordered_map<std::uint32_t, std::uint32_t> place_at_; // by vertex
};

std::array<std::uint32_t, 2> ends_of(std::uint64_t edge) {
  return {static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)};
}

std::vector<std::uint32_t> vertices_of_open_edges(const std::vector<std::uint64_t>& sides) {
  std::vector<std::uint32_t> vertices;
  for_each_run(sides, [&vertices](std::uint64_t edge, std::ptrdiff_t faces) {
    if(faces == 1)
      for(const std::uint32_t v : ends_of(edge))
        vertices.push_back(v);
  });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::string words_of(const Point& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x(), p.y(), p.z());
  return text;
}

// Edges that had more than two faces before do not count.
void check_not_crowded(const Soup& soup,
                       const std::vector<std::uint64_t>& crowded_before,
                       double length) {
  for_each_run(sorted_sides(soup), [&](std::uint64_t edge, std::ptrdiff_t faces) {
    if(faces <= 2 || std::binary_search(crowded_before.begin(), crowded_before.end(), edge))
      return;
    const auto [u, v] = ends_of(edge);
    throw Failure(Exit_code::UNACCEPTABLE_MESH,
                  "--weld: a length of " + formatted("%.6g", length) + " would join " +
                      std::to_string(faces) + " faces along " + name_of_edge(u, v) + ", near " +
                      words_of(soup.points[u]) +
                      ", and the result would not be a surface: try a smaller length");
  });
}

std::size_t number_of_single_triangles(const Mesh& mesh) {
  std::size_t number = 0;
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f), next = mesh.next(h);
    const auto is_free = [&mesh](Mesh::Halfedge_index side) {
      return mesh.is_border(mesh.opposite(side));
    };
    number += is_free(h) && is_free(next) && is_free(mesh.next(next)) ? 1 : 0;
  }
  return number;
}

// The options that weld what lies near, found out by trying.
const char* words_on_welding(const Mesh& mesh, bool is_exact) {
  Soup soup{{mesh.points().begin(), mesh.points().end()}, {}};
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.add_face(std::array<std::uint32_t, 3>{mesh.source(h).idx(), mesh.target(h).idx(),
                                               mesh.target(mesh.next(h)).idx()});
  }
  const Repair_steps all = Remedies().steps;
  const Relative_length length = {near_share, true};
  const std::pair<Remedies, const char*> candidates[] = {
      {{false, true, all}, "--repair welds them"},
      {{false, false, all, length}, "--weld 0.001% welds them"},
      {{false, true, all, length}, "--weld 0.001% and --repair together weld them"}};
  for(const auto& [remedies, words] : candidates)
    try {
      if(remedies.weld.has_value() != is_exact && diagnose(mend(soup, remedies).soup).empty())
        return words;
    } catch(const Failure&) { // an edge would get more than two faces
    }
  return "no option welds them to a surface";
}

} // namespace

std::vector<std::uint32_t> nearest_before(const std::vector<Point>& points,
                                          const std::vector<std::uint32_t>& vertices,
                                          const std::vector<std::uint64_t>& edges,
                                          double length) {
  Places places(points, edges, length);
  std::vector<std::uint32_t> nearest;
  for(const std::uint32_t v : vertices) {
    throw_if_interrupted();
    nearest.push_back(is_finite(points[v]) ? places.place_of(v) : v);
  }
  return nearest;
}

void weld_near_points(Mended_soup& mended, double length) {
  Soup& soup = mended.soup;
  const std::vector<std::uint64_t> sides = sorted_sides(soup);
  const std::vector<std::uint32_t> vertices = vertices_of_open_edges(sides);
  const std::vector<std::uint32_t> nearest = nearest_before(soup.points, vertices, sides, length);
  std::vector<std::uint32_t> welded(soup.points.size());
  for(std::uint32_t v = 0; v < welded.size(); ++v)
    welded[v] = v;
  for(std::size_t i = 0; i < vertices.size(); ++i) {
    welded[vertices[i]] = nearest[i];
    if(nearest[i] != vertices[i])
      mended.log.add(Change_kind::NEAR_VERTICES_WELDED, [&] {
        return name_of_vertex(vertices[i]) + " to " + name_of_vertex(nearest[i]);
      });
  }
  std::vector<std::uint64_t> crowded;
  for_each_run(sides, [&](std::uint64_t edge, std::ptrdiff_t faces) {
    const auto [u, v] = ends_of(edge);
    if(faces > 2)
      crowded.push_back(edge_key(welded[u], welded[v]));
  });
  std::sort(crowded.begin(), crowded.end());
  for(Soup_face& face : soup.faces)
    for(std::uint32_t& v : face)
      v = welded[v];
  for(std::uint32_t& v : soup.further_corners)
    v = welded[v];
  check_not_crowded(soup, crowded, length);
}

std::string Near_boundary::words() const {
  if(near_edges == 0)
    return "";
  return std::to_string(near_edges) + " of " + counted(edges, "boundary edge", "boundary edges") +
         " coincide with others within 1e-5 of the diagonal" +
         (single_triangles > 0
              ? ", and " + counted(single_triangles, "component is a single triangle",
                                   "components are single triangles")
              : "") +
         (is_exact ? ": " : ": they nearly coincide, and ") + remedy;
}

Near_boundary near_boundary_of(const Mesh& mesh) {
  std::vector<std::uint64_t> edges;
  std::vector<std::uint32_t> vertices;
  Near_boundary found;
  for(const Mesh::Edge_index e : mesh.edges())
    if(mesh.is_border(e)) {
      const std::uint32_t u = mesh.vertex(e, 0).idx(), v = mesh.vertex(e, 1).idx();
      edges.push_back(edge_key(u, v));
      vertices.insert(vertices.end(), {u, v});
    }
  if(edges.empty())
    return found;
  std::sort(edges.begin(), edges.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  CGAL::Bbox_3 box;
  for(const std::uint32_t v : vertices)
    box += mesh.points().begin()[v].bbox();
  const double diagonal = diagonal_of(box);
  if(!(diagonal > 0.) || !std::isfinite(diagonal))
    return found;
  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  const std::vector<std::uint32_t> nearest =
      nearest_before(points, vertices, edges, near_share * diagonal);
  for(std::size_t i = 0; i < vertices.size(); ++i)
    found.is_exact = found.is_exact && points[vertices[i]] == points[nearest[i]];
  const auto place = [&](std::uint32_t v) {
    return nearest[static_cast<std::size_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                            vertices.begin())];
  };
  std::vector<std::uint64_t> places;
  for(const std::uint64_t edge : edges) {
    const auto [u, v] = ends_of(edge);
    if(place(u) != place(v))
      places.push_back(edge_key(place(u), place(v)));
  }
  std::sort(places.begin(), places.end());
  for_each_run(places, [&found](std::uint64_t, std::ptrdiff_t number) {
    found.near_edges += number > 1 ? static_cast<std::size_t>(number) : 0;
  });
  found.edges = edges.size();
  if(found.near_edges > 0) {
    found.single_triangles = number_of_single_triangles(mesh);
    found.remedy = words_on_welding(mesh, found.is_exact);
  }
  return found;
}

} // namespace htloops
