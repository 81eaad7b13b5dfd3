// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "isosurface.h"

#include "Bcc_lattice.h"
#include "marching_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

using Word = std::uint64_t;
constexpr int word_bits = 64;

/// the position of the lowest bit of a word that is not zero.
int lowest_bit(Word word) {
#if defined(__GNUC__)
  return __builtin_ctzll(word);
#else
  int bit = 0;
  for(; (word & 1) == 0; word >>= 1)
    ++bit;
  return bit;
#endif
}

/// The extent of the tables of a slice: the lattice's rows and columns with a margin, so that all
/// neighbours of a point of the lattice have an entry.
class Slice_shape
{
public:
  explicit Slice_shape(const Bcc_lattice& lattice)
      : rows_(lattice.rows() + 2)
      , words_(lattice.columns() / word_bits + 3) {}

  int rows() const { return rows_; }
  int words() const { return words_; } ///< per row
  std::size_t size_in_words() const { return std::size_t(rows_) * words_; }
  std::size_t row_start(int row) const { return std::size_t(row + 1) * words_; } ///< in words

  /// the entry of a point; word 0 of a row is margin.
  std::size_t entry(int column, int row) const { return (row_start(row) + 1) * word_bits + column; }
  std::size_t size() const { return size_in_words() * word_bits; }

private:
  int rows_, words_;
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
class Edge_vertices
{
public:
  Edge_vertices(const Slice_shape& shape, int first_direction, int last_direction)
      : shape_(shape)
      , first_(first_direction)
      , count_(last_direction - first_direction + 1)
      , vertices_(shape.size() * count_) {}

  std::uint32_t& operator()(int column, int row, int direction) {
    return vertices_[shape_.entry(column, row) * count_ + (direction - first_)];
  }

private:
  Slice_shape shape_;
  std::size_t first_, count_;
  std::vector<std::uint32_t> vertices_; // only those of crossed edges are ever written or read
};

/// Sweeps the lattice slice by slice; two slices are in memory.
class Marcher
{
public:
  Marcher(const Field& field, double spacing, Soup& soup)
      : field_(field)
      , soup_(soup)
      , lattice_(field.box(), spacing)
      , shape_(lattice_)
      , lower_(shape_)
      , upper_(shape_)
      , in_lower_(shape_, 1, last_flat_direction)
      , in_upper_(shape_, 1, last_flat_direction)
      , between_(shape_, last_flat_direction + 1, 7) {}

  void march() {
    for(int slice = -1; slice < lattice_.slices(); ++slice) {
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
    for(int row = -1; row + step.row + 1 < shape_.rows(); ++row)
      for(int word = 0; word < shape_.words(); ++word) {
        Word crossed = from.word(row, word, 0) ^ to.word(row + step.row, word, step.column);
        for(; crossed != 0; crossed &= crossed - 1) {
          const int column = (word - 1) * word_bits + lowest_bit(crossed);
          vertices(column, row, direction) = static_cast<std::uint32_t>(soup_.points.size());
          const Vector from_point = lattice_.point(column, row, slice);
          const Vector to_point =
              lattice_.point(column + step.column, row + step.row, slice + step.slice);
          const Vector middle = (from_point + to_point) / 2.;
          soup_.points.push_back({middle.x(), middle.y(), middle.z()});
        }
      }
  }

  void connect_vertices() {
    for(int row = -1; row + 2 < shape_.rows(); ++row)
      for(int word = 0; word < shape_.words(); ++word) {
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
          const int bit = lowest_bit(mixed);
          unsigned inside = 0;
          for(int c = 0; c < 8; ++c)
            inside |= ((corners[c] >> bit) & 1) << c;
          emit_cell((word - 1) * word_bits + bit, row, inside);
        }
      }
  }

  void emit_cell(int column, int row, unsigned inside) {
    for(const Cell_triangle& triangle : cell_triangles(inside)) {
      std::array<std::uint32_t, 3> vertices;
      for(int i = 0; i < 3; ++i) {
        const Lattice_step step = Bcc_lattice::step_to_corner(triangle[i].base);
        const int direction = triangle[i].direction;
        Edge_vertices& edges = direction > last_flat_direction ? between_
                               : step.slice == 0               ? in_lower_
                                                               : in_upper_;
        vertices[i] = edges(column + step.column, row + step.row, direction);
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

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
