// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_SEARCH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_SEARCH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Search_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Unimodular_system.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

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

  /// A closed walk: of its class the shortest, or the shortest from another place if it is not much
  /// longer. What is shorter once it is tightened shows then: a loop along edges is as long as its
  /// walk, one across large faces may be much shorter.
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
    return length < c.here.length && length < nearby * c.shortest;
  }

  void take(std::uint64_t key, double length, std::vector<Index> walk) {
    Class& found = classes_.at(key);
    found.here = {length, std::move(walk)};
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
        if(walk.length < nearby * c.shortest && is_wanted(c.targets, walk.length))
          all.push_back({walk.length, std::move(walk.vertices), c.targets});
    }
    std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) {
      return a.length != b.length ? a.length < b.length : a.walk < b.walk;
    });
    return all;
  }

private:
  // Of walks more than so many times longer than the shortest, none is pulled to a shorter loop;
  // nor of those of one class from different places.
  static constexpr double slack = 1.15;
  static constexpr double nearby = 1.2;
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

/// How often steps cross a loop, in net numbers. A workspace that can be used again and again.
class Steps_across
{
public:
  struct Step
  {
    Index from, to, name;
    int number; // if names are heads

    friend bool operator<(const Step& a, const Step& b) {
      return a.from != b.from ? a.from < b.from : a.name < b.name;
    }
  };

  /// The mesh has been counted.
  explicit Steps_across(const Search_mesh& mesh)
      : mesh_(mesh)
      , numbers_(mesh.number_of_names(), 0)
      , is_beside_(numbers_.empty() ? mesh.number_of_vertices() : 0, 0) {}

  void find(const Crossing_loop& loop, Index number) {
    clear();
    mesh_.for_each_step_across(loop, number, [&](Index from, Index to, Index name, int n) {
      if(numbers_.empty() || numbers_[name] == 0)
        steps_.push_back({from, to, name, n});
      if(!numbers_.empty())
        numbers_[name] += n;
    });
    if(numbers_.empty())
      add_up();
  }

  /// how often a step from `v` crosses the loop.
  int operator()(Index v, Index step) const {
    if(!numbers_.empty())
      return numbers_[step];
    if(is_beside_[v] == 0)
      return 0;
    const Step wanted = {v, no_index, mesh_.name(step), 0};
    const auto s = std::lower_bound(steps_.begin(), steps_.end(), wanted);
    return s != steps_.end() && !(wanted < *s) ? s->number : 0;
  }

  /// calls `f(step, number)`, perhaps more than once for a step.
  template <typename Function> void for_each(const Function& f) const {
    for(const Step& s : steps_)
      if(const int number = numbers_.empty() ? s.number : numbers_[s.name]; number != 0)
        f(s, number);
  }

private:
  void clear() {
    for(const Step& s : steps_)
      if(numbers_.empty())
        is_beside_[s.from] = 0;
      else
        numbers_[s.name] = 0;
    steps_.clear();
  }

  void add_up() {
    std::sort(steps_.begin(), steps_.end());
    auto last = steps_.begin();
    for(auto s = steps_.begin(); s != steps_.end();) {
      Step sum = *s;
      for(++s; s != steps_.end() && !(sum < *s); ++s)
        sum.number += s->number;
      *last++ = sum;
      is_beside_[sum.from] = 1;
    }
    steps_.erase(last, steps_.end());
  }

  const Search_mesh& mesh_;
  std::vector<int> numbers_; // by name, if it is that of a step
  std::vector<Step> steps_;
  std::vector<char> is_beside_; // by vertex, if names are heads
};

/*!
How far it is to a loop, the partner, from either side of it: lower bounds of closed walks that
cross it.

The surface is cut open along the partner, and copies of it are put together, a copy beginning where
the one before ends: the cyclic cover. A closed walk through the partner that crosses it a net
number of times other than zero leads there from the partner between two copies to that between two
others. So what is left of a walk at any of its places is not shorter than the way from there to a
partner that is not the one it came from.
*/
class Partner_distances
{
public:
  /// The mesh has been counted.
  explicit Partner_distances(const Search_mesh& mesh)
      : mesh_(mesh)
      , across_(mesh)
      , sides_{Side(mesh), Side(mesh)} {}

