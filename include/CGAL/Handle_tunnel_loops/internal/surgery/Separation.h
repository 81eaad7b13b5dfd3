// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Curve_off_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What a closed surface is, by counting.
struct Surface_count
{
  std::size_t components = 0;
  std::size_t genus = 0; ///< summed over the components
};

/// the pieces that the faces for which `stays(f)` form, as sets of faces. Linear in the size of the
/// mesh.
template <typename Predicate>
Concurrent_disjoint_sets
pieces(Execution execution, const Surgery_mesh& mesh, const Predicate& stays) {
  Concurrent_disjoint_sets sets(execution, mesh.face_bound());
  for_each_index(execution, mesh.face_bound(), [&](std::size_t f) {
    if(stays(static_cast<Index>(f)))
      sets.insert(static_cast<Index>(f));
  });
  for_each_index(execution, 3 * std::size_t(mesh.face_bound()), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(stays(mesh.face(h)) && h < mesh.twin(h) && stays(mesh.face(mesh.twin(h))))
      sets.unite(mesh.face(h), mesh.face(mesh.twin(h)));
  });
  return sets;
}

/// the number of pieces of the surface. Linear in its size.
inline std::size_t number_of_pieces(Execution execution, const Surgery_mesh& mesh) {
  return pieces(execution, mesh, [&](Index f) { return mesh.is_alive(f); })
      .flatten(execution)
      .size();
}

/// whether a halfedge has a twin that leads back.
inline bool is_matched(const Surgery_mesh& mesh, Index h) {
  const Index twin = mesh.twin(h);
  return twin != no_index && mesh.is_alive(mesh.face(twin)) && mesh.twin(twin) == h &&
         mesh.source(twin) == mesh.target(h) && mesh.target(twin) == mesh.source(h);
}

/// whether each halfedge has a twin that leads back, and the faces at each vertex are one fan that
/// comes to no neighbour twice.
inline bool is_closed_manifold(Execution execution, const Surgery_mesh& mesh) {
  std::atomic<bool> is_good(true);
  for_each_index(execution, 3 * std::size_t(mesh.face_bound()), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(mesh.is_alive(mesh.face(h)) && !is_matched(mesh, h))
      is_good = false;
  });
  if(!is_good)
    return false; // not all fans end
  std::atomic<std::size_t> number_in_fans(0);
  execution.for_ranges(mesh.vertex_bound(), 16384, [&](std::size_t begin, std::size_t end) {
    std::vector<Index> neighbors;
    std::size_t number = 0;
    for(Index v = static_cast<Index>(begin); v < end; ++v) {
      neighbors.clear();
      mesh.for_each_outgoing(v, [&](Index h) { neighbors.push_back(mesh.target(h)); });
      number += neighbors.size();
      std::sort(neighbors.begin(), neighbors.end());
      if(std::adjacent_find(neighbors.begin(), neighbors.end()) != neighbors.end())
        is_good = false;
    }
    number_in_fans += number;
  });
  return is_good && number_in_fans == 3 * mesh.number_of_faces();
}

/// throws `std::logic_error` if the mesh is no closed manifold, which nothing that is done to it
/// may make of it. Linear in the size of the mesh.
inline Surface_count count_surface(Execution execution, const Surgery_mesh& mesh) {
  if(!is_closed_manifold(execution, mesh))
    throw std::logic_error("the surface is not a closed manifold after the removal of handles");
  Surface_count count;
  count.components = number_of_pieces(execution, mesh);
  std::size_t vertices = 0;
  for(Index v = 0; v < mesh.vertex_bound(); ++v)
    vertices += mesh.outgoing(v) != no_index;
  // V - E + F = 2 c - 2 g, with 2 E = 3 F.
  count.genus = (2 * count.components + mesh.number_of_faces() / 2 - vertices) / 2;
  return count;
}

/// Where a surface is cut, or a region of it taken out.
struct Surface_cut
{
  std::vector<Index> blocked; ///< halfedges that lead across, with their twins, in ascending order
  /// for each bank, or border of the region, the vertices beside it.
  std::vector<std::vector<Index>> banks;
};

/// with a bank for each border.
inline Surface_cut cut_around(const Surgery_mesh& mesh, const Cut_region& region) {
  Surface_cut cut;
  for(Index f : region.faces())
    for(Index h : {3 * f, 3 * f + 1, 3 * f + 2})
      if(region.contains(mesh.face(mesh.twin(h))))
        cut.blocked.push_back(h);
  for(std::size_t border = 0; border < region.number_of_borders(); ++border) {
    cut.banks.push_back(region.vertices_of(mesh, border));
    make_set(cut.banks.back());
  }
  return cut;
}

