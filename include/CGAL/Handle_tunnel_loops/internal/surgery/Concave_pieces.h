// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CONCAVE_PIECES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CONCAVE_PIECES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Separation.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The pieces of a surface between the convex edges of the solid, such as the walls of bores, and
/// how large they are: a search that would not come to an end need not begin.
class Concave_pieces
{
public:
  /// of the mesh as it is now. \p outward is 1 if the faces point out of the solid, -1 if they
  /// point into it. Near linear in the size of the mesh.
  Concave_pieces(Execution execution, const Surgery_mesh& mesh, double outward)
      : mesh_(mesh)
      , outward_(outward)
      , piece_(mesh.face_bound(), no_index)
      , size_(mesh.face_bound(), 0)
      , convex_sides_(mesh.face_bound(), 0) {
    Concurrent_disjoint_sets sets(execution, mesh.face_bound());
    for_each_index(execution, mesh.face_bound(), [&](std::size_t f) {
      if(mesh.is_alive(static_cast<Index>(f)))
        sets.insert(static_cast<Index>(f));
    });
    for_each_index(execution, mesh.face_bound(), [&](std::size_t i) {
      const Index f = static_cast<Index>(i);
      if(!mesh.is_alive(f))
        return;
      for(Index side : {0, 1, 2})
        if(turns_outward(3 * f + side))
          convex_sides_[f] |= static_cast<unsigned char>(1u << side);
        else if(3 * f + side < mesh.twin(3 * f + side))
          sets.unite(f, mesh.face(mesh.twin(3 * f + side)));
    });
    for(Index f = 0; f < mesh.face_bound(); ++f)
      if(mesh.is_alive(f)) {
        piece_[f] = sets.root(f);
        ++size_[piece_[f]];
      }
  }

  /// the number of the piece that a face was in at first; none if it has come since.
  Index piece(Index face) const { return face < piece_.size() ? piece_[face] : no_index; }

  /// how many faces a piece had at first.
  Index size(Index piece) const { return size_[piece]; }

  /// whether the edge is convex by more than five degrees.
  bool is_convex(Index h) const {
    const Index f = mesh_.face(h), g = mesh_.face(mesh_.twin(h));
    return (std::max)(f, g) < convex_sides_.size() ? (convex_sides_[f] >> (h - 3 * f) & 1) != 0
                                                   : turns_outward(h);
  }

private:
  bool turns_outward(Index h) const {
    constexpr double cosine = 0.996;
    const Index g = mesh_.twin(h);
    const auto m = normal_of(mesh_, mesh_.face(h)), n = normal_of(mesh_, mesh_.face(g));
    const double lengths = m.squared_length() * n.squared_length();
    if(lengths == 0. || m * n >= cosine * std::sqrt(lengths))
      return false;
    const Surgery_mesh::Point &p = mesh_.point(mesh_.source(h)),
                              &q = mesh_.point(mesh_.target(mesh_.next(g)));
    double height = 0.; // of the other face above this one
    for(int axis = 0; axis < 3; ++axis)
      height += m[axis] * (q[axis] / 2. - p[axis] / 2.);
    return outward_ * height < 0.;
  }

  const Surgery_mesh& mesh_;
  const double outward_;
  std::vector<Index> piece_;                // by face
  std::vector<Index> size_;                 // by piece
  std::vector<unsigned char> convex_sides_; // by face, as bits
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CONCAVE_PIECES_H
