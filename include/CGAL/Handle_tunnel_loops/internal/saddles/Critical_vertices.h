// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_CRITICAL_VERTICES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_CRITICAL_VERTICES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/executors/atomics.h>
#include <CGAL/Handle_tunnel_loops/internal/executors/buffers.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/saddle_formulas.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// What begins or ends at a vertex: a contour, or several in one.
enum class Critical_kind { MINIMUM, SADDLE, MAXIMUM };

/// Counts the critical vertices of one kind, and lists as many as there is room for.
struct Find_critical
{
  Mesh_view mesh;
  Span<const Time> time;
  Critical_kind kind;
  Index* number;
  Span<std::uint64_t> keys; ///< time and vertex, unsorted

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    if(!is_of_kind(v))
      return;
    const Index place = next_place(*number);
    if(place < keys.size())
      keys[place] = arrival_key(time[v], v);
  }

private:
  CGAL_HTL_HOST_DEVICE bool is_of_kind(Index v) const {
    const Ring ring = mesh.ring(v);
    const std::uint64_t key = arrival_key(time[v], v);
    const auto is_earlier = [&](Index u) { return arrival_key(time[u], u) < key; };
    const Index lower_components = count_lower_components(ring, is_earlier);
    if(kind == Critical_kind::SADDLE)
      return lower_components > 1;
    return lower_components == 0 && is_earlier(ring[0]) == (kind == Critical_kind::MAXIMUM);
  }
};

/// the critical vertices of one kind as arrival keys, the earliest first.
template <typename Executor>
std::vector<std::uint64_t> critical_vertices(Executor& executor,
                                             const Mesh_view& mesh,
                                             const Span<const Time>& time,
                                             Critical_kind kind) {
  const auto number = filled(executor, 1, Index(0));
  const auto find = [&](std::size_t room) {
    auto keys = executor.template make<std::uint64_t>(room);
    executor.fill(number.span(), Index(0));
    executor.for_each(mesh.number_of_vertices(),
                      Find_critical{mesh, time, kind, number.span().data(), keys.span()});
    return keys;
  };
  auto keys = find(mesh.number_of_vertices() / 64 + 64); // mostly enough
  std::vector<std::uint64_t> sorted(downloaded(executor, number)[0]);
  if(sorted.size() > keys.span().size())
    keys = find(sorted.size());
  executor.download(sorted.data(), Span<std::uint64_t>(keys.span().data(), sorted.size()));
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// the vertices of arrival keys.
inline std::vector<Index> vertices_of(const std::vector<std::uint64_t>& keys) {
  std::vector<Index> vertices(keys.size());
  std::transform(keys.begin(), keys.end(), vertices.begin(),
                 [](std::uint64_t key) { return static_cast<Index>(key); });
  return vertices;
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_CRITICAL_VERTICES_H
