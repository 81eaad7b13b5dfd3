// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_THREADING_CYCLES_H
#define BENCHMARK_THREADING_CYCLES_H

#include "Voxel_tree.h"

#include <boost/pending/disjoint_sets.hpp>

#include <random>
#include <unordered_set>
#include <utility>
#include <vector>

/// \file Threading_cycles.h
/// The widest cycles of voxels, with those voxels first in which there may be most room.

namespace voxel_measures {

/// A cycle that was not there before, and the voxels that it goes through.
struct Threading_cycle
{
  double most; ///< no cycle of places farther from the surface is independent of those before
  std::vector<std::uint32_t> voxels;
  Line line; ///< middles of voxels, and places where they touch
};

/*!
Whole leaves, in the order of falling distances that are possible in them, and the cycles that
appear with them. Each goes around the loops in a way (its linking numbers) that is independent of
all before. Voxels are convex, and so is what two of them have in common: cycles of voxels that
touch are all that there is in their union.
*/
class Threading_cycles
{
public:
  Threading_cycles(const Voxel_tree& voxels, const Loop_cones& cones)
      : voxels_(voxels)
      , cones_(cones) {
    std::mt19937_64 random;
    for(std::size_t i = 0; i < cones.number_of_loops(); ++i)
      weight_.push_back(random());
  }

  /// of the voxels with places as far away as that, which are whole; not more than there are loops.
  std::vector<Threading_cycle> find(double least) {
    leaves_ = voxels_.leaves(least);
    std::sort(leaves_.begin(), leaves_.end(), [this](auto a, auto b) {
      return std::make_pair(voxels_[b].most, a) < std::make_pair(voxels_[a].most, b);
    });
    find_contacts();
    find_forest();
    return find_cycles();
  }

private:
  /// Of two leaves, by their numbers in the order.
  struct Contact
  {
    std::uint32_t first, second; ///< the second is the later one
  };

  static constexpr std::uint32_t none = std::uint32_t(-1);

