// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_CONTOURS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_CONTOURS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/saddles/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Critical_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Handle_candidate.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

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

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_CONTOURS_H
