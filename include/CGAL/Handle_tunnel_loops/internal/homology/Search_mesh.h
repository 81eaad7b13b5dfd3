// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_MESH_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_MESH_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/homology/Intrinsic_triangulation.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Edge_crossings.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sparse_sum.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Sums of random weights, one for each loop, by how often a walk crosses it. Modulo 2^64: they are
/// zero for all walks that cross no loop but for a net number of zero, and for hardly any other.
/// `across` are the loops that are not to be crossed, `along` those that tell classes apart.
struct Class_sums
{
  std::uint64_t across = 0, along = 0;

  friend Class_sums operator+(Class_sums a, Class_sums b) {
    return {a.across + b.across, a.along + b.along};
  }
  friend bool operator==(const Class_sums& a, const Class_sums& b) {
    return a.across == b.across && a.along == b.along;
  }
  bool is_zero() const { return across == 0 && along == 0; }
  void add(std::int64_t number, const Class_sums& s) {
    across += static_cast<std::uint64_t>(number) * s.across;
    along += static_cast<std::uint64_t>(number) * s.along;
  }
};

/// The sums of the steps from a vertex, by step.
class Sums_of_steps
{
public:
  /// \p sums are those of the step \p first and the next ones; null if all are zero.
  Sums_of_steps(const Class_sums* sums, Index first)
      : sums_(sums)
      , first_(first) {}

  Class_sums operator[](Index step) const {
    return sums_ == nullptr ? Class_sums() : sums_[step - first_];
  }

private:
  const Class_sums* sums_;
  Index first_;
};

/// random weights for loops of which 2k and 2k + 1 are a pair. \p is_pure says by pair whether its
/// loops bound on their sides. If so, handles and tunnels have sums of their own; if not, there are
/// no loops that must not be crossed.
inline std::vector<Class_sums> random_weights(const std::vector<char>& is_pure) {
  std::mt19937_64 random;
  std::vector<Class_sums> weights;
  for(const char pure : is_pure) {
    const std::uint64_t handle = random(), tunnel = random();
    weights.push_back(pure ? Class_sums{handle, 0} : Class_sums{0, handle});
    weights.push_back({0, tunnel});
  }
  return weights;
}

/// What each edge contributes to the sums of walks, and which loops cross it.
class Edge_classes
{
public:
  /// \p weights are those of the loops.
  Edge_classes(std::shared_ptr<const Edge_crossings> crossings, std::vector<Class_sums> weights)
      : crossings_(std::move(crossings))
      , weights_(std::move(weights))
      , sums_(crossings_->number_of_edges()) {
    for(Index e = 0; e < sums_.size(); ++e)
      for(const Edge_crossings::Term& t : crossings_->terms(e))
        sums_[e].add(t.number, weights_[t.loop]);
  }

  std::size_t number_of_loops() const { return weights_.size(); }

  const Edge_crossings& crossings() const { return *crossings_; }

  /// the sums of a walk that crosses a loop once.
  const Class_sums& weight(Index loop) const { return weights_[loop]; }

  /// the sums of the edges from `v` to its neighbors, which have numbers from \p first_step on.
  Sums_of_steps sums_from(Index v, Index first_step) const {
    const Index edge = crossings_->first_edge(v);
    return {edge == no_index ? nullptr : sums_.data() + edge, first_step};
  }

  /// which loops cross the edge from `v` to its neighbor in this position of its ring.
  Span<const Edge_crossings::Term> terms_at(Index v, Index position) const {
    const Index first = crossings_->first_edge(v);
    return first == no_index ? Span<const Edge_crossings::Term>()
                             : crossings_->terms(first + position);
  }

  /// calls `f(loop, number)` for the loops that cross a way from `u` along an edge to `v`, or on
  /// the spot.
  template <typename Function> void for_each_term(Index u, Index v, const Function& f) const {
    crossings_->for_each_term(u, v, f);
  }

private:
  std::shared_ptr<const Edge_crossings> crossings_;
  std::vector<Class_sums> weights_; // by loop
  std::vector<Class_sums> sums_;    // by edge
};

