// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_FIELD_CONSTANTS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_FIELD_CONSTANTS_H

#include <CGAL/license/Handle_tunnel_loops.h>

namespace CGAL {
namespace Handle_tunnel_loops {

/*!
\ingroup PkgHandleTunnelLoopsRef

The constants of the phase field; the defaults are those of the paper, section 3. Times are in the
unit of the paper's equation, lengths in local edge lengths.

The front is a cosine about \f$ \pi\,a/\sqrt{2w} \f$ edges wide and moves
\f$ \mu e a / (2 \sqrt{2 w}) \f$ edges per unit of time. It needs `driving_force > 0` to move and a
width of a few edges to be smooth: the defaults give five. A smaller step takes as many more of
them, and as much more time.
*/
struct Field_constants
{
  double mobility = 1. / 4.;              ///< \f$ \mu > 0 \f$
  double driving_force = 1. / 30.;        ///< \f$ e > 0 \f$
  double gradient_coefficient = 1. / 25.; ///< \f$ a^2 > 0 \f$
  double penalty = 1. / 125.;             ///< \f$ w > 0 \f$, with \f$ e > w \f$
  double step = 1.0; ///< time step, in [1/1024, 1], as a fraction of the largest stable one
};

} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_FIELD_CONSTANTS_H
