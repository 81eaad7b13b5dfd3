// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CUT_REGION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CUT_REGION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/Index_table.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Growing_faces.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Faces, of no cap, that are taken out to remove handles: a wall, as that of a bore, which has n > 1
holes, so that the genus is n - 1 less once these are closed by discs, and less by that of the wall,
if the rest of the surface is in one piece; or a piece with one hole that holds whole handles. The
holes are simple closed curves of at least three edges, and they do not touch each other.
*/
class Cut_region
{
public:
  /// the faces at some vertices, if they are such a region that removes one handle.
  static std::optional<Cut_region> around(const Surgery_mesh& mesh,
                                          const std::vector<Index>& vertices) {
    std::optional<Cut_region> region = of(mesh, faces_at(mesh, vertices));
    return region && region->number_of_handles_ == 1 ? region : std::nullopt;
  }

  /// the faces at some vertices, in ascending order.
  static std::vector<Index> faces_at(const Surgery_mesh& mesh, const std::vector<Index>& vertices) {
    std::vector<Index> faces;
    for(Index v : vertices)
      mesh.for_each_outgoing(v, [&](Index h) { faces.push_back(mesh.face(h)); });
    make_set(faces);
    return faces;
  }

  /// the borders of some faces, as those of a region; none if they touch each other or themselves.
  static std::vector<std::vector<Index>> borders_of(const Surgery_mesh& mesh,
                                                    std::vector<Index> faces) {
    Cut_region region;
    region.faces_ = std::move(faces);
    const std::vector<Sourced_halfedge> border = region.border_halfedges(mesh);
    return pinches(border).empty() ? curves(mesh, border) : std::vector<std::vector<Index>>();
  }

  /// the given faces, and what is cut off by them but for the rest of the surface, if that holds
  /// whole handles and has no more than so many faces. In the end the given faces are what they
  /// were.
  static std::optional<Cut_region>
  whole(const Surgery_mesh& mesh, Growing_faces& faces, std::size_t most) {
    Cut_region region;
    Growing_faces::Stage stage = faces.stage();
    const std::vector<Sourced_halfedge> border = region.fill_up(mesh, faces, most);
    faces.return_to(std::move(stage));
    if(border.empty() || !region.is_of_handles(mesh, border) || region.borders_.size() != 1)
      return std::nullopt;
    return region;
  }

  /// the given faces as a wall, with the discs that it leaves out and that have less faces, and but
  /// a few for each edge of their border.
  static std::optional<Cut_region> wall(const Surgery_mesh& mesh, std::vector<Index> faces) {
    Cut_region region;
    region.faces_ = std::move(faces);
    std::vector<Sourced_halfedge> border = region.border_halfedges(mesh);
    if(!pinches(border).empty())
      return std::nullopt;
    region.add_discs(mesh, curves(mesh, border));
    border = region.border_halfedges(mesh);
    if(!region.is_of_handles(mesh, border) || region.borders_.size() < 2)
      return std::nullopt;
    return region;
  }

  /// the region with one more ring of faces beyond one of its borders, if it is such a one still:
  /// if these faces are an annulus that touches the region there only.
  std::optional<Cut_region> wider(const Surgery_mesh& mesh, std::size_t border) const {
    std::vector<Index> beyond = faces_at(mesh, vertices_of(mesh, border));
    beyond.erase(
        std::remove_if(beyond.begin(), beyond.end(), [this](Index f) { return contains(f); }),
        beyond.end());
    const std::optional<Cut_region> ring = of(mesh, std::move(beyond));
    if(!ring || ring->borders_.size() != 2 || ring->number_of_handles_ != 1)
      return std::nullopt;
    const std::vector<Index>& side = ring->borders_[0];
    const Index shared = mesh.twin(borders_[border].front());
    const std::size_t outer = std::find(side.begin(), side.end(), shared) == side.end() ? 0 : 1;
    if(borders_.size() == 2 && ring->touches(mesh, outer, vertices_of(mesh, 1 - border)))
      return std::nullopt;
    Cut_region region;
    region.faces_ = united(faces_, ring->faces_);
    region.borders_ = borders_;
    region.borders_[border] = ring->borders_[outer];
    region.number_of_handles_ = number_of_handles_;
    return region;
  }

  /// in ascending order.
  const std::vector<Index>& faces() const { return faces_; }

  bool contains(Index face) const { return is_in(face, faces_); }

  /// how many handles there will be less.
  std::size_t number_of_handles() const { return number_of_handles_; }

  std::size_t number_of_borders() const { return borders_.size(); }

