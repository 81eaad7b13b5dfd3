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
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The faces of a surface, large ones divided so that no piece is much longer than a given spacing.

A face is cut by lines parallel to its longest side into rows, and by lines at right angles to that
side into columns. Places in it are told by two numbers in [0, 1]: how far they are up from the
longest side to the apex, and how far along that side. What is left of a column at the end of a row
is of the column beside it if it is narrow. Pieces of two faces are neighbours where they share a
part of the edge between them. Caps are no part of the surface.
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
      , first_row_(wall.size() + 1) {
    for_each_index(execution, wall.size(), [&](std::size_t i) {
      const Index f = static_cast<Index>(i);
      shapes_[f] = shape(f, spacing);
      first_row_[f] = shapes_[f].rows;
      for(int k = 0; k < 3; ++k)
        face_of_slot_[slot(wall[f][k], wall[f][(k + 1) % 3])] = f;
    });
    first_row_[wall.size()] = 0;
    sum_before_each(execution, first_row_);
    lay_out_rows(execution);
  }

  std::size_t size() const { return row_of_.size(); }
  Index face(Index piece) const { return face_of_row_[row_of_[piece]]; }

  /// the piece of a face, not of a cap, that a point of the face is on, about.
  Index piece_at(Index f, const Vector& point) const {
    const Vector base = corner(f, 2) - corner(f, 1), to = point - corner(f, 1),
                 side = corner(f, 0) - corner(f, 1), normal = cross(base, side);
    const double square = dot(normal, normal), length = dot(base, base),
                 up = square > 0. ? dot(cross(base, to), normal) / square : 0.,
                 along = length > 0. ? dot(base, to) / length : 0.;
    const Row row(shapes_[f], index_of(up, shapes_[f].rows));
    return first_piece(f, row) + row.column_at(along) - row.first;
  }

  /// the face to the left of the way from `u` to its neighbour `v`.
  Index face_left_of(Index u, Index v) const { return face_of_slot_[slot(u, v)]; }

  Vector centre(Index piece) const {
    const auto [f, row, column] = place(piece);
    const double foot = shapes_[f].foot, along = 0.5 * (row.low_end(column) + row.high_end(column));
    const double top = along < foot ? along / foot
                       : foot < 1.  ? (1. - along) / (1. - foot)
                                    : 1.,
                 up = 0.5 * (row.low + (std::min)(row.high, top));
    const Vector at_base = (1. - along) * corner(f, 1) + along * corner(f, 2),
                 below_apex = (1. - foot) * corner(f, 1) + foot * corner(f, 2);
    return at_base + up * (corner(f, 0) - below_apex);
  }

  /// the area of a piece, about.
  double area(Index piece) const {
    const Index f = face(piece);
    return 0.5 * norm(wall_.normal(f)) /
           (first_of_row_[first_row_[f + 1]] - first_of_row_[first_row_[f]]);
  }

  /// calls `f(neighbor)` for the pieces beside a piece.
  template <typename Function> void for_each_neighbor(Index piece, const Function& f) const {
    if(const Index whole = this->face(piece); is_whole(whole)) {
      for(int k : {1, 0, 2})
        cross_side(whole, k, {0., 1.}, f);
      return;
    }
    const auto [face, row, column] = place(piece);
    const Shape& shape = shapes_[face];
    if(column > row.first)
      f(piece - 1);
    if(column < row.last)
      f(piece + 1);
    const double low = row.low_end(column), high = row.high_end(column);
    if(row.number > 0)
      visit_row(face, Row(shape, row.number - 1), {low, high}, f);
    else
      cross_side(face, 1, {low, high}, f);
    if(row.number + 1u < shape.rows)
      visit_row(face, Row(shape, row.number + 1), {low, high}, f);
    for(int k : {0, 2})
      cross_side(face, k, part_of_side(shape, row, column, k), f);
  }

