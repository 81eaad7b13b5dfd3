// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_NEW_FOLDS_H
#define BENCHMARK_NEW_FOLDS_H

#include "Judged_faces.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

/// \file New_folds.h
/// Edges where a surface turns back on itself, and did not before.

namespace judge {

/// in degrees, 0 where the surface is flat at the edge; nothing is known at needles: \p otherwise.
inline double
bend_at(const Mesh& mesh, Mesh::Edge_index e, double needle_height, double otherwise) {
  const Mesh::Halfedge_index h = mesh.halfedge(e);
  if(mesh.is_border(e))
    return 0.;
  const Triangle a = triangle_of(mesh, mesh.face(h));
  const Triangle b = triangle_of(mesh, mesh.face(mesh.opposite(h)));
  if(is_needle(a, needle_height) || is_needle(b, needle_height))
    return otherwise;
  return bend_between(normal_of(a), normal_of(b));
}

/// The sharp edges of the old surface.
class Old_folds
{
public:
  /// \p size is that of the surface: edges at a distance of 1e-7 of it are at the same place.
  Old_folds(const Mesh& before, double size)
      : near_(1e-7 * size)
      , needle_height_(1e-10 * size) {
    for(const Mesh::Edge_index e : before.edges()) {
      const double bend = bend_at(before, e, needle_height_, 180.);
      if(bend < 110.)
        continue;
      const Mesh::Halfedge_index h = before.halfedge(e);
      segments_.emplace_back(point_of(before, before.source(h)),
                             point_of(before, before.target(h)));
      bends_.push_back(bend);
    }
    tree_.insert(segments_.begin(), segments_.end());
    tree_.build();
  }

  Old_folds(const Old_folds&) = delete;
  Old_folds& operator=(const Old_folds&) = delete;

  /// the bend at an edge, if it is above 120 degrees and was not there before; else 0.
  double new_fold(const Mesh& after, Mesh::Edge_index e) const {
    const double bend = bend_at(after, e, needle_height_, 0.);
    if(bend <= 120.)
      return 0.;
    const Mesh::Halfedge_index h = after.halfedge(e);
    const Point middle =
        CGAL::midpoint(point_of(after, after.source(h)), point_of(after, after.target(h)));
    return was_there(middle, bend) ? 0. : bend;
  }

private:
  using Segments = std::vector<Kernel::Segment_3>;
  using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::iterator>;

  bool was_there(const Point& p, double bend) const {
    const Vector reach(near_, near_, near_);
    std::vector<Segments::iterator> found;
    if(!segments_.empty())
      tree_.all_intersected_primitives(Kernel::Iso_cuboid_3(p - reach, p + reach),
                                       std::back_inserter(found));
    return std::any_of(found.begin(), found.end(), [&](Segments::const_iterator s) {
      return bends_[std::size_t(s - segments_.begin())] >= bend - 5.;
    });
  }

  const double near_, needle_height_;
  Segments segments_;
  std::vector<double> bends_;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree_;
};

} // namespace judge

#endif // BENCHMARK_NEW_FOLDS_H
