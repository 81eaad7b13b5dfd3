// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_NARROW_BAND_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_NARROW_BAND_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The rows of the Laplacian with room for eight neighbours each, so that the inner loop has a
/// fixed length: valences vary at random, and a mispredicted branch costs as much as the sum
/// itself. Short rows are filled up with a vertex that does not exist, `n`, whose value is zero;
/// vertices with longer rows are left to the ring. Of those with long rows, whose neighbours know
/// them, sums are kept (see `whole_value()`).
class Stencils
{
public:
  static constexpr Index width = stencil_width;

  Stencils(Execution execution, const Flat_mesh& mesh)
      : rows_(mesh.number_of_vertices()) {
    for_each_index(execution, rows_.size(), [&](std::size_t v) {
      const Ring ring = mesh.ring(static_cast<Index>(v));
      Row& row = rows_[v];
      row.neighbors.fill(static_cast<Index>(rows_.size()));
      if(ring.size() <= width)
        std::copy(ring.begin(), ring.end(), row.neighbors.begin());
      row.weight = 1.f / static_cast<float>(ring.size());
    });
    find_long_rows(mesh);
  }

  float mean(Index v, const float* values) const {
    const Row& row = rows_[v];
    return stencil_mean(row.weight, [&](Index i) { return values[row.neighbors[i]]; });
  }

  /// the neighbours of a vertex with a short row, filled up.
  const std::array<Index, width>& neighbors(Index v) const { return rows_[v].neighbors; }

  std::size_t number_of_long_rows() const { return long_rows_.size(); }
  Index vertex_of_long_row(Index number) const { return long_rows_[number]; }
  /// the number of the long row of a vertex, `no_index` if it is not long.
  Index long_row(Index v) const {
    const auto it = std::lower_bound(long_rows_.begin(), long_rows_.end(), v);
    return it == long_rows_.end() || *it != v ? no_index
                                              : static_cast<Index>(it - long_rows_.begin());
  }
  /// calls `f(number)` for the long rows in which a vertex is, if there is any.
  template <typename Function> void for_each_long_row_with(Index v, const Function& f) const {
    for(Index i = long_begin_[v]; i < long_begin_[v + 1]; ++i)
      f(long_beside_[i]);
  }

private:
  void find_long_rows(const Flat_mesh& mesh) {
    for(Index v = 0; v < rows_.size(); ++v)
      if(mesh.ring(v).size() > many_neighbors)
        long_rows_.push_back(v);
    if(long_rows_.empty())
      return;
    long_begin_.assign(rows_.size() + 2, 0);
    for(Index v : long_rows_)
      for(Index u : mesh.ring(v))
        ++long_begin_[u + 2];
    std::partial_sum(long_begin_.begin(), long_begin_.end(), long_begin_.begin());
    long_beside_.resize(long_begin_.back());
    for(Index i = 0; i < long_rows_.size(); ++i)
      for(Index u : mesh.ring(long_rows_[i]))
        long_beside_[long_begin_[u + 1]++] = i;
  }

  struct Row
  {
    std::array<Index, width> neighbors;
    float weight;
  };

  std::vector<Row> rows_;
  std::vector<Index> long_rows_;   // their vertices, ascending
  std::vector<Index> long_begin_;  // by vertex, in
  std::vector<Index> long_beside_; // numbers of long rows
};

/// No wall anywhere.
struct No_walls
{
  static constexpr bool is_wall(Index, Index) { return false; }
};

/// Where a front comes from, if there are two.
enum class Side : std::uint8_t { LEFT, RIGHT };

