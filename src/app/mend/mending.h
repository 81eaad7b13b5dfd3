// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MENDING_H
#define HTLOOPS_MENDING_H

#include "read/soup.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// What may be done to a mesh that is not fit as it is.
struct Remedies
{
  bool do_triangulate = false;
  bool do_repair = false;

  bool any() const { return do_triangulate || do_repair; }
};

/// One kind of change, in words that follow the count.
struct Change
{
  std::size_t count;
  std::string words;
};

/// A soup, and what has been done to it. Vertices keep the numbers that they have in the file; new
/// ones come after them.
struct Mended_soup
{
  Soup soup;
  std::vector<Change> changes;
  std::vector<std::uint32_t> face_in_file; ///< of each face, the one that it was or is part of
  std::vector<std::uint32_t> origins;      ///< of each new vertex, one of the file
  /// Edges that are in no face of the file, by vertices of the file, the smaller one first; sorted.
  std::vector<std::array<std::uint32_t, 2>> diagonals;
  bool is_one_sided = false; ///< then its faces have not been glued

  /// the vertex of the file that a vertex is or is a copy of.
  std::uint32_t in_file(std::uint32_t vertex) const {
    const std::size_t old = soup.points.size() - origins.size();
    return vertex < old ? vertex : origins[vertex - old];
  }

  std::uint32_t add_vertex(const Point& point, std::uint32_t origin) {
    soup.points.push_back(point);
    origins.push_back(origin);
    return static_cast<std::uint32_t>(soup.points.size() - 1);
  }
};

/// applies remedies. What they do not help against stays: points that are nowhere, surfaces that
/// are not orientable. A sound soup is left as it is. Takes a time that is linear but for sorting.
Mended_soup mend(Soup soup, const Remedies& remedies);

} // namespace htloops

#endif // HTLOOPS_MENDING_H
