// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FRONT_ON_SIDE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FRONT_ON_SIDE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Length_by_distance.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/surface_distances.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The edges that loops cross, over which nothing goes.
class Cut_along_loop
{
public:
  explicit Cut_along_loop(const Flat_mesh& mesh)
      : is_end_(mesh.number_of_vertices(), 0) {}

  void start(const Crossing_loop& loop) {
    for(const auto& [u, v] : edges_)
      is_end_[u] = is_end_[v] = 0;
    edges_.clear();
    add(loop);
  }

  /// cuts along another loop, too.
  void add(const Crossing_loop& loop) {
    for(const Crossing& c : loop) {
      is_end_[c.left] = is_end_[c.right] = 1;
      edges_.push_back(std::minmax(c.left, c.right));
    }
    std::sort(edges_.begin(), edges_.end());
  }

  bool is_end(Index v) const { return is_end_[v] != 0; }

  bool is_crossed(Index u, Index v) const {
    return is_end(u) && is_end(v) &&
           std::binary_search(edges_.begin(), edges_.end(),
                              std::pair<Index, Index>(std::minmax(u, v)));
  }

private:
  std::vector<char> is_end_;
  std::vector<std::pair<Index, Index>> edges_; // sorted
};

/*!
The front that runs over the surface from one side of a loop, and how long it is, all of its curves
together. Where it comes to the other side of the loop, or to a boundary curve, it stays. So at any
time it is homologous to the loop, and a shorter front is something shorter that the loop can slip
off to, or part into: to nothing, where it shrinks to points.
*/
class Front_on_side
{
public:
  explicit Front_on_side(const Flat_mesh& mesh)
      : mesh_(mesh)
      , paths_(mesh.number_of_vertices()) {}

  /// \p barrier is how long the front must become on its way if what is beyond is not to count as
  /// the same place.
  void start(const Cut_along_loop& cut,
             const Crossing_loop& loop,
             bool is_left,
             double size,
             double barrier) {
    cut_ = &cut;
    size_ = size;
    barrier_ = barrier;
    lengths_.start(size);
    paths_.clear();
    order_.clear();
    first_open_ = bin_ = arrived_ = 0;
    staying_.clear();
    strips_.clear();
    arrivals_.clear();
    stays_ = longest_ = 0.;
    same_up_to_ = std::numeric_limits<double>::infinity();
    has_slipped_ = is_at_end_ = false;
    put_beside(loop, is_left);
  }

  void run_to(double distance) {
    paths_.grow([&](double d) { return d <= distance; }, [&](Index v) { pass(v); });
    look();
  }

  /// whether it has become shorter than the loop.
  bool has_slipped() const { return has_slipped_; }
  /// whether it has passed all that it can come to.
  bool is_at_end() const { return is_at_end_; }
  bool is_decided() const { return has_slipped_ || is_at_end_; }

  /// whether it has become as long as the barrier.
  bool has_met_barrier() const { return longest_ >= barrier_; }

  /// how long it was at most, before it has slipped.
  double longest() const { return longest_; }

  /// whether all vertices are passed that there are on this side of the cut.
  bool has_passed_all() { return known_up_to() == std::numeric_limits<double>::infinity(); }

  const std::vector<Index>& passed() const { return order_; }
  bool has_passed(Index v) const { return paths_[v].is_passed; }
  double distance(Index v) const { return paths_[v].distance; }

  /// calls `f(v)` for the vertices before the barrier.
  template <typename Function> void for_each_before_barrier(const Function& f) const {
    for(const Index v : order_)
      if(paths_[v].distance < same_up_to_)
        f(v);
  }

private:
  struct Label
  {
    double distance = std::numeric_limits<double>::infinity();
    bool is_passed = false;
  };

  /// Part of a face, from the loop to one or two of its corners.
  struct Strip
  {
    Vector p, q;
    Index a, b;
  };

  /// What is by a part less than the loop is shorter.
  static constexpr double shorter = 0.97;

  // ---- at the loop