/*!
The single-layer field in a narrow band: explicit Euler steps on the vertices where the field may
change, and the time at which each vertex was reached, and from which side.

A vertex counts as reached when its value has passed the threshold *and* a neighbour was reached in
an earlier step. Hence every vertex that is no source has an earlier neighbour, and the arrival time
has no minimum but the sources: the count of handles rests on that alone.

The object can be used again and again; `reset()` costs as much as the region that was touched.
*/
class Narrow_band
{
public:
  Narrow_band(const Flat_mesh& mesh, const Stencils& stencils, const Step_coefficients& k)
      : mesh_(mesh)
      , stencils_(stencils)
      , coefficients_(k)
      , spark_(k.penalty / k.diffusion)
      , value_(mesh.number_of_vertices() + 1, 0.f)
      , time_(mesh.number_of_vertices() + 1, never)
      , state_(mesh.number_of_vertices() + 1, 0)
      , band_(new Index[mesh.number_of_vertices() + 1])
      , touched_(new Index[mesh.number_of_vertices() + 1])
      , next_(new float[mesh.number_of_vertices()])
      , noted_(new Index[mesh.number_of_vertices() + 1])
      , sum_(stencils.number_of_long_rows(), 0) {
    for(Index v = 0; v < mesh.number_of_vertices(); ++v)
      if(mesh.ring(v).size() > Stencils::width)
        state_[v] = special;
    state_.back() = active;
  }

  /// says that there may be walls at \p v, in all runs to come; walls elsewhere are not seen.
  void expect_walls(Index v) { state_[v] |= special; }

  /// says that there may be walls at \p v, until `reset()`.
  void expect_walls_now(Index v) {
    if(state_[v] & (special | special_now))
      return;
    state_[v] |= special_now;
    special_now_.push_back(v);
  }

  /// makes `v` a source, unless it is one already: its value is one for ever.
  void add_source(Index v, Time time, Side side = Side::LEFT) {
    CGAL_precondition(v < mesh_.number_of_vertices());
    if(is_reached(v))
      return;
    touched_[number_of_touched_++] = v;
    sources_.push_back(v);
    state_[v] |= active;
    value_[v] = 1.f;
    arrive(v, time, side);
  }

  /// to be called after the last source was added.
  template <typename Walls> void start(const Walls& walls) {
    for(Index v : sources_)
      activate_neighbors(row_beside_walls(v, walls), walls);
    sources_.clear();
  }

  /// makes one step and calls `reached(v)` for each vertex that was reached in it. Returns false
  /// if there is nothing left to update.
  template <typename Walls, typename Reached>
  bool step(const Walls& walls, const Reached& reached) {
    if(band_size_ == 0 && special_band_.empty())
      return false;
    CGAL_assertion_msg(step_ < never / ticks_per_step - 1, "times are numbers of 32 bits");
    ++step_;
    compute();
    const std::size_t reached_before = number_of_reached_;
    commit(walls, reached);
    if(number_of_reached_ != reached_before)
      last_progress_ = step_;
    else if(step_ - last_progress_ > coefficients_.patience)
      push_on(walls, reached);
    return true;
  }

  /// calls `f(u)` for the reached neighbours of \p v.
  template <typename Function> void for_each_reached_neighbor(Index v, const Function& f) const {
    const auto visit = [&](const auto& neighbors) {
      for(Index u : neighbors)
        if(is_reached(u))
          f(u);
    };
    if(is_special(v))
      visit(mesh_.ring(v));
    else
      visit(stencils_.neighbors(v));
  }

  bool is_reached(Index v) const { return time_[v] != never; }
  Time time(Index v) const { return time_[v]; }

  /// the times of all vertices; the band cannot be used after it.
  std::vector<Time> take_times() {
    time_.pop_back();
    return std::move(time_);
  }

  Side side(Index v) const { return state_[v] & right ? Side::RIGHT : Side::LEFT; }

  /// a mark of the caller's on a reached vertex; gone after `reset()`.
  void mark(Index v) { state_[v] |= marked; }
  bool is_marked(Index v) const { return (state_[v] & marked) != 0; }

  std::size_t number_of_reached() const { return number_of_reached_; }
  std::size_t number_of_updates() const { return number_of_updates_; }
  Time number_of_steps() const { return step_; }

  void reset() {
    for(std::size_t i = 0; i < number_of_touched_; ++i) {
      const Index v = touched_[i];
      value_[v] = 0.f;
      time_[v] = never;
      state_[v] &= special;
    }
    for(Index v : special_now_)
      state_[v] = 0;
    number_of_touched_ = band_size_ = 0;
    special_now_.clear();
    special_band_.clear();
    special_rows_.clear();
    sources_.clear();
    step_ = last_progress_ = 0;
    number_of_reached_ = 0;
  }

