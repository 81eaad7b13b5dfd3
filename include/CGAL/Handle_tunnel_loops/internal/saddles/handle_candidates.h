// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_HANDLE_CANDIDATES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_HANDLE_CANDIDATES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/saddles/Handle_candidate.h>
#include <CGAL/Handle_tunnel_loops/internal/saddles/Saddle.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Unfolds a saddle into k - 1 simple ones: in step i the contour arc around lower components 0 .. i -
1 and the contour arc around lower component i are cut and joined crosswise. If they belong to
different contours, these meet, and a handle is found; if not, a contour parts. On a surface that is
swept from one minimum the handles so found are exactly as many as the genus, because Euler's
formula leaves no other number.
*/
class Saddle_unfolding
{
public:
  explicit Saddle_unfolding(const Saddle& saddle)
      : saddle_(saddle)
      , target_(saddle.number_of_lower_components()) {
    for(Index i = 0; i < target_.size(); ++i)
      target_[i] = i;
  }

  std::vector<Handle_candidate> handles() {
    std::vector<Handle_candidate> found;
    for(Index i = 1; i < target_.size(); ++i) {
      const Cycle a = cycle_through(i - 1), b = cycle_through(i);
      if(!a.contains(i))
        found.push_back(make_handle(a, b, i));
      std::swap(target_[i - 1], target_[i]);
    }
    return found;
  }

private:
  // A contour: the lower components at which its arcs arrive, in order.
  struct Cycle
  {
    std::vector<Index> arrivals;
    std::size_t size = 0; // crossings on its arcs
    bool has_longest = false;

    bool contains(Index lower_component) const {
      return std::find(arrivals.begin(), arrivals.end(), lower_component) != arrivals.end();
    }
  };

  Cycle cycle_through(Index arrival) const {
    Cycle cycle;
    Index at = arrival;
    do {
      cycle.arrivals.push_back(at);
      const Index leaving = target_[at];
      cycle.size += saddle_.arc(leaving).size();
      cycle.has_longest = cycle.has_longest || saddle_.is_longest(leaving);
      at = saddle_.arrival(leaving);
    } while(at != arrival);
    return cycle;
  }

  Handle_candidate make_handle(const Cycle& a, const Cycle& b, Index lower_component) const {
    const bool take_a = b.has_longest || (!a.has_longest && a.size <= b.size);
    return {trace(take_a ? a : b), saddle_.center(),
            saddle_.lower_component_vertex(lower_component - 1),
            saddle_.lower_component_vertex(lower_component)};
  }

  Crossing_loop trace(const Cycle& cycle) const {
    Crossing_loop loop;
    for(Index at : cycle.arrivals) {
      const Index leaving = target_[at];
      if(leaving == at + 1)
        saddle_.append_counterclockwise(at, loop);
      else
        saddle_.append_clockwise(at, leaving, loop);
      const Crossing_loop& arc = saddle_.arc(leaving);
      loop.insert(loop.end(), arc.begin(), arc.end());
    }
    return loop;
  }

  const Saddle& saddle_;
  boost::container::small_vector<Index, 4>
      target_; // lower component at which the contour arc from lower component i leaves
};

/// the handles of the sweep, in the order in which they are found.
template <typename Execution>
std::vector<Handle_candidate>
find_handle_candidates(Execution execution, const Flat_mesh& mesh, const Arrival_order& order) {
  std::vector<Index> saddles = find_saddles(execution, mesh, order);
  std::sort(saddles.begin(), saddles.end(),
            [&](Index u, Index v) { return order.is_earlier(u, v); });
  return collect<Handle_candidate>(
      execution, saddles.size(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<Handle_candidate> handles;
        for(std::size_t i = begin; i < end; ++i)
          for(Handle_candidate& handle :
              Saddle_unfolding(Saddle(mesh, order, saddles[i])).handles())
            handles.push_back(std::move(handle));
        return handles;
      },
      16);
}

/// the walk from `v` down to the source of the sweep, each vertex followed by its earliest
/// neighbour.
inline std::vector<Index> descent(const Flat_mesh& mesh, const Arrival_order& order, Index v) {
  std::vector<Index> walk(1, v);
  for(Index u = order.earliest_neighbor(mesh, v); order.is_earlier(u, v);
      u = order.earliest_neighbor(mesh, v))
  {
    walk.push_back(u);
    v = u;
  }
  return walk;
}

/// the tunnel of a handle that the sweep itself offers: from the saddle down on either side to the
/// source. It crosses its own handle once and no handle that was found later, whatever the mesh.
inline Crossing_loop descending_tunnel(const Flat_mesh& mesh,
                                       const Arrival_order& order,
                                       const Handle_candidate& handle) {
  std::vector<Index> walk = descent(mesh, order, handle.foot_a);
  std::vector<Index> other = descent(mesh, order, handle.foot_b);
  walk.insert(walk.end(), other.rbegin(), other.rend());
  walk.push_back(handle.saddle);
  remove_spurs(walk);
  return pushed_left(mesh, walk);
}

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SADDLES_HANDLE_CANDIDATES_H
