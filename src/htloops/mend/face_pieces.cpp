// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/face_pieces.h"

#include <numeric>
#include <utility>

namespace htloops {

Face_pieces::Face_pieces(std::size_t number_of_faces)
    : parents_(number_of_faces)
    , sizes_(number_of_faces, 1)
    , is_turned_(number_of_faces, false) {
  std::iota(parents_.begin(), parents_.end(), 0u);
}

// Halves the way to the root as it goes.
Face_pieces::Position Face_pieces::find(std::uint32_t f) {
  bool is_turned = false;
  while(parents_[f] != f) {
    const std::uint32_t parent = parents_[f];
    if(parents_[parent] != parent) {
      is_turned_[f] = is_turned_[f] != is_turned_[parent];
      parents_[f] = parents_[parent];
    }
    is_turned = is_turned != is_turned_[f];
    f = parents_[f];
  }
  return {f, is_turned};
}

bool Face_pieces::join(std::uint32_t f, std::uint32_t g, bool must_turn) {
  Position a = find(f), b = find(g);
  const bool is_turned = (a.is_turned != b.is_turned) != must_turn;
  if(a.root == b.root)
    return !is_turned;
  if(sizes_[a.root] < sizes_[b.root])
    std::swap(a, b);
  parents_[b.root] = a.root;
  is_turned_[b.root] = is_turned;
  sizes_[a.root] += sizes_[b.root];
  return true;
}

std::vector<bool> Face_pieces::turned_faces() {
  const auto number_of_faces = static_cast<std::uint32_t>(parents_.size());
  std::vector<std::uint32_t> number_turned(number_of_faces, 0);
  std::vector<bool> is_seen(number_of_faces, false), is_first_turned(number_of_faces, false);
  for(std::uint32_t f = 0; f < number_of_faces; ++f) {
    const Position at = find(f);
    number_turned[at.root] += at.is_turned ? 1 : 0;
    if(!is_seen[at.root])
      is_first_turned[at.root] = at.is_turned;
    is_seen[at.root] = true;
  }
  std::vector<bool> is_turned(number_of_faces);
  for(std::uint32_t f = 0; f < number_of_faces; ++f) {
    const Position at = find(f);
    const std::size_t others = sizes_[at.root] - number_turned[at.root];
    const bool are_most_turned = number_turned[at.root] > others ||
                                 (number_turned[at.root] == others && is_first_turned[at.root]);
    is_turned[f] = at.is_turned != are_most_turned;
  }
  return is_turned;
}

} // namespace htloops
