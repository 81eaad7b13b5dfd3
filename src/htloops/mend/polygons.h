// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_POLYGONS_H
#define HTLOOPS_POLYGONS_H

#include "read/soup.h"

#include <CGAL/Handle_tunnel_loops/internal/support/Index.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace htloops {

/// The vertices of a face of any size, in their order.
using Corners = std::vector<std::uint32_t>;

/// calls `visit(number of the face, corners)` for each face of a soup.
template <typename Visit> void for_each_polygon(const Soup& soup, Visit visit) {
  Corners corners;
  const std::uint32_t* further = soup.further_corners.data();
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const Soup_face& face = soup.faces[f];
    corners.assign(face.begin(), face.end());
    if(face.size() > 3) {
      const std::uint32_t* const end = further + (face.size() - 3);
      corners.insert(corners.end(), further, end);
      further = end;
    }
    visit(f, corners);
  }
}

/// calls `visit(u, v)` for each side of a polygon.
template <typename Visit> void for_each_side(const Corners& corners, Visit visit) {
  for(std::size_t i = 0; i < corners.size(); ++i)
    visit(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]);
}

/// the same for all polygons with the same sides: from the least corner on, its smaller neighbor
/// next. (A corner that comes twice makes no more of it than that one may be missed.)
inline Corners in_standard_order(Corners corners) {
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  if(corners.back() < corners[1])
    std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

inline void add_face(Soup& soup, const Corners& corners) {
  Soup_face& face = soup.faces.emplace_back();
  face.resize(corners.size());
  for(std::size_t i = 0; i < corners.size(); ++i)
    soup.set_corner(face, i, corners[i]);
}

/// one number for an edge, whatever its direction; the smaller vertex counts first.
using CGAL::Handle_tunnel_loops::internal::edge_key;

} // namespace htloops

#endif // HTLOOPS_POLYGONS_H