/*!
Fewer places to search from and longer steps between them, for loops that are long beside the edges
of a mesh.

Vertices that are nowhere nearer to each other than the spacing become nodes; each vertex belongs to
the nearest of them. There is a step between two nodes where an edge leads from a vertex of the one
to a vertex of the other, of each class the shortest, and from a node to itself where its vertices
lie around a handle: so walks of all classes are left.

`Mesh` is one of steps, which have been counted, as `Search_mesh`.
*/
template <typename Mesh> class Step_coarsening
{
public:
  /// A way from a node to another: to `from`, along a step of the mesh, and on to the node.
  struct Step
  {
    Index head;
    float length;
    Index from, step;
    Class_sums sums;
  };

  Step_coarsening(const Mesh& mesh, double spacing)
      : mesh_(mesh)
      , spacing_(static_cast<float>(spacing))
      , ways_(mesh.number_of_vertices()) {
    for(Index v = 0; v < ways_.size(); ++v)
      if(ways_[v].node == no_index && !mesh.is_hub(v))
        add_node(v);
    steps_.resize(nodes_.size());
    for(Index v = 0; v < ways_.size(); ++v)
      if(ways_[v].node != no_index)
        add_steps(v);
  }

  /// the vertices that are nodes.
  const std::vector<Index>& nodes() const { return nodes_; }

  /// the node to which a vertex belongs.
  Index node(Index v) const { return ways_[v].node; }

  /// the steps from a node.
  const std::vector<Step>& steps(Index node) const { return steps_[node]; }

  /// the vertex before another on the way to it from its node, and the step between them; none for
  /// a node.
  std::pair<Index, Index> last_step(Index v) const { return {ways_[v].parent, ways_[v].step}; }

private:
  // The shortest way to a vertex, from its node.
  struct Way
  {
    float distance = std::numeric_limits<float>::infinity();
    Index node = no_index, parent = no_index, step = no_index;
    Class_sums sums;
  };

  // Takes over what is nearer to the new node than to those before.
  void add_node(Index v) {
    ways_.reach(v, {0.f, static_cast<Index>(nodes_.size()), no_index, no_index, {}});
    nodes_.push_back(v);
    ways_.grow([&](Index u) {
      const Way here = ways_[u];
      const Sums_of_steps sums = mesh_.sums_from(u);
      for(Index step = mesh_.begin(u); step != mesh_.end(u); ++step) {
        const float there = here.distance + mesh_.length(u, step);
        const Way& way = ways_[mesh_.head(step)];
        // What is reached through u follows it, also where rounding hides that it is nearer.
        const bool follows = way.parent == u && way.step == step && way.node != here.node;
        if(follows || there < (std::min)(way.distance, spacing_))
          ways_.reach(mesh_.head(step), {there, here.node, u, step, here.sums + sums[step]});
      }
    });
  }

  void add_steps(Index v) {
    const Way& here = ways_[v];
    const Sums_of_steps sums_from_here = mesh_.sums_from(v);
    for(Index step = mesh_.begin(v); step != mesh_.end(v); ++step) {
      const Way& there = ways_[mesh_.head(step)];
      if(there.node == no_index)
        continue;
      Class_sums sums = here.sums + sums_from_here[step];
      sums.add(-1, there.sums);
      if(there.node == here.node && sums.is_zero())
        continue;
      add_step({there.node, here.distance + mesh_.length(v, step) + there.distance, v, step, sums},
               steps_[here.node]);
    }
  }

  // Where a node has a great many handles around it, those found first are enough.
  static void add_step(const Step& step, std::vector<Step>& steps) {
    constexpr std::size_t largest_number = 256;
    for(Step& other : steps)
      if(other.head == step.head && other.sums == step.sums) {
        if(step.length < other.length)
          other = step;
        return;
      }
    if(steps.size() < largest_number)
      steps.push_back(step);
  }

  const Mesh& mesh_;
  float spacing_;
  Shortest_paths<Way> ways_; // by vertex
  std::vector<Index> nodes_;
  std::vector<std::vector<Step>> steps_; // by node
};

/// A graph to search for loops on: the edges of the mesh, or of a better triangulation of the same
/// surface, or steps between some of the vertices of one of these. Its steps from a vertex have
/// consecutive numbers; for each stands a walk on the edges of the surface, which is the mesh or a
/// subdivision of it. Steps to hubs of caps are infinitely long.
class Search_mesh
{
public:
  explicit Search_mesh(const Flat_mesh& mesh)
      : mesh_(mesh)
      , surface_(&mesh)
      , number_of_vertices_(mesh.number_of_vertices())
      , begin_(mesh.row_begin.data())
      , heads_(mesh.neighbor.data()) {}