  void put_beside(const Crossing_loop& loop, bool is_left) {
    const auto end = [&](const Crossing& c) { return is_left ? c.left : c.right; };
    const auto other_end = [&](const Crossing& c) { return is_left ? c.right : c.left; };
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const Crossing &c = loop[i], &d = loop[i + 1 == loop.size() ? 0 : i + 1];
      const Vector p = position(mesh_, c), q = position(mesh_, d);
      for(const Index v : {end(c), end(d)})
        if(!mesh_.is_hub(v))
          reach(v, distance_to_segment(mesh_.points[v], p, q));
      for(const Index v : {other_end(c), other_end(d)})
        staying_.emplace_back(v, norm(q - p) / 2.);
      if(!mesh_.is_hub(end(c)) && !mesh_.is_hub(end(d)))
        strips_.push_back({p, q, end(c), end(d)});
    }
    std::sort(staying_.begin(), staying_.end());
  }

  static double distance_to_segment(const Vector& v, const Vector& p, const Vector& q) {
    const Vector along = q - p;
    const double all = dot(along, along),
                 place = all > 0. ? (std::min)((std::max)(dot(v - p, along) / all, 0.), 1.) : 0.;
    return norm(v - p - place * along);
  }

  void reach(Index v, double distance) {
    if(distance < paths_[v].distance)
      paths_.reach(v, {distance});
  }

  // What the loop leaves on this side of a face. The last ones are taken once they are passed.
  void take_strips() {
    while(!strips_.empty()) {
      const Strip& strip = strips_.back();
      if(!paths_[strip.a].is_passed || !paths_[strip.b].is_passed)
        return;
      lengths_.add({{{strip.p, 0.}, {strip.q, 0.}, corner(strip.b)}});
      if(strip.a != strip.b)
        lengths_.add({{{strip.p, 0.}, corner(strip.a), corner(strip.b)}});
      strips_.pop_back();
    }
  }

  // ---- on its way

  bool is_open(Index u, Index v) const { return !mesh_.is_spoke(u, v) && !cut_->is_crossed(u, v); }

  void pass(Index v) {
    paths_[v].is_passed = true;
    order_.push_back(v);
    const Ring ring = mesh_.ring(v);
    double staying = cut_->is_end(v) ? length_of_loop_at(v) : 0.;
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      if(mesh_.is_hub(a))
        staying += 0.5 * (mesh_.edge_length(v, b) + mesh_.edge_length(v, ring[ring.previous(p)]));
      else if(paths_[a].is_passed && paths_[b].is_passed && is_open(v, a) && is_open(v, b) &&
              is_open(a, b))
        lengths_.add({corner(v), corner(a), corner(b)});
    }
    if(staying > 0.)
      arrivals_.emplace_back(paths_[v].distance, staying);
    relax_around(
        mesh_, v, [&](Index u) { return paths_[u].distance; },
        [&](Index u, Index w) { return is_open(u, w); },
        [&](Index u, double d) {
          if(!paths_[u].is_passed)
            paths_.reach(u, {d});
        });
  }

  // Of its other side.
  double length_of_loop_at(Index v) const {
    double sum = 0.;
    for(auto it = std::lower_bound(staying_.begin(), staying_.end(), std::make_pair(v, 0.));
        it != staying_.end() && it->first == v; ++it)
      sum += it->second;
    return sum;
  }

  Length_by_distance::Corner corner(Index v) const { return {mesh_.points[v], paths_[v].distance}; }

  // ---- how long it was

  // As far as all faces are passed.
  void look() {
    take_strips();
    if(!strips_.empty())
      return;
    const double known = known_up_to();
    for(; !has_slipped_ && lengths_.begin(bin_ + 1) <= known; ++bin_) {
      if(bin_ > lengths_.number_of_bins() && arrived_ == arrivals_.size()) {
        is_at_end_ = true;
        return;
      }
      const double length =
          lengths_.mean(bin_) + mean_of_staying(lengths_.begin(bin_), lengths_.begin(bin_ + 1));
      if(length >= barrier_)
        same_up_to_ = (std::min)(same_up_to_, lengths_.begin(bin_));
      has_slipped_ = length < shorter * size_;
      if(!has_slipped_)
        longest_ = (std::max)(longest_, length);
    }
  }

  // In a bin, of which those before have been asked for.
  double mean_of_staying(double begin, double end) {
    double in_bin = 0.;
    const double before = stays_;
    for(; arrived_ < arrivals_.size() && arrivals_[arrived_].first < end; ++arrived_) {
      const auto& [distance, length] = arrivals_[arrived_];
      in_bin += length * (std::min)((end - distance) / (end - begin), 1.);
      stays_ += length;
    }
    return before + in_bin;
  }

  double known_up_to() {
    const auto is_open_there = [&](Index v) {
      const Ring ring = mesh_.ring(v);
      return std::any_of(ring.begin(), ring.end(),
                         [&](Index u) { return is_open(v, u) && !paths_[u].is_passed; });
    };
    while(first_open_ < order_.size() && !is_open_there(order_[first_open_]))
      ++first_open_;
    return first_open_ == order_.size() ? std::numeric_limits<double>::infinity()
                                        : paths_[order_[first_open_]].distance;
  }

  const Flat_mesh& mesh_;
  const Cut_along_loop* cut_ = nullptr;
  double size_ = 0., barrier_ = 0.;
  Shortest_paths<Label> paths_;
  Length_by_distance lengths_;
  std::vector<Index> order_;                      // what is passed
  std::vector<std::pair<Index, double>> staying_; // of the other side, by vertex
  std::vector<Strip> strips_;
  std::vector<std::pair<double, double>> arrivals_; // where it stays: distances, lengths
  std::size_t first_open_ = 0, bin_ = 0, arrived_ = 0;
  double stays_ = 0., longest_ = 0., same_up_to_ = 0.;
  bool has_slipped_ = false, is_at_end_ = false;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FRONT_ON_SIDE_H