  /// whether there is a wall between two neighbours.
  template <typename Walls> bool is_wall(Index u, Index v, const Walls& walls) const {
    return is_special(u) && walls.is_wall(u, v);
  }

private:
  // The states of a vertex: in the band now or before; reached from the right; marked by the
  // caller; having more neighbours than a stencil has room for, or perhaps a wall beside it, always
  // or in this run.
  static constexpr std::uint8_t active = 1, right = 2, marked = 4, special = 8, special_now = 16;

  bool is_special(Index v) const { return (state_[v] & (special | special_now)) != 0; }

  // The neighbours of a vertex that is not special, and the vertex that does not exist, which is
  // active and never reached. The stencil is in the cache already, which the ring is not.
  struct Stencil_row
  {
    Index vertex;
    const Index* neighbors;

    static constexpr Index size() { return Stencils::width; }
    Index operator[](Index i) const { return neighbors[i]; }
  };

  // Those neighbours of a special vertex from which no wall parts it, in `special_rows_`, which
  // grows while rows of it are in use.
  struct Special_row
  {
    Index vertex, length;
    Index long_row; // its number, if it is one
    std::size_t begin;
    const std::vector<Index>* rows;

    Index size() const { return length; }
    Index operator[](Index i) const { return (*rows)[begin + i]; }
  };

  Stencil_row row(Index v) const { return {v, stencils_.neighbors(v).data()}; }

  void arrive(Index v, Time time, Side side) {
    CGAL_assertion_msg(!is_reached(v), "a vertex is reached once");
    time_[v] = time;
    if(side == Side::RIGHT)
      state_[v] |= right;
    ++number_of_reached_;
  }

  template <typename Walls> Special_row row_beside_walls(Index v, const Walls& walls) {
    const std::size_t begin = special_rows_.size();
    for(Index u : mesh_.ring(v))
      if(!is_wall(v, u, walls))
        special_rows_.push_back(u);
    const Index long_row = stencils_.long_row(v);
    if(long_row != no_index)
      sum_[long_row] = std::accumulate(
          special_rows_.begin() + begin, special_rows_.end(), std::uint64_t(0),
          [this](std::uint64_t sum, Index u) { return sum + whole_value(value_[u]); });
    return {v, static_cast<Index>(special_rows_.size() - begin), long_row, begin, &special_rows_};
  }

  template <typename Row, typename Walls>
  void activate_neighbors(const Row& row, const Walls& walls) {
    for(Index i = 0; i < row.size(); ++i) {
      const Index u = row[i];
      const bool has_stencil = !is_special(u);
      const bool is_new = (state_[u] & active) == 0;
      state_[u] |= active;
      if(is_new && !has_stencil)
        special_band_.push_back(row_beside_walls(u, walls));
      // What is written behind the end does not count; this way there is no branch to mispredict.
      touched_[number_of_touched_] = u;
      band_[band_size_] = u;
      number_of_touched_ += is_new;
      band_size_ += is_new && has_stencil;
    }
    CGAL_assertion(number_of_touched_ <= mesh_.number_of_vertices());
    CGAL_assertion(band_size_ + special_band_.size() <= mesh_.number_of_vertices());
  }

  float mean(const Special_row& row) const {
    if(row.long_row != no_index)
      return mean_of_whole_values(sum_[row.long_row], row.size());
    float sum = 0.f;
    for(Index i = 0; i < row.size(); ++i)
      sum += value_[row[i]];
    return sum / static_cast<float>(row.size());
  }

  // The new values, and of whom the front takes notice: few, so that the loops over the whole band
  // stay short, and without a branch.
  void compute() {
    number_of_updates_ += band_size_ + special_band_.size();
    // Copies, which no write through a pointer can change.
    const Step_coefficients k = coefficients_;
    const float* const values = value_.data();
    std::size_t number_of_noted = 0;
    for(std::size_t i = 0; i < band_size_; ++i) {
      const Index v = band_[i];
      const float before = values[v];
      const float after = stepped_value(before, stencils_.mean(v, values), k);
      next_[i] = after;
      noted_[number_of_noted] = static_cast<Index>(i);
      number_of_noted += is_noted(before, after, spark_);
    }
    number_of_noted_ = number_of_noted;
    next_special_.clear();
    for(const Special_row& row : special_band_)
      next_special_.push_back(stepped_value(value_[row.vertex], mean(row), coefficients_));
  }