  /// places of another such mesh that are nowhere nearer to each other than \p spacing, and steps
  /// between them of each class; see `Step_coarsening`. Their walks are those of the other mesh,
  /// which has been counted.
  Search_mesh(const Search_mesh& finer, double spacing)
      : mesh_(finer.mesh_)
      , finer_(&finer)
      , surface_(finer.surface_)
      , subdivision_(finer.subdivision_) {
    const Step_coarsening<Search_mesh> coarsening(finer, spacing);
    nodes_ = coarsening.nodes();
    for(Index v = 0; v < finer.number_of_vertices(); ++v) {
      node_of_.push_back(coarsening.node(v));
      const auto [parent, step] = coarsening.last_step(v);
      ways_.push_back({parent, step});
    }
    for(Index node = 0; node < nodes_.size(); ++node) {
      add_vertex();
      for(const auto& step : coarsening.steps(node)) {
        add_step(step.head, step.length);
        links_.push_back({step.from, step.step});
      }
    }
    take_steps();
  }

  Search_mesh(const Search_mesh&) = delete;
  Search_mesh& operator=(const Search_mesh&) = delete;

  /// replaces the edges of the mesh by those of a triangulation with up to so many more vertices,
  /// or about twice as many in all if the mesh has few: ways along edges are poor where triangles
  /// are long and thin. Edges are divided that are longer than \p fine_enough.
  void refine(std::size_t number_of_vertices, double fine_enough = 0.) {
    const std::size_t n = (std::max)(number_of_vertices, mesh_.number_of_vertices());
    // An even mesh of n vertices has 2n triangles of area s^2 sqrt(3) / 4.
    const double longest = (std::max)(fine_enough, std::sqrt(1.5 * 2.31 * area() / double(2 * n)));
    Intrinsic_triangulation triangulation(mesh_);
    triangulation.split(longest, n + number_of_vertices);
    subdivision_ = std::make_shared<const Subdivision>(
        Subdivision{triangulation.subdivision(), triangulation.places(), triangulation.corners()});
    surface_ = &subdivision_->mesh;
    triangulation.make_delaunay();
    add_edges(triangulation);
    take_steps();
    relate_walks_to_mesh();
  }

  /// computes the lengths of all edges once: it pays if many searches follow.
  void measure(Execution execution = {}) {
    if(has_own_steps())
      return;
    lengths_.resize(mesh_.neighbor.size());
    for_each_index(execution, number_of_vertices(), [this](std::size_t i) {
      const Index v = static_cast<Index>(i);
      for(Index s = begin(v); s != end(v); ++s)
        lengths_[s] = length_of_edge(v, head(s));
    });
  }

  /// counts what the steps cross, for all that asks for it until this is called again.
  void count(const Edge_classes& classes) {
    classes_ = &classes;
    if(!has_own_steps())
      return;
    sums_.assign(own_heads_.size(), {});
    if(finer_ == nullptr)
      add_up_walks();
    else
      find_terms();
  }

  /// calls `f(loop, number)` for the loops that cross an edge along which a step leads.
  template <typename Function> void for_each_term(Index from, Index to, const Function& f) const {
    classes_->for_each_term(corner(from), corner(to), f);
  }

  /// calls `f(v, u, name, number)` for steps from `v` to `u` across a loop, which has this number
  /// among those counted, and for the steps back; the numbers of a step, by its name, are to be
  /// added up.
  template <typename Function>
  void for_each_step_across(const Crossing_loop& loop, Index number, const Function& f) const {
    if(finer_ != nullptr)
      for(Index i = across_begin_[number]; i != across_begin_[number + 1]; ++i) {
        const auto [v, step] = steps_across_[i];
        f(v, head(step), step, number_of_term(step, number));
      }
    else
      for(const Crossing& c : loop)
        for_each_step_across(c, f);
  }

  /// Steps have names of their own from 0 on, if their number is not 0; else they are named after
  /// their heads.
  Index name(Index step) const { return has_own_steps() ? step : heads_[step]; }
  std::size_t number_of_names() const { return own_heads_.size(); }

  std::size_t number_of_vertices() const { return number_of_vertices_; }

  /// not of a coarse mesh.
  bool is_hub(Index v) const { return mesh_.is_hub(v); }

  /// the vertex on the edges along which steps lead.
  Index vertex_of_walks(Index v) const { return nodes_.empty() ? v : nodes_[v]; }

