// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FLIP_SHORTENING_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FLIP_SHORTENING_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Angle_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Flipped_edges.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/*!
Shortens a loop without changing its homotopy class by flips of edges (Sharp and Crane 2020, You Can
Find Geodesic Paths in Triangle Meshes by Just Flipping Edges).

The loop is a closed walk on edges, and goes straight ahead where there is less than a straight
angle between two of them: edges that come from their vertex in between are flipped, and the loop is
led along the other side of the faces that are left there. What that costs depends on the faces next
to the vertex alone, not on how many edges of the mesh the loop crosses: many, where faces are long
and thin. Flips are limited by the edges that the loop crosses: where it goes around many vertices
for nothing, it lets go of one after the other, and all edges at the one become edges at the next.
*/
class Flip_shortening
{
public:
  Flip_shortening(Execution execution, const Flat_mesh& mesh)
      : execution_(execution)
      , mesh_(mesh)
      , edges_(mesh) {}

  /// \p loop is not to pass caps.
  void shorten(Crossing_loop& loop) {
    if(!start(loop))
      return;
    for(std::size_t round = 0; !open_.empty() && left_ > 0 && size_ >= least_size; ++round) {
      execution_.look();
      shorten_at(std::exchange(open_, {}), round);
    }
    loop = crossings();
  }

private:
  // With fewer edges one of them would be on both sides of a vertex.
  static constexpr std::size_t least_size = 3;
  static constexpr std::size_t most_flips = 4; // for each edge that is crossed

  // A halfedge of the loop.
  struct Step
  {
    Index halfedge;
    Index previous, next;   // steps
    Index round = no_index; // in which it was made
    bool is_gone = false;
  };

  // The walk along that end of each edge which is nearer.
  bool start(const Crossing_loop& loop) {
    std::vector<Index> walk;
    for(const Crossing& c : loop)
      walk.push_back(c.ratio < 0.5 ? c.left : c.right);
    remove_spurs(walk);
    size_ = walk.size();
    if(size_ < least_size)
      return false;
    left_ = most_flips * loop.size();
    for(Index i = 0; i < size_; ++i) {
      const Index end = i + 1 == size_ ? 0 : i + 1;
      steps_.push_back(
          {edges_.halfedge(walk[i], walk[end]), i == 0 ? Index(size_ - 1) : i - 1, end});
      set_passed(steps_.back().halfedge, 1);
      open_.push_back(i);
    }
    return true;
  }

  // At the ends of steps. Those beside one that has changed have to wait for the next round: if all
  // were done from one end to the other, faces would be long fans around where it began.
  void shorten_at(const std::vector<Index>& open, std::size_t round) {
    for(const Index i : open) {
      if(left_ == 0 || size_ < least_size)
        return;
      if(steps_[i].is_gone)
        continue;
      if(steps_[i].round == round || steps_[steps_[i].next].round == round)
        open_.push_back(i);
      else
        shorten_at(i, static_cast<Index>(round));
    }
  }

  void shorten_at(Index i, Index round) {
    const Index in = steps_[i].halfedge, out = steps_[steps_[i].next].halfedge;
    if(in == Flipped_edges::twin(out))
      return replace(i, {}, round);
    Wedge wedge = straightened_side(in, out);
    if(wedge.spokes.empty())
      return;
    flip_spokes(wedge.spokes);
    std::vector<Index> arc;
    for(std::size_t k = 0; k + 1 < wedge.spokes.size(); ++k)
      arc.push_back(edges_.next(wedge.spokes[k]));
    if(wedge.is_left) {
      std::reverse(arc.begin(), arc.end());
      for(Index& h : arc)
        h = Flipped_edges::twin(h);
    }
    replace(i, arc, round);
  }

  // The halfedges from a vertex on one side of the loop, counterclockwise, with those of the loop.
  struct Wedge
  {
    bool is_left;
    std::vector<Index> spokes;
    Angle_sum sum;

    bool is_complete(Index end) const { return spokes.back() == end; }
  };

  // The side that spans less than a straight angle. Looked for on both at once, as one may be long.
  Wedge straightened_side(Index in, Index out) {
    const Index back = Flipped_edges::twin(in), v = edges_.target(in);
    Wedge sides[2] = {{true, {out}, {}}, {false, {back}, {}}};
    bool is_open[2] = {edges_.target(out) != v, edges_.target(back) != v};
    while(is_open[0] || is_open[1])
      for(const int side : {0, 1}) {
        if(!is_open[side])
          continue;
        const Index end = side == 0 ? back : out;
        is_open[side] = add_face(sides[side], end);
        if(is_open[side] && sides[side].is_complete(end))
          return sides[side];
      }
    return {};
  }

  // Returns whether the side may still be less than straight, and the loop led along its other end.
  bool add_face(Wedge& wedge, Index end) {
    const Index spoke = wedge.spokes.back();
    if(!edges_.is_on_surface(spoke) || !edges_.add_corner(spoke, wedge.sum))
      return false;
    const Index next = edges_.after(spoke);
    wedge.spokes.push_back(next);
    return edges_.target(next) != edges_.source(next) && (next == end || passed(next) == 0);
  }

  // Flips the spokes at whose other ends there is less than a straight angle as well. Each one can
  // make that true of the one before it.
  void flip_spokes(std::vector<Index>& spokes) {
    std::vector<Index> kept = {spokes.front()};
    for(std::size_t k = 1; k < spokes.size(); ++k) {
      while(kept.size() > 1 && left_ > 0 && edges_.is_flippable(kept.back())) {
        edges_.flip(kept.back());
        kept.pop_back();
        --left_;
      }
      kept.push_back(spokes[k]);
    }
    spokes = std::move(kept);
  }

