// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_COMPONENT_ORIENTATION_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_COMPONENT_ORIENTATION_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Volume_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/halfedge_near.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/coordinates.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the corners of a triangle, counterclockwise.
template <typename Face, typename Mesh>
std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 3> corners(const Face& f,
                                                                             const Mesh& mesh) {
  const auto h = halfedge(f, mesh);
  return {target(h, mesh), target(next(h, mesh), mesh), source(h, mesh)};
}

/// the signs of the volumes that components enclose, exactly. `for_each_triangle(f)` calls
/// `f(component, triangle)` for all of their triangles.
std::vector<int> signs_of_volumes(
    std::size_t number_of_components,
    const std::function<void(const std::function<void(std::size_t, const Triangle&)>&)>&
        for_each_triangle);

/// Where a triangle is seen from a point if one looks up or down from it.
enum class Seen_triangle { NOWHERE, ABOVE, HERE, BELOW };

/// says it exactly, from the point half way between a and b. It is moved aside by an infinitesimal
/// amount, so that it lies above no edge.
Seen_triangle see_triangle(const Triangle& t, const Vector& a, const Vector& b);

/// the same from a point.
inline Seen_triangle see_triangle(const Triangle& t, const Vector& point) {
  return see_triangle(t, point, point);
}

/// On which side of the components of a surface the solid is.
struct Solid_sides
{
  /// by component, 1 if the faces look out of the solid, -1 if they look into it, 0 if that cannot
  /// be told.
  std::vector<int> outward;

  /// by component, in words, why that is 0.
  std::vector<std::string> reasons;
};

/*!
Tells on which side of the components of a closed surface the solid is: the points that are enclosed
by an odd number of components. So the faces of a component look out of the solid if the volume that
they enclose is positive and the component lies within an even number of others, or if it is
negative and the number is odd. How the input is oriented plays no part, as long as each component
is consistent in itself.

The sign of the volume is exact. A component is said to lie within another if its bounding box
does and the first of its vertices does, which is decided exactly by counting the faces above it. So
components that cross each other count as lying beside each other unless the boxes say otherwise.

A component with boundary, of which the faces given are those of its caps as well, encloses nothing:
its faces look out of the solid as they are oriented.
*/
template <typename TriangleMesh, typename VertexPointMap, typename ComponentOfFace>
class Component_orientation
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

public:
  /// \p component maps a face to the number of its component. What is asked for later are
  /// components with `is_wanted`. Those with `has_boundary` have caps.
  Component_orientation(Execution execution,
                        const TriangleMesh& tm,
                        VertexPointMap point,
                        const ComponentOfFace& component,
                        std::vector<char> is_wanted,
                        std::vector<char> has_boundary)
      : tm_(tm)
      , point_(point)
      , component_(component)
      , is_wanted_(std::move(is_wanted))
      , has_boundary_(std::move(has_boundary))
      , parts_(is_wanted_.size()) {
    if(std::find(is_wanted_.begin(), is_wanted_.end(), 1) == is_wanted_.end())
      return;
    const auto all = parts_of(faces(tm));
    find_volumes(execution, all);
    find_signs();
    if(parts_.size() > 1)
      find_nesting(execution, all);
  }

  Solid_sides sides() const {
    Solid_sides sides;
    for(const Part& part : parts_) {
      sides.outward.push_back(part.is_touched ? 0 : part.sign);
      sides.reasons.push_back(part.is_touched ? "a vertex of one component lies on another"
                                              : "a component encloses no volume");
    }
    return sides;
  }