  /// the steps from a vertex are those from `begin()` to `end()`.
  Index begin(Index v) const { return begin_[v]; }
  Index end(Index v) const { return begin_[v + 1]; }
  Index head(Index step) const { return heads_[step]; }

  float length(Index v, Index step) const {
    return lengths_.empty() ? length_of_edge(v, head(step)) : lengths_[step];
  }

  /// that of the step from `v` to `u` with this name.
  float length_by_name(Index v, Index u, Index name) const {
    return has_own_steps() ? lengths_[name] : length_of_edge(v, u);
  }

  /// what the steps from `v` cross.
  Sums_of_steps sums_from(Index v) const {
    return has_own_steps() ? Sums_of_steps(sums_.data(), 0) : classes_->sums_from(v, begin(v));
  }

  /// what a walk crosses that crosses a loop once.
  const Class_sums& weight(Index loop) const { return classes_->weight(loop); }

  /// the corner of the mesh that stands for a vertex on the edges along which steps lead.
  Index corner(Index v) const { return subdivision_ == nullptr ? v : subdivision_->corners[v]; }

  /// appends what follows on the edges along which a step from `v` leads.
  void append_walk(Index v, Index step, std::vector<Index>& walk) const {
    if(finer_ == nullptr)
      return for_each_edge(v, step, [&](Index, Index to) { walk.push_back(to); });
    const Step_from link = links_[step];
    append_way(link.vertex, walk);
    finer_->append_walk(link.vertex, link.step, walk);
    std::vector<Index> back(1, nodes_[head(step)]);
    append_way(finer_->head(link.step), back);
    walk.insert(walk.end(), back.rbegin() + 1, back.rend());
  }

  /// the loop on the mesh along a closed walk on these edges without spurs. It crosses the edges of
  /// the mesh where it crosses those of the subdivision that lie on them.
  Crossing_loop loop_along(const std::vector<Index>& walk) const {
    if(subdivision_ == nullptr)
      return pushed_left(mesh_, walk);
    Crossing_loop loop;
    for(const Crossing& c : pushed_left(*surface_, walk)) {
      const Place &left = subdivision_->places[c.left], &right = subdivision_->places[c.right];
      if(const std::optional<Crossing> crossing = crossing_between(left, right, c.ratio))
        loop.push_back(*crossing);
    }
    remove_backtracks(loop);
    return loop;
  }

  /// a vertex near a place, by steps towards it from a corner near it that is no hub.
  Index vertex_near(const Vector& place, Index corner) const {
    if(finer_ != nullptr)
      return node_of_[finer_->vertex_near(place, corner)];
    Index v = corner;
    for(double best = squared_distance(v, place);;) {
      const Index from = v;
      for(Index s = begin(from); s != end(from); ++s)
        if(const double d = squared_distance(head(s), place); d < best && !mesh_.is_hub(head(s))) {
          best = d;
          v = head(s);
        }
      if(v == from)
        return v;
    }
  }

  /// of the surface.
  double area(Execution execution = {}) const {
    constexpr std::size_t grain = 16384;
    std::vector<double> sums((mesh_.number_of_vertices() + grain - 1) / grain, 0.);
    execution.for_ranges(mesh_.number_of_vertices(), grain,
                         [&](std::size_t begin_of_range, std::size_t end_of_range) {
                           for(std::size_t v = begin_of_range; v < end_of_range; ++v)
                             sums[begin_of_range / grain] += area_at(static_cast<Index>(v));
                         });
    return std::accumulate(sums.begin(), sums.end(), 0.);
  }

private:
  // Of the faces of which a vertex is the first.
  double area_at(Index v) const {
    const Ring ring = mesh_.ring(v);
    double sum = 0.;
    for(Index p = 0; p < ring.size(); ++p) {
      const Index a = ring[p], b = ring[ring.next(p)];
      if(v < a && v < b && !mesh_.is_hub(v) && !mesh_.is_spoke(a, b))
        sum +=
            0.5 * norm(cross(mesh_.points[a] - mesh_.points[v], mesh_.points[b] - mesh_.points[v]));
    }
    return sum;
  }

  using Place = Intrinsic_triangulation::Place;

  struct Subdivision
  {
    Flat_mesh mesh; // points and rings
    std::vector<Place> places;
    std::vector<Index> corners;
  };

