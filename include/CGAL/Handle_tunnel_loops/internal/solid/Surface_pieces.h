// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_PIECES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_PIECES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The faces of a surface, large ones divided so that no piece is much longer than a given spacing.

A face is cut by lines parallel to its base into rows, and from its apex into columns: a grid in the
two numbers that tell how far a place is from the base and along it. The base is the longest side;
or the shortest of a needle, so that both of its long sides are divided. Pieces of two faces are
neighbours where they share a part of the edge between them. Caps are no part of the surface.
*/
class Surface_pieces
{
public:
  /// \p mesh and \p wall must outlive it.
  Surface_pieces(Execution execution, const Flat_mesh& mesh, const Wall& wall, double spacing)
      : mesh_(mesh)
      , wall_(wall)
      , face_of_slot_(mesh.neighbor.size())
      , shapes_(wall.size())
      , begin_(wall.size() + 1) {
    for_each_index(execution, wall.size(), [&](std::size_t i) {
      const Index f = static_cast<Index>(i);
      shapes_[f] = shape(f, spacing);
      begin_[f] = Index(shapes_[f].rows) * shapes_[f].columns;
      for(int k = 0; k < 3; ++k)
        face_of_slot_[slot(wall[f][k], wall[f][(k + 1) % 3])] = f;
    });
    begin_[wall.size()] = 0;
    sum_before_each(execution, begin_);
    face_of_.resize(begin_[wall.size()]);
    for_each_index(execution, wall.size(), [&](std::size_t f) {
      std::fill(face_of_.begin() + begin_[f], face_of_.begin() + begin_[f + 1],
                static_cast<Index>(f));
    });
  }

  std::size_t size() const { return face_of_.size(); }
  Index face(Index piece) const { return face_of_[piece]; }

  /// the piece of a face, not of a cap, that a point of the face is on, about.
  Index piece_at(Index f, const Vector& point) const {
    const Shape& shape = shapes_[f];
    const Vector base = corner(f, 2) - corner(f, 1), to = point - corner(f, 1),
                 side = corner(f, 0) - corner(f, 1), normal = cross(base, side);
    const double square = dot(normal, normal);
    const auto place_of = [](double part, Index number) {
      const double place = part * number;
      return place > 0. ? (std::min)(static_cast<Index>(place), number - 1) : 0;
    };
    const double up = square > 0. ? dot(cross(base, to), normal) / square : 0.,
                 along = square > 0. && up < 1. ? dot(cross(to, side), normal) / square / (1. - up)
                                                : 0.;
    return begin_[f] + place_of(up, shape.rows) * shape.columns + place_of(along, shape.columns);
  }

  /// the face to the left of the way from `u` to its neighbour `v`.
  Index face_left_of(Index u, Index v) const { return face_of_slot_[slot(u, v)]; }

  Vector centre(Index piece) const {
    const Place p = place(piece);
    const Shape& shape = shapes_[p.face];
    const double up = (p.row + 0.5) / shape.rows, along = (p.column + 0.5) / shape.columns;
    const Vector base = (1. - along) * corner(p.face, 1) + along * corner(p.face, 2);
    return (1. - up) * base + up * corner(p.face, 0);
  }

  /// the area of a piece, about.
  double area(Index piece) const {
    const Index f = face_of_[piece];
    return 0.5 * norm(wall_.normal(f)) / (begin_[f + 1] - begin_[f]);
  }

  /// calls `f(neighbor)` for the pieces beside a piece.
  template <typename Function> void for_each_neighbor(Index piece, const Function& f) const {
    const Place p = place(piece);
    const Shape& shape = shapes_[p.face];
    if(p.column > 0)
      f(piece - 1);
    else
      cross_side(p, 0, p.row, shape.rows, f);
    if(p.column + 1 < shape.columns)
      f(piece + 1);
    else
      cross_side(p, 2, p.row, shape.rows, f);
    if(p.row > 0)
      f(piece - shape.columns);
    else
      cross_side(p, 1, p.column, shape.columns, f);
    if(p.row + 1 < shape.rows)
      f(piece + shape.columns);
  }

private:
  // How a face is divided. The apex is opposite to the base.
  struct Shape
  {
    std::uint16_t rows, columns;
    std::uint8_t apex;
  };

