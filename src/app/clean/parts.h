// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PARTS_H
#define HTLOOPS_PARTS_H

#include "clean/crossings.h"
#include "solve/changeable_mesh.h"

#include <CGAL/Bbox_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace htloops {

/// A connected component of a surface.
struct Part
{
  std::size_t faces = 0;
  double area = 0.;
  /// whether its faces look outwards, 1, or inwards, -1; 0 where rounding decides that, and of what
  /// has a boundary.
  int orientation = 0;
  double volume = 0.; ///< that it encloses; 0 where no orientation is known
  CGAL::Bbox_3 box = {};
  bool is_closed = true;
  bool meets_others = false; ///< crosses or touches them
  std::size_t depth = 0;     ///< how many others it lies inside of, crossing none of them
  std::vector<std::uint32_t> around = {}; ///< which these are

  /// whether its faces look to where the material is not.
  bool is_turned() const { return orientation == (depth % 2 == 0 ? -1 : 1); }
};

/// The components of a surface.
struct Parts
{
  std::vector<Part> all;
  std::vector<std::uint32_t> of_face; ///< by the number of a face

  const Part& part_of(Changeable_mesh::Face_index f) const { return all[of_face[f.idx()]]; }
};

/// the components, each by itself. Linear in the size of the mesh.
Parts measured_parts(const Changeable_mesh& mesh);

/// the components, with how they lie in each other, which is decided exactly. Near linear in the
/// size of the mesh and the number of components of which the boxes lie in each other.
Parts parts_of(const Changeable_mesh& mesh, const Crossings& crossings);

} // namespace htloops

#endif // HTLOOPS_PARTS_H
