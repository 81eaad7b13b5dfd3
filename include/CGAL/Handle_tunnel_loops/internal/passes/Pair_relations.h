// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PAIR_RELATIONS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PAIR_RELATIONS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_linker.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Relates the loops of pairs, again and again, as loops are replaced by others: where the solid is, is
found once, and of loops that stay the numbers with each other are kept.

New loops are linked with each other and with those that are near them. The others neither cross
them nor are linked with them: the boxes around them are apart, or what is seen of them along an
axis is. Numbers are kept only where nothing was wrong with any; else all are counted anew.
*/
class Pair_relations
{
public:
  /// The surface must outlive it.
  explicit Pair_relations(const Flat_surface& surface)
      : surface_(surface) {}

  /// the relations of the loops of pairs, handles and tunnels in turn; without linking numbers
  /// unless \p do_link.
  Loop_relations relate(Execution execution, const std::vector<Flat_pair>& pairs, bool do_link) {
    return relate(execution, loops_of(pairs), do_link, {});
  }

  /// the same, with linking numbers, if some are known, which are taken.
  Loop_relations
  relate(Execution execution, const std::vector<Flat_pair>& pairs, const Known_relations& known) {
    const std::vector<const Crossing_loop*> loops = loops_of(pairs);
    if(!known.relations.is_linked || !known.relations.problems.empty())
      return relate(execution, loops, true, {});
    const std::vector<Index> numbers = new_and_near(execution, loops, known.before);
    std::vector<const Crossing_loop*> some;
    std::vector<char> is_new;
    for(Index i : numbers) {
      some.push_back(loops[i]);
      is_new.push_back(known.before[i] == no_index);
    }
    const Loop_relations of_some = relate(execution, some, true, std::move(is_new));
    if(!of_some.problems.empty())
      return relate(execution, loops, true, {});
    known.relations.take_in(known.before, of_some, numbers);
    return std::move(known.relations);
  }

private:
  static std::vector<const Crossing_loop*> loops_of(const std::vector<Flat_pair>& pairs) {
    std::vector<const Crossing_loop*> loops;
    for(const Flat_pair& pair : pairs)
      loops.insert(loops.end(), {&pair.handle, &pair.tunnel});
    return loops;
  }

  // See `Loop_linker::link()`.
  Loop_relations relate(Execution execution,
                        const std::vector<const Crossing_loop*>& flat_loops,
                        bool do_link,
                        std::vector<char> is_asked_for) {
    const Flat_mesh& mesh = surface_.mesh().mesh();
    const std::vector<Flat_surface::Loop> loops = surface_.loops(execution, flat_loops);
    std::vector<const Flat_surface::Loop*> pointers;
    for(const Flat_surface::Loop& loop : loops)
      pointers.push_back(&loop);
    Loop_linker<Flat_graph, Flat_surface::Loop, decltype(surface_.point()),
                decltype(surface_.vertex_index())>
        linker(surface_.mesh(), surface_.point(), surface_.vertex_index());
    linker.set_boundaries(surface_.boundaries());
    linker.set_loops(
        execution, std::move(pointers),
        [&](Flat_graph::Halfedge f) { return mesh.component[f.source]; }, mesh.seeds.size(),
        sides_);
    sides_ = linker.sides();
    if(do_link)
      linker.link(execution, std::move(is_asked_for));
    else
      linker.intersect(execution);
    return linker.take_relations();
  }

  // Seen along an axis: around a part of a loop in the projection, and around the loop in space.
  using Seen_box = Box<5>;

  static Seen_box seen_along(int axis, const Box<3>& part, const Box<3>& loop) {
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    return {{part.low[x], part.low[y], loop.low[0], loop.low[1], loop.low[2]},
            {part.high[x], part.high[y], loop.high[0], loop.high[1], loop.high[2]}};
  }

  // The loops that are new, and those near one of them.
  std::vector<Index> new_and_near(Execution execution,
                                  const std::vector<const Crossing_loop*>& loops,
                                  const std::vector<Index>& before) const {
    std::vector<std::vector<Box<3>>> parts(loops.size()); // the last one is around the whole loop
    for_each_index(
        execution, loops.size(),
        [&](std::size_t i) { parts[i] = boxes_around(*loops[i], before[i] == no_index); }, 16);
    std::vector<char> is_near(loops.size(), 1);
    for(const int axis : {0, 1, 2}) {
      std::vector<Seen_box> boxes;
      for(std::size_t i = 0; i < loops.size(); ++i)
        for(std::size_t k = 0; before[i] == no_index && k + 1 < parts[i].size(); ++k)
          boxes.push_back(seen_along(axis, parts[i][k], parts[i].back()));
      const Box_tree<5> tree(std::move(boxes));
      for_each_index(
          execution, loops.size(),
          [&](std::size_t i) {
            const Box<3>& whole = parts[i].back();
            is_near[i] = before[i] == no_index ||
                         (is_near[i] && tree.is_any_meeting(seen_along(axis, whole, whole)));
          },
          16);
    }
    std::vector<Index> numbers;
    for(Index i = 0; i < loops.size(); ++i)
      if(is_near[i])
        numbers.push_back(i);
    return numbers;
  }

  // Around the faces at the vertices beside a loop, which are those of its walk and its copy: with
  // \p in_parts of some crossings each, and at last of all.
  std::vector<Box<3>> boxes_around(const Crossing_loop& loop, bool in_parts) const {
    constexpr std::size_t crossings = 16;
    std::vector<Box<3>> boxes;
    Box<3> whole = Box<3>::empty();
    for(std::size_t begin = 0; begin < loop.size(); begin += crossings) {
      Box<3> part = Box<3>::empty();
      for(std::size_t i = begin; i < (std::min)(loop.size(), begin + crossings); ++i)
        for(const Crossing_end end : {&Crossing::left, &Crossing::right})
          if(i == begin || loop[i].*end != loop[i - 1].*end)
            extend_by_faces(loop[i].*end, part);
      whole.extend(part);
      if(in_parts)
        boxes.push_back(part);
    }
    boxes.push_back(whole);
    return boxes;
  }

  void extend_by_faces(Index v, Box<3>& box) const {
    const auto extend = [&](Index u) {
      const Vector p = coordinates(surface_.point(), u);
      box.extend({p, p});
    };
    extend(v);
    for(Index u : surface_.mesh().mesh().ring(v))
      extend(u);
  }

  const Flat_surface& surface_;
  Solid_sides sides_; // once known
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_PAIR_RELATIONS_H
