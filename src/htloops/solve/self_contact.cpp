// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/self_contact.h"

#include <CGAL/Handle_tunnel_loops/internal/patches/triangle_contacts.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace htloops {
namespace {

namespace internal = CGAL::Handle_tunnel_loops::internal;

using internal::Index;
using internal::Placed_triangle;
using Box = internal::Box<3>;

class Watch_by_function final : public internal::Watch
{
public:
  explicit Watch_by_function(const std::function<void()>& look)
      : look_(look) {}

  void look() override { look_(); }

private:
  const std::function<void()>& look_;
};

/// Finds whether faces meet that should not. Only those whose boxes meet are asked. The faces are
/// halved again and again where they extend farthest, so that a vertex far away makes no neighbors
/// of faces that are none. (`Polygon_mesh_processing::does_self_intersect()` says the same, but
/// does not let itself be interrupted, and copies the mesh.)
class Self_contact
{
public:
  Self_contact(internal::Execution how, const Mesh& mesh)
      : mesh_(mesh)
      , execution_(how)
      , order_(mesh.number_of_faces())
      , tree_(ordered_boxes()) {}

  bool is_there() const {
    std::atomic<bool> is_found(false);
    constexpr std::size_t grain = 256;
    internal::for_each_index(
        execution_, order_.size(),
        [&](std::size_t i) {
          if(!is_found && touches_an_earlier_one(i))
            is_found = true;
        },
        grain);
    return is_found;
  }

private:
  Placed_triangle triangle(Index face) const {
    Placed_triangle t;
    std::size_t i = 0;
    const Mesh::Face_index f(face);
    for(const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh_.halfedge(f), mesh_)) {
      const Point& p = mesh_.point(v);
      t.vertices[i] = static_cast<Index>(v.idx());
      t.points[i++] = {p.x(), p.y(), p.z()};
    }
    return t;
  }

  std::vector<Box> ordered_boxes() {
    std::vector<Box> boxes(order_.size()), ordered(order_.size());
    internal::for_each_index(execution_, boxes.size(), [&](std::size_t f) {
      boxes[f] = triangle(static_cast<Index>(f)).box();
    });
    std::iota(order_.begin(), order_.end(), Index(0));
    halve(order_.data(), order_.data() + order_.size(), boxes);
    internal::for_each_index(execution_, boxes.size(),
                             [&](std::size_t i) { ordered[i] = boxes[order_[i]]; });
    return ordered;
  }

  void halve(Index* begin, Index* end, const std::vector<Box>& boxes) const {
    constexpr std::ptrdiff_t few = 4;
    if(end - begin <= few)
      return;
    execution_.look();
    Box corners = Box::empty();
    for(const Index* i = begin; i != end; ++i)
      corners.extend({boxes[*i].low, boxes[*i].low});
    std::size_t axis = 0;
    for(std::size_t d = 1; d < 3; ++d)
      if(corners.high[d] - corners.low[d] > corners.high[axis] - corners.low[axis])
        axis = d;
    Index* const middle = begin + (end - begin) / 2;
    std::nth_element(begin, middle, end,
                     [&](Index a, Index b) { return boxes[a].low[axis] < boxes[b].low[axis]; });
    halve(begin, middle, boxes);
    halve(middle, end, boxes);
  }

  bool touches_an_earlier_one(std::size_t i) const {
    const Placed_triangle here = triangle(order_[i]);
    bool touches = here.is_degenerate();
    tree_.for_each_meeting(tree_.box(i), [&](Index j, const Box&) {
      touches = touches || (j < i && internal::are_in_contact(here, triangle(order_[j])));
    });
    return touches;
  }

  const Mesh& mesh_;
  internal::Execution execution_;
  std::vector<Index> order_;
  internal::Box_tree<3> tree_;
};

} // namespace

bool touches_itself(const Mesh& mesh, const std::function<void()>& look) {
  Watch_by_function watch(look);
  const auto execution = internal::execution_of<CGAL::Parallel_if_available_tag>();
  return Self_contact(execution.watched_by(watch), mesh).is_there();
}

} // namespace htloops
