// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SADDLE_CONTOURS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SADDLE_CONTOURS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <algorithm>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

/// The saddles of a sweep in their order, with the contours that meet at them, in the memory of an
/// executor. The mesh and the times must outlive the object.
template <typename Executor> class Saddle_contours
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  Saddle_contours(Executor& executor, const Mesh_view& mesh, const Span<const Time>& time)
      : executor_(executor)
      , mesh_(mesh)
      , time_(time)
      , keys_(critical_vertices(executor, mesh, time, Critical_kind::SADDLE))
      , saddles_(uploaded(executor, vertices_of(keys_)))
      , begins_(lower_component_begins())
      , begin_(uploaded(executor, begins_))
      , lower_components_(executor.template make<Lower_component_arc>(begins_.back())) {
    executor_.for_each(keys_.size(), Walk_contours{arrays()});
  }

  /// the arrival keys of the saddles.
  const std::vector<std::uint64_t>& keys() const { return keys_; }

  /// by saddle, its first lower component; and how many there are.
  const std::vector<Index>& begins() const { return begins_; }

  std::vector<Lower_component_arc> lower_components() const {
    return downloaded(executor_, lower_components_);
  }

  /// the handles, in the order in which the saddles are reached.
  std::vector<Handle_candidate> handles() {
    const std::vector<Index> saddles = vertices_of(keys_);
    const std::vector<Lower_component_arc> arcs = lower_components();
    std::vector<Found_handle> found;
    std::vector<Handle_candidate> handles;
    Index size = 0;
    for(Index i = 0; i < saddles.size(); ++i)
      for(Index j = begins_[i]; j < begins_[i + 1]; ++j)
        if(arcs[j].handle_start != no_index) {
          found.push_back({i, j - begins_[i], size});
          handles.push_back({{}, saddles[i], arcs[j - 1].foot, arcs[j].foot});
          size += arcs[j].handle_size;
        }
    const std::vector<Crossing> crossings = traced(found, size);
    for(std::size_t h = 0; h < found.size(); ++h) {
      const Index end = h + 1 == found.size() ? size : found[h + 1].begin;
      handles[h].loop.assign(crossings.begin() + found[h].begin, crossings.begin() + end);
    }
    return handles;
  }

  Saddle_arrays arrays() const {
    return {mesh_, time_, saddles_.span(), begin_.span(), lower_components_.span()};
  }

private:
  // The crossings of all handles, one after the other.
  std::vector<Crossing> traced(const std::vector<Found_handle>& handles, std::size_t size) {
    const Buffer<Found_handle> list = uploaded(executor_, handles);
    const Buffer<Crossing> crossings = executor_.template make<Crossing>(size);
    executor_.for_each(handles.size(), Trace_handles{arrays(), list.span(), crossings.span()});
    return downloaded(executor_, crossings);
  }

  std::vector<Index> lower_component_begins() {
    const Buffer<Index> numbers = executor_.template make<Index>(keys_.size());
    executor_.for_each(keys_.size(),
                       Count_lower_components{mesh_, time_, saddles_.span(), numbers.span()});
    return begins_of(downloaded(executor_, numbers));
  }

  Executor& executor_;
  Mesh_view mesh_;
  Span<const Time> time_;
  std::vector<std::uint64_t> keys_;
  Buffer<Index> saddles_;
  std::vector<Index> begins_;
  Buffer<Index> begin_;
  Buffer<Lower_component_arc> lower_components_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_SADDLE_CONTOURS_H