  /// the halfedges of the region along one of its borders, in cyclic order.
  const std::vector<Index>& border(std::size_t i) const { return borders_[i]; }

  /// the vertices of a border, in cyclic order.
  Closed_walk vertices_of(const Surgery_mesh& mesh, std::size_t border) const {
    Closed_walk walk;
    for(Index h : borders_[border])
      walk.push_back(mesh.source(h));
    return walk;
  }

  /// the vertices of all borders.
  std::vector<Index> border_vertices(const Surgery_mesh& mesh) const {
    std::vector<Index> vertices;
    for(const std::vector<Index>& border : borders_)
      for(Index h : border)
        vertices.push_back(mesh.source(h));
    return vertices;
  }

private:
  using Sourced_halfedge = std::pair<Index, Index>;

  static std::optional<Cut_region> of(const Surgery_mesh& mesh, std::vector<Index> faces) {
    Cut_region region;
    region.faces_ = std::move(faces);
    if(!region.is_of_handles(mesh, region.border_halfedges(mesh)))
      return std::nullopt;
    return region;
  }

  // Whether the faces with this border are such a region; finds all else then.
  bool is_of_handles(const Surgery_mesh& mesh, const std::vector<Sourced_halfedge>& border) {
    if(std::any_of(faces_.begin(), faces_.end(), [&](Index f) { return mesh.is_in_cap(f); }) ||
       !pinches(border).empty())
      return false;
    borders_ = curves(mesh, border);
    if(std::any_of(borders_.begin(), borders_.end(), [](const auto& b) { return b.size() < 3; }))
      return false;
    const std::ptrdiff_t number = static_cast<std::ptrdiff_t>(borders_.size()),
                         genus = (2 - number - euler_characteristic(mesh)) / 2;
    if(number == 0 || genus < 0)
      return false;
    number_of_handles_ = static_cast<std::size_t>(number - 1 + genus);
    return number_of_handles_ > 0;
  }

  // With their sources, by which they are sorted, the halfedges with no face of the region on their
  // other side.
  std::vector<Sourced_halfedge> border_halfedges(const Surgery_mesh& mesh) const {
    const Index_range_set region(faces_);
    return border_halfedges(mesh, [&](Index f) { return region.contains(f); });
  }
  template <typename Predicate>
  std::vector<Sourced_halfedge> border_halfedges(const Surgery_mesh& mesh,
                                                 const Predicate& is_inside) const {
    std::vector<Sourced_halfedge> all;
    for(Index f : faces_)
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        if(!is_inside(mesh.face(mesh.twin(h))))
          all.push_back({mesh.source(h), h});
    std::sort(all.begin(), all.end());
    return all;
  }

  // Vertices where the border touches itself.
  static std::vector<Index> pinches(const std::vector<Sourced_halfedge>& border) {
    std::vector<Index> vertices;
    for(std::size_t i = 1; i < border.size(); ++i)
      if(border[i].first == border[i - 1].first)
        vertices.push_back(border[i].first);
    return vertices;
  }

  // The place of the next one of a border that does not touch itself.
  static std::size_t
  following(const Surgery_mesh& mesh, const std::vector<Sourced_halfedge>& border, std::size_t i) {
    const Sourced_halfedge next(mesh.target(border[i].second), 0);
    return std::lower_bound(border.begin(), border.end(), next) - border.begin();
  }

  // The curves of a border that does not touch itself.
  static std::vector<std::vector<Index>> curves(const Surgery_mesh& mesh,
                                                const std::vector<Sourced_halfedge>& border) {
    std::vector<std::vector<Index>> curves;
    std::vector<char> is_used(border.size(), 0);
    for(std::size_t begin = 0; begin < border.size(); ++begin) {
      if(is_used[begin])
        continue;
      curves.emplace_back();
      for(std::size_t i = begin; !is_used[i]; i = following(mesh, border, i)) {
        is_used[i] = 1;
        curves.back().push_back(border[i].second);
      }
    }
    return curves;
  }

