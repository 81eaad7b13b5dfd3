// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FIELDS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FIELDS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/field/phase_field.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Arrivals.h>

#include <CGAL/assertions.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

/// The Laplacian in local edge lengths: four times (mean of the neighbors - value). Its weights are
/// positive and sum up to the same in each row, so that the front moves at the same number of edges
/// per step everywhere; neither holds of the weights of linear elements. Neighbors behind walls do
/// not count.
inline Eigen::SparseMatrix<double, Eigen::RowMajor>
laplacian(const Flat_mesh& mesh, const Barred_edges& walls = Barred_edges()) {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(mesh.neighbor.size() + mesh.number_of_vertices());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const std::size_t first = entries.size();
    const Ring ring = mesh.ring(v);
    for(Index i = 0; i < ring.size(); ++i)
      if(walls.empty() || !walls[mesh.row_begin[v] + i])
        entries.emplace_back(static_cast<int>(v), static_cast<int>(ring[i]), 4.);
    const double number = static_cast<double>(entries.size() - first);
    for(std::size_t j = first; j < entries.size(); ++j)
      entries[j] = {entries[j].row(), entries[j].col(), 4. / number};
    if(number > 0.)
      entries.emplace_back(static_cast<int>(v), static_cast<int>(v), -4.);
  }
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The Laplacian of linear finite elements, with a mass for each vertex (paper, section 3). Lengths
/// are in mean edge lengths, so that it is the other one on equilateral triangles. Edges with walls
/// have no weight.
inline Eigen::SparseMatrix<double, Eigen::RowMajor>
finite_element_laplacian(const Flat_mesh& mesh, const Barred_edges& walls = Barred_edges()) {
  const auto n = static_cast<Eigen::Index>(mesh.number_of_vertices());
  std::vector<double> area(mesh.number_of_vertices(), 0.);
  std::vector<Eigen::Triplet<double>> weights;
  double length = 0.;
  for(Index v = 0; v < mesh.number_of_vertices(); ++v) {
    const Ring ring = mesh.ring(v);
    for(Index i = 0; i < ring.size(); ++i) { // the triangle (v, a, b), for its edge from a to b
      const Index a = ring[i], b = ring[ring.next(i)];
      const Vector p = mesh.points[a] - mesh.points[v], q = mesh.points[b] - mesh.points[v];
      const double twice_area = norm(cross(p, q));
      area[v] += twice_area / 6.;
      length += norm(p);
      if(!(twice_area > 0.) || (!walls.empty() && walls[slot(mesh, a, b)]))
        continue;
      const double weight = dot(p, q) / twice_area / 2.;
      for(const auto& [u, w] : {std::pair(a, b), std::pair(b, a)}) {
        weights.emplace_back(static_cast<int>(u), static_cast<int>(w), weight);
        weights.emplace_back(static_cast<int>(u), static_cast<int>(u), -weight);
      }
    }
  }
  length /= static_cast<double>(mesh.neighbor.size());
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(n, n);
  matrix.setFromTriplets(weights.begin(), weights.end());
  Eigen::VectorXd scale(n);
  for(Eigen::Index v = 0; v < n; ++v)
    scale[v] = area[v] > 0. ? length * length / area[v] : 0.;
  return scale.asDiagonal() * matrix;
}

/// the one that is asked for.
inline Eigen::SparseMatrix<double, Eigen::RowMajor>
laplacian(const Flat_mesh& mesh, const Literal_rules& rules, const Barred_edges& walls = {}) {
  return rules.finite_elements ? finite_element_laplacian(mesh, walls) : laplacian(mesh, walls);
}

inline void check_rules(const Literal_rules& rules) {
  const auto is_threshold = [](double value) { return value >= 0. && value < 1.; };
  if(!(rules.mean_edge_length > 0.) || !std::isfinite(rules.mean_edge_length) ||
     !is_threshold(rules.band_threshold) || !is_threshold(rules.contact_threshold) ||
     !(rules.offset > 0.) || !std::isfinite(rules.offset))
    throw std::invalid_argument(
        "lengths of literal rules must be positive, and thresholds in [0, 1)");
}

/// the constants of the fields.
inline Field_constants literal_constants(Field_constants constants, const Literal_rules& rules) {
  if(!rules.gradient_coefficient)
    return constants;
  const double factor =
      constants.gradient_coefficient / (rules.mean_edge_length * rules.mean_edge_length);
  constants.gradient_coefficient *= factor;
  constants.step = (std::min)(constants.step * factor, 1.); // the time step stays if it is stable
  return constants;
}

