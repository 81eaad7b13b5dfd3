// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VOLUME_CHANGE_H
#define HTLOOPS_VOLUME_CHANGE_H

#include "words.h"

#include <cmath>
#include <string>

namespace htloops {

/// What a step would make of the volume of a piece of a solid.
struct Volume_change
{
  double before = 0., after = 0.;

  double share() const { return (after - before) / before; }

  /// whether a person must have asked for it.
  bool is_large() const {
    constexpr double most = 0.05; // repairs change less, and who prints or weighs it sees more
    return std::abs(after - before) > most * before;
  }

  std::string words() const {
    return formatted("the volume from %.6g to %.6g (%+.0f%%)", before, after, 100. * share());
  }
};

} // namespace htloops

#endif // HTLOOPS_VOLUME_CHANGE_H
