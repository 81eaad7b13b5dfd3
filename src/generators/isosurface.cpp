// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mesh_of_field.h"

#include <boost/multiprecision/integer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// An edge of a cell of the lattice: it starts at corner `base` and goes along `direction`, where
/// both are sums of basis vectors as in `Bcc_lattice` and have no basis vector in common.
struct Cell_edge
{
  std::uint8_t base, direction;
};

using Cell_triangle = std::array<Cell_edge, 3>;

/// A step from a point of the lattice to another.
struct Lattice_step
{
  int column, row, slice;
};

/*!
The part of a body-centred cubic lattice that lies in a box, with integer coordinates in which the
lattice's tetrahedra are those of Kuhn's subdivision of a cube: with the basis a1 = (-1, 1, 1) / 2,
a2 = (1, -1, 1) / 2, a3 = (1, 1, -1) / 2, the tetrahedra at a point are the six paths to the
opposite corner a1 + a2 + a3 of its cell. Corner `c` of a cell is the sum of the basis vectors whose
bits are set in `c`.

A point has a slice and a row, its coordinates along a3 and a2, and a column, which counts along a1
from where the row enters the box: so columns run over a range that is the same for all rows.
*/
class Bcc_lattice
{
public:
  Bcc_lattice(const Box& box, double spacing)
      : origin_(box.low - Vector(1, 1, 1) * spacing)
      , spacing_(spacing) {
    for(int c = 0; c < 3; ++c)
      size_[c] = static_cast<int>(std::ceil((box.high[c] - origin_[c]) / spacing)) + 1;
  }

  int columns() const { return 2 * size_[2] + 1; }
  int rows() const { return size_[0] + size_[2] + 1; }
  int slices() const { return size_[0] + size_[1] + 1; }

  /// the length of a step along a row.
  double column_length() const { return spacing_ * std::sqrt(3.) / 2.; }

  Vector point(int column, int row, int slice) const {
    return origin_ + displacement({column, row, slice}) * spacing_;
  }

  /// where a step leads, in units of the spacing.
  static Vector displacement(const Lattice_step& step) {
    const double z = step.column / 2.;
    return Vector(step.row - z, step.slice - step.row + z, z);
  }

  /// the columns of a row that lie in the box: from the first to, and without, the second.
  std::pair<int, int> columns_inside(int row, int slice) const {
    const int first = (std::max)({0, 2 * (row - size_[0]), 2 * (row - slice)});
    const int last = (std::min)({2 * size_[2], 2 * row, 2 * (size_[1] + row - slice)});
    return {first, last + 1};
  }

  /// the step from a corner 0 to corner `c`.
  static constexpr Lattice_step step_to_corner(int c) {
    const int a1 = c & 1, a2 = (c >> 1) & 1, a3 = (c >> 2) & 1;
    return {a1 + a2 - a3, a2, a3};
  }

private:
  Vector origin_;
  double spacing_;
  std::array<int, 3> size_; ///< of the box, in cubes
};

Vector corner_position(int corner) {
  return Bcc_lattice::displacement(Bcc_lattice::step_to_corner(corner));
}

/// appends the triangles that part the corners of a tetrahedron, turned to face the outside.
void add_triangles(const std::vector<int>& inside,
                   const std::vector<int>& outside,
                   std::vector<Cell_triangle>& triangles) {
  std::vector<std::pair<int, int>> crossed; // edges, one after the other around the polygon
  for(const int a : inside)
    for(const int b : outside)
      crossed.emplace_back(a, b);
  if(crossed.size() == 4)
    std::swap(crossed[2], crossed[3]);
  for(std::size_t last = 2; last < crossed.size(); ++last) {
    std::array<std::pair<int, int>, 3> edges = {crossed[0], crossed[last - 1], crossed[last]};
    std::array<Vector, 3> p;
    for(int i = 0; i < 3; ++i)
      p[i] = (corner_position(edges[i].first) + corner_position(edges[i].second)) / 2.;
    const Vector normal = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    if(normal * (corner_position(outside[0]) - p[0]) < 0.)
      std::swap(edges[1], edges[2]);

    Cell_triangle triangle;
    for(int i = 0; i < 3; ++i) {
      // Of two corners of a tetrahedron one contains the other, as a set of basis vectors.
      const auto [a, b] = edges[i];
      triangle[i] = {static_cast<std::uint8_t>(a & b), static_cast<std::uint8_t>(a ^ b)};
    }
    triangles.push_back(triangle);
  }
}

