// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_FRONT_LAYERS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_FRONT_LAYERS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/Contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Front_history.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Saddle_contours.h>
#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>

#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The way from each vertex to the end of its layer.

A layer is an arc of the Reeb graph of the arrival times: the contours that one front is while
nothing happens to it. It ends at a maximum, or as one of the contours just below a saddle. The
front that passes a vertex goes up an edge to a later neighbour, and as long as no contour just
below a saddle crosses that edge, it comes to the neighbour and passes that one too; if there are
such contours, the front is the earliest of them. So each vertex has a link to a neighbour or to an
end, and following the links leads to the end of its layer. Only arrival keys are compared.

The edge that a front goes up is the first one after the earlier neighbours, counterclockwise. A
saddle has several, one for each gap between its lower components; it lies itself in the layer that
ends at its first lower component. Ends are numbered after the vertices: the lower components of all
saddles, of which the first one stands for its contour, then the maxima.
*/
struct Layer_links
{
  Saddle_arrays saddles;
  Span<Index> link;  ///< by vertex, a neighbour or an end
  Span<Index> first; ///< by vertex, then by gap: the earliest contour that crosses the edge up

  CGAL_HTL_HOST_DEVICE Index number_of_vertices() const { return static_cast<Index>(link.size()); }
  CGAL_HTL_HOST_DEVICE bool is_end(Index target) const { return target >= number_of_vertices(); }
  CGAL_HTL_HOST_DEVICE Index number_of_end(Index target) const {
    return target - number_of_vertices();
  }
  /// the end at a lower component, in `link`, and the gap after it, in `first`.
  CGAL_HTL_HOST_DEVICE Index after_vertices(Index lower_component) const {
    return number_of_vertices() + lower_component;
  }

  CGAL_HTL_HOST_DEVICE bool is_earlier(Index u, Index v) const {
    return arrival_key(saddles.time[u], u) < arrival_key(saddles.time[v], v);
  }

  /// the position of the neighbour that the front goes up to from `v`; at a minimum, the first.
  CGAL_HTL_HOST_DEVICE Index way_up(Index v) const {
    const Ring ring = saddles.mesh.ring(v);
    for(Index p = 0; p < ring.size(); ++p)
      if(is_earlier(ring[ring.previous(p)], v) && is_earlier(v, ring[p]))
        return p;
    return 0;
  }
};

/// Links each vertex to the neighbour that its front goes up to.
struct Link_up
{
  Layer_links links;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    links.link[v] = links.saddles.mesh.ring(v)[links.way_up(v)];
  }
};

/// Links the saddles and the maxima to their ends.
struct Link_to_ends
{
  Layer_links links;
  Span<const Index> vertices, ends;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const { links.link[vertices[i]] = ends[i]; }
};

/// Walks the contours just below the saddles, one thread for each lower component, and notes the
/// earliest one on each edge that a front goes up: lower components are numbered in the order of
/// the sweep.
struct Note_contours
{
  Layer_links links;
  Span<const Index> saddle_of_lower_component;

  CGAL_HTL_HOST_DEVICE void operator()(Index lower_component) const {
    const Index saddle = saddle_of_lower_component[lower_component],
                begin = links.saddles.begin[saddle];
    const Saddle_view view = links.saddles.saddle(saddle);
    const Index contour = begin + view.cycles().first_of_contour(lower_component - begin);
    const auto note_at = [&](const Crossing& c) { note(c.left, c.right, contour); };
    view.join(lower_component - begin, lower_component - begin, note_at);
    view.trace_arc(lower_component - begin, note_at);
  }

private:
  // The edge is one that a front goes up if an earlier neighbour is behind it, or, at a minimum,
  // where there are none, if it is the first.
  CGAL_HTL_HOST_DEVICE void note(Index from, Index to, Index contour) const {
    const auto& mesh = links.saddles.mesh;
    const Index previous = internal::before(mesh.ring(from), mesh.ring(to), from, to);
    if(links.is_earlier(previous, from) || (mesh.ring(from)[0] == to && links.way_up(from) == 0))
      fetch_min(links.first[edge_up(from, previous)], contour);
  }

  // The place of the edge that follows upon an earlier neighbour.
  CGAL_HTL_HOST_DEVICE Index edge_up(Index from, Index previous) const {
    if(!links.is_end(links.link[from]))
      return from;
    const Ring ring = links.saddles.mesh.ring(from);
    Index lower_component = links.number_of_end(links.link[from]);
    while(ring[links.saddles.lower_components[lower_component].last] != previous)
      ++lower_component;
    return links.after_vertices(lower_component);
  }
};

/// Links a vertex to the contour that its front is, where there is one.
struct Link_to_contours
{
  Layer_links links;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    if(!links.is_end(links.link[v]) && links.first[v] != no_index)
      links.link[v] = links.after_vertices(links.first[v]);
  }
};

/// Follows the links to the ends by pointer jumping, as a program for `run_steps()`.
class Follow_links : public Rounds
{
public:
  Follow_links(const Layer_links& links, const Span<std::uint32_t>& changed)
      : Rounds(changed)
      , links_(links) {}

  CGAL_HTL_HOST_DEVICE Index size(const State&) const { return links_.number_of_vertices(); }

  // A link that another thread has changed meanwhile is as good, and shorter.
  CGAL_HTL_HOST_DEVICE void operator()(Index v, const State& state) const {
    const Index next = racy_load(links_.link[v]);
    if(links_.is_end(next))
      return;
    racy_store(links_.link[v], racy_load(links_.link[next]));
    note_change(state);
  }

private:
  Layer_links links_;
};

/// The numbers of the ends of the layers in which vertices lie.
struct Ends_at_vertices
{
  Layer_links links;
  Span<const Index> vertices;
  Span<Index> end;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    end[i] = links.number_of_end(links.link[vertices[i]]);
  }
};

/// The numbers of the ends of the layers that begin just above the saddles, by gap.
struct Ends_above_gaps
{
  Layer_links links;
  Span<const Index> saddle_of_lower_component;
  Span<Index> end;

  CGAL_HTL_HOST_DEVICE void operator()(Index lower_component) const {
    const Index contour = links.first[links.after_vertices(lower_component)];
    end[lower_component] = contour != no_index
                               ? contour
                               : links.number_of_end(links.link[neighbor_up(lower_component)]);
  }

private:
  CGAL_HTL_HOST_DEVICE Index neighbor_up(Index lower_component) const {
    const Ring ring =
        links.saddles.mesh.ring(links.saddles.saddles[saddle_of_lower_component[lower_component]]);
    return ring[ring.next(links.saddles.lower_components[lower_component].last)];
  }
};

/// Replaces the end of each vertex by the number of its layer.
struct Number_layers
{
  Layer_links links;
  Span<const Index> layer_of_end;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    links.link[v] = layer_of_end[links.number_of_end(links.link[v])];
  }
};

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
    return {minima_,
            ends_of_minima(),
            saddles_.keys(),
            saddles_.begins(),
            saddles_.lower_components(),
            linked_fronts(),
            ends_above_gaps(),
            maxima_,
            lengths_of_closing_fronts()};
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

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_FRONT_LAYERS_H