  static bool is_noted(float before, float after, float spark) {
    return ((before < front_threshold) & (after >= front_threshold)) |
           ((before <= spark) & (after > spark));
  }

  template <typename Walls, typename Reached>
  void commit(const Walls& walls, const Reached& reached) {
    // What is activated meanwhile goes behind the old band.
    const std::size_t size = band_size_, special_size = special_band_.size();
    for(std::size_t j = 0; j < number_of_noted_; ++j) {
      const Index i = noted_[j];
      next_[i] = settled_value(row(band_[i]), next_[i], walls, reached);
    }
    for(std::size_t i = 0; i < special_size; ++i) {
      const Special_row row = special_band_[i];
      if(is_noted(value_[row.vertex], next_special_[i], spark_))
        next_special_[i] = settled_value(row, next_special_[i], walls, reached);
    }
    if(std::any_of(special_band_.begin(), special_band_.end(),
                   [](const Special_row& row) { return row.long_row != no_index; }))
      change_sums(size, special_size, walls);
    set_values(size, special_size);
  }

  template <typename Walls>
  void change_sums(std::size_t size, std::size_t special_size, const Walls& walls) {
    for(std::size_t i = 0; i < size; ++i)
      change_sums(band_[i], next_[i], walls);
    for(std::size_t i = 0; i < special_size; ++i)
      change_sums(special_band_[i].vertex, next_special_[i], walls);
  }

  // Those of long rows in which a vertex is that is about to have another value.
  template <typename Walls> void change_sums(Index v, float after, const Walls& walls) {
    const std::uint64_t change = whole_value(after) - whole_value(value_[v]); // modulo 2^64
    if(change == 0 || sum_.empty())
      return;
    stencils_.for_each_long_row_with(v, [&](Index row) {
      const Index u = stencils_.vertex_of_long_row(row);
      if((state_[u] & active) != 0 && !is_wall(u, v, walls))
        sum_[row] += change;
    });
  }

  /// the new value of a vertex of which the front takes notice. No vertex passes the threshold
  /// before a neighbour has.
  template <typename Row, typename Walls, typename Reached>
  float settled_value(const Row& row, float after, const Walls& walls, const Reached& reached) {
    const Index v = row.vertex;
    const float before = value_[v];
    if(before < front_threshold && after >= front_threshold) {
      const Index earlier = earliest_neighbor(row);
      if(earlier == v)
        after = just_below_threshold;
      else {
        arrive(v, crossing_time(before, after, step_), side(earlier));
        CGAL_assertion(time(earlier) < time(v));
        reached(v);
      }
    }
    if(before <= spark_ && after > spark_)
      activate_neighbors(row, walls);
    return after;
  }

  // Those that have come to one leave the band, the first `size` places of it.
  void set_values(std::size_t size, std::size_t special_size) {
    std::size_t kept = 0;
    for(std::size_t i = 0; i < size; ++i) {
      const Index v = band_[i];
      value_[v] = next_[i];
      band_[kept] = v;
      kept += next_[i] < 1.f;
    }
    band_size_ =
        std::copy(band_.get() + size, band_.get() + band_size_, band_.get() + kept) - band_.get();

    kept = 0;
    for(std::size_t i = 0; i < special_size; ++i) {
      const Special_row row = special_band_[i];
      value_[row.vertex] = next_special_[i];
      special_band_[kept] = row;
      kept += next_special_[i] < 1.f;
    }
    special_band_.erase(special_band_.begin() + kept, special_band_.begin() + special_size);
  }

  // Among the neighbours reached in earlier steps; the vertex itself if there is none.
  template <typename Row> Index earliest_neighbor(const Row& row) const {
    std::uint64_t earliest = arrival_key((step_ - 1) * ticks_per_step, no_index);
    for(Index i = 0; i < row.size(); ++i)
      earliest = (std::min)(earliest, arrival_key(time_[row[i]], row[i]));
    const Index u = static_cast<Index>(earliest);
    return u == no_index ? row.vertex : u;
  }

