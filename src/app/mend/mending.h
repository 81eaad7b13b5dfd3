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

#include "mend/Change_log.h"
#include "read/soup.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// The steps of a repair, in their order.
enum class Repair_step : char {
  DEGENERATE, ///< drop faces that name a vertex twice
  WELD,       ///< make one vertex of those at the same place along open edges
  DUPLICATES, ///< drop faces that are there several times, and flaps
  ONE_SIDED,  ///< drop components that are not orientable
  PILLOWS,    ///< drop components of two faces that close each other off
  ORIENT,     ///< turn faces over until neighbors agree
  SPLIT       ///< split edges with more than two faces, and vertices with more than one fan
};

constexpr std::size_t number_of_repair_steps = 7;

/// which steps there are to be, by their order.
using Repair_steps = std::bitset<number_of_repair_steps>;

/// what the step is called in options.
const char* name_of(Repair_step step);

/// A length, or a share of the diagonal of the box of a mesh.
struct Relative_length
{
  double value;
  bool is_share;
};

/// What may be done to a mesh that is not fit as it is.
struct Remedies
{
  bool do_triangulate = false;
  bool do_repair = false;
  Repair_steps steps = Repair_steps(~0ull); ///< of the repair
  std::optional<Relative_length> weld =
      std::nullopt; ///< within which points of open edges are welded

  bool any() const { return do_triangulate || do_repair || weld.has_value(); }
  bool has(Repair_step step) const {
    return do_repair && steps.test(static_cast<std::size_t>(step));
  }
};

/// A soup, and what has been done to it. Vertices keep the numbers that they have in the file; new
/// ones come after them.
struct Mended_soup
{
  Soup soup;
  Change_log log;                          ///< from the file to this
  std::vector<Change> changes;             ///< what the log says in the end
  std::vector<std::uint32_t> face_in_file; ///< of each face, the one that it was or is part of
  std::vector<std::uint32_t> origins;      ///< of each new vertex, one of the file
  /// Edges that are in no face of the file, by vertices of the file, the smaller one first; sorted.
  std::vector<std::array<std::uint32_t, 2>> diagonals;
  bool is_one_sided = false; ///< in a component that stays; then faces have not been glued

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

/// applies remedies; throws `Failure` if welding within a length would make no surface. What they
/// do not help against stays: points that are nowhere, a surface of which no component is
/// orientable. A sound soup without pillows is left as it is. Takes a time that is linear but for
/// sorting.
Mended_soup mend(Soup soup, const Remedies& remedies);

} // namespace htloops

#endif // HTLOOPS_MENDING_H
