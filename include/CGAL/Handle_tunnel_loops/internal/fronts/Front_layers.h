// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LAYERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LAYERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/fronts/Front_history.h>
#include <CGAL/Handle_tunnel_loops/internal/fronts/Front_log.h>
#include <CGAL/Handle_tunnel_loops/internal/fronts/Layer_links.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Saddle_contours.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Finds the layers of the fronts of a sweep, and what happens to the fronts.

All contours just below saddles are walked, once for the layers and once for the lengths, and not
kept: memory is eight bytes per vertex, and what the saddles take.
*/
template <typename Executor> class Front_layers
{
  template <typename T> using Buffer = typename Executor::template Buffer<T>;

public:
  /// \p mesh is \p host_mesh in the memory of the executor, as the times are.
  Front_layers(Executor& executor,
               const Flat_mesh& host_mesh,
               const Mesh_view& mesh,
               const Span<const Time>& time)
      : executor_(executor)
      , host_mesh_(host_mesh)
      , mesh_(mesh)
      , time_(time)
      , saddles_(executor, mesh, time)
      , minima_(critical_vertices(executor, mesh, time, Critical_kind::MINIMUM))
      , maxima_(critical_vertices(executor, mesh, time, Critical_kind::MAXIMUM))
      , saddle_of_lower_component_(uploaded(executor, saddles_of_lower_components()))
      , link_(executor.template make<Index>(mesh.number_of_vertices()))
      , first_(
            filled(executor, mesh.number_of_vertices() + number_of_lower_components(), no_index)) {}

  Front_log run() {
    follow_fronts();
    Front_history history(host_mesh_, walked_fronts());
    const Buffer<Index> layers = uploaded(executor_, history.layer_of_end());
    executor_.for_each(link_.span().size(), Number_layers{links(), layers.span()});
    return {history.take_events(), downloaded(executor_, link_)};
  }

private:
  Layer_links links() const { return {saddles_.arrays(), link_.span(), first_.span()}; }

  Index number_of_lower_components() const { return saddles_.begins().back(); }

  std::vector<Index> saddles_of_lower_components() const {
    std::vector<Index> saddles;
    for(Index i = 0; i < saddles_.keys().size(); ++i)
      saddles.resize(saddles_.begins()[i + 1], i);
    return saddles;
  }

  // Leads each vertex to the end of its layer.
  void follow_fronts() {
    const std::size_t n = mesh_.number_of_vertices();
    executor_.for_each(n, Link_up{links()});
    link_critical_vertices();
    executor_.for_each(number_of_lower_components(),
                       Note_contours{links(), saddle_of_lower_component_.span()});
    executor_.for_each(n, Link_to_contours{links()});
    const Buffer<std::uint32_t> changed = filled(executor_, 3, std::uint32_t(0));
    executor_.run(Follow_links(links(), changed.span()), n);
  }

  void link_critical_vertices() {
    std::vector<Index> vertices = vertices_of(saddles_.keys()), ends;
    const std::vector<Index> maxima = vertices_of(maxima_);
    const Index n = static_cast<Index>(mesh_.number_of_vertices());
    for(Index i = 0; i < vertices.size(); ++i)
      ends.push_back(n + saddles_.begins()[i]);
    for(Index i = 0; i < maxima.size(); ++i)
      ends.push_back(n + number_of_lower_components() + i);
    vertices.insert(vertices.end(), maxima.begin(), maxima.end());
    const Buffer<Index> places = uploaded(executor_, vertices), values = uploaded(executor_, ends);
    executor_.for_each(vertices.size(), Link_to_ends{links(), places.span(), values.span()});
  }

  Walked_fronts walked_fronts() {
    return {{minima_, ends_of_minima()},
            {saddles_.keys(), saddles_.begins(), saddles_.lower_components(), linked_fronts(),
             ends_above_gaps()},
            {maxima_, lengths_of_closing_fronts()}};
  }

  std::vector<Index> ends_of_minima() {
    const Buffer<Index> vertices = uploaded(executor_, vertices_of(minima_));
    const Buffer<Index> ends = executor_.template make<Index>(minima_.size());
    executor_.for_each(minima_.size(), Ends_at_vertices{links(), vertices.span(), ends.span()});
    return downloaded(executor_, ends);
  }

  std::vector<Index> ends_above_gaps() {
    const Buffer<Index> ends = executor_.template make<Index>(number_of_lower_components());
    executor_.for_each(number_of_lower_components(),
                       Ends_above_gaps{links(), saddle_of_lower_component_.span(), ends.span()});
    return downloaded(executor_, ends);
  }

  std::vector<Linked_fronts> linked_fronts() {
    const Buffer<Measured_curve> arcs =
        executor_.template make<Measured_curve>(number_of_lower_components());
    executor_.for_each(
        number_of_lower_components(),
        Measure_arcs{saddles_.arrays(), saddle_of_lower_component_.span(), arcs.span()});
    const Buffer<Linked_fronts> fronts =
        filled(executor_, number_of_lower_components(), Linked_fronts());
    executor_.for_each(number_of_lower_components(),
                       Measure_links{saddles_.arrays(), saddle_of_lower_component_.span(),
                                     arcs.span(), fronts.span()});
    return downloaded(executor_, fronts);
  }

  std::vector<double> lengths_of_closing_fronts() {
    const Buffer<Index> vertices = uploaded(executor_, vertices_of(maxima_));
    const Buffer<double> lengths = executor_.template make<double>(maxima_.size());
    executor_.for_each(maxima_.size(), Measure_closings{mesh_, vertices.span(), lengths.span()});
    return downloaded(executor_, lengths);
  }

  Executor& executor_;
  const Flat_mesh& host_mesh_;
  Mesh_view mesh_;
  Span<const Time> time_;
  Saddle_contours<Executor> saddles_;
  std::vector<std::uint64_t> minima_, maxima_; // arrival keys
  Buffer<Index> saddle_of_lower_component_;
  Buffer<Index> link_, first_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FRONTS_FRONT_LAYERS_H