  // A step, and where it begins.
  struct Step_from
  {
    Index vertex, step;
  };

  // Or those of the mesh.
  bool has_own_steps() const { return !own_begin_.empty(); }

  // Of a mesh that is not coarse.
  template <typename Function> void for_each_edge(Index v, Index step, const Function& f) const {
    if(!has_own_steps())
      return f(v, head(step));
    for(Index i = walk_begin_[step]; i != walk_begin_[step + 1]; ++i) {
      f(v, walks_[i]);
      v = walks_[i];
    }
  }

  // What follows its node on the way to a vertex of the finer mesh.
  void append_way(Index v, std::vector<Index>& walk) const {
    std::vector<Step_from> steps;
    for(; ways_[v].vertex != no_index; v = ways_[v].vertex)
      steps.push_back(ways_[v]);
    for(auto s = steps.rbegin(); s != steps.rend(); ++s)
      finer_->append_walk(s->vertex, s->step, walk);
  }

  Span<const std::pair<Index, int>> terms(Index step) const {
    return {terms_.data() + terms_begin_[step], terms_begin_[step + 1] - terms_begin_[step]};
  }

  int number_of_term(Index step, Index loop) const {
    const auto own = terms(step);
    return std::lower_bound(own.begin(), own.end(), std::make_pair(loop, INT_MIN))->second;
  }

  // In both directions.
  template <typename Function>
  void for_each_step_across(const Crossing& c, const Function& f) const {
    if(!has_own_steps()) {
      f(c.left, c.right, c.right, 1);
      f(c.right, c.left, c.left, -1);
      return;
    }
    const auto [edge, is_from_left] = edge_of_mesh(c.left, c.right);
    for(Index i = steps_along_begin_[edge]; i != steps_along_begin_[edge + 1]; ++i) {
      const auto [step, is_back] = steps_along_[i];
      const Index back = ways_back_[step], v = head(back), u = head(step);
      const int number = is_back != is_from_left ? 1 : -1;
      f(v, u, step, number);
      f(u, v, back, -number);
    }
  }

  float length_of_edge(Index u, Index v) const {
    return mesh_.is_spoke(u, v) ? std::numeric_limits<float>::infinity()
                                : static_cast<float>(mesh_.edge_length(u, v));
  }

  // Of an edge of the subdivision, if it lies on one of the mesh.
  static std::optional<Crossing> crossing_between(const Place& left, const Place& right, double r) {
    const Place edge = Place::edge_of(left, right);
    const double from = left.ratio_on(edge), to = right.ratio_on(edge);
    if(left.source == no_index || right.source == no_index || from < 0. || to < 0.)
      return std::nullopt;
    const double at = rounded_product(1. - r, from) + rounded_product(r, to);
    return from < to ? Crossing{edge.source, edge.target, at}
                     : Crossing{edge.target, edge.source, 1. - at};
  }

  double squared_distance(Index v, const Vector& place) const {
    const Vector to = place - surface_->points[vertex_of_walks(v)];
    return dot(to, to);
  }

  // ---- counting

  // What comes before a vertex on its way is looked at before it.
  void find_crossed_ways() {
    last_crossed_.assign(ways_.size(), no_index);
    std::vector<char> is_known(ways_.size(), 0);
    std::vector<Index> way;
    for(Index v = 0; v < ways_.size(); ++v) {
      for(Index u = v; ways_[u].vertex != no_index && is_known[u] == 0; u = ways_[u].vertex)
        way.push_back(u);
      for(; !way.empty(); way.pop_back()) {
        const Index u = way.back(), before = ways_[u].vertex;
        const bool is_crossed = !finer_->sums_from(before)[ways_[u].step].is_zero();
        last_crossed_[u] = is_crossed ? u : last_crossed_[before];
        is_known[u] = 1;
      }
    }
  }

  // What is known of one way along an edge of a triangulation is known of the other.
  void add_up_walks() {
    for(Index v = 0; v < number_of_vertices(); ++v)
      for(Index s = begin(v); s != end(v); ++s)
        if(const Index back = ways_back_[s]; back < s)
          sums_[s].add(-1, sums_[back]);
        else
          for_each_edge_of_mesh(v, s, [&](Index u, Index position, int sign) {
            sums_[s].add(sign, classes_->sums_from(u, 0)[position]);
          });
  }