  /// measures the distances to loop \p number, for walks shorter than `limit`. Takes a visit for
  /// two vertices; what has not been reached when there are none left is known to be no nearer.
  void compute(const Crossing_loop& partner, Index number, double limit, std::size_t& visits) {
    number_ = number;
    for(Side& side : sides_)
      side.paths.clear();
    across_.find(partner, number);
    across_.for_each([&](const Steps_across::Step& s, int crossings) { add_step(s, crossings); });
    // Halfway from both sides; and on only where both together are short enough.
    const float whole = static_cast<float>(limit), half = 0.5f * whole;
    for(std::size_t i : {0, 1})
      grow(sides_[i], half, visits, [](Index, float) { return true; });
    around_ = whole;
    for(Index v : sides_[0].paths.reached())
      around_ = (std::min)(around_, after(v) + before(v));
    for(std::size_t i : {0, 1})
      if(sides_[i].radius == half)
        grow(sides_[i], whole, visits,
             [&](Index v, float distance) { return distance + value(sides_[1 - i], v) < whole; });
  }

  /// the number of the partner.
  Index loop() const { return number_; }

  /// No walk that crosses the partner is shorter.
  double around() const { return around_; }

  /// by how much a step crosses the partner, if its sums are not zero.
  int number(Index v, Index step) const { return across_(v, step); }

  /// the copy in which a walk begins that comes from the partner before copy 0.
  int first_copy(Index v) const { return after(v) <= before(v) ? 0 : -1; }

  /// the distance of a vertex from the partner.
  double distance(Index v) const { return (std::min)(after(v), before(v)); }

  /// No way from a vertex in a copy is shorter to a partner that is not the one before copy 0.
  double way_on(Index v, int copy) const {
    return copy == 0    ? (std::min)(before(v), after(v) + around_)
           : copy == -1 ? (std::min)(after(v), before(v) + around_)
                        : (std::min)(after(v), before(v));
  }

private:
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  struct Label
  {
    float distance = infinity;
  };

  struct Side
  {
    explicit Side(const Search_mesh& mesh)
        : paths(mesh.number_of_vertices()) {}

    Shortest_paths<Label> paths; // by vertex
    float radius = 0.f;          // so far they are known
  };

  // The distances to the partners at the ends of a copy.
  float after(Index v) const { return value(sides_[0], v); }
  float before(Index v) const { return value(sides_[1], v); }

  static float value(const Side& side, Index v) {
    return (std::min)(side.paths[v].distance, side.radius);
  }

  static void reach(Side& side, Index v, float distance) {
    if(distance < side.paths[v].distance)
      side.paths.reach(v, {distance});
  }

  // The partner is in the middle of each step that crosses it. There is the step back, too.
  void add_step(const Steps_across::Step& s, int crossings) {
    if(const float length = mesh_.length_by_name(s.from, s.to, s.name); length != infinity)
      reach(sides_[crossings > 0 ? 1 : 0], s.from, 0.5f * length);
  }

  template <typename Predicate>
  void grow(Side& side, float radius, std::size_t& visits, const Predicate& is_wanted) {
    side.radius = radius;
    std::size_t settled = 0;
    const auto goes_on = [&](float distance) {
      if(visits == 0)
        side.radius = (std::min)(radius, distance);
      return distance < side.radius;
    };
    side.paths.grow(goes_on, [&](Index v) {
      visits -= ++settled % 2;
      const Sums_of_steps sums = mesh_.sums_from(v);
      for(Index step = mesh_.begin(v); step != mesh_.end(v); ++step) {
        const float there = side.paths[v].distance + mesh_.length(v, step);
        const Index head = mesh_.head(step);
        if(there < side.paths[head].distance && is_wanted(head, there) &&
           (sums[step].is_zero() || number(v, step) == 0))
          side.paths.reach(head, {there});
      }
    });
  }

  const Search_mesh& mesh_;
  Index number_ = 0;
  Steps_across across_;       // the partner
  std::array<Side, 2> sides_; // after and before the partner
  float around_ = 0.f;        // from the partner to itself
};

/*!
Finds the shortest closed walks through a vertex, one of each class, that cross certain loops, the
walls, not at all in net numbers.

Dijkstra's algorithm on the covering surface on which the walls unroll: a label is a vertex together
with the sum of the walls that the way to it has crossed. Where two ways come to one vertex with the
same sum, they are a closed walk that crosses the walls as often forth as back, and all shortest
such walks are of this form (two shortest ways and an edge, as Thomassen's condition on three paths
holds on the cover; Erickson and Whittlesey 2005). Without walls these are a tree and an edge.

No vertex is visited with more than a few sums, so something may be missed. Zero is always kept. So
are, up to three times and unless the search is lean, the sums of ways around a knotted tube, which
differ in how often they cross the wall that is paired with the partner. All others are of ways in
and out of holes nearby. There may be very many of them, and if they came first, none would be left
for a walk that passes by.
*/
class Class_search
{
public:
  /// The mesh has been counted.
  explicit Class_search(const Search_mesh& mesh)
      : mesh_(mesh)
      , first_(mesh.number_of_vertices(), no_index)
      , lower_bounds_(mesh.number_of_vertices(), 0.f) {}

