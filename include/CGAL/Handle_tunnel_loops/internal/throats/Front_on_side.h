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
#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
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
    first_open_ = bin_ = 0;
    strips_.clear();
    strips_there_.clear();
    strip_at_.clear();
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

  /// Part of a face, from the loop to one or two of its corners: \p p is on an edge to \p a, and \p
  /// q on one to \p b.
  struct Strip
  {
    Vector p, q;
    Index a, b;
  };

  /// A segment where the front stays. It comes to one end first, and to the other last.
  struct Arrival
  {
    double first, last, length;

    // The integral, up to a distance, of what has been arrived at.
    double up_to(double distance) const {
      const double d = distance - first;
      return d <= 0.           ? 0.
             : distance < last ? length * d * d / (2. * (last - first))
                               : length * (d - (last - first) / 2.);
    }
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
      if(!mesh_.is_hub(end(c)) && !mesh_.is_hub(end(d)))
        strips_.push_back({p, q, end(c), end(d)});
      if(mesh_.is_hub(other_end(c)) || mesh_.is_hub(other_end(d)))
        continue;
      for(const Index v : {other_end(c), other_end(d)})
        strip_at_.emplace_back(v, strips_there_.size());
      strips_there_.push_back({p, q, other_end(c), other_end(d)});
    }
    make_set(strip_at_);
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
      add(strip, 0., 0.);
      strips_.pop_back();
    }
  }

  void add(const Strip& strip, double at_p, double at_q) {
    lengths_.add({{{strip.p, at_p}, {strip.q, at_q}, corner(strip.b)}});
    if(strip.a != strip.b)
      lengths_.add({{{strip.p, at_p}, corner(strip.a), corner(strip.b)}});
  }

  // ---- on its way

  bool is_open(Index u, Index v) const { return !mesh_.is_spoke(u, v) && !cut_->is_crossed(u, v); }

  void pass(Index v) {
    paths_[v].is_passed = true;
    order_.push_back(v);
    const Ring ring = mesh_.ring(v);
    come_to_loop(v);
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      if(mesh_.is_hub(a)) {
        for(const Index w : {b, ring[ring.previous(p)]})
          if(paths_[w].is_passed)
            stay(paths_[w].distance, paths_[v].distance, mesh_.edge_length(v, w));
      } else if(paths_[a].is_passed && paths_[b].is_passed && is_open(v, a) && is_open(v, b) &&
                is_open(a, b))
        lengths_.add({corner(v), corner(a), corner(b)});
    }
    relax_around(
        mesh_, v, [&](Index u) { return paths_[u].distance; },
        [&](Index u, Index w) { return is_open(u, w); },
        [&](Index u, double d) {
          if(!paths_[u].is_passed)
            paths_.reach(u, {d});
        });
  }

  // From its other side, as far as the corners there are passed.
  void come_to_loop(Index v) {
    for(auto it =
            std::lower_bound(strip_at_.begin(), strip_at_.end(), std::make_pair(v, std::size_t(0)));
        it != strip_at_.end() && it->first == v; ++it)
    {
      const Strip& strip = strips_there_[it->second];
      if(!paths_[strip.a].is_passed || !paths_[strip.b].is_passed)
        continue;
      const auto over_edge = [this](Index end, const Vector& place) {
        return paths_[end].distance + norm(place - mesh_.points[end]);
      };
      const double at_p = over_edge(strip.a, strip.p), at_q = over_edge(strip.b, strip.q);
      add(strip, at_p, at_q);
      stay(at_p, at_q, norm(strip.q - strip.p));
    }
  }

  void stay(double at_one_end, double at_the_other, double length) {
    const auto [first, last] = std::minmax(at_one_end, at_the_other);
    arrivals_.push_back({first, last, length});
  }

  Length_by_distance::Corner corner(Index v) const { return {mesh_.points[v], paths_[v].distance}; }

  // ---- how long it was

  // As far as all faces are passed.
  void look() {
    take_strips();
    const double known = known_up_to();
    for(; !has_slipped_ && lengths_.begin(bin_ + 1) <= known; ++bin_) {
      if(bin_ > lengths_.number_of_bins() && arrivals_.empty()) {
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
    for(const Arrival& arrival : arrivals_)
      in_bin += arrival.up_to(end) - arrival.up_to(begin);
    const double mean = stays_ + in_bin / (end - begin);
    const auto rest = std::partition(arrivals_.begin(), arrivals_.end(),
                                     [end](const Arrival& a) { return a.last > end; });
    std::for_each(rest, arrivals_.end(), [this](const Arrival& a) { stays_ += a.length; });
    arrivals_.erase(rest, arrivals_.end());
    return mean;
  }

  // Nothing is as long as vertices beside the loop wait.
  double known_up_to() {
    if(!strips_.empty())
      return 0.;
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
  std::vector<Index> order_;                            // what is passed
  std::vector<Strip> strips_, strips_there_;            // on its side of the loop, and on the other
  std::vector<std::pair<Index, std::size_t>> strip_at_; // of those there, by vertex, sorted
  std::vector<Arrival> arrivals_;                       // that may not be over
  std::size_t first_open_ = 0, bin_ = 0;
  double stays_ = 0., longest_ = 0., same_up_to_ = 0.;
  bool has_slipped_ = false, is_at_end_ = false;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_THROATS_FRONT_ON_SIDE_H
