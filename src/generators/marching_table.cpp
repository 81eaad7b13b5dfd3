// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "marching_table.h"

#include "Bcc_lattice.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Vector corner_position(int corner) {
  return Bcc_lattice::displacement(Bcc_lattice::step_to_corner(corner));
}

/// One tetrahedron of a cell, its corners parted into those inside and those outside.
struct Parted_tetrahedron
{
  std::vector<int> inside, outside;

  /// appends a triangle through three edges, turned to face the outside.
  void add_triangle(std::array<std::pair<int, int>, 3> edges,
                    std::vector<Cell_triangle>& triangles) const {
    std::array<Vector, 3> p;
    for(int i = 0; i < 3; ++i)
      p[i] = (corner_position(edges[i].first) + corner_position(edges[i].second)) / 2.;
    const Vector normal = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    if(normal * (corner_position(outside[0]) - p[0]) < 0.)
      std::swap(edges[1], edges[2]);

    Cell_triangle triangle;
    for(int i = 0; i < 3; ++i) {
      // Of two corners of a tetrahedron one contains the other, as a set of basis vectors.
      const int base = edges[i].first & edges[i].second;
      triangle[i] = {static_cast<std::uint8_t>(base),
                     static_cast<std::uint8_t>(edges[i].first ^ edges[i].second)};
    }
    triangles.push_back(triangle);
  }

  void triangulate(std::vector<Cell_triangle>& triangles) const {
    const auto& [a, b] = std::tie(inside, outside);
    if(a.size() == 1)
      add_triangle({{{a[0], b[0]}, {a[0], b[1]}, {a[0], b[2]}}}, triangles);
    else if(b.size() == 1)
      add_triangle({{{a[0], b[0]}, {a[1], b[0]}, {a[2], b[0]}}}, triangles);
    else if(a.size() == 2) {
      add_triangle({{{a[0], b[0]}, {a[0], b[1]}, {a[1], b[1]}}}, triangles);
      add_triangle({{{a[0], b[0]}, {a[1], b[1]}, {a[1], b[0]}}}, triangles);
    }
  }
};

using Table = std::array<std::vector<Cell_triangle>, 256>;

Table make_table() {
  Table table;
  for(unsigned cell = 0; cell < table.size(); ++cell) {
    std::array<int, 3> path = {0, 1, 2};
    do {
      Parted_tetrahedron tetrahedron;
      int corner = 0;
      for(int step = 0; step <= 3; ++step) {
        auto& side = ((cell >> corner) & 1) != 0 ? tetrahedron.inside : tetrahedron.outside;
        side.push_back(corner);
        if(step < 3)
          corner |= 1 << path[step];
      }
      tetrahedron.triangulate(table[cell]);
    } while(std::next_permutation(path.begin(), path.end()));
  }
  return table;
}

} // namespace

const std::vector<Cell_triangle>& cell_triangles(unsigned inside) {
  static const Table table = make_table();
  return table[inside];
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