  /// before searches with other targets or walls. The walls are the loops of the sums `along` if
  /// \p are_walls_along, else those of `across`.
  /// With distances from a partner, walks begin near it, and ways are followed only that may
  /// be part of one that crosses it and is short enough. A search that \p is_lean visits no vertex
  /// with more than two sums.
  void
  start(bool are_walls_along, const Partner_distances* partner = nullptr, bool is_lean = false) {
    are_walls_along_ = are_walls_along;
    partner_ = partner;
    most_others_ = is_lean ? 1 : partner != nullptr ? 2 : 8;
    kept_.assign(1, 0);
    if(partner != nullptr && !is_lean)
      keep_windings(wall(mesh_.weight(partner->loop() ^ 1)));
    for(Index v : bounded_)
      lower_bounds_[v] = 0.f;
    bounded_.clear();
  }

  /// looks for closed walks through `root` that the targets want. Stops when there are no `visits`
  /// left, of which it takes one for each label, and one for each few steps of a walk that it goes
  /// along.
  void search(Index root, Search_targets& targets, std::size_t& visits) {
    targets_ = &targets;
    visits_ = &visits;
    shortest_ = targets.limit();
    is_cut_off_ = false;
    Label first{0.f, root, no_index, no_index, no_index, false, false, 0, {}};
    if(partner_ != nullptr) {
      first.copy = partner_->first_copy(root);
      offset_ = partner_->distance(root);
    }
    reach(root, first);
    const auto goes_on = [&](float distance) {
      return visits > 0 && 2. * distance < targets.limit();
    };
    queue_.run(labels_, goes_on, [&](Index l) {
      if(is_too_far(labels_[l]))
        return;
      --visits;
      visit(l);
    });
    reset(visits > 0 && !is_cut_off_);
  }

  /// No walk through a vertex that the targets want can be shorter, by the searches since
  /// `start()`.
  double lower_bound(Index v) const { return lower_bounds_[v]; }

private:
  static constexpr std::uint64_t most_windings = 3;

  struct Label
  {
    float distance;
    Index vertex;
    Index parent; // a label
    Index step;   // from it
    Index next;   // of the same vertex
    bool is_settled;
    bool is_other; // than those that are always kept
    int copy;      // of the surface cut open along the partner
    Class_sums sums;
  };

  std::uint64_t wall(const Class_sums& s) const { return are_walls_along_ ? s.along : s.across; }
  std::uint64_t kind(const Class_sums& s) const { return are_walls_along_ ? s.across : s.along; }

  void keep_windings(std::uint64_t sum) {
    for(std::uint64_t i = 1; i <= most_windings; ++i)
      kept_.insert(kept_.end(), {i * sum, 0 - i * sum});
  }

  bool is_kept(std::uint64_t sum) const {
    return std::find(kept_.begin(), kept_.end(), sum) != kept_.end();
  }

  // Whether no walk that goes this way is short enough.
  bool is_too_far(const Label& way) const {
    return partner_ != nullptr &&
           way.distance + partner_->way_on(way.vertex, way.copy) - offset_ >= targets_->limit();
  }

  void reach(Index v, Label label) {
    if(first_[v] == no_index)
      reached_.push_back(v);
    label.next = first_[v];
    first_[v] = static_cast<Index>(labels_.size());
    labels_.push_back(label);
    queue_.push(label.distance, first_[v]);
  }

  void visit(Index l) {
    labels_[l].is_settled = true;
    const Label here = labels_[l];
    Label there = here;
    there.parent = l;
    there.is_settled = false;
    const Sums_of_steps sums_from_here = mesh_.sums_from(here.vertex);
    for(Index step = mesh_.begin(here.vertex); step != mesh_.end(here.vertex); ++step) {
      there.vertex = mesh_.head(step);
      there.step = step;
      there.distance = here.distance + mesh_.length(here.vertex, step);
      const Class_sums sums = sums_from_here[step];
      there.sums = here.sums + sums;
      there.copy = here.copy;
      if(partner_ != nullptr && !sums.is_zero())
        there.copy += partner_->number(here.vertex, step);
      relax(there);
    }
  }

