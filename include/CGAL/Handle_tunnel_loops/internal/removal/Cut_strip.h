// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_CUT_STRIP_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_CUT_STRIP_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/removal/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/removal/closed_walks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
A strip of faces along a closed walk, an annulus: cutting the surface along the walk takes it out,
and leaves two holes. Each hole is a simple closed curve of at least three edges, and they do not
touch each other.
*/
class Cut_strip
{
public:
  /// the faces at the vertices of a simple closed walk, if they are an annulus.
  static std::optional<Cut_strip> around(const Surgery_mesh& mesh, const Closed_walk& walk) {
    std::vector<Index> faces;
    for(Index v : walk)
      mesh.for_each_outgoing(v, [&](Index h) { faces.push_back(mesh.face(h)); });
    return of(mesh, std::move(faces));
  }

  /// the strip with one more ring of faces beyond one of its sides, if that is still an annulus.
  std::optional<Cut_strip> wider(const Surgery_mesh& mesh, std::size_t side) const {
    std::vector<Index> faces = faces_;
    for(Index h : borders_[side])
      mesh.for_each_outgoing(mesh.source(h), [&](Index g) { faces.push_back(mesh.face(g)); });
    std::optional<Cut_strip> strip = of(mesh, std::move(faces));
    // The other side stays as it is.
    if(strip && !strip->has_border_with(mesh.source(borders_[1 - side].front()), mesh, 1 - side))
      std::swap(strip->borders_[0], strip->borders_[1]);
    return strip;
  }

  /// in ascending order.
  const std::vector<Index>& faces() const { return faces_; }

  /// the halfedges of the strip along one of its sides, 0 or 1, in cyclic order.
  const std::vector<Index>& border(std::size_t side) const { return borders_[side]; }

  bool contains(Index face) const { return std::binary_search(faces_.begin(), faces_.end(), face); }

private:
  static std::optional<Cut_strip> of(const Surgery_mesh& mesh, std::vector<Index> faces) {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    Cut_strip strip;
    strip.faces_ = std::move(faces);
    if(!strip.find_borders(mesh) || strip.euler_characteristic(mesh) != 0)
      return std::nullopt;
    return strip;
  }

  // By source, the halfedges with no face of the strip on their other side. None if a vertex has
  // two of them: the border touches itself there.
  std::vector<std::pair<Index, Index>> border_halfedges(const Surgery_mesh& mesh) const {
    std::vector<std::pair<Index, Index>> all;
    for(Index f : faces_)
      for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
        if(!contains(mesh.face(mesh.twin(h))))
          all.push_back({mesh.source(h), h});
    std::sort(all.begin(), all.end());
    const auto has_same_source = [](const auto& a, const auto& b) { return a.first == b.first; };
    if(std::adjacent_find(all.begin(), all.end(), has_same_source) != all.end())
      all.clear();
    return all;
  }

  // Whether there are two closed curves.
  bool find_borders(const Surgery_mesh& mesh) {
    const std::vector<std::pair<Index, Index>> all = border_halfedges(mesh);
    std::vector<char> is_used(all.size(), 0);
    std::size_t number_of_used = 0;
    for(std::vector<Index>& border : borders_) {
      std::size_t i = std::find(is_used.begin(), is_used.end(), 0) - is_used.begin();
      for(; i < all.size() && !is_used[i]; ++number_of_used) {
        is_used[i] = 1;
        border.push_back(all[i].second);
        const std::pair<Index, Index> next(mesh.target(all[i].second), 0);
        i = std::lower_bound(all.begin(), all.end(), next) - all.begin();
      }
      if(border.size() < 3)
        return false;
    }
    return number_of_used == all.size();
  }

  std::ptrdiff_t euler_characteristic(const Surgery_mesh& mesh) const {
    std::vector<Index> vertices;
    for(Index f : faces_)
      vertices.insert(vertices.end(), mesh.corners(f).begin(), mesh.corners(f).end());
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const std::size_t border = borders_[0].size() + borders_[1].size();
    CGAL_assertion((3 * faces_.size() + border) % 2 == 0);
    return static_cast<std::ptrdiff_t>(vertices.size()) -
           static_cast<std::ptrdiff_t>((3 * faces_.size() + border) / 2) +
           static_cast<std::ptrdiff_t>(faces_.size());
  }

  bool has_border_with(Index v, const Surgery_mesh& mesh, std::size_t side) const {
    return std::any_of(borders_[side].begin(), borders_[side].end(),
                       [&](Index h) { return mesh.source(h) == v; });
  }

  std::vector<Index> faces_;
  std::array<std::vector<Index>, 2> borders_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REMOVAL_CUT_STRIP_H
