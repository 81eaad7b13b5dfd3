// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_LABEL_FRONT_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_LABEL_FRONT_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Front_labels.h>
#include <CGAL/Handle_tunnel_loops/internal/device/buffers.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace device {

/// the label of each position in the rings: `no_index` for those that are no triangle of the front
/// at a level, see `Front`. Takes four bytes per position and eight per triangle of the front.
template <typename Executor>
std::vector<Index>
label_front(Executor& executor, const Mesh_view& mesh, const Span<const Time>& time, Time level) {
  const Front front(mesh, time, level);
  const auto label = executor.template make<Index>(mesh.neighbor.size());
  const auto number = filled(executor, 1, Index(0));
  const auto collect = [&](const Span<Front_pair>& pairs) {
    executor.fill(number.span(), Index(0));
    executor.for_each(mesh.number_of_vertices(),
                      Collect_front{front, label.span(), pairs, number.span().data()});
  };
  collect({});
  const auto pairs = executor.template make<Front_pair>(downloaded(executor, number)[0]);
  collect(pairs.span());
  const auto changed = filled(executor, 3, std::uint32_t(0));
  executor.run(Label_front(pairs.span(), label.span(), changed.span()), pairs.span().size());
  return downloaded(executor, label);
}

} // namespace device
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_LABEL_FRONT_H
