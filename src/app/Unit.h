// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_UNIT_H
#define HTLOOPS_UNIT_H

namespace htloops {

/// The length that coordinates are counted in, where a file says so; as 3MF has them, in its order.
enum class Unit : char { NONE, MICRON, MILLIMETER, CENTIMETER, INCH, FOOT, METER };

struct Unit_words
{
  const char* name; ///< as 3MF has it
  const char* sign;
  double metres;
};

/// its words; those of no unit are empty.
inline const Unit_words& words_of(Unit unit) {
  static constexpr Unit_words words[] = {{"", "", 1.},
                                         {"micron", "um", 1e-6},
                                         {"millimeter", "mm", 1e-3},
                                         {"centimeter", "cm", 0.01},
                                         {"inch", "in", 0.0254},
                                         {"foot", "ft", 0.3048},
                                         {"meter", "m", 1.}};
  return words[static_cast<int>(unit)];
}

} // namespace htloops

#endif // HTLOOPS_UNIT_H