  // What lies beyond one of some curves and comes to no other one. Each face is reached once.
  void add_discs(const Surgery_mesh& mesh, const std::vector<std::vector<Index>>& curves) {
    Index_table reached; // by face, from which curve
    std::vector<Index> discs;
    for(Index k = 0; k < curves.size(); ++k) {
      constexpr std::size_t most_per_edge = 8;
      const std::size_t most = (std::min)(faces_.size(), most_per_edge * curves[k].size());
      std::vector<Index> disc;
      bool is_alone = true;
      const auto visit = [&](Index f) {
        const auto [curve, is_new] = reached.insert(f, k);
        if(is_new)
          disc.push_back(f);
        is_alone = is_alone && *curve == k;
      };
      std::vector<Index> own;
      for(Index h : curves[k]) {
        own.push_back(mesh.twin(h));
        visit(mesh.face(mesh.twin(h)));
      }
      make_set(own);
      for(std::size_t i = 0; i < disc.size() && is_alone; ++i) {
        is_alone = disc.size() < most;
        for(Index h : {3 * disc[i], 3 * disc[i] + 1, 3 * disc[i] + 2})
          if(const Index f = mesh.face(mesh.twin(h)); !contains(f))
            visit(f);
          else
            is_alone = is_alone && is_in(h, own);
      }
      if(is_alone)
        discs.insert(discs.end(), disc.begin(), disc.end());
    }
    make_set(discs);
    faces_ = united(faces_, discs);
  }

  // Takes these faces, with what makes their border touch itself, and islands. Returns what the
  // border is then; none if there are too many faces.
  std::vector<Sourced_halfedge>
  fill_up(const Surgery_mesh& mesh, Growing_faces& faces, std::size_t most) {
    while(faces.size() <= most) {
      if(faces.add_faces_at_pinches())
        continue;
      faces_ = faces.faces();
      std::sort(faces_.begin(), faces_.end());
      std::vector<Sourced_halfedge> border =
          border_halfedges(mesh, [&](Index f) { return faces.contains(f); });
      const auto borders = curves(mesh, border);
      const std::vector<Index> more =
          borders.size() > 1 ? islands(mesh, borders, faces, most) : std::vector<Index>();
      if(more.empty())
        return border;
      if(faces.size() + more.size() > most)
        break;
      for(Index f : more)
        faces.add(f);
    }
    return {};
  }

  // The faces of pieces beyond some borders that have fewer faces than the region. What is beyond
  // one border is in one piece, as no border touches itself. Ends where they are too many with it.
  static std::vector<Index> islands(const Surgery_mesh& mesh,
                                    const std::vector<std::vector<Index>>& borders,
                                    const Growing_faces& region,
                                    std::size_t most) {
    enum Mark : char { NONE, SMALL, LARGE };
    std::vector<char>& marks = region.marks_beyond();
    std::vector<Index> all, seen;
    for(const std::vector<Index>& border : borders) {
      if(region.size() + all.size() > most)
        break;
      std::vector<Index> piece;
      bool is_small = true;
      const auto visit = [&](Index f) {
        if(region.contains(f))
          return;
        if(marks[f] == NONE) {
          marks[f] = SMALL;
          piece.push_back(f);
        }
        is_small = is_small && marks[f] == SMALL;
      };
      visit(mesh.face(mesh.twin(border.front())));
      for(std::size_t i = 0; i < piece.size() && is_small; ++i) {
        for(Index g : {3 * piece[i], 3 * piece[i] + 1, 3 * piece[i] + 2})
          visit(mesh.face(mesh.twin(g)));
        is_small = is_small && piece.size() < region.size();
      }
      if(is_small)
        all.insert(all.end(), piece.begin(), piece.end());
      else
        for(Index f : piece)
          marks[f] = LARGE;
      seen.insert(seen.end(), piece.begin(), piece.end());
    }
    for(Index f : seen)
      marks[f] = NONE;
    return all;
  }

  // Whether a border comes to one of some vertices.
  bool touches(const Surgery_mesh& mesh, std::size_t border, Closed_walk vertices) const {
    make_set(vertices);
    const Closed_walk walk = vertices_of(mesh, border);
    return std::any_of(walk.begin(), walk.end(), [&](Index v) { return is_in(v, vertices); });
  }

  std::ptrdiff_t euler_characteristic(const Surgery_mesh& mesh) const {
    std::vector<Index> corners;
    corners.reserve(3 * faces_.size());
    for(Index f : faces_)
      for(Index v : mesh.corners(f))
        corners.push_back(v);
    std::size_t sides = 3 * faces_.size();
    for(const std::vector<Index>& border : borders_)
      sides += border.size();
    CGAL_assertion(sides % 2 == 0);
    return static_cast<std::ptrdiff_t>(number_of_different(std::move(corners)) + faces_.size()) -
           static_cast<std::ptrdiff_t>(sides / 2);
  }

  std::vector<Index> faces_;
  std::vector<std::vector<Index>> borders_;
  std::size_t number_of_handles_ = 1;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CUT_REGION_H
