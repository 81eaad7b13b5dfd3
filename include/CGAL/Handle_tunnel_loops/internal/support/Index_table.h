// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_TABLE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_TABLE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A number for each of some indices, wherever these are: a hash table without pointers, which is
/// copied as fast as memory is.
class Index_table
{
public:
  /// the number of an index, or null.
  const Index* find(Index index) const {
    if(slots_.empty())
      return nullptr;
    const Slot& slot = slots_[place(index)];
    return slot.index == index ? &slot.number : nullptr;
  }

  /// a number for an index that has none yet. Returns its number, which stays in place until the
  /// next call, and whether it is new.
  std::pair<Index*, bool> insert(Index index, Index number) {
    if(2 * (size_ + 1) > slots_.size())
      grow();
    Slot& slot = slots_[place(index)];
    const bool is_new = slot.index == no_index;
    if(is_new) {
      slot = {index, number};
      ++size_;
    }
    return {&slot.number, is_new};
  }

private:
  struct Slot
  {
    Index index = no_index, number = 0;
  };

  // Where an index is, or would be.
  std::size_t place(Index index) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = (std::uint64_t(index) * 0x9e3779b97f4a7c15u >> 32) & mask;
    while(slots_[i].index != index && slots_[i].index != no_index)
      i = (i + 1) & mask;
    return i;
  }

  void grow() {
    std::vector<Slot> before(slots_.empty() ? 64 : 2 * slots_.size()); // a power of two
    before.swap(slots_);
    for(const Slot& slot : before)
      if(slot.index != no_index)
        slots_[place(slot.index)] = slot;
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SUPPORT_INDEX_TABLE_H
