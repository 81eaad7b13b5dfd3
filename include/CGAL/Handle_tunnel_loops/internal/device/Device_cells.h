// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_CELLS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_CELLS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/device/Solver.h>
#include <CGAL/Handle_tunnel_loops/internal/device/cell_kernels.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// The first cells of a mesh, and what is around them. Of the second there is left open what is
/// rare and much work.
template <typename Executor> class Device_cells
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  Device_cells(Executor& executor, const Mesh_view& mesh, Costs& costs)
      : executor_(executor)
      , mesh_(mesh)
      , costs_(costs)
      , links_(executor.template make<Cell_link>(mesh.number_of_vertices()))
      , are_vertices_(executor.template make<char>(mesh.number_of_vertices())) {}

  /// Returns whether it has found them.
  bool find(First_cells& cells) {
    if(!grow(cells))
      return false;
    cells.are_begun = true;
    executor_.download(cells.links.data(), links_.span());
    executor_.download(cells.are_vertices.data(), are_vertices_.span());
    cells.find_centres(cells);
    look(cells);
    return true;
  }

private:
  bool grow(const First_cells& cells) {
    const std::size_t n = mesh_.number_of_vertices();
    const Buffer<Index> rounds = executor_.template make<Index>(n);
    const Growing_cells growing = {mesh_, links_.span(), rounds.span()};
    executor_.for_each(n, Start_cells{growing, are_vertices_.span(), cells.spacing, cells.first_hub,
                                      cells.number_of_hubs});
    const Buffer<Index> seeds = uploaded(executor_, cells.seeds);
    executor_.for_each(cells.seeds.size(), Start_at_seeds{growing, seeds.span()});
    const Buffer<std::uint32_t> changed = filled(executor_, 3, std::uint32_t(0));
    const Buffer<Index> are_more = executor_.template make<Index>(1);
    executor_.run(Grow_cells(growing, changed.span(), are_more.span()), n);
    executor_.for_each(n, Close_cells{growing, are_vertices_.span()});
    Index is_unfinished = 0;
    executor_.download(&is_unfinished, are_more.span());
    return is_unfinished == 0;
  }

  void look(First_cells& cells) {
    const Buffer<Index> centres = uploaded(executor_, cells.centres);
    const Buffer<Cell_look> looks = executor_.template make<Cell_look>(cells.looks.size());
    const Buffer<Cell_neighbor> neighbors =
        filled(executor_, cells.neighbors.size(), Cell_neighbor());
    const Buffer<Index> number = filled(executor_, 1, Index(0));
    costs_.largest_bytes = (std::max)(costs_.largest_bytes, executor_.bytes_in_use());
    const Cell_view view = {mesh_, links_.span(), are_vertices_.span()};
    executor_.for_each(cells.centres.size(), Look_at_cells{view, centres.span(), looks.span(),
                                                           neighbors.span(), number.span().data()});
    Index size = 0;
    executor_.download(&size, number.span());
    executor_.download(cells.looks.data(), looks.span());
    executor_.download(cells.neighbors.data(),
                       Span<Cell_neighbor>(neighbors.span().data(),
                                           (std::min<std::size_t>)(size, cells.neighbors.size())));
  }

  Executor& executor_;
  Mesh_view mesh_;
  Costs& costs_;
  Buffer<Cell_link> links_;
  Buffer<char> are_vertices_;
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_DEVICE_CELLS_H
