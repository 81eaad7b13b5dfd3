// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_LAYERED_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_LAYERED_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/laplacian.h>

#include <CGAL/assertions.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {
namespace reference {

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

  /// `v` has the value one in its layer from now on.
  void add_source(Index v) { is_source_[v] = 1; }

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

} // namespace reference
} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_EIGEN3_ENABLED

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REFERENCE_LAYERED_FIELD_H
