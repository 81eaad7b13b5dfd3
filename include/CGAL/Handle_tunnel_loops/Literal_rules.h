// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_LITERAL_RULES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_LITERAL_RULES_H

#include <CGAL/license/Handle_tunnel_loops.h>

namespace CGAL {
namespace Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

Rules of the paper in whose place the reference solver has others, which hold on any mesh. It
follows those to the letter that are set here, and throws `Literal_failure_exception` where a rule
leads nowhere. None is set by default.
*/
struct Literal_rules
{
  /// section 3, "the standard linear finite element approximation": the Laplacian has cotangents as
  /// weights, with a diagonal matrix of masses. Lengths are in mean edge lengths. By default it is
  /// the mean of the neighbors less the value, whose weights are positive on any mesh.
  bool finite_elements = false;

  /// section 3, "gradient energy coefficients are set to 1/25": \f$ a = 1/25 \f$, so that
  /// \f$ a^2 = 1/625 \f$, and a front is one edge wide. By default \f$ a^2 = 1/25 \f$, and it is
  /// five edges wide. `field_constants` are as they are given otherwise.
  bool gradient_coefficient = false;

  /// sections 4.1 and 5: fronts are components of the triangles of a band, a front has split where
  /// there are several, and fronts meet that have values at the same vertex. By default fronts are
  /// boundary curves of what is covered, and split and meet at vertices.
  bool bands = false;

  /// section 4.2: the field that looks for a tunnel is restricted to what was covered when its
  /// handle was found. By default the handles that were found later are walls.
  bool covered_area = false;

  /// sections 4.2 and 4.3: the streamline from the first point reached is taken, whatever it
  /// crosses. By default the shortest of several is, that crosses what it should.
  bool first_reached = false;

  /// section 4.3: a refined handle is always taken. By default it is if it is shorter and the loops
  /// remain a basis.
  bool refined_always = false;

  /// section 4.5: loops are told apart by "slightly offsetting" them along the normals and
  /// "checking the changes" of their lengths. By default linking numbers name them, or, without
  /// these, the derivative of the length by the offset, which name them before this rule does: it
  /// is for `do_compute_linking(false)`.
  bool finite_offset = false;

  /// the mean edge length in the unit of the paper, which it does not tell, for
  /// `gradient_coefficient`: with 1/5 the front is as wide as by default, with 1 it comes to rest.
  double mean_edge_length = 1. / 5.;

  /// the value above which a vertex is in the band of a layer; the paper has "a given threshold".
  double band_threshold = 0.3;

  /// the value above which a layer is at a vertex, so that it meets others there; that of the paper
  /// is 0.
  double contact_threshold = 0.;

  /// by how many mean edge lengths loops are moved; the paper has "slightly".
  double offset = 0.1;

  /// all of them.
  static Literal_rules all() { return {true, true, true, true, true, true, true}; }

  /// whether the fields are others than by default; where they come to rest there is no answer.
  bool are_of_fields() const { return finite_elements || gradient_coefficient || bands; }

  /// whether one is set.
  bool any() const {
    return are_of_fields() || covered_area || first_reached || refined_always || finite_offset;
  }
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_LITERAL_RULES_H
