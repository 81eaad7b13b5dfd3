// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHARTS_H
#define HTLOOPS_CHARTS_H

#include "generators/generators.h"

#include <array>
#include <cstddef>
#include <vector>

namespace htloops {

/// Disks laid out in the unit square.
struct Charts
{
  std::vector<std::array<double, 2>> places; ///< by vertex
  std::size_t number = 0;
  std::size_t number_of_fine_ones = 0; ///< that single precision would turn over in places
  /// How much longer things become one way than across it, in the mean over the surface.
  double angle_distortion = 1.;
  /// By how much areas become smaller or larger than in the mean; but for a twentieth at each end.
  double least_area = 1., largest_area = 1.;
};

/// whether this build can make them: that wants Eigen.
bool can_make_charts();

/*!
lays out the components of an opened mesh, each a disk, as charts. No triangle is turned over or
flat, and no chart meets itself or another one: exact predicates say so of the places as they are,
which are numbers of single precision where that suffices. Areas are in proportion as far as can be.

A chart is as rigid as possible if that keeps all triangles upright, and else the least distorted
one of those that are conformal, or have a circle as their border, which keeps them so but for
roundings. Throws `Failure` if none does.
*/
Charts make_charts(const CGAL::Handle_tunnel_loops::generators::Soup& opened);

} // namespace htloops

#endif // HTLOOPS_CHARTS_H