private:
  // How a face is divided. The apex is opposite to the longest side, and above the place there
  // that is called its foot.
  struct Shape
  {
    std::uint16_t rows, columns;
    std::uint8_t apex;
    float foot;
  };

  struct Interval
  {
    double low, high;
  };

  // A row of a face, and the columns that there are in it.
  struct Row
  {
    Row(const Shape& shape, Index i)
        : number(i)
        , columns(shape.columns)
        , last(shape.columns - 1u) {
      if(shape.rows == 1) // most are
        return;
      constexpr double narrow = 0.25;
      low = double(i) / shape.rows;
      high = (i + 1.) / shape.rows;
      begin = shape.foot * low;
      end = 1. - (1. - shape.foot) * low;
      first = index_of(begin + narrow / columns, columns);
      last = (std::max)(first, index_of(end - narrow / columns, columns));
    }

    Index column_at(double along) const {
      return (std::max)(first, (std::min)(index_of(along, columns), last));
    }
    double low_end(Index column) const {
      return column == first ? begin : double(column) / columns;
    }
    double high_end(Index column) const { return column == last ? end : (column + 1.) / columns; }

    Index number, columns, first = 0, last;
    double low = 0., high = 1.;  // how far up it is
    double begin = 0., end = 1.; // of its lower side, along the longest one
  };

  struct Place
  {
    Index face;
    Row row;
    Index column;
  };

  static Index index_of(double part, Index number) {
    const double place = part * number;
    return place > 0. ? (std::min)(static_cast<Index>(place), number - 1) : 0;
  }

  std::size_t slot(Index u, Index v) const { return mesh_.row_begin[u] + mesh_.position(u, v); }

  Shape shape(Index f, double spacing) const {
    if(wall_.is_of_cap(f))
      return {0, 0, 0, 0.f};
    const int apex = wall_.apex(f);
    const double longest = wall_.length_opposite(f, apex);
    const double height = longest > 0. ? norm(wall_.normal(f)) / longest : 0.;
    const Vector& start = wall_.corner(f, (apex + 1) % 3);
    const double foot =
        dot(wall_.corner(f, apex) - start, wall_.corner(f, (apex + 2) % 3) - start) /
        (longest * longest);
    const auto number = [&](double length) {
      constexpr double largest = (std::numeric_limits<std::uint16_t>::max)();
      return static_cast<std::uint16_t>(
          (std::max)(1., (std::min)(std::ceil(length / spacing), largest)));
    };
    return {number(height), number(longest), static_cast<std::uint8_t>(apex),
            foot > 0. ? static_cast<float>((std::min)(foot, 1.)) : 0.f};
  }

  void lay_out_rows(Execution execution) {
    const std::size_t rows = first_row_[wall_.size()];
    face_of_row_.resize(rows);
    first_of_row_.resize(rows + 1);
    for_each_index(execution, wall_.size(), [&](std::size_t f) {
      for(Index r = 0; r < shapes_[f].rows; ++r) {
        const Row row(shapes_[f], r);
        face_of_row_[first_row_[f] + r] = static_cast<Index>(f);
        first_of_row_[first_row_[f] + r] = row.last - row.first + 1;
      }
    });
    first_of_row_[rows] = 0;
    sum_before_each(execution, first_of_row_);
    row_of_.resize(first_of_row_[rows]);
    for_each_index(execution, rows, [&](std::size_t row) {
      std::fill(row_of_.begin() + first_of_row_[row], row_of_.begin() + first_of_row_[row + 1],
                static_cast<Index>(row));
    });
  }

  Index first_piece(Index f, const Row& row) const {
    return first_of_row_[first_row_[f] + row.number];
  }

  Place place(Index piece) const {
    const Index f = face(piece);
    const Row row(shapes_[f], row_of_[piece] - first_row_[f]);
    return {f, row, row.first + piece - first_of_row_[row_of_[piece]]};
  }

  // The corners from the apex on.
  Index vertex(Index f, int k) const { return wall_[f][(shapes_[f].apex + k) % 3]; }
  const Vector& corner(Index f, int k) const { return wall_.corner(f, (shapes_[f].apex + k) % 3); }

  // Calls `f(piece)` for those of a row that have more than a point in common with an interval
  // along the longest side.
  template <typename Function>
  void visit_row(Index face, const Row& row, Interval along, const Function& f) const {
    const double margin = 1e-6 / row.columns;
    const double low = (std::max)(along.low, row.begin) + margin,
                 high = (std::min)(along.high, row.end) - margin;
    if(low <= high)
      visit_columns(face, row, {low, high}, f);
  }

  template <typename Function>
  void visit_columns(Index face, const Row& row, Interval along, const Function& f) const {
    const Index begin = first_piece(face, row) - row.first, last = row.column_at(along.high);
    for(Index column = row.column_at(along.low); column <= last; ++column)
      f(begin + column);
  }

  // Whether a face is one piece.
  bool is_whole(Index f) const { return shapes_[f].rows == 1 && shapes_[f].columns == 1; }

  // How far up it is that a piece is at side 0 or 2.
  static Interval part_of_side(const Shape& shape, const Row& row, Index column, int k) {
    const double foot = k == 0 ? shape.foot : 1. - shape.foot; // from the end of the side
    const double low = k == 0 ? row.low_end(column) : 1. - row.high_end(column),
                 high = k == 0 ? row.high_end(column) : 1. - row.low_end(column);
    const bool is_first = column == (k == 0 ? row.first : row.last);
    return {is_first     ? row.low
            : low < foot ? low / foot
                         : 1.,
            high < foot * row.high ? high / foot : row.high};
  }

  // Side k leads from corner k to the next one. Calls `f(piece)` for the pieces beyond an interval
  // of it: along the longest side, and how far up on the others.
  template <typename Function>
  void cross_side(Index face, int k, Interval part, const Function& f) const {
    if(part.low >= part.high)
      return;
    const Index u = vertex(face, k), v = vertex(face, (k + 1) % 3), other = face_left_of(v, u);
    const Shape& shape = shapes_[other];
    if(shape.rows == 0)
      return;
    if(is_whole(other))
      return f(first_of_row_[first_row_[other]]);
    int side = 0;
    while(vertex(other, side) != v)
      ++side;
    // Both are told by how far one has gone on them, but side 0, which leads down.
    if((k == 0) == (side == 0))
      part = {1. - part.high, 1. - part.low};
    if(side == 1)
      return visit_row(other, Row(shape, 0), part, f);
    const double margin = 1e-6 / shape.rows;
    const Index last = index_of(part.high - margin, shape.rows);
    for(Index r = index_of(part.low + margin, shape.rows); r <= last; ++r) {
      const Row row(shape, r);
      const double low = (std::max)(part.low, row.low), high = (std::min)(part.high, row.high);
      visit_columns(other, row,
                    side == 0
                        ? Interval{shape.foot * low, shape.foot * high}
                        : Interval{1. - (1. - shape.foot) * high, 1. - (1. - shape.foot) * low},
                    f);
    }
  }

  const Flat_mesh& mesh_;
  const Wall& wall_;
  Uninitialized_vector<Index> face_of_slot_; // to the left of a vertex's way to its neighbour
  Uninitialized_vector<Shape> shapes_;       // by face
  Uninitialized_vector<Index> first_row_;    // by face
  Uninitialized_vector<Index> face_of_row_;  // by row
  Uninitialized_vector<Index> first_of_row_; // the first piece, by row
  Uninitialized_vector<Index> row_of_;       // by piece
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SOLID_SURFACE_PIECES_H