/// By the set of the corners of a cell that are inside, as bits: the triangles that separate them
/// from the others in the six tetrahedra of the cell, seen counterclockwise from the outside.
using Table = std::array<std::vector<Cell_triangle>, 256>;

Table make_table() {
  Table table;
  for(unsigned cell = 0; cell < table.size(); ++cell) {
    std::array<int, 3> path = {0, 1, 2};
    do {
      std::vector<int> inside, outside;
      int corner = 0;
      for(int step = 0; step <= 3; ++step) {
        (((cell >> corner) & 1) != 0 ? inside : outside).push_back(corner);
        if(step < 3)
          corner |= 1 << path[step];
      }
      add_triangles(inside, outside, table[cell]);
    } while(std::next_permutation(path.begin(), path.end()));
  }
  return table;
}

using Word = std::uint64_t;
constexpr int word_bits = 64;

/// The extent of the tables of a slice: the lattice's rows and columns with a margin, so that all
/// neighbours of a point of the lattice have an entry.
struct Slice_shape
{
  int rows, words; ///< words per row

  std::size_t size_in_words() const { return std::size_t(rows) * words; }
  std::size_t row_start(int row) const { return std::size_t(row + 1) * words; } ///< in words

  /// the entry of a point; word 0 of a row is margin.
  std::size_t entry(int column, int row) const { return (row_start(row) + 1) * word_bits + column; }
};

/// A bit for each point of a slice: whether it is inside the solid.
class Inside_bits
{
public:
  explicit Inside_bits(const Slice_shape& shape)
      : shape_(shape)
      , words_(shape.size_in_words() + 2, 0) {}

  void clear() { std::fill(words_.begin(), words_.end(), 0); }

  void set(int row, int first_column, int end_column) {
    std::size_t i = shape_.entry(first_column, row) + word_bits;
    for(std::size_t left = end_column - first_column; left > 0;) {
      const std::size_t offset = i % word_bits,
                        count = (std::min<std::size_t>)(left, word_bits - offset);
      words_[i / word_bits] |= (~Word(0) >> (word_bits - count)) << offset;
      i += count;
      left -= count;
    }
  }

  /// the bits of a word of a row, and then those `shift` columns further.
  Word word(int row, int word, int shift) const {
    const Word* w = &words_[shape_.row_start(row) + word + 1];
    if(shift == 0)
      return w[0];
    return shift > 0 ? (w[0] >> shift) | (w[1] << (word_bits - shift))
                     : (w[0] << -shift) | (w[-1] >> (word_bits + shift));
  }

private:
  Slice_shape shape_;
  std::vector<Word> words_;
};

/// The vertices on the lattice edges that start at the points of a slice, by direction.
using Edge_vertices = std::vector<std::uint32_t>; // only those of crossed edges are ever touched

/// Sweeps the lattice slice by slice; two slices are in memory.
class Marcher
{
public:
  Marcher(const Field& field, double spacing, Soup& soup)
      : field_(field)
      , soup_(soup)
      , lattice_(field.box(), spacing)
      , shape_{lattice_.rows() + 2, lattice_.columns() / word_bits + 3}
      , lower_(shape_)
      , upper_(shape_)
      , in_lower_(shape_.size_in_words() * word_bits * last_flat_direction)
      , in_upper_(in_lower_.size())
      , between_(shape_.size_in_words() * word_bits * (7 - last_flat_direction)) {}

  void march() {
    for(int slice = -1; slice < lattice_.slices(); ++slice) {
      look_at(soup_);
      sample(slice + 1);
      for(int direction = 1; direction <= last_flat_direction; ++direction)
        place_vertices(slice + 1, direction, upper_, upper_, in_upper_);
      for(int direction = last_flat_direction + 1; direction <= 7; ++direction)
        place_vertices(slice, direction, lower_, upper_, between_);
      connect_vertices();
      std::swap(lower_, upper_);
      std::swap(in_lower_, in_upper_);
    }
  }

private:
  // Directions are sums of a1, a2, a3, coded as corners of a cell: those without a3 stay in a
  // slice.
  static constexpr int last_flat_direction = 3;