  // Puts halfedges in the place of a step and the next one. Counts like a flip: where points
  // coincide, rounding could lead around for ever.
  void replace(Index i, const std::vector<Index>& halfedges, Index round) {
    left_ -= left_ > 0 ? 1 : 0;
    const Index j = steps_[i].next, begin = steps_[i].previous, end = steps_[j].next;
    for(const Index gone : {i, j}) {
      steps_[gone].is_gone = true;
      set_passed(steps_[gone].halfedge, -1);
    }
    size_ = size_ + halfedges.size() - 2;
    Index last = begin;
    open_.push_back(begin);
    for(const Index h : halfedges) {
      const Index step = static_cast<Index>(steps_.size());
      steps_.push_back({h, last, end, round});
      steps_[last].next = step;
      set_passed(h, 1);
      open_.push_back(step);
      last = step;
    }
    steps_[last].next = end;
    steps_[end].previous = last;
    first_ = last;
  }

  Index passed(Index h) const { return h / 2 < passed_.size() ? passed_[h / 2] : 0; }
  void set_passed(Index h, int change) {
    if(passed_.size() <= h / 2)
      passed_.resize(h / 2 + 1, 0);
    passed_[h / 2] += change;
  }

  // ---- the loop in terms of the mesh

  // What is left of the walk, without spurs.
  std::vector<Index> halfedges() const {
    std::vector<Index> walk;
    Index i = first_;
    do {
      const Index h = steps_[i].halfedge;
      if(!walk.empty() && walk.back() == Flipped_edges::twin(h))
        walk.pop_back();
      else
        walk.push_back(h);
      i = steps_[i].next;
    } while(i != first_);
    std::size_t spurs = 0;
    while(2 * spurs + 1 < walk.size() &&
          walk[spurs] == Flipped_edges::twin(walk[walk.size() - 1 - spurs]))
      ++spurs;
    return {walk.begin() + spurs, walk.end() - spurs};
  }

  // The way of the loop by a vertex, on one side of it.
  struct Passage
  {
    bool has_vertex_right;
    Crossing_loop spokes;
  };

  // The vertices lie to the left, but for those to the right of which there is a cap: on the
  // surface without it the loop has to pass on their other side.
  Crossing_loop crossings() {
    const std::vector<Index> walk = halfedges();
    const std::size_t n = walk.size();
    std::vector<Crossing_loop> parts(n);
    for(std::size_t i = 0; i < n; ++i)
      edges_.append_crossings(walk[i], parts[i]);
    std::vector<Passage> passages(n); // at the source of each halfedge
    for(std::size_t i = 0; i < n; ++i) {
      const std::size_t before = i == 0 ? n - 1 : i - 1;
      const auto pass = [&](bool has_vertex_right) {
        passages[i] = {has_vertex_right,
                       spokes(walk[before], parts[before], walk[i], parts[i], has_vertex_right)};
      };
      pass(false);
      if(std::any_of(passages[i].spokes.begin(), passages[i].spokes.end(),
                     [&](const Crossing& c) { return mesh_.is_hub(c.right); }))
        pass(true);
    }
    Crossing_loop loop;
    for(std::size_t i = 0; i < n; ++i) {
      loop.insert(loop.end(), passages[i].spokes.begin(), passages[i].spokes.end());
      loop.insert(loop.end(), parts[i].begin(), parts[i].end());
      const bool is_left = passages[i].has_vertex_right;
      if(edges_.is_of_mesh(walk[i]) && passages[i + 1 == n ? 0 : i + 1].has_vertex_right != is_left)
      {
        const Index u = edges_.source(walk[i]), v = edges_.target(walk[i]);
        loop.push_back(is_left ? Crossing{v, u, 1.} : Crossing{u, v, 0.});
      }
    }
    remove_backtracks(loop);
    return loop;
  }

  // The edges that are crossed between two halfedges of the walk.
  Crossing_loop spokes(Index in,
                       const Crossing_loop& part_of_in,
                       Index out,
                       const Crossing_loop& part_of_out,
                       bool has_vertex_right) {
    const Index v = edges_.source(out);
    const Ring ring = mesh_.ring(v);
    const auto step = [&](Index p) { return has_vertex_right ? ring.previous(p) : ring.next(p); };
    const auto end_of = [&](const Crossing& c) { return has_vertex_right ? c.left : c.right; };
    const Index first = edges_.is_of_mesh(in) ? step(mesh_.position(v, edges_.source(in)))
                                              : mesh_.position(v, end_of(part_of_in.back())),
                end = edges_.is_of_mesh(out) ? mesh_.position(v, edges_.target(out))
                                             : step(mesh_.position(v, end_of(part_of_out.front())));
    Crossing_loop spokes;
    for(Index p = first; p != end; p = step(p))
      spokes.push_back(has_vertex_right ? Crossing{ring[p], v, 1.} : Crossing{v, ring[p], 0.});
    return spokes;
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  Flipped_edges edges_;
  std::vector<Step> steps_;         // also those that are gone
  std::vector<Index> open_;         // steps, at whose ends the loop may turn
  std::vector<Index> passed_;       // by edge, how many steps
  std::size_t size_ = 0, left_ = 0; // of the steps that are left, and of the flips
  Index first_ = 0;                 // a step
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SHORTENING_FLIP_SHORTENING_H