  struct Place
  {
    Index face, row, column;
  };

  std::size_t slot(Index u, Index v) const { return mesh_.row_begin[u] + mesh_.position(u, v); }

  Shape shape(Index f, double spacing) const {
    if(wall_.is_of_cap(f))
      return {0, 0, 0};
    std::array<std::pair<double, int>, 3> sides; // the longest first, with the corner opposite
    for(int k = 0; k < 3; ++k)
      sides[k] = {norm(wall_.corner(f, (k + 1) % 3) - wall_.corner(f, (k + 2) % 3)), k};
    std::sort(sides.begin(), sides.end(), [](const auto& a, const auto& b) {
      return std::make_pair(b.first, a.second) < std::make_pair(a.first, b.second);
    });
    const auto height = [&](int side) {
      return sides[side].first > 0. ? norm(wall_.normal(f)) / sides[side].first : 0.;
    };
    const auto number = [&](double length) {
      constexpr double largest = (std::numeric_limits<std::uint16_t>::max)();
      return static_cast<std::uint16_t>(
          (std::max)(1., (std::min)(std::ceil(length / spacing), largest)));
    };
    constexpr double most = 2., upright = 0.7;
    const double middle = sides[1].first;
    const int base =
        middle > most * spacing * number(height(0)) && height(2) > upright * middle ? 2 : 0;
    return {number(height(base)), number(sides[base].first),
            static_cast<std::uint8_t>(sides[base].second)};
  }

  Place place(Index piece) const {
    const Index f = face_of_[piece], i = piece - begin_[f];
    return {f, i / shapes_[f].columns, i % shapes_[f].columns};
  }

  // The corners from the apex on.
  Index vertex(Index f, int k) const { return wall_[f][(shapes_[f].apex + k) % 3]; }
  const Vector& corner(Index f, int k) const { return wall_.corner(f, (shapes_[f].apex + k) % 3); }

  // Side k leads from corner k to the next one. Row 0 is at side 1. Places on the sides are told by
  // how far they are from the first of its corners.
  template <typename Function>
  void cross_side(const Place& p, int k, Index i, Index number, const Function& f) const {
    const Index u = vertex(p.face, k), v = vertex(p.face, (k + 1) % 3);
    const Index other = face_left_of(v, u);
    const Shape& shape = shapes_[other];
    if(shape.rows == 0)
      return;
    double low = double(i) / number, high = double(i + 1) / number;
    if(k == 0) { // rows are counted from the base
      const double before = low;
      low = 1. - high;
      high = 1. - before;
    }
    // As the other face sees it.
    double from = 1. - high, to = 1. - low;
    int side = 0;
    while(vertex(other, side) != v)
      ++side;
    if(side == 0) {
      const double before = from;
      from = 1. - to;
      to = 1. - before;
    }
    const Index n = side == 1 ? shape.columns : shape.rows;
    const auto place_of = [&](double t) {
      return (std::min)(static_cast<Index>((std::max)(0., t * n)), n - 1);
    };
    constexpr double margin = 1e-6;
    const Index last = place_of(to - margin / n);
    for(Index j = place_of(from + margin / n); j <= last; ++j)
      f(begin_[other] + (side == 1   ? j
                         : side == 0 ? j * shape.columns
                                     : (j + 1) * shape.columns - 1));
  }

  const Flat_mesh& mesh_;
  const Wall& wall_;
  Uninitialized_vector<Index> face_of_slot_; // to the left of a vertex's way to its neighbour
  Uninitialized_vector<Shape> shapes_;       // by face
  Uninitialized_vector<Index> begin_;        // the first piece, by face
  Uninitialized_vector<Index> face_of_;      // by piece
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_PIECES_H