/// the time step: the given fraction of the largest one for which no neighbor's weight, nor that of
/// the value itself, becomes negative.
inline double time_step(const Field_constants& c) {
  return c.step / (0.5 * c.mobility * 4. * c.gradient_coefficient);
}

/// A number of steps in which a front that moves at all has passed many edges (its speed is that of
/// `Field_constants`); if it has not reached a vertex in so many, it is at rest.
inline std::size_t patience(const Field_constants& c) {
  const double speed = c.mobility * c.driving_force * std::sqrt(c.gradient_coefficient) /
                       (2. * std::sqrt(2. * c.penalty));
  return static_cast<std::size_t>(20. / (speed * time_step(c))) + 20;
}

/*!
The fields of the paper, section 3, as the rows of a sparse matrix Phi with a column for each
vertex. Row 0 is the base layer. The fields follow
\f[ \dot\varphi_i = -\sum_j \frac{\mu_{ij}}{n} \Bigl( \sum_k \bigl[ (w_{ik} - w_{jk}) \varphi_k +
    \tfrac{1}{2} (a_{ik}^2 - a_{jk}^2) \nabla^2 \varphi_k \bigr]
    - e_{ij} \sqrt{\varphi_i \varphi_j} \Bigr) \f]
where the sums are over the n layers that are present: those that are not zero at the vertex and all
of its neighbors. The mobility and the driving force are zero unless i or j is the base
layer; \f$ e_{ij} = -e_{ji} \f$, as the fields must go on to sum up to one.

Sources keep the value one.
*/
class Layered_field
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  using Vector_of_values = Eigen::VectorXd;

  Layered_field(const Flat_mesh& mesh,
                const Field_constants& constants,
                const Literal_rules& rules = Literal_rules())
      : constants_(constants)
      , time_step_(time_step(constants))
      , transposed_laplacian_(laplacian(mesh, rules).transpose())
      , phi_(1, transposed_laplacian_.cols())
      , is_source_(mesh.number_of_vertices(), 0) {
    for(Eigen::Index v = 0; v < phi_.cols(); ++v)
      phi_.insert(0, v) = 1.;
    phi_.makeCompressed();
  }

  const Matrix& phi() const { return phi_; }

  /// one minus the base layer.
  Vector_of_values covered() const {
    return Vector_of_values::Ones(phi_.cols()) - Vector_of_values(phi_.row(0).transpose());
  }

  /// From now on each seed and its neighbors have the value one in a layer of their own, from
  /// number 1 on.
  void start(const Flat_mesh& mesh, const std::vector<Index>& seeds) {
    std::map<Index, Index> layer_of_vertex;
    for(Index i = 0; i < seeds.size(); ++i) {
      layer_of_vertex[seeds[i]] = i + 1;
      for(Index u : mesh.ring(seeds[i]))
        layer_of_vertex[u] = i + 1;
    }
    for(const auto& [v, layer] : layer_of_vertex)
      is_source_[v] = 1;
    move_vertices(seeds.size() + 1, layer_of_vertex);
  }

  /// moves all that there is at some vertices to one row each.
  void move_vertices(std::size_t number_of_rows, const std::map<Index, Index>& row_of_vertex) {
    move_rows(number_of_rows, [&](Index row, Index v) {
      const auto it = row_of_vertex.find(v);
      return it == row_of_vertex.end() ? row : it->second;
    });
  }

  /// moves what row i has at vertex v to row `target(i, v)`, for all i and v, and adds up what
  /// comes together.
  template <typename Target> void move_rows(std::size_t number_of_rows, const Target& target) {
    std::vector<Eigen::Triplet<double>> entries;
    for(Eigen::Index i = 0; i < phi_.outerSize(); ++i)
      for(Matrix::InnerIterator it(phi_, i); it; ++it) {
        const Index row = target(static_cast<Index>(i), static_cast<Index>(it.col()));
        entries.emplace_back(static_cast<int>(row), static_cast<int>(it.col()), it.value());
      }
    phi_.resize(static_cast<Eigen::Index>(number_of_rows), phi_.cols());
    phi_.setFromTriplets(entries.begin(), entries.end());
  }

  /// makes one explicit Euler step; then columns are clipped to [0, 1] and divided by their sums.
  void step() {
    const Matrix product = phi_ * transposed_laplacian_;
    const Columns values(phi_), laplacians(product);
    Columns next(phi_.rows(), phi_.cols());
    next.reserve(product.nonZeros());
    for(Eigen::Index v = 0; v < phi_.cols(); ++v) {
      next.startVec(v);
      gather(values, laplacians, v);
      if(!is_source_[v])
        update_column();
      for(const Entry& entry : column_)
        if(entry.value > 0.)
          next.insertBack(entry.layer, v) = entry.value;
    }
    next.finalize();
    phi_ = next;
  }

