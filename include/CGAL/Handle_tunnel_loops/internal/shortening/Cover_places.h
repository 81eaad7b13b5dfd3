// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_COVER_PLACES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_COVER_PLACES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Vertices with the numbers of ways to them, found by both: a hash table with a place for so many
/// that half of it stays free. It keeps its memory.
class Cover_places
{
public:
  struct Place
  {
    Index vertex;
    std::uint64_t number;

    bool operator==(const Place& p) const { return vertex == p.vertex && number == p.number; }
  };

  explicit Cover_places(int binary_logarithm_of_size)
      : shift_(63 - binary_logarithm_of_size)
      , table_(std::size_t(2) << binary_logarithm_of_size, no_index) {}

  /// in the order in which they were added.
  std::size_t size() const { return places_.size(); }
  const Place& operator[](Index i) const { return places_[i]; }

  Index find(const Place& place) const { return table_[slot(place)]; }

  /// a place that is not there yet.
  void add(const Place& place) {
    slots_.push_back(slot(place));
    table_[slots_.back()] = static_cast<Index>(places_.size());
    places_.push_back(place);
  }

  /// takes as long as adding them took.
  void clear() {
    for(const std::size_t s : slots_)
      table_[s] = no_index;
    slots_.clear();
    places_.clear();
  }

private:
  // Where it is, or belongs.
  std::size_t slot(const Place& place) const {
    const std::uint64_t mixed = (place.number ^ (place.vertex * UINT64_C(0x9e3779b97f4a7c15)));
    std::size_t s = std::size_t((mixed * UINT64_C(0xd6e8feb86659fd93)) >> shift_);
    while(table_[s] != no_index && !(places_[table_[s]] == place))
      s = s + 1 == table_.size() ? 0 : s + 1;
    return s;
  }

  int shift_;
  std::vector<Index> table_; // the numbers of places
  std::vector<Place> places_;
  std::vector<std::size_t> slots_; // by place
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_COVER_PLACES_H
