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
A solid that a text describes, a part on each line, put together or cut out one after the other:

    # the first line is what it is
    genus N                        of its surface, summed over its components; checked if it is
given faces N                        as many as show it well; 40000 if it is not said blend R parts
that follow are joined with a fillet of about this size ball X Y Z R rod X Y Z X Y Z R with round
ends cylinder X Y Z X Y Z R         with flat ends pipe R [closed] X Y Z ...      around a smooth
curve through points ring X Y Z NX NY NZ R r        around a circle: its middle, its axis, its
radius knot P Q R r TUBE              a torus knot: p times the long way, q times the short one
    block X Y Z X Y Z ROUNDING     two corners

`cut` before a part takes it away; `times N by X Y Z` and `times N around X Y Z NX NY NZ` repeat
what follows them, moved or turned about an axis through a point by the N-th part of a turn.
*/
class Shape : public Field
{
public:
  /// throws `std::invalid_argument`, with the line, if the text is no description.
  explicit Shape(std::string_view text);

  /// the shape with a radius of about this size at the edges of cylinders, of blocks and of what is
  /// cut out, as far as there is room for it: a lattice does not show sharper ones.
  Shape rounded(double radius) const;

  double operator()(const Vector& p) const override;
  Box box() const override { return box_; }

  /// the coarsest lattice that can show so many faces: of its surface there is not enough for more,
  /// and of thin parts no more is seen than what lies around points in them.
  double most_spacing(std::size_t faces) const;

  std::size_t number_of_parts() const { return parts_.size(); }
  const std::string& description() const { return description_; }
  std::optional<std::size_t> genus() const { return genus_; }
  std::size_t faces() const { return faces_; }

private:
  // How far a point is from a part, whose edges have a radius.
  using Distance = std::function<double(const Vector&, double)>;

  /// A part: how far a point is from it, and how it is joined to those before.
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

/// the mesh of a shape with about as many faces as asked for. Throws `std::invalid_argument`, with
/// the name, if they are too many, and with a number that is enough if they are too few for the
/// genus that the text tells.
Soup mesh_of_shape(const Shape& shape, const Request& request, const char* name);

/// those that are kept in shapes/, each a kind of its own.
std::vector<Kind> kinds_of_shapes();

/// the names and the texts of the files in shapes/.
const std::vector<std::pair<const char*, std::string_view>>& shape_texts();

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // CGAL_HANDLE_TUNNEL_LOOPS_GENERATORS_SHAPE_H
