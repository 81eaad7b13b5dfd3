// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_ORDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_ORDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// an integer that orders as the finite value does; the two zeros are one.
inline std::uint64_t ordering_key(double value) {
  value += 0.; // turns -0 into 0
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  constexpr std::uint64_t sign = std::uint64_t(1) << 63;
  return bits & sign ? ~bits : bits | sign;
}

template <typename Integer>
std::enable_if_t<std::is_integral<Integer>::value, std::uint64_t> ordering_key(Integer value) {
  constexpr std::uint64_t sign = std::uint64_t(1) << 63;
  return std::is_signed<Integer>::value
             ? static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) ^ sign
             : static_cast<std::uint64_t>(value);
}

/// A total order of the vertices: by their values, and by the caller's indices where these are
/// equal. So the order does not depend on how the flat mesh numbers its vertices.
class Sweep_order
{
public:
  /// \p key gives an unsigned integer for each vertex.
  template <typename Key>
  Sweep_order(Execution execution, const Flat_mesh& mesh, const Key& key)
      : vertices_(mesh.number_of_vertices())
      , rank_(mesh.number_of_vertices()) {
    std::vector<Entry> entries(mesh.number_of_vertices());
    for_each_index(execution, entries.size(), [&](std::size_t i) {
      const Index v = static_cast<Index>(i);
      entries[i] = {key(v), mesh.original[v], v};
    });
    sort(entries);
    CGAL_expensive_assertion(
        std::adjacent_find(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
          return std::make_pair(a.key, a.original) >= std::make_pair(b.key, b.original);
        }) == entries.end());
    for_each_index(execution, entries.size(), [&](std::size_t r) {
      vertices_[r] = entries[r].vertex;
      rank_[entries[r].vertex] = static_cast<Index>(r);
    });
  }

  /// the vertices, from the lowest to the highest.
  const std::vector<Index>& vertices() const { return vertices_; }

  Index rank(Index v) const { return rank_[v]; }

private:
  struct Entry
  {
    std::uint64_t key;
    Index original, vertex;
  };

  static void sort(std::vector<Entry>& entries) {
    boost::sort::spreadsort::integer_sort(
        entries.begin(), entries.end(),
        [](const Entry& e, unsigned shift) { return e.key >> shift; },
        [](const Entry& a, const Entry& b) { return a.key < b.key; });
    const auto by_index = [](const Entry& a, const Entry& b) { return a.original < b.original; };
    for(auto first = entries.begin(); first != entries.end();) {
      auto last = first + 1;
      while(last != entries.end() && last->key == first->key)
        ++last;
      std::sort(first, last, by_index);
      first = last;
    }
  }

  std::vector<Index> vertices_, rank_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_SWEEP_ORDER_H
