// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_VORONOI_GRAPH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_VORONOI_GRAPH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/measure/Ball_network.h>
#include <CGAL/Handle_tunnel_loops/internal/measure/insertion_order.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/rounded_rational.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
The vertices and edges of the Voronoi diagram of points, and how far they are from the points. Where
all is farther from them than a radius, every closed curve can be pushed to closed walks on edges
that are, too.

Points far away all around are added, so that there is no vertex at infinity. The ball of a vertex
is that through the points of its cell.
*/
class Voronoi_graph : public Ball_network
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Point = Kernel::Point_3;
  using Cell = Triangulation_cell_base_with_info_3<Index,
                                                   Kernel,
                                                   Delaunay_triangulation_cell_base_3<Kernel>>;
  using Delaunay = Delaunay_triangulation_3<
      Kernel,
      Triangulation_data_structure_3<Triangulation_vertex_base_3<Kernel>, Cell>>;
  using Cell_handle = Delaunay::Cell_handle;

public:
  using Vertex_handle = Delaunay::Vertex_handle;

  /// \p box_low and \p box_high are corners of a box around all points that are ever added.
  Voronoi_graph(const Vector& box_low, const Vector& box_high) {
    const Vector middle = 0.5 * (box_low + box_high);
    const double size = norm(box_high - box_low);
    for(int i = 0; i < 27; ++i) {
      const Vector direction = {i % 3 - 1., i / 3 % 3 - 1., i / 9 - 1.};
      if(i != 13)
        delaunay_.insert(point(middle + (distance_of_frame * size / norm(direction)) * direction));
    }
  }

  /// adds points from a number on.
  void insert(Execution execution, const std::vector<Vector>& points, std::size_t first) {
    const Span<const Vector> added(points.data() + first, points.size() - first);
    Vertex_handle last;
    for(const Index i : insertion_order(execution, added))
      last = delaunay_.insert(point(added[i]), last);
  }

  /// finds nodes and edges anew.
  void build(Execution execution) {
    std::vector<Cell_handle> cells;
    cells.reserve(delaunay_.number_of_cells());
    for(const Cell_handle c : delaunay_.all_cell_handles()) {
      c->info() = delaunay_.is_infinite(c) ? no_index : static_cast<Index>(cells.size());
      if(c->info() != no_index)
        cells.push_back(c);
    }
    nodes.resize(cells.size());
    for_each_index(execution, cells.size(), [&](std::size_t i) { nodes[i] = node(cells[i]); });
    edges = collect<Edge>(execution, cells.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<Edge> found;
      for(std::size_t i = begin; i < end; ++i)
        for(int k = 0; k < 4; ++k)
          if(const Index j = cells[i]->neighbor(k)->info(); j != no_index && i < j) {
            const double radius =
                norm(narrowest_across(cells[i], k) - place(cells[i]->vertex((k + 1) % 4)));
            const auto least =
                static_cast<float>((std::min)({radius, nodes[i].radius, nodes[j].radius}));
            found.push_back({{static_cast<Index>(i), j}, least, least});
          }
      return found;
    });
  }

  /// how far the nearest of the points is from a place. It is looked for from where the last one
  /// was found, and is then where to start the next time.
  double distance(const Vector& p, Vertex_handle& nearest) const {
    const Point q = point(p);
    nearest = nearest == Vertex_handle() ? delaunay_.nearest_vertex(q)
                                         : delaunay_.nearest_vertex(q, nearest->cell());
    return norm(place(nearest) - p);
  }

private:
  static constexpr double distance_of_frame = 8.; // in diagonals

  static Point point(const Vector& p) { return {p[0], p[1], p[2]}; }

  static Vector place(Vertex_handle v) { return {v->point().x(), v->point().y(), v->point().z()}; }

  static Node node(Cell_handle c) {
    const Vector a = place(c->vertex(0)), p = place(c->vertex(1)) - a, q = place(c->vertex(2)) - a,
                 r = place(c->vertex(3)) - a;
    const double pp = dot(p, p), qq = dot(q, q), rr = dot(r, r);
    const double volume = dot(p, cross(q, r));
    constexpr double flat = 1e-8; // of the product of three sides: the rest of the digits do
    if(std::abs(volume) < flat * std::sqrt(pp * qq * rr))
      return exact_node(c);
    const Vector to_centre =
        (0.5 / volume) * (pp * cross(q, r) + qq * cross(r, p) + rr * cross(p, q));
    return {a + to_centre, norm(to_centre)};
  }

  // Of a cell that is nearly flat.
  static Node exact_node(Cell_handle c) {
    using Exact = Simple_cartesian<Exact_rational>;
    std::array<Exact::Point_3, 4> corners;
    for(int k = 0; k < 4; ++k)
      corners[k] = {c->vertex(k)->point().x(), c->vertex(k)->point().y(),
                    c->vertex(k)->point().z()};
    const Exact::Point_3 centre =
        CGAL::circumcenter(corners[0], corners[1], corners[2], corners[3]);
    return {{rounded(centre.x()), rounded(centre.y()), rounded(centre.z())},
            std::sqrt(rounded(CGAL::squared_distance(centre, corners[0])))};
  }

  // Where the edge across a facet is nearest to the corners of that: in the middle of the circle
  // through them, if it passes there, or else at one of its ends.
  Vector narrowest_across(Cell_handle c, int k) const {
    const Node &n = nodes[c->info()], &m = nodes[c->neighbor(k)->info()];
    const Vector a = place(c->vertex((k + 1) % 4)), p = place(c->vertex((k + 2) % 4)) - a,
                 q = place(c->vertex((k + 3) % 4)) - a;
    const Vector way = m.place - n.place, normal = cross(p, q);
    const double square = dot(normal, normal);
    if(square > 0.) {
      const Vector middle =
          a + (0.5 / square) * (dot(p, p) * cross(q, normal) + dot(q, q) * cross(normal, p));
      if(dot(middle - n.place, way) > 0. && dot(m.place - middle, way) > 0.)
        return middle;
    }
    return n.radius < m.radius ? n.place : m.place;
  }

  Delaunay delaunay_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MEASURE_VORONOI_GRAPH_H
