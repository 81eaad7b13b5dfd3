// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_H

#include "Field.h"
#include "generators.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {

/*!
A solid described by a text with one part on each line, added or cut out one after the other:

    # a description of the shape
    genus N                     of its surface, summed over its components; checked if given
    faces N                     the default number of faces; 40000 if not given
    blend R                     join the following parts with a fillet of about this size
    ball X Y Z R
    rod X Y Z X Y Z R           with round ends
    cylinder X Y Z X Y Z R      with flat ends
    pipe R [closed] X Y Z ...   around a smooth curve through points
    ring X Y Z NX NY NZ R r     around a circle: center, axis, radius
    knot P Q R r TUBE           a torus knot: P times the long way, Q times the short way
    block X Y Z X Y Z ROUNDING  two corners

`cut` before a part removes it; `times N by X Y Z` and `times N around X Y Z NX NY NZ` repeat the
following part, translated, or rotated about an axis through a point by 1/N of a turn.
*/
class Shape : public Field
{
public:
  /// throws `std::invalid_argument`, with the line, if the text is not a valid description.
  explicit Shape(std::string_view text);

  /// the shape with edges of cylinders, blocks and cut-out parts rounded to about this radius,
  /// where there is room: a lattice does not resolve sharper edges.
  Shape rounded(double radius) const;

  double operator()(const Vector& p) const override;
  Box box() const override { return box_; }

  /// the largest spacing of a lattice that can give so many faces, by the area of the surface, and
  /// by the volume of thin parts.
  double most_spacing(std::size_t faces) const;

  std::size_t number_of_parts() const { return parts_.size(); }
  const std::string& description() const { return description_; }
  std::optional<std::size_t> genus() const { return genus_; }
  std::size_t faces() const { return faces_; }

private:
  // The distance of a point from a part whose edges have a radius.
  using Distance = std::function<double(const Vector&, double)>;

  /// A part: the distance to it, and how it is joined to the parts before.
  struct Part
  {
    Distance distance;
    double blend;
    bool is_cut;
  };

  class Reader;

  std::string description_;
  std::optional<std::size_t> genus_;
  std::size_t faces_ = 40000;
  double rounding_ = 0.;
  double most_area_ = 0., most_volume_ = 0.; // sums of those of the parts
  std::vector<Part> parts_;
  Box box_;
};

/// the mesh of a shape with about the requested number of faces. Throws `std::invalid_argument` if
/// they are too many, or too few for the genus in the text; then the message has a sufficient
/// number.
Soup mesh_of_shape(const Shape& shape, const Request& request, const char* name);

/// the shapes in shapes/, each a kind of its own.
std::vector<Kind> kinds_of_shapes();

/// the names and the texts of the files in shapes/.
const std::vector<std::pair<const char*, std::string_view>>& shape_texts();

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_H
