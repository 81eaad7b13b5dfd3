// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_TARGETS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_TARGETS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/classes/Class_vector.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/*!
Loops that are to be replaced by shorter ones, and what has been found for them.

A curve can replace loop k of a basis if its coordinate in k is 1 or -1. That coordinate is, up to
sign, the intersection number with the class that is dual to loop k: a sum of its numbers with the
loops.
*/
class Search_targets
{
public:
  struct Target
  {
    double limit;             ///< walks have to be shorter
    const Class_vector* dual; ///< the coordinate, by the intersection numbers
  };

  /// A closed walk: of its class the shortest, or the shortest from another place if it is hardly
  /// longer. What is shorter once it is tightened shows then.
  struct Found
  {
    double length; ///< on the mesh that is searched
    std::vector<Index> walk;
    std::vector<Index> targets; ///< what it can replace
  };

  explicit Search_targets(std::vector<Target> targets)
      : targets_(std::move(targets)) {
    update_limit();
  }

  /// No target wants a walk that is longer.
  double limit() const { return limit_; }

  /// the length of the shortest limit of a target.
  double smallest_limit() const {
    double smallest = limit_;
    for(const Target& t : targets_)
      smallest = (std::min)(smallest, t.limit);
    return smallest;
  }

  bool is_known(std::uint64_t key) const { return classes_.count(key) != 0; }

  /// says by intersection numbers what class a key stands for.
  void add_class(std::uint64_t key, const Class_vector& numbers) {
    Class& found = classes_[key];
    for(Index t = 0; t < targets_.size(); ++t) {
      const std::int64_t x = product_sum(numbers, *targets_[t].dual);
      if(x == 1 || x == -1)
        found.targets.push_back(t);
    }
    found.shortest = found.here.length = limit_;
  }

  /// before a search from another place.
  void start_place() {
    for(auto& entry : classes_)
      entry.second.keep(limit_);
  }

  /// whether walks of a class and of this length are of use.
  bool wants(std::uint64_t key, double length) const {
    return is_wanted(classes_.at(key).targets, length);
  }

  /// whether none so short has been found of the class from this place, and none much shorter from
  /// another.
  bool is_shortest(std::uint64_t key, double length) const {
    const Class& c = classes_.at(key);
    return length < c.here.length && length < near * c.shortest;
  }

  void take(std::uint64_t key, double length, std::vector<Index> walk) {
    Class& found = classes_.at(key);
    found.here.length = length;
    found.here.vertices = std::move(walk);
    found.shortest = (std::min)(found.shortest, length);
    for(Index t : found.targets)
      targets_[t].limit = (std::min)(targets_[t].limit, slack * length);
    update_limit();
  }

  /// what is still wanted, the shortest first.
  std::vector<Found> take_found() {
    std::vector<Found> all;
    for(auto& entry : classes_) {
      Class& c = entry.second;
      c.keep(limit_);
      for(Walk& walk : c.walks)
        if(walk.length < near * c.shortest && is_wanted(c.targets, walk.length))
          all.push_back({walk.length, std::move(walk.vertices), c.targets});
    }
    std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) {
      return a.length != b.length ? a.length < b.length : a.walk < b.walk;
    });
    return all;
  }

private:
  // Of walks more than so many times longer than the shortest, none is pulled to a shorter loop.
  static constexpr double slack = 1.15;
  static constexpr double near = 1.04;
  static constexpr std::size_t most_walks = 3; // of a class

  struct Walk
  {
    double length;
    std::vector<Index> vertices;

    bool operator<(const Walk& w) const {
      return length != w.length ? length < w.length : vertices < w.vertices;
    }
  };

  struct Class
  {
    double shortest;
    Walk here; // found from the present place
    std::vector<Walk> walks;
    std::vector<Index> targets;

    void keep(double limit) {
      if(!here.vertices.empty())
        walks.push_back(std::move(here));
      here = {limit, {}};
      std::sort(walks.begin(), walks.end());
      walks.resize((std::min)(walks.size(), most_walks));
    }
  };

  bool is_wanted(const std::vector<Index>& targets, double length) const {
    return std::any_of(targets.begin(), targets.end(),
                       [&](Index t) { return length < targets_[t].limit; });
  }

  void update_limit() {
    limit_ = 0.;
    for(const Target& t : targets_)
      limit_ = (std::max)(limit_, t.limit);
  }

  std::vector<Target> targets_;
  double limit_ = 0.;
  std::unordered_map<std::uint64_t, Class> classes_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CLASSES_SEARCH_TARGETS_H
