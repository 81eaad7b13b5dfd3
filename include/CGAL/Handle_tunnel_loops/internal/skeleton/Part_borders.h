// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_BORDERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_BORDERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/depths_in_parts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Finds closed curves on a surface that lead around parts of it, each a tube: a curve along which the
part ends, or one that is some edges farther in, where the ends of the part touch each other and it
has two of them.
*/
class Part_borders
{
public:
  using Curve = std::vector<Vector>;

  /// \p part_of_vertex has the hubs, too. All must outlive it.
  Part_borders(const Flat_mesh& mesh,
               Span<const Vector> places,
               const std::vector<Index>& part_of_vertex)
      : mesh_(mesh)
      , places_(places)
      , part_(part_of_vertex) {}

  /// by part, a curve around each that is wanted; none, if there are not two anywhere.
  std::vector<Curve> operator()(const std::vector<char>& is_wanted) {
    depth_ = depths_in_parts(mesh_, part_, [&](Index part) { return is_wanted[part] != 0; });
    std::vector<std::vector<Index>> vertices(is_wanted.size());
    for(Index v = 0; v < part_.size(); ++v)
      if(depth_[v] > 0)
        vertices[part_[v]].push_back(v);
    std::vector<Curve> curves;
    for(const std::vector<Index>& of_part : vertices)
      curves.push_back(curve_around(of_part));
    return curves;
  }

private:
  static std::uint64_t key(Index v, Index u) { return std::uint64_t(v) << 32 | u; }

  Curve curve_around(const std::vector<Index>& vertices) const {
    Index deepest = 0;
    for(const Index v : vertices)
      deepest = (std::max)(deepest, depth_[v]);
    Curve some;
    for(Index depth = 1; depth <= deepest; depth += 1 + depth / 4) {
      std::vector<Curve> curves = curves_at(depth, vertices);
      std::stable_sort(curves.begin(), curves.end(),
                       [](const Curve& a, const Curve& b) { return a.size() > b.size(); });
      if(curves.size() == 2)
        return curves[1];
      if(curves.size() > 2 && some.empty())
        some = std::move(curves[1]);
    }
    return some;
  }

  std::vector<Curve> curves_at(Index depth, const std::vector<Index>& vertices) const {
    std::vector<Curve> curves;
    std::unordered_set<std::uint64_t> passed;
    for(const Index v : vertices)
      if(depth_[v] == depth)
        for(const Index u : mesh_.ring(v))
          if(!is_within(u, v, depth) && passed.count(key(v, u)) == 0)
            curves.push_back(follow(v, u, depth, passed));
    return curves;
  }

  bool is_within(Index u, Index v, Index depth) const {
    return part_[u] == part_[v] && depth_[u] >= depth;
  }

  // From an edge that leads out, from face to face.
  Curve follow(Index v, Index u, Index depth, std::unordered_set<std::uint64_t>& passed) const {
    Curve curve;
    while(passed.insert(key(v, u)).second) {
      curve.push_back(0.5 * (places_[v] + places_[u]));
      const Index w = after(mesh_.ring(v), mesh_.ring(u), v, u);
      (is_within(w, v, depth) ? v : u) = w;
    }
    return curve;
  }

  const Flat_mesh& mesh_;
  Span<const Vector> places_;
  const std::vector<Index>& part_;
  std::vector<Index> depth_; // by vertex
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_PART_BORDERS_H
