// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Bored_box.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

/// Writes the surface of a box with bores.
class Bored_box_surface
{
public:
  Bored_box_surface(const Vector& size, const std::vector<Bore>& bores, Cut cut)
      : size_(size)
      , bores_(bores) {
    for(int corner = 0; corner < 8; ++corner)
      soup_.points.push_back({(corner & 1) != 0 ? size.x() : 0., (corner & 2) != 0 ? size.y() : 0.,
                              (corner & 4) != 0 ? size.z() : 0.});
    for(const Bore& bore : bores)
      add_bore(bore);
    for(int axis = 0; axis < 3; ++axis)
      if(cut == Cut::DELAUNAY)
        add_faces<CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>>(axis);
      else
        add_faces<CGAL::Constrained_triangulation_2<Kernel, Structure>>(axis);
  }

  Soup take() { return std::move(soup_); }

private:
  using Index = std::uint32_t;

  /// A vertex of the two faces that an axis goes through.
  struct Vertex
  {
    Index low = 0, high = 0;
    int bore = -1; ///< none for the corners of the box
  };

  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Vertex, Kernel>;
  using Face_base = CGAL::Constrained_triangulation_face_base_2<Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;

  /// the vertices of a bore, those at the low and the high end in turn, and its wall.
  void add_bore(const Bore& bore) {
    const int u = (bore.axis + 1) % 3, v = (bore.axis + 2) % 3;
    const auto first = static_cast<Index>(soup_.points.size());
    const auto n = static_cast<Index>(bore.corners);
    first_.push_back(first);
    for(Index i = 0; i < n; ++i) {
      const double angle = bore.phase + 2. * CGAL_PI * i / n;
      std::array<double, 3> point;
      point[u] = bore.centre[u] + bore.half_size[u] * std::cos(angle);
      point[v] = bore.centre[v] + bore.half_size[v] * std::sin(angle);
      for(const double height : {0., size_[bore.axis]}) {
        point[bore.axis] = height;
        soup_.points.push_back(point);
      }
      const Index low = first + 2 * i, next_low = first + 2 * ((i + 1) % n);
      soup_.triangles.push_back({low, low + 1, next_low + 1});
      soup_.triangles.push_back({low, next_low + 1, next_low});
    }
  }

  /// the two faces of the box that an axis goes through.
  template <typename Triangulation> void add_faces(int axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Triangulation triangulation;
    const auto insert = [&](const Vertex& vertex) {
      const auto& point = soup_.points[vertex.low];
      const auto handle = triangulation.insert({point[u], point[v]});
      handle->info() = vertex;
      return handle;
    };
    for(const Index corner : {0u, 1u << u, 1u << v, 1u << u | 1u << v})
      insert({corner, corner | 1u << axis, -1});
    for(std::size_t b = 0; b < bores_.size(); ++b) {
      if(bores_[b].axis != axis)
        continue;
      std::vector<typename Triangulation::Vertex_handle> polygon;
      for(Index i = 0; i < bores_[b].corners; ++i)
        polygon.push_back(insert({first_[b] + 2 * i, first_[b] + 2 * i + 1, static_cast<int>(b)}));
      for(std::size_t i = 0; i < polygon.size(); ++i)
        triangulation.insert_constraint(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    for(const auto face : triangulation.finite_face_handles())
      add_on_both_sides(face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
  }

  void add_on_both_sides(const Vertex& a, const Vertex& b, const Vertex& c) {
    // The polygons are convex: what has all vertices on one is within.
    if(a.bore >= 0 && a.bore == b.bore && b.bore == c.bore)
      return;
    soup_.triangles.push_back({a.high, b.high, c.high});
    soup_.triangles.push_back({a.low, c.low, b.low});
  }

  Vector size_;
  const std::vector<Bore>& bores_;
  std::vector<Index> first_; ///< by bore: its first vertex
  Soup soup_;
};

} // namespace

Soup bored_box(const Vector& size, const std::vector<Bore>& bores, Cut cut) {
  return Bored_box_surface(size, bores, cut).take();
}

std::vector<std::size_t>
choose_corners(std::size_t boxes, std::size_t bores, std::size_t faces, Random& random) {
  const std::size_t least = faces_of_bored_boxes(boxes, bores, 3 * bores);
  std::size_t left = faces > least ? (faces - least) / 4 : 0;
  std::vector<std::size_t> corners;
  for(std::size_t after = bores; after > 0; --after) {
    // At most twice the mean of what is left; the last one takes it all.
    const std::size_t more = after == 1 ? left : random.below(2 * left / after + 1);
    corners.push_back(3 + more);
    left -= more;
  }
  random.shuffle(corners);
  return corners;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
