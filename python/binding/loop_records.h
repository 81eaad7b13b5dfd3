// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

// Loops as arrays, and back.

#ifndef HTL_PYTHON_LOOP_RECORDS_H
#define HTL_PYTHON_LOOP_RECORDS_H

#include "arrays.h"

#include "app/read/loops_reader.h"
#include "app/solve/answer.h"

#include <CGAL/Handle_tunnel_loops/Basis_kind.h>

#include <string>

namespace htl_python {

/// of the name of a kind of basis; throws `std::invalid_argument` if there is none of that name.
CGAL::Handle_tunnel_loops::Basis_kind basis_kind(const std::string& name);

/// the places of loops, one loop after the other, and their lengths.
py::dict record_of(const htloops::Mesh& mesh, const std::vector<const htloops::Loop*>& loops);

/// what is known of an answer: the loops, handle and tunnel of each pair in turn, the curves of the
/// boundary, the certificate and the rest.
py::dict record_of(const htloops::Mesh& mesh, const htloops::Answer& answer);

/// what a certificate says, and the sides of the loops.
py::dict certificate_of(const CGAL::Handle_tunnel_loops::Certificate& certificate);

/// the loops of a record on a mesh, with the boundary curves and their waists. Throws
/// `std::invalid_argument` if they are not on it.
htloops::Bound_loops loops_of(const py::dict& record, const htloops::Mesh& mesh);

/// the pairs of a record on a mesh. Throws `std::invalid_argument` if they are not on it.
htloops::Pairs pairs_of(const py::dict& record, const htloops::Mesh& mesh);

} // namespace htl_python

#endif // HTL_PYTHON_LOOP_RECORDS_H