  void find_terms() {
    terms_begin_.assign(own_heads_.size() + 1, 0);
    terms_.clear();
    find_crossed_ways();
    for(Index step = 0; step < own_heads_.size(); ++step) {
      add_terms(step);
      terms_begin_[step + 1] = static_cast<Index>(terms_.size());
    }
    note_steps_across();
  }

  // By the ways to the link of a step from both ends.
  void add_terms(Index step) {
    const Step_from link = links_[step];
    add_terms_of_way(link.vertex, 1);
    finer_->for_each_loop_across(link, [&](Index loop, int number) { crossed_.add(loop, number); });
    add_terms_of_way(finer_->head(link.step), -1);
    crossed_.take([&](Index loop, int number) {
      terms_.emplace_back(loop, number);
      sums_[step].add(number, classes_->weight(loop));
    });
  }

  void add_terms_of_way(Index v, int sign) {
    for(Index u = last_crossed_[v]; u != no_index; u = last_crossed_[ways_[u].vertex])
      finer_->for_each_loop_across(
          ways_[u], [&](Index loop, int number) { crossed_.add(loop, sign * number); });
  }

  // Calls `f(loop, number)`, perhaps more than once for a loop.
  template <typename Function> void for_each_loop_across(Step_from s, const Function& f) const {
    if(!has_own_steps())
      for_each_term(s.vertex, head(s.step), f);
    else if(finer_ == nullptr)
      for_each_edge_of_mesh(s.vertex, s.step, [&](Index v, Index position, int sign) {
        for(const Edge_crossings::Term& t : classes_->terms_at(v, position))
          f(t.loop, sign * t.number);
      });
    else
      for(const auto& [loop, number] : terms(s.step))
        f(loop, number);
  }

  void note_steps_across() {
    across_begin_.assign(classes_->number_of_loops() + 1, 0);
    for(const auto& term : terms_)
      ++across_begin_[term.first];
    std::partial_sum(across_begin_.begin(), across_begin_.end(), across_begin_.begin());
    steps_across_.resize(terms_.size());
    for(Index v = static_cast<Index>(number_of_vertices()); v-- > 0;)
      for(Index s = end(v); s-- > begin(v);)
        for(const auto& term : terms(s))
          steps_across_[--across_begin_[term.first]] = {v, s};
  }

  // ---- steps

  // The steps that are added next are from the next vertex.
  void add_vertex() { own_begin_.push_back(static_cast<Index>(own_heads_.size())); }

  void add_step(Index head, float length) {
    own_heads_.push_back(head);
    lengths_.push_back(length);
  }

