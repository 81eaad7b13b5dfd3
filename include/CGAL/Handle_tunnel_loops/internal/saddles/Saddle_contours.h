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

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

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
      , lower_components_(executor.template make<Lower_component>(begins_.back())) {
    executor_.for_each(keys_.size(), Walk_contours{arrays()});
  }

  /// the arrival keys of the saddles.
  const std::vector<std::uint64_t>& keys() const { return keys_; }

  /// by saddle, its first lower component; and how many there are.
  const std::vector<Index>& begins() const { return begins_; }

  std::vector<Lower_component> lower_components() const {
    return downloaded(executor_, lower_components_);
  }

  Saddle_arrays arrays() const {
    return {mesh_, time_, saddles_.span(), begin_.span(), lower_components_.span()};
  }

private:
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
  Buffer<Lower_component> lower_components_;
};

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_SADDLE_CONTOURS_H