private:
  using Columns = Eigen::SparseMatrix<double, Eigen::ColMajor>;

  // A layer that is present at a vertex.
  struct Entry
  {
    Eigen::Index layer;
    double value, laplacian, rate;
  };

  static bool is_base(Eigen::Index i) { return i == 0; }

  double w(Eigen::Index i, Eigen::Index j) const { return i == j ? 0. : constants_.penalty; }
  double a_squared(Eigen::Index i, Eigen::Index j) const {
    return i == j ? 0. : constants_.gradient_coefficient;
  }
  double mu(Eigen::Index i, Eigen::Index j) const {
    return is_base(i) != is_base(j) ? constants_.mobility : 0.;
  }
  double e(Eigen::Index i, Eigen::Index j) const {
    if(is_base(i) == is_base(j))
      return 0.;
    return is_base(j) ? constants_.driving_force : -constants_.driving_force;
  }

  // The product has an entry wherever the vertex or one of its neighbors has one.
  void gather(const Columns& values, const Columns& laplacians, Eigen::Index v) {
    column_.clear();
    Columns::InnerIterator value(values, v);
    for(Columns::InnerIterator it(laplacians, v); it; ++it) {
      const bool is_here = value && value.row() == it.row();
      column_.push_back({it.row(), is_here ? value.value() : 0., it.value(), 0.});
      if(is_here)
        ++value;
    }
  }

  void update_column() {
    const double n = static_cast<double>(column_.size());
    for(Entry& i : column_) {
      i.rate = 0.;
      for(const Entry& j : column_)
        if(mu(i.layer, j.layer) != 0.)
          i.rate -= mu(i.layer, j.layer) / n *
                    (interaction(i, j) - e(i.layer, j.layer) * std::sqrt(i.value * j.value));
    }
    double sum = 0.;
    for(Entry& i : column_) {
      i.value = (std::min)(1., (std::max)(0., i.value + time_step_ * i.rate));
      sum += i.value;
    }
    CGAL_assertion_msg(sum > 0., "some layer is present");
    for(Entry& i : column_)
      i.value /= sum;
  }

  double interaction(const Entry& i, const Entry& j) const {
    double sum = 0.;
    for(const Entry& k : column_)
      sum += (w(i.layer, k.layer) - w(j.layer, k.layer)) * k.value +
             0.5 * (a_squared(i.layer, k.layer) - a_squared(j.layer, k.layer)) * k.laplacian;
    return sum;
  }

  Field_constants constants_;
  double time_step_;
  Matrix transposed_laplacian_;
  Matrix phi_;
  std::vector<char> is_source_;
  std::vector<Entry> column_;
};

/*!
One field over the whole mesh, with walls (paper, section 5): the base layer is one minus its value,
and the equation of the layers becomes
\f[ \dot\varphi = \frac{\mu}{2} \left[ a^2 \nabla^2 \varphi + e \sqrt{\varphi (1 - \varphi)}
    - w (1 - 2 \varphi) \right]. \f]
Sources keep the value one.
*/
class Single_field
{
public:
  Single_field(const Flat_mesh& mesh,
               const Field_constants& constants,
               const Barred_edges& walls,
               const Literal_rules& rules = Literal_rules())
      : constants_(constants)
      , is_rest_failure_(rules.are_of_fields())
      , factor_(time_step(constants) * constants.mobility / 2.)
      , laplacian_(laplacian(mesh, rules, walls))
      , phi_(Eigen::ArrayXd::Zero(laplacian_.cols()))
      , arrivals_(mesh, walls) {}

  void add_source(Index v) {
    if(arrivals_.is_reached(v))
      return;
    sources_.push_back(v);
    phi_[v] = 1.;
    arrivals_.reach(v);
  }

  bool is_source(Index v) const { return arrivals_.rank(v) < sources_.size(); }

  const Arrivals& arrivals() const { return arrivals_; }

