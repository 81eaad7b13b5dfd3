// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_RINGS_AROUND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_RINGS_AROUND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Cut_region.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Growing_faces.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The faces at some vertices, and rings around them: as long as more and more rings are asked for,
/// none is laid twice.
class Rings_around
{
public:
  using Marks = Workspace_pool<Face_marks>;

  Rings_around(const Surgery_mesh& mesh, Marks& marks, std::vector<Index> vertices)
      : mesh_(mesh)
      , marks_(marks)
      , vertices_(std::move(vertices)) {}

  /// the region of so many rings, if it holds whole handles and is not too large.
  std::optional<Cut_region> region(int rings) {
    if(!faces_ || rings < number_)
      begin();
    for(; number_ < rings && faces_->size() <= most_; ++number_)
      faces_->add_ring();
    return faces_->size() <= most_ ? Cut_region::whole(mesh_, *faces_, most_) : std::nullopt;
  }

private:
  void begin() {
    faces_.reset();
    if(!borrowed_)
      borrowed_.emplace(marks_.borrow());
    faces_.emplace(mesh_, **borrowed_, vertices_);
    number_ = 0;
    // Where all is near, as on a random surface, a few rings would hold the whole of it.
    most_ = 1024 + 16 * faces_->size();
  }

  const Surgery_mesh& mesh_;
  Marks& marks_;
  const std::vector<Index> vertices_;
  std::optional<decltype(std::declval<Marks&>().borrow())> borrowed_;
  std::optional<Growing_faces> faces_;
  int number_ = 0; // of rings
  std::size_t most_ = 0;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_RINGS_AROUND_H
