// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "emptiness.h"

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

void add_octants(const Box& box, std::vector<Box>& boxes) {
  const Vector half = (box.high - box.low) / 2.;
  for(int octant = 0; octant < 8; ++octant) {
    const Vector low =
        box.low + Vector((octant & 1) != 0 ? half.x() : 0., (octant & 2) != 0 ? half.y() : 0.,
                         (octant & 4) != 0 ? half.z() : 0.);
    boxes.push_back({low, low + half});
  }
}

} // namespace

bool is_empty(const Field& field) {
  constexpr int most_boxes = 200000;
  std::vector<Box> boxes = {field.box()};
  for(int count = 0; !boxes.empty(); ++count) {
    const Box box = boxes.back();
    boxes.pop_back();
    const double value = field((box.low + box.high) / 2.);
    if(value < 0. || count == most_boxes)
      return false;
    // The field is no more than the distance to the surface: a large value tells of the whole box.
    if(value < length(box.high - box.low) / 2.)
      add_octants(box, boxes);
  }
  return true;
}

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