  void relax(const Label& way) {
    int others = 0;
    for(Index m = first_[way.vertex]; m != no_index; m = labels_[m].next) {
      Label& other = labels_[m];
      others += other.is_other;
      if(wall(other.sums) != wall(way.sums))
        continue;
      if(kind(other.sums) != kind(way.sums))
        note(way, other);
      if(!other.is_settled && way.distance < other.distance && !is_too_far(way)) {
        const Index next = other.next;
        const bool is_other = other.is_other;
        other = way;
        other.next = next;
        other.is_other = is_other;
        queue_.push(way.distance, m);
      }
      return;
    }
    if(2. * way.distance >= targets_->limit() || is_too_far(way))
      return;
    Label label = way;
    label.is_other = !is_kept(wall(way.sums));
    if(!label.is_other || others < most_others_)
      reach(way.vertex, label);
    else
      is_cut_off_ = true;
  }

  // Two ways to one vertex.
  void note(const Label& way, const Label& other) {
    const double length = double(way.distance) + other.distance;
    if(length >= targets_->limit())
      return;
    const std::uint64_t difference = kind(way.sums) - kind(other.sums);
    const std::uint64_t key = (std::min)(difference, 0 - difference);
    if(!targets_->is_known(key))
      targets_->add_class(key, numbers(closed_walk(way, other)));
    if(!targets_->wants(key, length))
      return;
    shortest_ = (std::min)(shortest_, length);
    if(targets_->is_shortest(key, length))
      targets_->take(key, length, closed_walk(way, other));
  }

  // On the edges behind the steps, to the place where the ways meet, and back.
  std::vector<Index> closed_walk(const Label& way, const Label& other) const {
    std::vector<Index> walk = way_from_root(way), back = way_from_root(other);
    walk.insert(walk.end(), back.rbegin(), back.rend());
    remove_spurs(walk);
    *visits_ -= (std::min)(*visits_, walk.size() / 4);
    return walk;
  }

  std::vector<Index> way_from_root(const Label& way) const {
    std::vector<const Label*> labels(1, &way);
    while(labels.back()->parent != no_index)
      labels.push_back(&labels_[labels.back()->parent]);
    std::vector<Index> walk(1, mesh_.vertex_of_walks(labels.back()->vertex));
    for(std::size_t i = labels.size() - 1; i-- > 0;)
      mesh_.append_walk(labels[i + 1]->vertex, labels[i]->step, walk);
    return walk;
  }

  // How often a closed walk crosses the loops.
  Class_vector numbers(const std::vector<Index>& walk) {
    for(std::size_t i = 0; i < walk.size(); ++i)
      mesh_.for_each_term(walk[i], walk[i + 1 == walk.size() ? 0 : i + 1],
                          [&](Index loop, int number) { crossed_.add(loop, number); });
    Class_vector numbers;
    crossed_.take([&](Index loop, std::int64_t number) { numbers.emplace_back(loop, number); });
    return numbers;
  }

  // A walk through a vertex is by the way there and back shorter, at most, than the shortest
  // through the root.
  void reset(bool is_complete) {
    for(Index v : reached_) {
      double distance = shortest_;
      for(Index l = first_[v]; l != no_index; l = labels_[l].next)
        if(labels_[l].is_settled)
          distance = (std::min)(distance, double(labels_[l].distance));
      const float bound = static_cast<float>(shortest_ - 2. * distance);
      if(is_complete && bound > lower_bounds_[v]) {
        if(lower_bounds_[v] == 0.f)
          bounded_.push_back(v);
        lower_bounds_[v] = bound;
      }
      first_[v] = no_index;
    }
    reached_.clear();
    labels_.clear();
    queue_.clear();
  }

  const Search_mesh& mesh_;
  std::vector<Index> first_; // label, by vertex
  std::vector<Label> labels_;
  std::vector<Index> reached_, bounded_;
  std::vector<float> lower_bounds_; // by vertex
  Distance_queue<float> queue_;
  bool are_walls_along_ = false;
  std::vector<std::uint64_t> kept_; // sums of walls
  int most_others_ = 0;             // at a vertex
  bool is_cut_off_ = false;         // at a vertex that has been reached with too many sums
  double shortest_ = 0.;
  double offset_ = 0.; // of the root from the partner
  const Partner_distances* partner_ = nullptr;
  Search_targets* targets_ = nullptr;
  Sparse_sum<std::int64_t> crossed_; // by a walk, by loop
  std::size_t* visits_ = nullptr;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_CLASS_SEARCH_H
