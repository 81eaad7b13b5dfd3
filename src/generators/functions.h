// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_GENERATORS_FUNCTIONS_H
#define HTL_GENERATORS_FUNCTIONS_H

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

namespace CGAL::Handle_tunnel_loops::generators {

// Those of the C library differ from machine to machine in their last bits, and then so do meshes.
using internal::arc_cosine;
using internal::arc_tangent;
using internal::cosine;
using internal::exponential;
using internal::logarithm;
using internal::power;
using internal::sine;
using internal::sine_and_cosine;

inline double hypotenuse(double x, double y) { return std::sqrt(x * x + y * y); }

} // namespace CGAL::Handle_tunnel_loops::generators

#endif // HTL_GENERATORS_FUNCTIONS_H
