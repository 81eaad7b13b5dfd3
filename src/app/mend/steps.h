// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_STEPS_H
#define HTLOOPS_STEPS_H

#include "mend/mending.h"
#include "mesh_types.h"
#include "read/soup.h"
#include "read/soup_diagnosis.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace htloops {

/// The vertices of a face of any size, in their order.
using Corners = std::vector<std::uint32_t>;

/// calls `visit(number of the face, corners)` for each face of a soup.
template <typename Visit> void for_each_polygon(const Soup& soup, Visit visit) {
  Corners corners;
  const std::uint32_t* further = soup.further_corners.data();
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Soup_face& face = soup.faces[f];
    corners.assign(face.begin(), face.end());
    if(face.size() > 3) {
      const std::uint32_t* const end = further + (face.size() - 3);
      corners.insert(corners.end(), further, end);
      further = end;
    }
    visit(f, corners);
  }
}

/// calls `visit(u, v)` for each side of a polygon.
template <typename Visit> void for_each_side(const Corners& corners, Visit visit) {
  for(std::size_t i = 0; i < corners.size(); ++i)
    visit(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
}

/// the same for all polygons with the same sides: from the least corner on, its smaller neighbor
/// next. (A corner that comes twice makes no more of it than that one may be missed.)
inline Corners in_standard_order(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if(corners.back() < corners[1])
    std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

inline void add_face(Soup& soup, const Corners& corners) {
  Soup_face& face = soup.faces.emplace_back();
  face.resize(corners.size());
  for(std::size_t i = 0; i < corners.size(); ++i)
    soup.set_corner(face, i, corners[i]);
}

/// makes a soup of the faces that `replace(number of the face, corners, soup)` adds to it in place
/// of each.
template <typename Replace> void replace_faces(Mended_soup& mended, Replace replace) {
  Soup soup;
  std::vector<std::uint32_t> face_in_file;
  soup.faces.reserve(mended.soup.faces.size() + mended.soup.further_corners.size());
  for_each_polygon(mended.soup, [&](std::size_t f, const Corners& corners) {
    replace(f, corners, soup);
    face_in_file.resize(soup.faces.size(), mended.face_in_file[f]);
  });
  soup.points = std::move(mended.soup.points);
  mended.soup = std::move(soup);
  mended.face_in_file = std::move(face_in_file);
}

/// one number for an edge, whatever its direction; the smaller vertex counts first.
using CGAL::Handle_tunnel_loops::internal::edge_key;

/// the sides of all faces, as `edge_key()` has them, one for each face that has it; sorted.
inline std::vector<std::uint64_t> sorted_sides(const Soup& soup) {
  std::vector<std::uint64_t> sides;
  sides.reserve(3 * soup.faces.size() + soup.further_corners.size());
  for_each_polygon(soup, [&sides](std::size_t, const Corners& corners) {
    for_each_side(corners, [&sides](std::uint32_t u, std::uint32_t v) {
      if(u != v)
        sides.push_back(edge_key(u, v));
    });
  });
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// calls `visit(key, how often it is there)` for each of some sorted keys.
template <typename Visit> void for_each_run(const std::vector<std::uint64_t>& keys, Visit visit) {
  for(auto begin = keys.begin(); begin != keys.end();) {
    const auto end =
        std::find_if(begin, keys.end(), [begin](std::uint64_t key) { return key != *begin; });
    visit(*begin, end - begin);
    begin = end;
  }
}

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_point = Exact::Point_3;

inline Exact_point exact_point(const Point& p) { return {p.x(), p.y(), p.z()}; }

/// makes one vertex of those at the same place, exactly, where an edge without a second face lies
/// on another edge. Faces with the same sides count as one. What touches in points stays apart, and
/// a mesh without such edges as it is. True if anything was welded; see `report_vertices()`.
bool weld_points(Mended_soup& mended);

/// does the same, and drops points that no face has; the others keep their order.
Soup join_seams(Soup soup);

/// takes out corners that name the vertex before them again, and faces of which no three are left.
void drop_degenerate_faces(Mended_soup& mended);

/// takes out triangles with the same three vertices as an earlier one, in whatever order, where
/// they are too many for their edges or run the same way. Two that close each other off stay.
void drop_duplicate_faces(Mended_soup& mended);

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// makes triangles of a polygon of four or more corners, convex or not, plane or about so; always
/// as many as it has corners but two. `is_free(u, v)` says whether a diagonal may join two
/// vertices: if it can be, there are only such. Decisions are exact, so the result is always the
/// same.
Triangles triangulate_polygon(const std::vector<Point>& points,
                              const Corners& corners,
                              const std::function<bool(std::uint32_t, std::uint32_t)>& is_free);

/// makes triangles of all faces of more than three vertices. Vertices stay; no diagonal becomes an
/// edge of a further face, if that can be. Points must be finite.
void triangulate(Mended_soup& mended);

/// for each halfedge of a soup of triangles the one of the neighboring face, or `no_halfedge`.
using Neighbors = std::vector<std::uint32_t>;

constexpr std::uint32_t no_halfedge = static_cast<std::uint32_t>(-1);

/// An edge that has more than two faces.
struct Crowded_edge
{
  std::array<std::uint32_t, 2> vertices;
  std::uint32_t number_of_faces;
};

/// Which faces are neighbors, once those are turned over that have to be for neighbors to agree.
struct Gluing
{
  Neighbors neighbors;
  std::vector<bool> is_turned; ///< of each face
  std::vector<Crowded_edge> crowded_edges;
};

/// decides which faces are neighbors, and turns faces so that neighbors agree: as few as possible
/// of each piece. Pieces, of faces that are connected over edges of two, which are not orientable
/// are dropped if `do_drop_one_sided` and there are others. Nothing, and no face is turned, if one
/// stays.
std::optional<Gluing> glue_faces(Mended_soup& mended, bool do_drop_one_sided);

/// turns faces over.
void turn(Soup& soup, const std::vector<bool>& is_turned);

/// takes faces out; those that were their neighbors have none there.
void drop_faces(Mended_soup& mended, Gluing& gluing, const std::vector<bool>& is_dropped);

/// takes out pairs of faces that are neighbors along all their edges.
void drop_pillows(Mended_soup& mended, Gluing& gluing);

/// gives each fan of faces, from neighbor to neighbor, a vertex of its own: the first keeps the one
/// that there is. Neighbors must agree. True if there are vertices more; see `report_vertices()`.
bool split_vertices(Mended_soup& mended, const Neighbors& neighbors);

/// divides edges in the middle that join the same two vertices as another one: of those the first
/// stays. Fans must have vertices of their own.
void divide_parallel_edges(Mended_soup& mended, Gluing& gluing);

/// reports which vertices of `before` have become one, and which several, by comparing the corners
/// of the faces that are left: what was welded and then split again as it was is neither.
void report_vertices(const Soup& before, Mended_soup& mended);

/// reports by how much there are fewer, or more, edges with a face on one side only.
void report_boundary(const Soup& before, Mended_soup& mended);

} // namespace htloops

#endif // HTLOOPS_STEPS_H
