// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SEEN_LINES_H
#define HTLOOPS_SEEN_LINES_H

#include "draw/surfaces.h"
#include "scene/scene.h"

#include <array>
#include <cstddef>
#include <vector>

namespace htloops {

/// How near a surface comes to the eye, in the cells of a square: all of it is in the unit ball,
/// and the eye far away.
class Depth_map
{
public:
  /// \p from has length one, as the eye is in that direction.
  Depth_map(const Vector& from, std::size_t cells);

  /// notes a point of the surface.
  void add(const Vector& point);

  /// the same, of one that is placed.
  void add_placed(const Vector& point);

  /// notes a triangle, the corners of which are placed, in all cells the middle of which it covers.
  /// If the side is not 0, but 1 or -1, what turns the other one to the eye is left out.
  void add(const Vector& a, const Vector& b, const Vector& c, double side);

  /// whether nothing is clearly in front of a point of the surface, the normal of which has length
  /// one, or is null if it is not known.
  bool is_free(const Vector& point, const Vector& normal) const;

  /// coordinates in the square, in cells, and towards the eye.
  Vector placed(const Vector& point) const;

  const Vector& from() const { return from_; }

private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * cells_ + static_cast<std::size_t>(column);
  }
  double& nearest(int column, int row) { return nearest_[index(column, row)]; }
  double nearest(int column, int row) const { return nearest_[index(column, row)]; }

  Vector from_, right_, upwards_;
  std::size_t cells_;
  std::vector<double> nearest_;
};

/*!
Points along lines that lie on a surface, and how much of them is seen from a direction.

A line on the far side of a plate is hidden however thin the plate is: where the surface is closed,
what faces away from the eye is not seen. Both `estimate()`, from samples of the surface in no time,
and `measure()`, from all of its triangles, take linear time.
*/
class Seen_lines
{
public:
  Seen_lines(const htl_scene::Surface& surface, const std::vector<std::vector<Vector>>& lines);

  struct Line
  {
    double length;     ///< in a unit in which the surface has radius 1
    double seen = 0.;  ///< the length that is not hidden
    double large = 0.; ///< of that, what remains of it in the picture, where slopes count less
  };

  struct View
  {
    std::vector<Line> lines;
    double surface = 0.; ///< the part of the surface that is seen
  };

  View estimate(const Vector& from) const;
  View measure(const Vector& from) const;

private:
  struct Point_on_line
  {
    Vector point, along;             // of length one
    std::array<Vector, 2> normals{}; // of the faces that it is on; null if there is none
  };

  void add_points(const std::vector<Vector>& line);
  void choose_cells(const std::vector<htl_scene::Triangle>& triangles);
  void find_normals(const htl_scene::Surface& surface);
  bool is_seen(const Point_on_line& point, const Depth_map& depths) const;
  static double facing_of(const Point_on_line& point, const Depth_map& depths);
  View view_of(const Depth_map& depths) const;

  std::vector<Vector> points_; // of the surface, in the unit ball
  std::size_t cells_ = 0;
  std::vector<htl_scene::Triangle> large_triangles_; // than a cell
  double side_ =
      0.; // 1 if triangles are turned outwards, -1 inwards, 0 if the surface is not closed
  std::vector<Vector> samples_;
  std::vector<double> lengths_; // of the lines
  std::vector<Point_on_line> points_on_lines_;
};

} // namespace htloops

#endif // HTLOOPS_SEEN_LINES_H
