// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FACE_PIECES_H
#define HTLOOPS_FACE_PIECES_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace htloops {

/// Pieces of faces that have been joined, and which faces of a piece have to be turned for all to
/// agree. Disjoint sets, with a parity for each face.
class Face_pieces
{
public:
  explicit Face_pieces(std::size_t number_of_faces);

  /// puts two faces into one piece, which agree as they are or if one of them is turned. False if
  /// they are of one piece already and it says otherwise; then nothing is changed.
  bool join(std::uint32_t f, std::uint32_t g, bool must_turn);

  /// a face that stands for the piece, always the same until the next call of `join()`.
  std::uint32_t piece(std::uint32_t f) { return find(f).root; }
  std::size_t size_of_piece(std::uint32_t f) { return sizes_[find(f).root]; }

  /// for each face whether it has to be turned: the fewer of each piece; if they are as many as the
  /// others, not the first.
  std::vector<bool> turned_faces();

private:
  struct Position
  {
    std::uint32_t root;
    bool is_turned; // against the root
  };

  Position find(std::uint32_t f);

  std::vector<std::uint32_t> parents_;
  std::vector<std::uint32_t> sizes_; // of roots
  std::vector<bool> is_turned_;      // against the parent
};

} // namespace htloops

#endif // HTLOOPS_FACE_PIECES_H
