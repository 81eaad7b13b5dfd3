// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_CORNER_NORMALS_H
#define HTL_PICTURE_CORNER_NORMALS_H

#include "Vector_3.h"
#include "picture.h"

#include <array>
#include <cstdint>
#include <vector>

namespace htl_picture {

/// The normals with which triangles are shaded: at each corner the mean of those of the triangles
/// around it that make a small angle with the triangle itself, so that creases stay sharp.
class Corner_normals
{
public:
  Corner_normals(const std::vector<Vector_3>& points, const std::vector<Triangle>& triangles);

  std::array<Vector_3, 3> operator()(std::uint32_t triangle) const;

private:
  const std::vector<Triangle>& triangles_;
  std::vector<Vector_3> normals_; ///< of the triangles, as long as twice their areas
  std::vector<std::uint32_t> first_at_, at_vertex_; ///< the triangles at each vertex
};

} // namespace htl_picture

#endif // HTL_PICTURE_CORNER_NORMALS_H
