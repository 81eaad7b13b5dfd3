// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh_builder.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Unit_box.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The boundary curves of a mesh: cycles of vertices, as caller's indices, in the order in which
/// halfedges without a face follow each other. So the surface is to the right of a curve. A vertex
/// may lie on one curve, and once.
class Boundary_curves
{
public:
  Boundary_curves() = default;

  explicit Boundary_curves(const Mesh_as_read& read) {
    std::vector<Index> next; // by caller's index, if there is any curve
    for_each_gap(read, [&](std::size_t i, Index after) {
      if(next.empty())
        next.assign(read.index_bound, no_index);
      next[read.index[i]] = after;
    });
    curve_at_.assign(next.size(), no_index);
    for_each_gap(read, [&](std::size_t i, Index) {
      if(curve_at_[read.index[i]] == no_index)
        add_curve(next, read.index[i]);
    });
  }

  std::size_t size() const { return begin_.size() - 1; }

  /// the vertices of a curve.
  Ring operator[](std::size_t i) const {
    return Ring(vertices_.data() + begin_[i], begin_[i + 1] - begin_[i]);
  }

  /// the number of the curve on which a vertex lies.
  Index curve_at(Index v) const {
    CGAL_precondition_msg(v < curve_at_.size() && curve_at_[v] < size(), "on the boundary");
    return curve_at_[v];
  }

private:
  // Calls `f(i, v)` where the boundary leaves the i-th vertex, to vertex v.
  template <typename Function>
  static void for_each_gap(const Mesh_as_read& read, const Function& f) {
    for(std::size_t r = 0; r < read.ranges.size(); ++r) {
      if(read.ranges[r].number_of_borders == 0)
        continue;
      const std::size_t begin = r * Mesh_as_read::grain;
      for(std::size_t i = begin; i < begin + read.ranges[r].row_end.size(); ++i) {
        const Ring ring = read.ring(i);
        for(Index p = 0; p < ring.size(); ++p)
          if(ring[p] == no_index)
            f(i, ring[ring.previous(p)]);
      }
    }
  }

  // What is not a curve, as at a vertex with several fans, is refused later.
  void add_curve(const std::vector<Index>& next, Index first) {
    const Index curve = static_cast<Index>(size());
    for(Index v = first; v != no_index && curve_at_[v] == no_index; v = next[v]) {
      curve_at_[v] = curve;
      vertices_.push_back(v);
    }
    begin_.push_back(static_cast<Index>(vertices_.size()));
  }

  std::vector<Index> vertices_, begin_ = {0};
  std::vector<Index> curve_at_; // by caller's index, if there is any curve
};

/// See `build_flat_mesh()`.
class Builder_of_flat_mesh
{
public:
  Builder_of_flat_mesh(Execution execution, Mesh_as_read&& read)
      : execution_(execution)
      , read_(std::move(read)) {}

  Flat_mesh build(const std::vector<Suspect_halfedge>& halfedges,
                  Uninitialized_vector<Index>& order) {
    check_halfedges(halfedges);
    curves_ = Boundary_curves(read_);
    check_points();
    number_vertices();
    fill_rings();
    order = std::move(order_);
    add_caps();
    find_components();
    return std::move(mesh_);
  }

private:
  // Names the first halfedge that is wrong. If there is none, the rings may still have missed some,
  // at a vertex with several fans.
  void check_halfedges(const std::vector<Suspect_halfedge>& halfedges) {
    std::vector<Index> valence; // by caller's index
    for(const Suspect_halfedge& h : halfedges) {
      if(!h.is_triangle)
        throw_edge_defect(Mesh_defect::NOT_TRIANGULATED, h.source, h.target,
                          "a face at an edge is not a triangle");
      valence.resize((std::max)(valence.size(), h.target + 1), 0);
      ++valence[h.target];
    }
    for(std::size_t i = 0; !halfedges.empty() && i < read_.index.size(); ++i)
      valence_.push_back(read_.index[i] < valence.size() ? valence[read_.index[i]] : 0);
    std::size_t number_of_halfedges = 0, number_of_borders = 0;
    for(const Mesh_as_read::Range& range : read_.ranges) {
      number_of_halfedges += range.neighbor.size() - range.number_of_borders;
      number_of_borders += range.number_of_borders;
    }
    if(number_of_halfedges == 0)
      throw Invalid_mesh_exception(Mesh_defect::EMPTY, {}, "the mesh has no faces");
    check_number_of_halfedges(number_of_halfedges + 2 * number_of_borders);
  }

