#ifndef HTL_TEST_LABEL_FRONT_H
#define HTL_TEST_LABEL_FRONT_H

#include "Front_labels.h"

#include <CGAL/Handle_tunnel_loops/internal/device/domains.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>

#include <cstddef>
#include <cstdint>
#include <vector>

// A device labels the parts of a front, which the passes have no need of: a test of what executors
// provide for programs of many rounds.

namespace front_labels {

// The label of each position in the rings: `no_index` for those that are no triangle of the front
// at a level, see `Front`. Takes four bytes per position and eight per triangle of the front.
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

// The same for a mesh and times that are not there yet.
template <typename Executor>
std::vector<Index>
label_front(Executor& executor, const Flat_mesh& mesh, const std::vector<Time>& times, Time level) {
  const device::Device_mesh<Executor> on_device(executor, view_of(mesh));
  const auto time = uploaded(executor, times);
  return label_front(executor, on_device.view(), time.span(), level);
}

} // namespace front_labels

#endif // HTL_TEST_LABEL_FRONT_H