/// with two banks: left and right. An edge that is crossed an even number of times has both ends on
/// the same side, if there are sides at all.
inline Surface_cut cut_along(const Surgery_mesh& mesh, const Curve_off_vertices& curve) {
  struct At_edge
  {
    Index edge;
    double place;  ///< along the edge
    bool is_along; ///< the left side is towards its target
  };
  std::vector<At_edge> crossings;
  for(const Edge_crossing& c : curve.crossings()) {
    const Index edge = (std::min)(c.halfedge, mesh.twin(c.halfedge));
    const bool is_along = edge == c.halfedge;
    crossings.push_back({edge, is_along ? c.ratio : 1. - c.ratio, is_along});
  }
  std::sort(crossings.begin(), crossings.end(), [](const At_edge& a, const At_edge& b) {
    return std::make_pair(a.edge, a.place) < std::make_pair(b.edge, b.place);
  });
  Surface_cut cut{{}, std::vector<std::vector<Index>>(2)};
  for(auto begin = crossings.begin(); begin != crossings.end();) {
    const Index edge = begin->edge;
    const auto end =
        std::find_if(begin, crossings.end(), [&](const At_edge& c) { return c.edge != edge; });
    if((end - begin) % 2 == 1) {
      cut.blocked.insert(cut.blocked.end(), {edge, mesh.twin(edge)});
      cut.banks[(end - 1)->is_along ? 0 : 1].push_back(mesh.target(edge));
      cut.banks[begin->is_along ? 1 : 0].push_back(mesh.source(edge));
    }
    begin = end;
  }
  make_set(cut.blocked);
  for(std::vector<Index>& bank : cut.banks)
    make_set(bank);
  return cut;
}

/*!
Finds whether a surface falls apart along a cut: from both banks, the vertices that edges lead to
are gone through in turn, until they meet or one side has no more. Takes no longer than the smaller
piece or the way around.

If vertices meet, the banks are joined. Where faces are very large, the way around may lead across
edges that are crossed several times, between the crossings: then it is not found, and the surface
is said to fall apart.
*/
class Separation
{
public:
  bool operator()(const Surgery_mesh& mesh, const Surface_cut& cut) {
    side_of_.resize(mesh.vertex_bound(), 0);
    for(std::size_t bank = 1; bank < cut.banks.size(); ++bank) {
      sides_ = {};
      const bool separates = !do_meet(mesh, cut, bank);
      for(const Side& side : sides_)
        for(Index v : side.reached)
          side_of_[v] = 0;
      if(separates)
        return true;
    }
    return false;
  }

private:
  struct Side
  {
    std::vector<Index> reached;
    std::size_t number_at_cut = 0; // which are reached first
    std::size_t done = 0;

    bool is_complete() const { return done == reached.size(); }
  };

  // Whether the first bank is joined to another one.
  bool do_meet(const Surgery_mesh& mesh, const Surface_cut& cut, std::size_t bank) {
    for(std::size_t side : {0, 1}) {
      for(Index v : cut.banks[side == 0 ? 0 : bank])
        if(visit(v, side))
          return true;
      sides_[side].number_at_cut = sides_[side].reached.size();
    }
    for(std::size_t side = 0; !sides_[side].is_complete(); side = 1 - side)
      if(meets_other(mesh, cut, side))
        return true;
    return false;
  }

  // Goes from the next vertex of a side to its neighbours. Other banks are open: from there on,
  // edges may be blocked wherever they are.
  bool meets_other(const Surgery_mesh& mesh, const Surface_cut& cut, std::size_t side) {
    const bool is_at_cut = cut.banks.size() > 2 || sides_[side].done < sides_[side].number_at_cut;
    const Index v = sides_[side].reached[sides_[side].done++];
    bool meets = false;
    mesh.for_each_outgoing(v, [&](Index h) {
      if(!is_at_cut || !is_in(h, cut.blocked))
        meets = visit(mesh.target(h), side) || meets;
    });
    return meets;
  }

  // Whether the other side was here.
  bool visit(Index v, std::size_t side) {
    const char mark = static_cast<char>(side + 1);
    if(side_of_[v] == 0) {
      side_of_[v] = mark;
      sides_[side].reached.push_back(v);
    }
    return side_of_[v] != mark;
  }

  std::vector<char> side_of_; // by vertex
  std::array<Side, 2> sides_;
};

/// Which of some cuts with two banks, that share no vertices, would separate the surface if it was
/// cut and closed there in this order, but for those that would. Near linear in the size of the
/// mesh, however many cuts there are.
inline std::vector<char> separating_cuts(Execution execution,
                                         const Surgery_mesh& mesh,
                                         const std::vector<Surface_cut>& cuts) {
  std::vector<char> is_blocked(3 * std::size_t(mesh.face_bound()), 0);
  for(const Surface_cut& cut : cuts)
    for(Index h : cut.blocked)
      is_blocked[h] = 1;
  Concurrent_disjoint_sets joined(execution, mesh.vertex_bound());
  for_each_index(execution, mesh.vertex_bound(),
                 [&](std::size_t v) { joined.insert(static_cast<Index>(v)); });
  for_each_index(execution, is_blocked.size(), [&](std::size_t i) {
    const Index h = static_cast<Index>(i);
    if(!is_blocked[i] && mesh.is_alive(mesh.face(h)) && h < mesh.twin(h))
      joined.unite(mesh.source(h), mesh.target(h));
  });
  for(const Surface_cut& cut : cuts)
    for(const std::vector<Index>& bank : cut.banks)
      for(Index v : bank)
        joined.unite(bank.front(), v);
  // The last ones that are needed to join what is left stay.
  std::vector<char> separates(cuts.size(), 1);
  for(std::size_t i = cuts.size(); i-- > 0;) {
    const auto& banks = cuts[i].banks;
    if(banks[0].empty() || banks[1].empty())
      continue;
    separates[i] = joined.root(banks[0].front()) != joined.root(banks[1].front());
    joined.unite(banks[0].front(), banks[1].front());
  }
  return separates;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SEPARATION_H
