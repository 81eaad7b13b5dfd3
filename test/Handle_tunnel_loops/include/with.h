// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_TEST_WITH_H
#define HTL_TEST_WITH_H

/// options of which one is set: `with(&Solver_options::do_tighten, false)`; by default of those
/// that nobody has touched.
template <typename Options, typename Member, typename Value>
Options with(Member Options::*member, const Value& value, Options options = {}) {
  options.*member = value;
  return options;
}

#endif // HTL_TEST_WITH_H
