// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/mesh/Triangle_connectivity.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

namespace CGAL::Handle_tunnel_loops::internal {

Triangle_connectivity::Triangle_connectivity(Execution execution,
                                             std::size_t number_of_vertices,
                                             Uninitialized_vector<Index> corners)
    : number_of_corners_(corners.size())
    , source_(std::move(corners))
    , arriving_(number_of_vertices, no_index) {
  check_corners(execution);
  find_opposites(execution);
  check_fans(execution);
}

void Triangle_connectivity::check_corners(Execution execution) const {
  check_number_of_halfedges(number_of_corners_);
  First_index degenerate;
  for_each_index(execution, number_of_faces(), [&](std::size_t f) {
    const Index* const c = source_.data() + 3 * f;
    CGAL_precondition((std::max)({c[0], c[1], c[2]}) < number_of_vertices());
    if(c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      degenerate.see(f);
  });
  if(!degenerate.found())
    return;
  const Index* const c = source_.data() + 3 * degenerate.get();
  throw Invalid_mesh_exception(Mesh_defect::DEGENERATE_FACE, {c[0], c[1], c[2]},
                               "a face uses the same vertex twice: face " +
                                   std::to_string(degenerate.get()));
}

// All halfedges by the smaller one of their vertices; \p end is where those of each vertex end.
Triangle_connectivity::Entries
Triangle_connectivity::sort_by_near_vertex(Execution execution,
                                           Uninitialized_vector<Index>& end) const {
  end.assign(number_of_vertices(), 0);
  const auto for_each_halfedge = [this](const auto& visit) {
    for(Index h = 0; h < number_of_corners_; ++h) {
      const Index u = source_[h], v = source_[next_in_face(h)];
      visit(h, (std::min)(u, v), (std::max)(u, v));
    }
  };
  for_each_halfedge([&](Index, Index near_vertex, Index) { ++end[near_vertex]; });
  sum_before_each(execution, end);
  Entries entries(number_of_corners_);
  for_each_halfedge([&](Index h, Index near_vertex, Index far_vertex) {
    entries[end[near_vertex]++] = {far_vertex, h};
  });
  return entries;
}

bool Triangle_connectivity::is_edge(Edge edge) const {
  return edge.size() == 1 ||
         (edge.size() == 2 && source_[edge[0].halfedge] != source_[edge[1].halfedge]);
}

void Triangle_connectivity::throw_defect(Index near_vertex, Edge edge) const {
  const bool is_crowded = edge.size() > 2;
  throw_edge_defect(is_crowded ? Mesh_defect::NON_MANIFOLD_EDGE
                               : Mesh_defect::INCONSISTENT_ORIENTATION,
                    near_vertex, edge[0].far_vertex,
                    is_crowded ? "more than two faces share an edge"
                               : "two faces traverse their common edge in the same direction");
}

void Triangle_connectivity::find_opposites(Execution execution) {
  Uninitialized_vector<Index> end;
  Entries entries = sort_by_near_vertex(execution, end);
  // Calls visit(edge) for the edges from a vertex to larger ones until one is not sound.
  const auto for_each_edge = [&](std::size_t v, const auto& visit) {
    Entry* begin = entries.data() + (v == 0 ? 0 : end[v - 1]);
    Entry* const last = entries.data() + end[v];
    std::sort(begin, last, [](Entry a, Entry b) { return a.far_vertex < b.far_vertex; });
    while(begin != last) {
      Entry* next = begin + 1;
      while(next != last && next->far_vertex == begin->far_vertex)
        ++next;
      visit(Edge(begin, static_cast<std::size_t>(next - begin)));
      begin = next;
    }
  };
  First_index unsound;
  opposite_.resize(number_of_corners_);
  const std::vector<Index> inner =
      collect<Index>(execution, number_of_vertices(), [&](std::size_t first, std::size_t last) {
        std::vector<Index> without_other;
        for(std::size_t v = first; v < last; ++v)
          for_each_edge(v, [&](Edge edge) {
            if(!is_edge(edge))
              unsound.see(v);
            else if(edge.size() == 1)
              without_other.push_back(edge[0].halfedge);
            else
              for(int i = 0; i < 2; ++i)
                opposite_[edge[i].halfedge] = edge[1 - i].halfedge;
          });
        return without_other;
      });
  if(unsound.found())
    for_each_edge(unsound.get(), [&](Edge edge) {
      if(!is_edge(edge))
        throw_defect(static_cast<Index>(unsound.get()), edge);
    });
  find_arriving();
  add_borders(inner);
}

void Triangle_connectivity::find_arriving() {
  for(Index h = 0; h < number_of_corners_; ++h)
    arriving_[source_[next_in_face(h)]] = h;
}

// A vertex on the boundary has one halfedge without a face that arrives, and one that leaves.
void Triangle_connectivity::add_borders(const std::vector<Index>& inner) {
  if(inner.empty())
    return;
  check_number_of_halfedges(number_of_corners_ + inner.size());
  opposite_.reserve(number_of_corners_ + inner.size());
  source_.reserve(number_of_corners_ + inner.size());
  for(const Index h : inner) {
    const Index border = static_cast<Index>(opposite_.size()), v = source_[h];
    opposite_[h] = border;
    opposite_.push_back(h);
    source_.push_back(source_[next_in_face(h)]);
    if(is_border(arriving_[v]))
      throw_fan_defect(v);
    arriving_[v] = border;
  }
  next_of_border_.resize(inner.size());
  for(Index h = static_cast<Index>(number_of_corners_); h < number_of_halfedges(); ++h)
    next_of_border_[arriving_[source_[h]] - number_of_corners_] = h;
}

// Each halfedge with a face is in one fan at most, that of the vertex to which it leads.
void Triangle_connectivity::check_fans(Execution execution) const {
  std::atomic<std::size_t> number_in_fans{0};
  execution.for_ranges(number_of_vertices(), 16384, [&](std::size_t begin, std::size_t end) {
    std::size_t number = 0;
    for(std::size_t v = begin; v < end; ++v)
      number += size_of_fan(static_cast<Index>(v));
    number_in_fans += number;
  });
  if(number_in_fans == number_of_corners_)
    return;
  std::vector<Index> left(number_of_vertices(), 0);
  for(Index h = 0; h < number_of_corners_; ++h)
    ++left[source_[h]];
  Index v = 0;
  while(left[v] == size_of_fan(v))
    ++v;
  throw_fan_defect(v);
}

// The faces that are found around a vertex.
Index Triangle_connectivity::size_of_fan(Index v) const {
  const Index first = arriving_[v];
  if(first == no_index)
    return 0;
  Index size = 0, h = first;
  do {
    size += is_border(h) ? 0 : 1;
    h = opposite_[next(h)];
  } while(h != first);
  return size;
}

void Triangle_connectivity::throw_fan_defect(Index v) {
  throw_vertex_defect(Mesh_defect::NON_MANIFOLD_VERTEX, v,
                      "the faces around a vertex form more than one fan");
}

} // namespace CGAL::Handle_tunnel_loops::internal
