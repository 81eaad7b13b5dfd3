// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_VERTEX_SUBSET_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_VERTEX_SUBSET_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Some of the vertices, counted in their order. It takes two bits for each vertex of the mesh, so
/// that arrays of what few vertices have need not have a place for all.
class Vertex_subset
{
public:
  /// of the vertices below a number; none of them yet.
  explicit Vertex_subset(std::size_t number_of_vertices)
      : blocks_(number_of_vertices / 64 + 1) {}

  /// Once all are in, `count()` has to be called.
  void insert(Index v) { blocks_[v / 64].members |= bit(v); }

  void count() {
    for(Block& block : blocks_) {
      block.before = size_;
      size_ += number_of_bits(block.members);
    }
  }

  Index size() const { return size_; }

  bool contains(Index v) const { return (blocks_[v / 64].members & bit(v)) != 0; }

  /// how many of them are before `v`, which may be one after the last vertex: of those there are,
  /// the numbers from 0 on.
  Index number_before(Index v) const {
    const Block& block = blocks_[v / 64];
    return block.before + number_of_bits(block.members & (bit(v) - 1));
  }

  /// all of them, in order.
  std::vector<Index> vertices() const {
    std::vector<Index> all;
    all.reserve(size_);
    for(std::size_t i = 0; i < blocks_.size(); ++i)
      for(std::uint64_t left = blocks_[i].members; left != 0; left &= left - 1)
        all.push_back(static_cast<Index>(64 * i + number_of_bits(~left & (left - 1))));
    return all;
  }

private:
  struct Block
  {
    std::uint64_t members = 0; // as bits
    Index before = 0;          // in the blocks before
  };

  static std::uint64_t bit(Index v) { return std::uint64_t(1) << (v % 64); }

  // Sums of neighboring bits, of pairs, of fours. `std::bitset` has them counted by a function that
  // is not inlined, unless it is compiled for one kind of processor.
  static Index number_of_bits(std::uint64_t bits) {
    bits -= bits >> 1 & 0x5555555555555555u;
    bits = (bits & 0x3333333333333333u) + (bits >> 2 & 0x3333333333333333u);
    bits = (bits + (bits >> 4)) & 0x0f0f0f0f0f0f0f0fu;
    return static_cast<Index>(bits * 0x0101010101010101u >> 56);
  }

  std::vector<Block> blocks_;
  Index size_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_VERTEX_SUBSET_H