  void add_edges(const Intrinsic_triangulation& triangulation) {
    const Index n = static_cast<Index>(triangulation.number_of_halfedges());
    std::vector<Index> end(triangulation.number_of_vertices() + 1, 0), by_source(n), steps(n);
    for(Index h = 0; h < n; ++h)
      ++end[triangulation.source(h) + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    for(Index h = 0; h < n; ++h) {
      steps[h] = end[triangulation.source(h)]++;
      by_source[steps[h]] = h;
    }
    for(Index h : by_source)
      ways_back_.push_back(steps[triangulation.twin(h)]);
    own_heads_.reserve(n);
    lengths_.reserve(n);
    walk_begin_.reserve(n + 1);
    walks_.reserve(n);
    for(std::size_t v = 0, i = 0; v + 1 < end.size(); ++v)
      for(add_vertex(); i < end[v]; ++i) {
        add_step(triangulation.target(by_source[i]),
                 static_cast<float>(triangulation.length(by_source[i])));
        walk_begin_.push_back(static_cast<Index>(walks_.size()));
        triangulation.append_walk(by_source[i], walks_);
      }
    walk_begin_.push_back(static_cast<Index>(walks_.size()));
  }

  // Which edges of the mesh walks lead along, and which walks lead along edges.
  void relate_walks_to_mesh() {
    edges_.resize(walks_.size());
    for(Index v = 0; v < number_of_vertices(); ++v)
      for(Index step = begin(v); step != end(v); ++step)
        if(Index i = walk_begin_[step]; ways_back_[step] > step)
          for_each_edge(v, step, [&](Index from, Index to) {
            const Index u = corner(from), w = corner(to);
            edges_[i++] = u == w ? no_index : edge_of_mesh(u, w).first;
          });
    steps_along_begin_.assign(mesh_.neighbor.size() + 1, 0);
    for_each_step_along_edge([&](Index edge, Index, bool) { ++steps_along_begin_[edge]; });
    std::partial_sum(steps_along_begin_.begin(), steps_along_begin_.end(),
                     steps_along_begin_.begin());
    steps_along_.resize(steps_along_begin_.back());
    for_each_step_along_edge([&](Index edge, Index step, bool is_back) {
      steps_along_[--steps_along_begin_[edge]] = {step, is_back};
    });
  }

  // An edge of the mesh, by its number in the ring of the end with fewer neighbors, and whether
  // that is `u`.
  std::pair<Index, bool> edge_of_mesh(Index u, Index w) const {
    const Ring at_u = mesh_.ring(u), at_w = mesh_.ring(w);
    const bool is_at_u = std::make_pair(at_u.size(), u) < std::make_pair(at_w.size(), w);
    return {is_at_u ? mesh_.row_begin[u] + at_u.position(w) : mesh_.row_begin[w] + at_w.position(u),
            is_at_u};
  }

  // Calls `f(v, position, sign)` for edges in the rings of `v`, and 1 if the walk leads away from
  // there. Of two ways along an edge of the triangulation, the edges of the first are known.
  template <typename Function>
  void for_each_edge_of_mesh(Index v, Index step, const Function& f) const {
    const bool is_back = ways_back_[step] < step;
    if(is_back) {
      v = head(step);
      step = ways_back_[step];
    }
    for(Index i = walk_begin_[step]; i != walk_begin_[step + 1]; ++i) {
      if(const Index edge = edges_[i]; edge != no_index) {
        const Index from = corner(v);
        const bool is_at_from = mesh_.row_begin[from] <= edge && edge < mesh_.row_begin[from + 1];
        const Index at = is_at_from ? from : corner(walks_[i]);
        f(at, edge - mesh_.row_begin[at], is_at_from != is_back ? 1 : -1);
      }
      v = walks_[i];
    }
  }

  // Calls `f(edge, step, is_back)`, for one of two ways.
  template <typename Function> void for_each_step_along_edge(const Function& f) const {
    for(Index v = 0; v < number_of_vertices(); ++v)
      for(Index step = begin(v); step != end(v); ++step)
        if(ways_back_[step] > step)
          for_each_edge_of_mesh(v, step, [&](Index at, Index position, int sign) {
            f(mesh_.row_begin[at] + position, step, sign < 0);
          });
  }

  void take_steps() {
    number_of_vertices_ = own_begin_.size();
    add_vertex();
    begin_ = own_begin_.data();
    heads_ = own_heads_.data();
  }

  const Flat_mesh& mesh_;
  // The mesh of which this has a part of the vertices, if there is one, those, and by vertex there
  // the nearest of them.
  const Search_mesh* finer_ = nullptr;
  std::vector<Index> nodes_, node_of_;
  std::vector<Step_from> ways_; // by vertex there: the last step on the way from its node
  std::vector<Step_from>
      links_; // by step: the one there from a vertex of one node to one of another
  const Flat_mesh* surface_;
  std::shared_ptr<const Subdivision> subdivision_; // unless the mesh is the surface
  std::size_t number_of_vertices_ = 0;
  const Index *begin_ = nullptr, *heads_ = nullptr; // by vertex and by step, of the mesh or these:
  std::vector<Index> own_begin_, own_heads_;
  // By step of a triangulation: what its walk leads to, along which edges of the mesh (of one of
  // two ways), and the step back; by edge of the mesh: the steps whose walks lead along it, and
  // whether backwards.
  std::vector<Index> walk_begin_, walks_, edges_, ways_back_;
  std::vector<Index> steps_along_begin_;
  std::vector<std::pair<Index, bool>> steps_along_;
  std::vector<float> lengths_;            // by step, of the mesh as well if measured
  const Edge_classes* classes_ = nullptr; // that were last counted
  std::vector<Class_sums> sums_;          // by step, only of its own
  // Of a coarser mesh: by step, what it crosses, and how often.
  std::vector<Index> terms_begin_;
  std::vector<std::pair<Index, int>> terms_; // loops and numbers, by loop
  std::vector<Index> across_begin_;          // by loop
  std::vector<Step_from> steps_across_;
  Sparse_sum<int> crossed_;         // by a step, by loop
  std::vector<Index> last_crossed_; // of the steps on a way, by vertex of the finer mesh: its end
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_HOMOLOGY_SEARCH_MESH_H