  void find_contacts() {
    std::vector<std::uint32_t> number(voxels_.size(), none);
    for(std::uint32_t i = 0; i < leaves_.size(); ++i)
      number[leaves_[i]] = i;
    contacts_.clear();
    for(std::uint32_t i = 0; i < leaves_.size(); ++i)
      voxels_.visit_touching(leaves_[i], [&](std::uint32_t w) {
        if(const std::uint32_t j = number[w]; j != none)
          contacts_.push_back({(std::min)(i, j), (std::max)(i, j)});
      });
    std::sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
      return a.second < b.second || (a.second == b.second && a.first < b.first);
    });
    contacts_.erase(std::unique(contacts_.begin(), contacts_.end(),
                                [](const Contact& a, const Contact& b) {
                                  return a.first == b.first && a.second == b.second;
                                }),
                    contacts_.end());
  }

  void find_forest() {
    const std::size_t n = leaves_.size();
    boost::disjoint_sets_with_storage<> sets(n);
    is_in_forest_.assign(contacts_.size(), 0);
    std::vector<std::vector<std::uint32_t>> next(n);
    for(std::size_t c = 0; c < contacts_.size(); ++c) {
      const auto [a, b] = contacts_[c];
      if(sets.find_set(a) != sets.find_set(b)) {
        sets.union_set(a, b);
        is_in_forest_[c] = 1;
        next[a].push_back(b);
        next[b].push_back(a);
      }
    }
    parent_.assign(n, none);
    depth_.assign(n, 0);
    sum_.assign(n, 0);
    std::vector<char> is_seen(n, 0);
    std::vector<std::uint32_t> queue;
    for(std::uint32_t root = 0; root < n; ++root) {
      if(is_seen[root] != 0)
        continue;
      is_seen[root] = 1;
      queue.assign(1, root);
      for(std::size_t i = 0; i < queue.size(); ++i)
        for(const std::uint32_t b : next[queue[i]])
          if(is_seen[b] == 0) {
            is_seen[b] = 1;
            parent_[b] = queue[i];
            depth_[b] = depth_[queue[i]] + 1;
            sum_[b] = sum_[queue[i]] + weighted_crossings(queue[i], b);
            queue.push_back(b);
          }
    }
  }

  template <typename Count>
  void count_crossings(std::uint32_t a, std::uint32_t b, const Count& count) const {
    const std::uint32_t v = leaves_[a], w = leaves_[b];
    if(voxels_[v].cones.empty() && voxels_[w].cones.empty())
      return;
    const Point place = voxels_.common_place(v, w);
    for(const std::uint32_t t : voxels_[v].cones)
      count(cones_.loop(t), crossing(voxels_.middle(v), place, cones_.triangles()[t]));
    for(const std::uint32_t t : voxels_[w].cones)
      count(cones_.loop(t), crossing(place, voxels_.middle(w), cones_.triangles()[t]));
  }

  // With a random weight for each loop: zero for a row of zeros, and for next to no other.
  std::uint64_t weighted_crossings(std::uint32_t a, std::uint32_t b) const {
    std::uint64_t sum = 0;
    count_crossings(a, b,
                    [&](std::size_t loop, int n) { sum += std::uint64_t(n) * weight_[loop]; });
    return sum;
  }

  // From the first end of a contact to where the ways to the root meet, and back to the second.
  std::vector<std::uint32_t> cycle(const Contact& contact) const {
    std::vector<std::uint32_t> there = {contact.first}, back = {contact.second};
    while(there.back() != back.back()) {
      auto& way = depth_[there.back()] >= depth_[back.back()] ? there : back;
      way.push_back(parent_[way.back()]);
    }
    back.pop_back();
    there.insert(there.end(), back.rbegin(), back.rend());
    return there;
  }

  std::vector<int> row(const std::vector<std::uint32_t>& cycle) const {
    std::vector<int> row(cones_.number_of_loops(), 0);
    for(std::size_t i = 0; i < cycle.size(); ++i)
      count_crossings(cycle[i], cycle[(i + 1) % cycle.size()],
                      [&](std::size_t loop, int n) { row[loop] += n; });
    return row;
  }

  std::vector<Threading_cycle> find_cycles() const {
    std::vector<Threading_cycle> found;
    Independent_rows rows;
    std::unordered_set<std::uint64_t> seen = {0};
    for(std::size_t c = 0; c < contacts_.size() && rows.rank() < cones_.number_of_loops(); ++c) {
      const auto [a, b] = contacts_[c];
      if(is_in_forest_[c] != 0 || !seen.insert(sum_[a] + weighted_crossings(a, b) - sum_[b]).second)
        continue;
      const std::vector<std::uint32_t> numbers = cycle(contacts_[c]);
      if(!rows.add(row(numbers)))
        continue;
      found.push_back({voxels_[leaves_[b]].most, {}, {}});
      for(std::size_t i = 0; i < numbers.size(); ++i) {
        const std::uint32_t v = leaves_[numbers[i]], w = leaves_[numbers[(i + 1) % numbers.size()]];
        found.back().voxels.push_back(v);
        found.back().line.push_back(voxels_.middle(v));
        found.back().line.push_back(voxels_.common_place(v, w));
      }
    }
    return found;
  }

  const Voxel_tree& voxels_;
  const Loop_cones& cones_;
  std::vector<std::uint64_t> weight_; ///< by loop
  std::vector<std::uint32_t> leaves_;
  std::vector<Contact> contacts_;
  std::vector<char> is_in_forest_; ///< by contact
  std::vector<std::uint32_t> parent_, depth_;
  std::vector<std::uint64_t> sum_; ///< of weighted crossings from the root
};

} // namespace voxel_measures

#endif // BENCHMARK_THREADING_CYCLES_H
