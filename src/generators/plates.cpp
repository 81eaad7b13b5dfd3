// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Field.h"
#include "Random.h"
#include "functions.h"
#include "kinds.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

/// A straight hole through a box: a convex polygon inscribed in an ellipse, along an axis.
struct Bore
{
  int axis;
  Vector centre, half_size; ///< along the other two axes
  std::size_t corners;
  double phase; ///< an angle
};

/// Writes the surface of a box from the origin to a corner, with bores that keep away from each
/// other. It has no more vertices than the corners of the box and the polygons: its faces are
/// constrained triangulations, and the walls of the bores have two triangles for each side.
class Bored_box_surface
{
public:
  /// The faces are as even as they can be without further vertices, or as vertices and constraints
  /// come, with slivers, as some programs export parts.
  Bored_box_surface(const Vector& size, const std::vector<Bore>& bores, Random& random)
      : size_(size)
      , bores_(bores) {
    for(int corner = 0; corner < 8; ++corner)
      add_point(soup_, Box{Vector(0., 0., 0.), size}.corner(corner));
    for(const Bore& bore : bores)
      add_bore(bore);
    const bool is_even = random.below(2) == 0;
    for(int axis = 0; axis < 3; ++axis)
      if(is_even)
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
      point[u] = bore.centre[u] + bore.half_size[u] * cosine(angle);
      point[v] = bore.centre[v] + bore.half_size[v] * sine(angle);
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
      look_at(soup_);
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
      for(std::size_t i = 0; i < polygon.size(); ++i) {
        look_at(soup_);
        triangulation.insert_constraint(polygon[i], polygon[(i + 1) % polygon.size()]);
      }
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

/// the least number of faces of boxes with bores, all together.
std::size_t least_faces(std::size_t boxes, std::size_t bores) { return 12 * boxes + 16 * bores; }

/// numbers of corners, of bores.
using Corners = std::vector<std::size_t>;

/// three or more for each bore, that make up for a number of faces.
Corners choose_corners(std::size_t boxes, std::size_t bores, std::size_t faces, Random& random) {
  const std::size_t least = least_faces(boxes, bores);
  std::size_t left = faces > least ? (faces - least) / 4 : 0;
  Corners corners;
  for(std::size_t after = bores; after > 0; --after) {
    // At most twice the mean of what is left; the last one takes it all.
    const std::size_t more = after == 1 ? left : random.below(2 * left / after + 1);
    corners.push_back(3 + more);
    left -= more;
  }
  random.shuffle(corners);
  return corners;
}

/// the parts that `make_part(corners, place, random)` makes beside each other; it moves the place.
template <typename MakePart>
Soup make_parts(const Request& request, const char* kind, const MakePart& make_part) {
  if(request.parts == 0)
    refuse(kind, "needs at least one part");
  require_least_genus(request, kind, request.parts);
  require_faces(request, kind, least_faces(request.parts, request.genus));
  Random random(request.seed);
  const Corners corners = choose_corners(request.parts, request.genus, request.faces, random);
  std::vector<Soup> parts;
  double place = 0.;
  for(std::size_t i = 0; i < request.parts; ++i) {
    const auto first = corners.begin() + i * request.genus / request.parts;
    const auto end = corners.begin() + (i + 1) * request.genus / request.parts;
    parts.push_back(make_part({first, end}, place, random));
  }
  return joined(parts);
}

/// a bar along the x axis with a bore for each number of corners, along the y or the z axis.
Soup make_bar(const Corners& corners, double depth, double height, Random& random) {
  constexpr double least = 0.1, most = 0.46; // of the bar's width, or a bore's part of its length
  const Vector size(double(corners.size()), depth, height);
  std::vector<Bore> bores;
  for(std::size_t i = 0; i < corners.size(); ++i) {
    const double x = double(i) + 0.5;
    const double a = random.uniform(least, most), b = random.uniform(least, most);
    const auto axis = static_cast<int>(1 + random.below(2));
    bores.push_back({axis, Vector(x, depth / 2., height / 2.), Vector(a, b * depth, b * height),
                     corners[i], random.uniform(0., 2. * CGAL_PI)});
  }
  return Bored_box_surface(size, bores, random).take();
}

/// a bore along the z axis somewhere in a square of side one.
Bore bore_in_square(double x, double y, std::size_t corners, Random& random) {
  constexpr double least = 0.06, most = 0.46;
  const double a = random.uniform(least, most), b = random.uniform(least, most);
  const double dx = random.uniform(a - most, most - a), dy = random.uniform(b - most, most - b);
  return {2, Vector(x + 0.5 + dx, y + 0.5 + dy, 0), Vector(a, b, 0), corners,
          random.uniform(0., 2. * CGAL_PI)};
}

/// a plate, or block, with a bore for each number of corners, in rows.
Soup make_plate(const Corners& corners, double thickness, Random& random) {
  const auto square_root = static_cast<std::size_t>(std::sqrt(double(corners.size())));
  const std::size_t rows = 1 + random.below(square_root);
  const std::size_t columns = (corners.size() + rows - 1) / rows;
  std::vector<Bore> bores;
  for(std::size_t i = 0; i < corners.size(); ++i)
    bores.push_back(bore_in_square(double(i / rows), double(i % rows), corners[i], random));
  const Vector size(double(columns), double(rows), thickness);
  return Bored_box_surface(size, bores, random).take();
}

} // namespace

Soup make_bars(const Request& request) {
  return make_parts(request, "bars", [](const Corners& corners, double& y, Random& random) {
    const double depth = random.uniform(0.4, 1.5), height = random.uniform(0.4, 1.5);
    const Soup bar = translated(make_bar(corners, depth, height, random), {0., y, 0.});
    y += depth + random.uniform(0.05, 0.3);
    return bar;
  });
}

Soup make_plates(const Request& request) {
  return make_parts(request, "plates", [](const Corners& corners, double& height, Random& random) {
    // From sheets to blocks.
    const double thickness = exponential(random.uniform(logarithm(0.05), logarithm(3.)));
    const Soup plate = translated(make_plate(corners, thickness, random), {0., 0., height});
    height += thickness + random.uniform(0.05, 0.5);
    return plate;
  });
}

} // namespace CGAL::Handle_tunnel_loops::generators
