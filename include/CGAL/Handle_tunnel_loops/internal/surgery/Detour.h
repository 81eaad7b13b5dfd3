// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_DETOUR_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_DETOUR_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/closed_walks.h>

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Leads closed walks around a handle that was removed. A part of a walk that is gone has both ends at
the patch that has taken its place. If these are at the same disc of it, the way over that disc is
homotopic to the part that is gone, up to loops that are contractible now. If they are at different
discs, the walk went through the handle, along which the surface was cut: then it goes to the other
disc as the partner of the loop there does, which crossed that once. So bases stay bases: with the
loop that is contractible now and its partner, each walk is the sum of the one that it was and of
partners.
*/
class Detour
{
public:
  /// \p first_face is the number of the first face of the discs, \p first_vertex that of the first
  /// vertex that was put in, \p partner a closed walk that crossed what was taken out, or an empty
  /// one.
  Detour(const Surgery_mesh& mesh, Index first_face, Index first_vertex, const Closed_walk& partner)
      : mesh_(mesh)
      , first_face_(first_face)
      , first_vertex_(first_vertex) {
    std::vector<Closed_walk> parts = joined_parts(partner);
    if(parts.size() == 1)
      way_through_ = std::move(parts.front());
  }

  /// an empty walk if there is no such way.
  Closed_walk around(const Closed_walk& walk) const {
    const std::vector<Closed_walk> parts = joined_parts(walk);
    if(parts.empty())
      return {};
    Closed_walk led = parts.front();
    for(std::size_t i = 1; i <= parts.size(); ++i) {
      const Closed_walk& part = i < parts.size() ? parts[i] : Closed_walk{led.front()};
      if(!append(part, led) && !append_through(part, led))
        return {};
    }
    led.pop_back(); // where it began
    return led;
  }

private:
  bool is_of_disc(Index h) const {
    return mesh_.face(h) >= first_face_ || mesh_.face(mesh_.twin(h)) >= first_face_;
  }

  // Along an edge of a disc; or, at the ends of the way, over a part of a face beside it. A vertex
  // that was there before may have such parts on both sides of the cut.
  bool leads_on(Index h, Index end) const {
    const bool begins_new = mesh_.source(h) >= first_vertex_,
               ends_new = mesh_.target(h) >= first_vertex_;
    return is_of_disc(h) || (begins_new != ends_new && (begins_new || mesh_.source(h) == end));
  }

  // With no gaps but those between different discs.
  std::vector<Closed_walk> joined_parts(const Closed_walk& walk) const {
    std::vector<Closed_walk> joined;
    for(Closed_walk& part : parts_left(walk))
      if(joined.empty() || !append(part, joined.back()))
        joined.push_back(std::move(part));
    if(joined.size() > 1 && append(joined.front(), joined.back()))
      joined.erase(joined.begin());
    return joined;
  }

  // In cyclic order, with gaps between them.
  std::vector<Closed_walk> parts_left(const Closed_walk& walk) const {
    std::vector<Closed_walk> parts;
    for(std::size_t i = 0; i < walk.size(); ++i) {
      if(mesh_.outgoing(walk[i]) == no_index)
        continue; // was taken out
      if(i == 0 || mesh_.halfedge(walk[i - 1], walk[i]) == no_index)
        parts.emplace_back();
      parts.back().push_back(walk[i]);
    }
    if(parts.size() > 1 && mesh_.halfedge(walk.back(), walk.front()) != no_index) {
      parts.back().insert(parts.back().end(), parts.front().begin(), parts.front().end());
      parts.erase(parts.begin());
    }
    return parts;
  }

  // Goes on to another part over one disc, if there is such a way: that with the fewest edges.
  bool append(const Closed_walk& part, Closed_walk& walk) const {
    const Index from = walk.back(), to = part.front();
    std::unordered_map<Index, Index> next{{to, to}}; // on the way to the end
    Closed_walk reached{to};
    for(std::size_t i = 0; i < reached.size() && next.count(from) == 0; ++i)
      mesh_.for_each_outgoing(reached[i], [&](Index h) {
        if(leads_on(h, to) && next.insert({mesh_.target(h), reached[i]}).second)
          reached.push_back(mesh_.target(h));
      });
    if(next.count(from) == 0)
      return false;
    for(Index v = from; v != to;)
      walk.push_back(v = next.at(v));
    walk.insert(walk.end(), part.begin() + 1, part.end());
    return true;
  }

  // ... or through the handle that was there.
  bool append_through(const Closed_walk& part, Closed_walk& walk) const {
    if(way_through_.empty())
      return false;
    Closed_walk way = way_through_;
    for(bool is_reversed : {false, true}) {
      if(is_reversed)
        std::reverse(way.begin(), way.end());
      Closed_walk longer = walk;
      if(append(way, longer) && append(part, longer)) {
        walk = std::move(longer);
        return true;
      }
    }
    return false;
  }

  const Surgery_mesh& mesh_;
  const Index first_face_, first_vertex_;
  Closed_walk way_through_; // from one disc to the other, where the surface is as it was
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_DETOUR_H