private:
  // A box around points, and the first of them: as far as is known, in the given part of the faces.
  struct Extent
  {
    std::size_t part = 0;
    Vector first = {0., 0., 0.};
    Box<3> box = Box<3>::empty();

    bool is_empty() const { return box.low[0] > box.high[0]; }

    void add(const Triangle& t) {
      if(is_empty())
        first = t[0];
      for(const Vector& p : t)
        box.extend({p, p});
    }

    void add(const Extent& e, std::size_t part_of_e) {
      if(is_empty() || part_of_e < part) {
        first = e.first;
        part = part_of_e;
      }
      box.extend(e.box);
    }
  };

  struct Part
  {
    Extent extent;
    Volume_sum volume;
    int sign = 0;
    bool is_touched = false;
  };

  Triangle triangle(face_descriptor f) const {
    const auto [u, v, w] = corners(f, tm_);
    return {coordinates(point_, u), coordinates(point_, v), coordinates(point_, w)};
  }

  // ---- boxes and volumes

  // Adds up results in the parts of components, where `f(result, component, element)` adds a face,
  // or a vertex. Threads do so for runs of elements of one component, and end in any order: what
  // becomes of rounding errors is up to them, but no more than a bound of these is used.
  template <typename Result, typename Elements, typename Component, typename F>
  void add_up(Execution execution,
              const Elements& all,
              const Component& component_of,
              Result Part::*result_of,
              const F& f) {
    std::mutex mutex;
    all.for_each_part(execution, [&](std::size_t i, auto begin, auto end) {
      std::vector<std::pair<std::size_t, Result>> runs;
      while(begin != end) {
        const std::size_t component = component_of(*begin);
        CGAL_precondition(component < parts_.size());
        Result result;
        for(; begin != end && component_of(*begin) == component; ++begin)
          f(result, component, *begin);
        runs.emplace_back(component, result);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for(const auto& [component, result] : runs)
        (parts_[component].*result_of).add(result, i);
    });
  }

  // A box is of use only where there are several.
  template <typename Faces> void find_volumes(Execution execution, const Faces& all) {
    if(parts_.size() == 1 && all.size() > 0)
      parts_[0].extent.first = triangle(*faces(tm_).begin())[0];
    else
      add_up(execution, all, component_, &Part::extent,
             [this](Extent& extent, std::size_t, face_descriptor f) { extent.add(triangle(f)); });
    // Rings are gone through in a third of the time that it takes to find the faces in them.
    const auto plane = [this](std::size_t component) { return parts_[component].extent.first[2]; };
    if constexpr(std::is_same_v<TriangleMesh, Flat_graph>)
      add_up(
          execution, parts_of(vertices(tm_)),
          [this](Index v) {
            return parts_.size() == 1 ? 0 : component_(face(Flat_graph::Halfedge{v, 0}, tm_));
          },
          &Part::volume,
          [&](Volume_sum& volume, std::size_t component, Index v) {
            if(is_wanted_[component])
              volume.add_star(
                  v, tm_.mesh().ring(v), [&](Index u) { return coordinates(point_, u); },
                  plane(component));
          });
    else
      add_up(execution, all, component_, &Part::volume,
             [&](Volume_sum& volume, std::size_t component, face_descriptor f) {
               if(is_wanted_[component])
                 volume.add(triangle(f), plane(component));
             });
  }

  void find_signs() {
    std::vector<char> is_open(parts_.size(), 0);
    for(std::size_t i = 0; i < parts_.size(); ++i) {
      Part& part = parts_[i];
      if(has_boundary_[i])
        part.sign = 1;
      if(!is_wanted_[i] || has_boundary_[i])
        continue;
      part.sign = part.volume.sign();
      is_open[i] = part.sign == 0;
    }
    if(std::find(is_open.begin(), is_open.end(), 1) != is_open.end())
      find_exact_signs(is_open);
  }

  void find_exact_signs(const std::vector<char>& is_open) {
    const std::vector<int> signs = signs_of_volumes(parts_.size(), [&](const auto& add) {
      for(face_descriptor f : faces(tm_))
        if(is_open[component_(f)])
          add(component_(f), triangle(f));
    });
    for(std::size_t i = 0; i < parts_.size(); ++i)
      if(is_open[i])
        parts_[i].sign = signs[i];
  }

  // ---- components within components

  bool may_contain(std::size_t outer, std::size_t inner) const {
    const Box<3>&a = parts_[outer].extent.box, &b = parts_[inner].extent.box;
    bool is_within = outer != inner && !has_boundary_[outer] && !has_boundary_[inner];
    for(int d = 0; d < 3; ++d)
      is_within = is_within && a.low[d] <= b.low[d] && b.high[d] <= a.high[d];
    return is_within;
  }

  // The first points of the components that lie in the box of another.
  std::vector<std::size_t> open_components(Execution execution) const {
    std::vector<Box<3>> boxes;
    for(const Part& part : parts_)
      boxes.push_back(part.extent.box);
    const Sorted_boxes<3> sorted(execution, boxes);
    std::vector<std::size_t> open;
    for(std::size_t i = 0; i < parts_.size(); ++i)
      if(is_wanted_[i] &&
         sorted.any_meeting(boxes[i], [&](Index j, const Box<3>&) { return may_contain(j, i); }))
        open.push_back(i);
    return open;
  }

  // Turns the sign of a component with each face above its first point that belongs to a component
  // whose box contains it.
  template <typename Faces> void find_nesting(Execution execution, const Faces& all) {
    const std::vector<std::size_t> open = open_components(execution);
    if(open.empty())
      return;
    std::vector<Box<2>> boxes;
    for(std::size_t i : open) {
      const Vector& p = parts_[i].extent.first;
      boxes.push_back({{p[0], p[1]}, {p[0], p[1]}});
    }
    const Sorted_boxes<2> sorted(execution, boxes);
    std::mutex mutex;
    all.for_each(execution, [&](face_descriptor f) {
      const Triangle t = triangle(f);
      const auto [x1, x2] = std::minmax({t[0][0], t[1][0], t[2][0]});
      const auto [y1, y2] = std::minmax({t[0][1], t[1][1], t[2][1]});
      sorted.for_each_meeting({{x1, y1}, {x2, y2}}, [&](Index i, const Box<2>&) {
        if(!may_contain(component_(f), open[i]))
          return;
        const std::lock_guard<std::mutex> lock(mutex);
        count_face_above(t, parts_[open[i]]);
      });
    });
  }

  static void count_face_above(const Triangle& t, Part& part) {
    const Seen_triangle seen = see_triangle(t, part.extent.first);
    if(seen == Seen_triangle::HERE)
      part.is_touched = true;
    if(seen == Seen_triangle::ABOVE)
      part.sign = -part.sign;
  }

  const TriangleMesh& tm_;
  VertexPointMap point_;
  const ComponentOfFace& component_;
  std::vector<char> is_wanted_, has_boundary_; // by component
  std::vector<Part> parts_;                    // by component
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_LINKING_COMPONENT_ORIENTATION_H
