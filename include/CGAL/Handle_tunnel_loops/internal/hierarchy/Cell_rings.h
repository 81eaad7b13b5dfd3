// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RINGS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RINGS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Cell_ring.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/First_cells.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What is around many cells, put down by threads of which each has ranges of `grain` cells.
class Cell_rings
{
public:
  static constexpr std::size_t grain = 1024;

  class Place;

  Cell_rings() = default;

  /// nothing is around any of the cells yet, which are sorted.
  explicit Cell_rings(std::vector<Index> cells)
      : cells_(std::move(cells))
      , sizes_(cells_.size(), 0)
      , points_(cells_.size())
      , neighbors_((cells_.size() + grain - 1) / grain) {}

  std::size_t size() const { return cells_.size(); }
  Index cell(std::size_t i) const { return cells_[i]; }
  /// where the middle of the i-th cell is.
  const Vector& point(std::size_t i) const { return points_[i]; }
  Index number_of_neighbors(std::size_t i) const { return sizes_[i]; }
  std::size_t number_of_ranges() const { return neighbors_.size(); }

  /// takes over what is around the i-th cell, which is fit. In a range, cells follow each other.
  void set(std::size_t i, const Cell_ring& ring) {
    sizes_[i] = ring.size();
    ring.put_centre_of_mass(points_[i].data());
    for(Index k = 0; k < ring.size(); ++k)
      neighbors_[i / grain].push_back(ring.neighbor(k));
  }
  /// the same of one that was looked at by somebody else.
  void set(std::size_t i, const Cell_look& look, const Cell_neighbor* neighbors) {
    sizes_[i] = look.number_of_neighbors;
    std::copy_n(look.point, 3, points_[i].begin());
    neighbors_[i / grain].insert(neighbors_[i / grain].end(), neighbors,
                                 neighbors + look.number_of_neighbors);
  }
  void set(std::size_t i, const Place& place);

  /// calls `f(cell, neighbor)` for the neighbours of all cells of a range, counterclockwise.
  template <typename Function> void for_each_neighbor(std::size_t range, const Function& f) const {
    auto neighbor = neighbors_[range].begin();
    const std::size_t end = (std::min)(size(), (range + 1) * grain);
    for(std::size_t i = range * grain; i < end; ++i)
      for(Index k = 0; k < sizes_[i]; ++k)
        f(cells_[i], *neighbor++);
  }

private:
  std::vector<Index> cells_, sizes_;
  std::vector<Vector> points_;
  std::vector<std::vector<Cell_neighbor>> neighbors_; // by range, one after the other
};

/// A cell among others.
class Cell_rings::Place
{
public:
  /// at the cell, or at the next one.
  Place(const Cell_rings& rings, Index cell)
      : rings_(rings)
      , cell_(std::lower_bound(rings.cells_.begin(), rings.cells_.end(), cell) -
              rings.cells_.begin()) {
    for(std::size_t i = cell_ / grain * grain; i < cell_; ++i)
      neighbor_ += rings.sizes_[i];
  }

  bool is_at(Index cell) const { return cell_ < rings_.size() && rings_.cells_[cell_] == cell; }

  void advance() {
    neighbor_ += rings_.sizes_[cell_];
    if(++cell_ % grain == 0)
      neighbor_ = 0;
  }

private:
  friend class Cell_rings;

  const Cell_rings& rings_;
  std::size_t cell_, neighbor_ = 0; // its first one, in the range
};

inline void Cell_rings::set(std::size_t i, const Place& place) {
  const Cell_rings& other = place.rings_;
  const auto from = other.neighbors_[place.cell_ / grain].begin() + place.neighbor_;
  std::vector<Cell_neighbor>& to = neighbors_[i / grain];
  sizes_[i] = other.sizes_[place.cell_];
  points_[i] = other.points_[place.cell_];
  to.insert(to.end(), from, from + sizes_[i]);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HIERARCHY_CELL_RINGS_H
