// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_STENCILS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_STENCILS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The rows of the Laplacian with room for eight neighbours each, so that the inner loop has a
/// fixed length: valences vary at random, and a mispredicted branch costs as much as the sum
/// itself. Short rows are filled up with a vertex that does not exist, `n`, whose value is zero;
/// vertices with longer rows are left to the ring.
class Stencils
{
public:
  static constexpr Index width = stencil_width;

  Stencils(Execution execution, const Flat_mesh& mesh)
      : rows_(mesh.number_of_vertices()) {
    for_each_index(execution, rows_.size(), [&](std::size_t v) {
      const Ring ring = mesh.ring(static_cast<Index>(v));
      Row& row = rows_[v];
      row.neighbors.fill(static_cast<Index>(rows_.size()));
      if(ring.size() <= width)
        std::copy(ring.begin(), ring.end(), row.neighbors.begin());
      row.weight = 1.f / static_cast<float>(ring.size());
    });
  }

  float mean(Index v, const float* values) const {
    const Row& row = rows_[v];
    return stencil_mean(row.weight, [&](Index i) { return values[row.neighbors[i]]; });
  }

  /// the neighbours of a vertex with a short row, filled up.
  const std::array<Index, width>& neighbors(Index v) const { return rows_[v].neighbors; }

private:
  struct Row
  {
    std::array<Index, width> neighbors;
    float weight;
  };

  std::vector<Row> rows_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_STENCILS_H
