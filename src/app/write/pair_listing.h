// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PAIR_LISTING_H
#define HTLOOPS_PAIR_LISTING_H

#include "mesh_types.h"
#include "solve/answer.h"
#include "solve/details.h"
#include "solve/removal_solver.h"

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// By what listed pairs follow each other.
enum class Pair_order {
  SIZE,   ///< the shorter loop, the smallest first
  LENGTH, ///< both loops together, the shortest first
  PAIR,   ///< the number of the pair
  PLACE,  ///< the centre, by x, then y, then z
  NOISE   ///< the smaller of thickness and clear width; what is not measured comes last
};

/// Which pairs are listed, shown and drawn.
struct Listing_options
{
  Pair_order order = Pair_order::SIZE;
  double shorter_than = (std::numeric_limits<double>::infinity)(); ///< one of the loops at least
  double longer_than = 0.;                                         ///< both loops
  double noise_below = (std::numeric_limits<double>::infinity)();  ///< the smaller measure
  std::optional<CGAL::Bbox_3> box; ///< in which one of the loops lies, one that is shorter
};

/// How wide the hole of a handle is: the bore, or else the circle that fits the tunnel loop best.
struct Listed_hole
{
  double diameter;
  std::optional<Bore> bore;
  double out_of_roundness; ///< of the tunnel loop: see `Loop_shape::Circle`; 0 for a bore
  double wall_diameter;    ///< of a circle as long as the handle loop, around the wall beside it

  const char* word() const { return bore ? "bore" : "hole"; }
};

/// A ball that can be threaded, without the curve along which it goes.
struct Listed_ball
{
  double diameter, error;
  Point throat;
};

/// How thick a handle is, and how wide its hole; why not, if one of them is not known.
struct Listed_measure
{
  std::optional<Listed_ball> thickness, clear_width;
  Range_of_diameters thickness_range, clear_width_range, noise; ///< `noise_of()`
  std::string why;
};

/// What became of a handle: one of these.
struct Listed_removal
{
  std::optional<Removed_handle> done;
  std::optional<Refused_handle> refused;
};

/// how wide the hole of a pair is, around which there is that bore, or none.
Listed_hole hole_of(const Pair& pair, const std::optional<Bore>& bore);

/// What is told of a pair beside the loops themselves.
struct Listed_pair
{
  std::size_t pair; ///< its number
  double handle_length, tunnel_length;
  double size;      ///< `size_of()`
  Point centre;     ///< of the bore, or else of the box of the shorter loop
  CGAL::Bbox_3 box; ///< of the shorter loop
  Listed_hole hole;
  std::optional<Listed_measure> measure;      ///< if it was taken
  std::optional<Costs::value_type> costs;     ///< of its removal, if they were asked for
  std::optional<Listed_removal> removal = {}; ///< if its handle was to be removed
};

using Pair_listing = std::vector<Listed_pair>;

/// those of a listing that were to be removed, with what became of them.
Pair_listing list_removals(const Pair_listing& listing, const Removal_report& report);

/// the pairs that are wanted, in the order that is wanted; those that are equal in it by number.
Pair_listing
list_pairs(const Mesh& mesh, const Answer& answer, const Listing_options& options = {});

/// the middle of a box.
Point middle_of(const CGAL::Bbox_3& box);

/// what is told of one pair on a mesh with this box.
Listed_pair listed_pair(const Answer& answer, std::size_t number, const CGAL::Bbox_3& box_of_mesh);

/// the length of the shorter loop, relative to the diagonal of the mesh's box; 0 if that is a
/// point.
double size_of(const Pair& pair, const CGAL::Bbox_3& box_of_mesh);

} // namespace htloops

#endif // HTLOOPS_PAIR_LISTING_H