  void check_points() const {
    First_index not_finite;
    for_each_index(execution_, read_.points.size(), [&](std::size_t i) {
      const Vector& x = read_.points[i];
      if(!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        not_finite.see(i);
    });
    if(not_finite.found())
      throw_vertex_defect(Mesh_defect::NON_FINITE_COORDINATE, read_.index[not_finite.get()],
                          "a coordinate is not finite");
  }

  // Whether the faces around a vertex are not one fan: its ring has the boundary twice, or more
  // halfedges lead to it than those of its ring.
  bool has_several_fans(std::size_t i) const {
    const Ring ring = read_.ring(i);
    const auto gaps = std::count(ring.begin(), ring.end(), no_index);
    return gaps > 1 || (!valence_.empty() && valence_[i] != ring.size() - gaps);
  }

  void number_vertices() {
    const Unit_box box(execution_, read_.points);
    const std::size_t n = read_.points.size();
    order_ =
        space_filling_order(execution_, n, [&](std::size_t i) { return box(read_.points[i]); });
    const std::size_t n_with_hubs = n + curves_.size();
    mesh_.half_scale = box.half_scale();
    mesh_.first_hub = static_cast<Index>(n);
    mesh_.number_of_hubs = static_cast<Index>(curves_.size());
    mesh_.points.resize(n_with_hubs);
    mesh_.original.resize(n_with_hubs);
    mesh_.row_begin.resize(n_with_hubs + 1);
    flat_index_.resize(read_.index_bound);
    for_each_index(execution_, read_.index_bound,
                   [this](std::size_t c) { flat_index_[c] = no_index; });
    for_each_index(execution_, n, [&](std::size_t i) {
      const Index c = read_.index[order_[i]];
      CGAL_precondition_msg(flat_index_[c] == no_index, "the indices of vertices are unique");
      mesh_.points[i] = box(read_.points[order_[i]]);
      mesh_.original[i] = c;
      mesh_.row_begin[i] = read_.ring(order_[i]).size();
      flat_index_[c] = static_cast<Index>(i);
    });
    Uninitialized_vector<Vector>().swap(read_.points);
    for(std::size_t i = 0; i < curves_.size(); ++i)
      mesh_.row_begin[n + i] = static_cast<Index>(curves_[i].size());
    mesh_.row_begin[n_with_hubs] = 0;
    mesh_.neighbor.resize(sum_before_each(execution_, mesh_.row_begin));
  }

  void fill_rings() {
    First_index several_fans, parallel_edges;
    CGAL_expensive_assertion(is_permutation(order_));
    for_each_index(execution_, order_.size(), [&](std::size_t i) {
      Index position = mesh_.row_begin[i];
      for(Index u : read_.ring(order_[i]))
        mesh_.neighbor[position++] = u == no_index ? hub_at(i) : flat_index_[u];
      CGAL_assertion(position == mesh_.row_begin[i + 1]);
      const Ring ring = mesh_.ring(static_cast<Index>(i));
      if(has_several_fans(order_[i]))
        several_fans.see(i);
      else if(has_repetition(ring))
        parallel_edges.see(i);
    });
    read_.ranges = {};
    if(several_fans.found())
      throw_vertex_defect(Mesh_defect::NON_MANIFOLD_VERTEX, mesh_.original[several_fans.get()],
                          "the faces around a vertex form more than one fan");
    if(parallel_edges.found())
      throw_vertex_defect(Mesh_defect::PARALLEL_EDGES, mesh_.original[parallel_edges.get()],
                          "two edges join a vertex to the same neighbor");
  }

  Index hub_at(std::size_t i) const {
    return mesh_.first_hub + curves_.curve_at(mesh_.original[i]);
  }

  // A hub lies in the middle of the vertices of its curve.
  void add_caps() {
    for_each_index(
        execution_, curves_.size(),
        [this](std::size_t i) {
          const Index hub = mesh_.first_hub + static_cast<Index>(i);
          Vector sum = {0., 0., 0.};
          Index position = mesh_.row_begin[hub];
          for(Index u : curves_[i]) {
            sum = sum + mesh_.points[flat_index_[u]];
            mesh_.neighbor[position++] = flat_index_[u];
          }
          mesh_.points[hub] = (1. / double(curves_[i].size())) * sum;
          mesh_.original[hub] = static_cast<Index>(read_.index_bound + i);
        },
        1);
    mesh_.find_places_in_long_rings();
  }

  static bool is_permutation(Uninitialized_vector<Index> numbers) {
    std::sort(numbers.begin(), numbers.end());
    for(std::size_t i = 0; i < numbers.size(); ++i)
      if(numbers[i] != i)
        return false;
    return true;
  }

  static bool has_repetition(Ring ring) {
    if(ring.size() <= 16) {
      for(Index i = 1; i < ring.size(); ++i)
        for(Index j = 0; j < i; ++j)
          if(ring[i] == ring[j])
            return true;
      return false;
    }
    std::vector<Index> sorted(ring.begin(), ring.end());
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }

  // The seed of a component is its vertex of smallest caller's index, and it comes in their order.
  void find_components() {
    const std::size_t n = mesh_.number_of_vertices();
    mesh_.component = smallest_in_component(execution_, mesh_);
    const std::vector<Index> smallest =
        collect<Index>(execution_, n, [&](std::size_t begin, std::size_t end) {
          std::vector<Index> own;
          for(Index v = static_cast<Index>(begin); v < end; ++v)
            if(mesh_.component[v] == v)
              own.push_back(v);
          return own;
        });
    const auto rank = [&](Index v) {
      return std::lower_bound(smallest.begin(), smallest.end(), mesh_.component[v]) -
             smallest.begin();
    };
    std::vector<Index> number(smallest.size(), no_index);
    for(auto it = flat_index_.begin(); mesh_.seeds.size() < smallest.size(); ++it)
      if(*it != no_index && number[rank(*it)] == no_index) {
        number[rank(*it)] = static_cast<Index>(mesh_.seeds.size());
        mesh_.seeds.push_back(*it);
      }
    for_each_index(execution_, n, [&](std::size_t v) {
      mesh_.component[v] = number[rank(static_cast<Index>(v))];
    });
    mesh_.count_handles();
    CGAL_assertion_msg(mesh_.genus <= mesh_.number_of_faces(), "a surface has a genus");
  }

  Execution execution_;
  Mesh_as_read read_;
  Flat_mesh mesh_;
  std::vector<Index> valence_; // by place in what was read, if in doubt
  Boundary_curves curves_;
  Uninitialized_vector<Index> order_;      // by flat index, the place in what was read
  Uninitialized_vector<Index> flat_index_; // by caller's index
};

void check_index_bound(std::size_t bound) {
  if(bound >= no_index / 2)
    throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many vertices");
}

bool is_suspect(const Mesh_as_read& read) {
  std::size_t number_of_halfedges = 0;
  bool are_triangles = true;
  for(const Mesh_as_read::Range& range : read.ranges) {
    number_of_halfedges += range.neighbor.size() - range.number_of_borders;
    are_triangles = are_triangles && range.are_triangles;
  }
  return !are_triangles || number_of_halfedges != read.number_of_halfedges;
}

Flat_mesh build_flat_mesh(Execution execution,
                          Mesh_as_read&& read,
                          const std::vector<Suspect_halfedge>& halfedges,
                          Uninitialized_vector<Index>& order) {
  return Builder_of_flat_mesh(execution, std::move(read)).build(halfedges, order);
}

} // namespace CGAL::Handle_tunnel_loops::internal
