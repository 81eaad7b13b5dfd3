// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_CONTOUR_GIRTHS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_CONTOUR_GIRTHS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/contour_above.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A contour: the one just above a vertex, on the arc of that.
struct Girth_at
{
  Index vertex; ///< `no_index` on an arc without one
  float girth;
};

/*!
How long the contours of a function are along the arcs of its Reeb graph: of each arc the first and
the last one, and between them those that are shorter or longer than what is around them, in turns.

A contour is as long as the strip of faces that it passes through, by the middles of the edges that
it crosses. One of few edges becomes longer and shorter with each vertex that it passes; so lengths
are means over as much of the function as an edge is long, but at the ends of an arc. Where a
contour passes the hub of a cap, it is infinite.
*/
class Contour_girths
{
public:
  Contour_girths(const Flat_mesh& mesh,
                 const Sweep_order& order,
                 const std::vector<Star>& stars,
                 const Flat_reeb_graph& graph,
                 const std::vector<float>& function)
      : mesh_(mesh)
      , order_(order)
      , function_(function) {
    find_contours(stars, graph);
    std::vector<Girth_at> arc_contours;
    for(Index arc = 0; arc < graph.arcs.size(); ++arc) {
      begin_.push_back(static_cast<Index>(girths_.size()));
      smooth(arc, arc_contours);
      if(arc_contours.empty())
        girths_.push_back(
            {no_index, (std::max)(graph.arcs[arc].lower_girth, graph.arcs[arc].upper_girth)});
      else
        keep_turns(arc_contours);
    }
    begin_.push_back(static_cast<Index>(girths_.size()));
  }

  const std::vector<Girth_at>& all() const { return girths_; }
  Index first(Index arc) const { return begin_[arc]; }
  Index last(Index arc) const { return begin_[arc + 1] - 1; }

private:
  static constexpr float turn = 1.02f; // a smaller one is none

  // On each arc, in the order of the sweep.
  void find_contours(const std::vector<Star>& stars, const Flat_reeb_graph& graph) {
    raw_begin_.assign(graph.arcs.size() + 1, 0);
    const auto has_contour = [&](Index v) {
      return stars[v].kind == Vertex_kind::REGULAR || stars[v].kind == Vertex_kind::MINIMUM;
    };
    for(Index v = 0; v < graph.vertex_arc.size(); ++v)
      raw_begin_[graph.vertex_arc[v] + 1] += has_contour(v) ? 1 : 0;
    for(std::size_t i = 1; i < raw_begin_.size(); ++i)
      raw_begin_[i] += raw_begin_[i - 1];
    raw_.resize(raw_begin_.back());
    std::vector<Index> end(raw_begin_.begin(), raw_begin_.end() - 1);
    std::vector<double> girth(graph.arcs.size(), 0.);
    for(const Index v : order_.vertices())
      if(has_contour(v)) {
        const Index arc = graph.vertex_arc[v];
        girth[arc] = end[arc] == raw_begin_[arc] ? length_above(v) : girth[arc] + change_at(v);
        raw_[end[arc]++] = {v, static_cast<float>((std::max)(girth[arc], 0.))};
      }
  }

  // A face through which a contour passes counts with half of the edge that is not crossed.
  double length_above(Index v) const {
    double sum = 0.;
    Index left = v, right = no_index;
    for_each_crossing_above(mesh_, order_, v, [&](Index next_left, Index next_right) {
      if(right != no_index)
        sum += left == next_left ? mesh_.edge_length(right, next_right)
                                 : mesh_.edge_length(left, next_left);
      left = next_left;
      right = next_right;
    });
    return sum / 2.;
  }

  double change_at(Index v) const {
    double sum = 0.;
    const Ring ring = mesh_.ring(v);
    const auto is_lower = [&](Index u) { return order_.rank(u) < order_.rank(v); };
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      if(is_lower(a) == is_lower(b))
        sum += (is_lower(a) ? -1. : 1.) * mesh_.edge_length(a, b);
      else
        sum += (is_lower(a) ? 1. : -1.) * (mesh_.edge_length(v, a) - mesh_.edge_length(v, b));
    }
    return sum / 2.;
  }

  float edge_length_around(Index v) const {
    double sum = 0.;
    for(const Index u : mesh_.ring(v))
      sum += mesh_.edge_length(v, u);
    return static_cast<float>(sum / mesh_.ring(v).size());
  }

  void smooth(Index arc, std::vector<Girth_at>& contours) const {
    const std::size_t begin = raw_begin_[arc], end = raw_begin_[arc + 1];
    contours.clear();
    std::vector<double> sums = {0.};
    for(std::size_t i = begin; i < end; ++i)
      sums.push_back(sums.back() + raw_[i].girth);
    std::size_t low = begin, high = begin;
    for(std::size_t i = begin; i < end; ++i) {
      const Index v = raw_[i].vertex;
      const float half = 0.5f * edge_length_around(v);
      while(low < i && function_[raw_[low].vertex] < function_[v] - half)
        ++low;
      high = (std::max)(high, i);
      while(high + 1 < end && function_[raw_[high + 1].vertex] <= function_[v] + half)
        ++high;
      const std::size_t n = (std::min)(i - low, high - i), first = i - n - begin;
      contours.push_back(
          {v, static_cast<float>((sums[first + 2 * n + 1] - sums[first]) / double(2 * n + 1))});
    }
    for(Girth_at& contour : contours)
      if(mesh_.is_hub(contour.vertex))
        contour.girth = std::numeric_limits<float>::infinity();
  }

  // Goes up until it has come down by more than a little, and so on.
  void keep_turns(const std::vector<Girth_at>& contours) {
    std::size_t low = 0, high = 0, kept = 0;
    bool goes_up = true, goes_down = true;
    const auto keep = [&](std::size_t i) {
      if(i != kept)
        girths_.push_back(contours[i]);
      kept = i;
    };
    girths_.push_back(contours[0]);
    for(std::size_t i = 1; i < contours.size(); ++i) {
      low = contours[i].girth < contours[low].girth ? i : low;
      high = contours[i].girth > contours[high].girth ? i : high;
      if(goes_down && contours[i].girth > turn * contours[low].girth) {
        keep(low);
        high = i;
        goes_up = true;
        goes_down = false;
      } else if(goes_up && turn * contours[i].girth < contours[high].girth) {
        keep(high);
        low = i;
        goes_up = false;
        goes_down = true;
      }
    }
    if(goes_up != goes_down)
      keep(goes_up ? high : low);
    else
      keep(low);
    keep(contours.size() - 1);
  }

  const Flat_mesh& mesh_;
  const Sweep_order& order_;
  const std::vector<float>& function_;
  std::vector<Girth_at> raw_, girths_;
  std::vector<Index> raw_begin_, begin_; // by arc
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_CONTOUR_GIRTHS_H
