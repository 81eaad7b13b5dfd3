// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_DUAL_LOOP_PASS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_DUAL_LOOP_PASS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/compare_lengths.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Streamline.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/fields.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

/*!
The operation of the tunnel pass and the refinement pass (paper, 4.2 and 4.3): a field grows from
the left side of a loop, which is a wall, until it comes to the right side. From the places that it
comes to streamlines lead back to the left side; along the loop, and across it, they are closed.
*/
class Dual_loop_pass
{
public:
  Dual_loop_pass(const Flat_mesh& mesh,
                 const Field_constants& constants,
                 const Literal_rules& rules = Literal_rules())
      : mesh_(mesh)
      , constants_(constants)
      , rules_(rules) {}

  /// `walls` are edges that may not be crossed, those of `loop` among them. Returns the loops of
  /// all streamlines, the shortest first.
  std::vector<Crossing_loop> dual_loops(const Crossing_loop& loop,
                                        const Barred_edges& walls) const {
    Single_field field(mesh_, constants_, walls, rules_);
    for(const Crossing& c : loop)
      field.add_source(c.left);
    std::vector<char> is_target(mesh_.number_of_vertices(), 0);
    bool has_target = false;
    for(const Crossing& c : loop)
      if(!field.is_source(c.right)) {
        is_target[c.right] = 1;
        has_target = true;
      }
    if(!has_target)
      return {};
    std::vector<Crossing_loop> loops;
    std::vector<Index> targets = field.run_until(is_target);
    if(rules_.are_of_fields() && targets.empty())
      throw Literal_failure_exception("a field came to rest on its way around a loop");
    if(rules_.first_reached && targets.size() > 1)
      targets.resize(1);
    for(const Index target : targets) {
      std::vector<Surface_point> line = Streamline(mesh_, field.arrivals()).trace(target);
      append_along(loop, line.back().a, target, line);
      remove_turns(line);
      loops.push_back(Loop_of_line(mesh_)(line));
    }
    std::stable_sort(loops.begin(), loops.end(),
                     [this](const auto& a, const auto& b) { return is_shorter(mesh_, a, b); });
    return loops;
  }

private:
  // Goes on from `left`, a vertex on the left side, along the loop, the short way, to beside
  // `right`.
  void append_along(const Crossing_loop& loop,
                    Index left,
                    Index right,
                    std::vector<Surface_point>& line) const {
    const std::vector<double> along = lengths_up_to(loop);
    std::size_t from = loop.size(), to = loop.size();
    double shortest = 0.;
    for(std::size_t i = 0; i < loop.size(); ++i)
      for(std::size_t j = 0; loop[i].left == left && j < loop.size(); ++j) {
        if(loop[j].right != right)
          continue;
        const double direct = std::abs(along[i] - along[j]);
        const double distance = (std::min)(direct, along.back() - direct);
        if(from == loop.size() || distance < shortest) {
          shortest = distance;
          from = i;
          to = j;
        }
      }
    CGAL_assertion_msg(from < loop.size() && to < loop.size(),
                       "a line begins and ends at the loop");
    const double forward = along[to] - along[from] + (to < from ? along.back() : 0.);
    const bool go_forward = forward <= along.back() - forward;
    const std::size_t n = loop.size();
    std::vector<Surface_point> way;
    for(std::size_t i = from; i != to; i = (go_forward ? i + 1 : i + n - 1) % n)
      way.push_back({loop[i].left, loop[i].right, loop[i].ratio});
    append_between(left, right, way, line);
  }

  // Appends what does not share an edge with the ends.
  static void append_between(Index left,
                             Index right,
                             const std::vector<Surface_point>& way,
                             std::vector<Surface_point>& line) {
    auto first = way.begin(), last = way.end();
    while(first != last && first->has_end(left))
      ++first;
    while(first != last && std::prev(last)->has_end(right))
      --last;
    line.insert(line.end(), first, last);
  }

  // Of the loop, up to each crossing, and in all.
  std::vector<double> lengths_up_to(const Crossing_loop& loop) const {
    std::vector<double> lengths(1, 0.);
    for(std::size_t i = 0; i < loop.size(); ++i)
      lengths.push_back(lengths.back() + norm(position(mesh_, loop[(i + 1) % loop.size()]) -
                                              position(mesh_, loop[i])));
    return lengths;
  }

  const Flat_mesh& mesh_;
  Field_constants constants_;
  Literal_rules rules_;
};

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_DUAL_LOOP_PASS_H
