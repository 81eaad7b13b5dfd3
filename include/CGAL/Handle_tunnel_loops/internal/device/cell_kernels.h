// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CELL_KERNELS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CELL_KERNELS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/execution_steps.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_ring.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_view.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>

namespace CGAL::Handle_tunnel_loops::internal::device {

/// Cells while they grow: those of `Cells`, and the round in which each vertex was taken.
struct Growing_cells
{
  /// Rounds of vertices that are in no cell, and of those that take none.
  static constexpr Index open = no_index, alone = no_index - 1;

  Mesh_view mesh;
  Span<Cell_link> links;
  Span<Index> rounds;

  CGAL_HTL_HOST_DEVICE void add_cell(Index v, Index round) const {
    links[v] = {v, no_index};
    racy_store(rounds[v], round);
  }
};

/// Where cells begin: at each so many-th vertex. A vertex of many neighbours is one for good.
struct Start_cells
{
  Growing_cells cells;
  Span<char> are_vertices;
  Index spacing, first_hub, number_of_hubs;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    const bool is_alone =
        v - first_hub < number_of_hubs || cells.mesh.ring(v).size() > many_neighbors;
    are_vertices[v] = is_alone;
    if(is_alone || (v < first_hub && v % spacing == 0))
      cells.add_cell(v, is_alone ? Growing_cells::alone : 0);
    else {
      cells.links[v] = {no_index, no_index};
      cells.rounds[v] = Growing_cells::open;
    }
  }
};

/// ... and at the seeds.
struct Start_at_seeds
{
  Growing_cells cells;
  Span<const Index> seeds;

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    if(cells.rounds[seeds[i]] == Growing_cells::open)
      cells.add_cell(seeds[i], 0);
  }
};

/// Lets cells grow ring by ring, as a program for `run_steps()`. A vertex that is still open has
/// among its neighbours that are not those of the last round only: what was there before would have
/// taken it. So a round needs one barrier; who is taken in it is not looked at in it.
class Grow_cells : public Rounds
{
public:
  /// After so many the processor is to do it, which goes through what is still open only.
  static constexpr Index most_rounds = 100;

  /// \p are_more is set to whether more rounds are needed.
  Grow_cells(const Growing_cells& cells, const Span<std::uint32_t>& changed, Span<Index> are_more)
      : Rounds(changed)
      , cells_(cells)
      , are_more_(are_more) {}

  CGAL_HTL_HOST_DEVICE bool begin_step(State& state) const {
    return state.step < most_rounds && Rounds::begin_step(state);
  }
  CGAL_HTL_HOST_DEVICE void store(const State& state) const { are_more_[0] = state.goes_on; }
  CGAL_HTL_HOST_DEVICE Index size(const State&) const { return cells_.mesh.number_of_vertices(); }

  CGAL_HTL_HOST_DEVICE void operator()(Index v, const State& state) const {
    if(racy_load(cells_.rounds[v]) != Growing_cells::open)
      return;
    const auto cell_of = [&](Index u) {
      return racy_load(cells_.rounds[u]) == state.step - 1 ? cells_.links[u].cell : no_index;
    };
    const Cell_link link = least_link(cells_.mesh.ring(v), cell_of, [](Index) { return true; });
    if(link.cell == no_index)
      return;
    cells_.links[v] = link;
    racy_store(cells_.rounds[v], state.step);
    note_change(state);
  }

private:
  Growing_cells cells_;
  Span<Index> are_more_;
};

/// Makes vertices for good of those that no cell has come to.
struct Close_cells
{
  Growing_cells cells;
  Span<char> are_vertices;

  CGAL_HTL_HOST_DEVICE void operator()(Index v) const {
    if(cells.rounds[v] != Growing_cells::open)
      return;
    cells.add_cell(v, Growing_cells::alone);
    are_vertices[v] = 1;
  }
};

/// A list of a thread, of limited length.
template <typename T, Index capacity> class Short_list
{
public:
  CGAL_HTL_HOST_DEVICE void clear() { size_ = number_ = 0; }
  CGAL_HTL_HOST_DEVICE void push_back(const T& value) {
    if(size_ < capacity)
      at_[size_++] = value;
    ++number_;
  }
  CGAL_HTL_HOST_DEVICE Index size() const { return size_; }
  CGAL_HTL_HOST_DEVICE bool is_too_short() const { return number_ > size_; }
  CGAL_HTL_HOST_DEVICE const T& operator[](Index i) const { return at_[i]; }

protected:
  T at_[capacity];
  Index size_ = 0, number_ = 0; // and how many there should be
};

/// The lists of a thread that looks at a cell. Cells of three times as many vertices as usual, or
/// neighbours, are rare, and left to the processor: no thread works for long.
struct Short_lists
{
  static constexpr Index most_vertices = 48, most_corners = 16;

  using Vertices = Short_list<Index, most_vertices>;
  using Order = Short_list<Index, most_corners>;

  struct Corners : Short_list<Cell_corner, most_corners>
  {
    CGAL_HTL_HOST_DEVICE void sort() {
      for(Index i = 1; i < size_; ++i) {
        const Cell_corner corner = at_[i];
        Index place = i;
        for(; place > 0 && corner.neighbor < at_[place - 1].neighbor; --place)
          at_[place] = at_[place - 1];
        at_[place] = corner;
      }
    }
  };
};

/// Looks at cells, one thread for each.
struct Look_at_cells
{
  Cell_view cells;
  Span<const Index> centres;
  Span<Cell_look> looks;
  Span<Cell_neighbor> neighbors;
  Index* number_of_neighbors; ///< of all cells

  CGAL_HTL_HOST_DEVICE void operator()(Index i) const {
    Cell_look look = {{0., 0., 0.}, no_index, 0};
    Cell_ring_in<Short_lists> ring(cells);
    if(cells.ring(centres[i]).size() <= many_neighbors) {
      const bool is_fit = ring.look(centres[i]);
      if(is_fit)
        put(ring, look);
      else if(!ring.is_too_large())
        look.number_of_neighbors = 0;
    }
    looks[i] = look;
  }

private:
  // If there is room.
  CGAL_HTL_HOST_DEVICE void put(const Cell_ring_in<Short_lists>& ring, Cell_look& look) const {
    look.first = fetch_add(*number_of_neighbors, ring.size());
    if(look.first + ring.size() > neighbors.size())
      return;
    look.number_of_neighbors = ring.size();
    ring.put_centre_of_mass(look.point);
    for(Index k = 0; k < ring.size(); ++k)
      neighbors[look.first + k] = ring.neighbor(k);
  }
};

} // namespace CGAL::Handle_tunnel_loops::internal::device

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_DEVICE_CELL_KERNELS_H
