// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_CHECK_CONSTANTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_CHECK_CONSTANTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>

#include <cmath>
#include <stdexcept>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// throws `std::invalid_argument` if no front would move with these constants, or too slowly.
inline void check_constants(const Field_constants& c) {
  const bool are_finite = std::isfinite(c.mobility) && std::isfinite(c.gradient_coefficient) &&
                          std::isfinite(c.penalty) && std::isfinite(c.driving_force);
  if(!(are_finite && c.mobility > 0. && c.gradient_coefficient > 0. && c.penalty > 0. &&
       c.driving_force > c.penalty))
    throw std::invalid_argument("the field's constants must be positive, and the driving force "
                                "must be larger than the penalty");
  if(!(c.step >= smallest_step && c.step <= 1.))
    throw std::invalid_argument("the field's time step must be in [1/1024, 1]");
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_CHECK_CONSTANTS_H