  // On a mesh that is coarser than the front is wide, the front can come to rest: a vertex of high
  // degree with one reached neighbour, say. Then all that it touches is declared reached.
  template <typename Walls, typename Reached>
  void push_on(const Walls& walls, const Reached& reached) {
    last_progress_ = ++step_;
    const std::size_t reached_before = number_of_reached_;
    const std::vector<Index> band(band_.get(), band_.get() + band_size_);
    const std::vector<Special_row> special_band = special_band_;
    for(Index v : band)
      push_on_to(row(v), walls, reached);
    for(const Special_row& row : special_band)
      push_on_to(row, walls, reached);
    if(number_of_reached_ == reached_before) {
      band_size_ = 0; // all is reached, and the values have come to rest somewhere below 1
      special_band_.clear();
    }
    leave_band();
  }

  template <typename Row, typename Walls, typename Reached>
  void push_on_to(const Row& row, const Walls& walls, const Reached& reached) {
    const Index v = row.vertex;
    const Index earlier = is_reached(v) ? v : earliest_neighbor(row);
    if(earlier == v)
      return;
    arrive(v, step_ * ticks_per_step, side(earlier));
    CGAL_assertion(time(earlier) < time(v));
    if(value_[v] <= spark_)
      activate_neighbors(row, walls);
    change_sums(v, 1.f, walls);
    value_[v] = 1.f;
    reached(v);
  }

  // What has come to 1 is updated no more.
  void leave_band() {
    const auto is_full = [&](Index v) { return value_[v] == 1.f; };
    band_size_ = std::remove_if(band_.get(), band_.get() + band_size_, is_full) - band_.get();
    special_band_.erase(std::remove_if(special_band_.begin(), special_band_.end(),
                                       [&](const Special_row& row) { return is_full(row.vertex); }),
                        special_band_.end());
  }

  const Flat_mesh& mesh_;
  const Stencils& stencils_;
  Step_coefficients coefficients_;
  float spark_; // a vertex stays at zero as long as all its neighbours are below this value
  // These three have one more place than there are vertices, see `Stencils`.
  std::vector<float> value_;
  std::vector<Time> time_;
  std::vector<std::uint8_t> state_;
  std::unique_ptr<Index[]> band_; // not initialised: a pass in a small region touches little of it
  std::unique_ptr<Index[]> touched_;
  std::unique_ptr<float[]> next_;
  std::unique_ptr<Index[]> noted_; // places in the band
  std::size_t number_of_noted_ = 0;
  std::size_t band_size_ = 0;
  std::size_t number_of_touched_ = 0;
  std::vector<Special_row> special_band_;
  std::vector<Index> special_rows_;
  std::vector<Index> special_now_;
  std::vector<float> next_special_;
  std::vector<std::uint64_t> sum_; // by long row that is active: of its values
  std::vector<Index> sources_;
  Time step_ = 0;
  Time last_progress_ = 0;
  std::size_t number_of_reached_ = 0;
  std::size_t number_of_updates_ = 0;
};

/// makes steps until so many vertices are reached, or the band is at rest; tells `tell(part)` now
/// and then how far it has come.
template <typename Tell>
void grow(Narrow_band& band, std::size_t number_of_vertices, const Tell& tell) {
  const No_walls walls;
  band.start(walls);
  while(band.number_of_reached() < number_of_vertices && band.step(walls, [](Index) {}))
    if(band.number_of_steps() % 64 == 0)
      tell(double(band.number_of_reached()) / double(number_of_vertices));
}

/// starts a front at vertices. A single vertex may be too little for a front to leave it.
inline void add_sources_with_rings(Narrow_band& band,
                                   const Flat_mesh& mesh,
                                   const std::vector<Index>& vertices) {
  for(Index v : vertices)
    band.add_source(v, 0);
  for(Index v : vertices)
    for(Index u : mesh.ring(v))
      band.add_source(u, 1);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_NARROW_BAND_H
