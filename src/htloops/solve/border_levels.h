// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_BORDER_LEVELS_H
#define HTLOOPS_BORDER_LEVELS_H

#include "mesh_types.h"
#include "solve/reeb_answer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace htloops {

/*!
The levels at which arcs meet.

Two arcs meet along the contour of the node between them; but where the simplification moved that
node, along one at another level, and where it took leaves off, not quite along a contour. So each
border between two arcs, as far as it is connected, gets the level at which it crosses most of its
edges.
*/
class Border_levels
{
public:
  /// the level of the node at which an arc ends and another begins, if there is one.
  using Node_level = std::function<std::optional<double>(std::size_t, std::size_t)>;

  Border_levels(const Mesh& mesh, const Reeb_answer& answer, const Node_level& node_level);

  /// at an edge between vertices of two arcs.
  double level(Mesh::Edge_index e) const { return levels_[numbers_[e.idx()]]; }

private:
  struct Crossed_edge
  {
    Mesh::Edge_index edge;
    double low, high;
    std::size_t low_arc, high_arc;
  };

  void find_crossed_edges();
  std::vector<std::vector<std::uint32_t>> connected_borders() const;
  double best_level(const std::vector<std::uint32_t>& border, const Node_level& node_level) const;

  const Mesh& mesh_;
  const Reeb_answer& answer_;
  std::vector<Crossed_edge> crossed_;
  std::vector<std::uint32_t> numbers_; // of crossed edges, by edge
  std::vector<double> levels_;         // by crossed edge
};

} // namespace htloops

#endif // HTLOOPS_BORDER_LEVELS_H