  std::uint32_t& vertex(Edge_vertices& vertices, int column, int row, int direction) {
    const std::size_t entry = shape_.entry(column, row);
    return direction > last_flat_direction
               ? vertices[entry * (7 - last_flat_direction) + (direction - last_flat_direction - 1)]
               : vertices[entry * last_flat_direction + (direction - 1)];
  }

  /// finds the points of a slice that are inside, stepping along the rows by the distance to the
  /// surface that the field grants.
  void sample(int slice) {
    upper_.clear();
    if(slice >= lattice_.slices())
      return;
    for(int row = 0; row < lattice_.rows(); ++row) {
      auto [column, end] = lattice_.columns_inside(row, slice);
      while(column < end) {
        const double value = field_(lattice_.point(column, row, slice));
        const double free_steps = 0.99 * std::abs(value) / lattice_.column_length();
        const int next = column + 1 + static_cast<int>((std::min)(free_steps, double(end)));
        if(value < 0.)
          upper_.set(row, column, (std::min)(next, end));
        column = next;
      }
    }
  }

  /// makes the vertices on the crossed edges along a direction from the points of the slice `from`
  /// to those of the slice `to`.
  void place_vertices(int slice,
                      int direction,
                      const Inside_bits& from,
                      const Inside_bits& to,
                      Edge_vertices& vertices) {
    const Lattice_step step = Bcc_lattice::step_to_corner(direction);
    for(int row = -1; row + step.row + 1 < shape_.rows; ++row)
      for(int word = 0; word < shape_.words; ++word) {
        Word crossed = from.word(row, word, 0) ^ to.word(row + step.row, word, step.column);
        for(; crossed != 0; crossed &= crossed - 1) {
          const auto bit = static_cast<int>(boost::multiprecision::lsb(crossed));
          const int column = (word - 1) * word_bits + bit;
          const Vector from_point = lattice_.point(column, row, slice);
          const Vector to_point =
              lattice_.point(column + step.column, row + step.row, slice + step.slice);
          vertex(vertices, column, row, direction) = add_point(soup_, (from_point + to_point) / 2.);
        }
      }
  }

  void connect_vertices() {
    for(int row = -1; row + 2 < shape_.rows; ++row)
      for(int word = 0; word < shape_.words; ++word) {
        std::array<Word, 8> corners;
        Word any = 0, all = ~Word(0);
        for(int c = 0; c < 8; ++c) {
          const Lattice_step step = Bcc_lattice::step_to_corner(c);
          const Inside_bits& bits = step.slice == 0 ? lower_ : upper_;
          corners[c] = bits.word(row + step.row, word, step.column);
          any |= corners[c];
          all &= corners[c];
        }
        for(Word mixed = any & ~all; mixed != 0; mixed &= mixed - 1) {
          const auto bit = static_cast<int>(boost::multiprecision::lsb(mixed));
          unsigned inside = 0;
          for(int c = 0; c < 8; ++c)
            inside |= ((corners[c] >> bit) & 1) << c;
          emit_cell((word - 1) * word_bits + bit, row, inside);
        }
      }
  }

  void emit_cell(int column, int row, unsigned inside) {
    static const Table table = make_table();
    for(const Cell_triangle& triangle : table[inside]) {
      std::array<std::uint32_t, 3> vertices;
      for(int i = 0; i < 3; ++i) {
        const Lattice_step step = Bcc_lattice::step_to_corner(triangle[i].base);
        const int direction = triangle[i].direction;
        Edge_vertices& edges = direction > last_flat_direction ? between_
                               : step.slice == 0               ? in_lower_
                                                               : in_upper_;
        vertices[i] = vertex(edges, column + step.column, row + step.row, direction);
      }
      soup_.triangles.push_back(vertices);
    }
  }

  const Field& field_;
  Soup& soup_;
  Bcc_lattice lattice_;
  Slice_shape shape_;
  Inside_bits lower_, upper_;
  Edge_vertices in_lower_, in_upper_, between_;
};

} // namespace

Soup isosurface(const Field& field, double spacing, std::size_t expected_faces) {
  Soup soup;
  soup.points.reserve(expected_faces / 2);
  soup.triangles.reserve(expected_faces);
  Marcher(field, spacing, soup).march();
  return soup;
}

} // namespace CGAL::Handle_tunnel_loops::generators