  /// makes steps until all of the targets are reached, but only a third more than until the first
  /// is; stops when all that can be reached from the sources is covered. Returns the targets
  /// reached, in their order.
  std::vector<Index> run_until(const std::vector<char>& is_target) {
    const auto number_of_targets =
        static_cast<std::size_t>(std::count(is_target.begin(), is_target.end(), 1));
    std::vector<Index> targets;
    std::size_t last_step = (std::numeric_limits<std::size_t>::max)();
    const auto reached = [&](Index v) {
      if(!is_target[v])
        return;
      if(targets.empty())
        last_step = arrivals_.number_of_steps() * 4 / 3;
      targets.push_back(v);
    };
    bool goes_on = true;
    while(goes_on && (targets.empty() || targets.size() < number_of_targets) &&
          arrivals_.number_of_steps() < last_step)
      goes_on = advance(reached);
    return targets;
  }

  /// makes steps until so many vertices are reached, or the field is at rest for good; calls
  /// `advanced()` after each.
  template <typename Advanced> void run(std::size_t number_of_vertices, const Advanced& advanced) {
    while(arrivals_.number_of_reached() < number_of_vertices && advance([](Index) {}))
      advanced();
  }

private:
  // Makes a step, and pushes on what has come to rest. Returns false if that is for good.
  template <typename Reached> bool advance(const Reached& reached) {
    const std::size_t reached_before = arrivals_.number_of_reached();
    step(reached);
    steps_at_rest_ = arrivals_.number_of_reached() == reached_before ? steps_at_rest_ + 1 : 0;
    if(steps_at_rest_ < patience(constants_))
      return true;
    steps_at_rest_ = 0;
    return !is_rest_failure_ && push_on(reached);
  }

  template <typename Reached> void step(const Reached& reached) {
    const Eigen::ArrayXd before = phi_;
    const Eigen::ArrayXd diffusion = (laplacian_ * phi_.matrix()).array();
    const Field_constants& c = constants_;
    phi_ += factor_ *
            (c.gradient_coefficient * diffusion +
             c.driving_force * (before * (1. - before)).sqrt() - c.penalty * (1. - 2. * before));
    phi_ = ((phi_.max)(0.).min)(1.);
    for(Index v : sources_)
      phi_[v] = 1.;
    arrivals_.advance(before, phi_, reached);
  }

  // What the field touches while it is at rest is declared covered. Returns whether there was any.
  template <typename Reached> bool push_on(const Reached& reached) {
    const std::size_t reached_before = arrivals_.number_of_reached();
    arrivals_.push_on(phi_, [&](Index v) {
      phi_[v] = 1.;
      reached(v);
    });
    return arrivals_.number_of_reached() != reached_before;
  }

  Field_constants constants_;
  bool is_rest_failure_;
  double factor_;
  Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian_;
  Eigen::ArrayXd phi_;
  Arrivals arrivals_;
  std::vector<Index> sources_;
  std::size_t steps_at_rest_ = 0;
};

/// a moment in steps, as `crossing_time()` gives those of the other solvers.
inline Time fixed_point_time(double moment) {
  const double step = std::ceil(moment);
  return static_cast<Time>(step) * ticks_per_step -
         static_cast<Time>((step - moment) * (ticks_per_step - 2));
}

/// The arrivals of a field from vertices and their neighbours in fixed point, `never` where it did
/// not come. Vertices that waited for a neighbour are later than it, so that the vertices from
/// which the field started remain the only minima.
inline std::vector<Time> fixed_point_times(const Flat_mesh& mesh,
                                           const Arrivals& arrivals,
                                           const std::vector<Index>& vertices) {
  std::vector<Index> order(arrivals.number_of_reached());
  for(Index v = 0; v < mesh.number_of_vertices(); ++v)
    if(arrivals.is_reached(v))
      order[arrivals.rank(v)] = v;
  std::vector<Time> times(mesh.number_of_vertices(), never);
  for(Index v : vertices)
    for(Index u : mesh.ring(v))
      times[u] = 1;
  for(Index v : vertices)
    times[v] = 0;
  for(Index v : order)
    if(times[v] == never) {
      Time earliest = never;
      for(Index u : mesh.ring(v))
        earliest = (std::min)(earliest, times[u]);
      times[v] = (std::max)(earliest + 1, fixed_point_time(arrivals.time(v)));
    }
  return times;
}

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_FIELDS_H
