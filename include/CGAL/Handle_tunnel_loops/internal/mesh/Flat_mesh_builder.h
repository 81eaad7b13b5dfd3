// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/support/sort.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The boundary curves of a mesh: cycles of vertices, as caller's indices, in the order in which
/// halfedges without a face follow each other. So the surface is to the right of a curve.
class Boundary_curves
{
public:
  Boundary_curves() = default;

  /// \p borders are all halfedges without a face; the curves come in their order. \p bound is
  /// above all indices. A vertex may lie on one curve, and once: the last one counts.
  template <typename TriangleMesh, typename VertexIndexMap, typename Halfedge>
  Boundary_curves(const TriangleMesh& tm,
                  VertexIndexMap index,
                  const std::vector<Halfedge>& borders,
                  std::size_t bound) {
    if(borders.empty())
      return;
    curve_at_.assign(bound, no_index);
    for(const Halfedge first : borders) {
      if(curve_at_[get(index, target(first, tm))] != no_index)
        continue;
      const Index curve = static_cast<Index>(size());
      Halfedge h = first;
      do {
        const Index v = static_cast<Index>(get(index, target(h, tm)));
        curve_at_[v] = curve;
        vertices_.push_back(v);
        h = next(h, tm);
      } while(h != first);
      begin_.push_back(static_cast<Index>(vertices_.size()));
    }
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
  std::vector<Index> vertices_, begin_ = {0};
  std::vector<Index> curve_at_; // by vertex, if there is any curve
};

/// The rings of the vertices of a mesh, as caller's indices, each read once; `no_index` is where
/// the boundary is. That they are all the halfedges is known from their number; only if it is not,
/// the halfedges are looked at one by one.
template <typename TriangleMesh, typename VertexIndexMap> class Rings_of_mesh
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

public:
  Rings_of_mesh(const TriangleMesh& tm, VertexIndexMap index)
      : tm_(tm)
      , index_(index) {}

  /// reads the rings of these vertices. Throws if there is no triangle, or something else.
  void read(Execution execution, const std::vector<vertex_descriptor>& vertices) {
    ranges_.resize((vertices.size() + grain - 1) / grain);
    execution.for_ranges(vertices.size(), grain, [&](std::size_t begin, std::size_t end) {
      read_range(vertices.data() + begin, end - begin, ranges_[begin / grain]);
    });
    std::size_t number_of_halfedges = 0, number_of_borders = 0;
    bool are_triangles = true;
    for(const Range& range : ranges_) {
      number_of_halfedges += range.neighbor.size() - range.borders.size();
      number_of_borders += range.borders.size();
      are_triangles = are_triangles && range.are_triangles;
    }
    if(!are_triangles || number_of_halfedges != num_halfedges(tm_))
      check_halfedges(vertices);
    if(number_of_halfedges == 0)
      throw Invalid_mesh_exception(Mesh_defect::EMPTY, {}, "the mesh has no faces");
    check_number_of_halfedges(number_of_halfedges + 2 * number_of_borders);
  }

  /// the ring of the i-th of these vertices, counterclockwise.
  Ring operator[](std::size_t i) const {
    const Range& range = ranges_[i / grain];
    const Index begin = i % grain == 0 ? 0 : range.row_end[i % grain - 1];
    return Ring(range.neighbor.data() + begin, range.row_end[i % grain] - begin);
  }

  /// whether the faces around the i-th vertex are not one fan: its ring has the boundary twice, or
  /// more halfedges lead to it than those of its ring.
  bool has_several_fans(std::size_t i) const {
    const Ring ring = (*this)[i];
    const auto gaps = std::count(ring.begin(), ring.end(), no_index);
    return gaps > 1 || (!valence_.empty() && valence_[i] != ring.size() - gaps);
  }

  /// the halfedges without a face, in the order of the vertices to which they lead.
  std::vector<halfedge_descriptor> take_borders() {
    std::vector<halfedge_descriptor> borders;
    for(Range& range : ranges_) {
      borders.insert(borders.end(), range.borders.begin(), range.borders.end());
      range.borders.clear();
    }
    return borders;
  }

  void clear() { ranges_ = {}; }

private:
  struct Range
  {
    std::vector<Index> neighbor;
    std::vector<Index> row_end;
    std::vector<halfedge_descriptor> borders;
    bool are_triangles = true;
  };

  std::size_t caller_index(vertex_descriptor v) const {
    return static_cast<std::size_t>(get(index_, v));
  }

  void read_range(const vertex_descriptor* vertices, std::size_t n, Range& range) const {
    constexpr std::size_t likely_valence = 7;
    range.neighbor.reserve(likely_valence * n);
    range.row_end.reserve(n);
    for(std::size_t i = 0; i < n; ++i) {
      const halfedge_descriptor first = halfedge(vertices[i], tm_);
      halfedge_descriptor h = first;
      do {
        range.neighbor.push_back(static_cast<Index>(caller_index(source(h, tm_))));
        range.are_triangles = range.are_triangles && is_in_triangle(h);
        const halfedge_descriptor out = opposite(h, tm_);
        h = prev(out, tm_);
        if(is_border(out, tm_)) {
          range.neighbor.push_back(no_index);
          range.borders.push_back(h);
        }
      } while(h != first);
      range.row_end.push_back(static_cast<Index>(range.neighbor.size()));
    }
  }

  bool is_in_triangle(halfedge_descriptor h) const {
    return is_border(h, tm_) || next(next(h, tm_), tm_) == prev(h, tm_);
  }

  // Names the first halfedge that is wrong. If there is none, the rings may still have missed some,
  // at a vertex with several fans.
  void check_halfedges(const std::vector<vertex_descriptor>& vertices) {
    std::vector<Index> valence; // by caller's index
    for(halfedge_descriptor h : halfedges(tm_)) {
      const std::size_t from = caller_index(source(h, tm_)), to = caller_index(target(h, tm_));
      if(!is_in_triangle(h))
        throw_edge_defect(Mesh_defect::NOT_TRIANGULATED, from, to,
                          "a face at an edge is not a triangle");
      valence.resize((std::max)(valence.size(), to + 1), 0);
      ++valence[to];
    }
    for(vertex_descriptor v : vertices)
      valence_.push_back(caller_index(v) < valence.size() ? valence[caller_index(v)] : 0);
  }

  static constexpr std::size_t grain = 16384;

  const TriangleMesh& tm_;
  VertexIndexMap index_;
  std::vector<Range> ranges_;
  std::vector<Index> valence_; // of these vertices, if in doubt
};

/// Moves and scales points into the unit box, by the same factor along all axes.
class Unit_box
{
public:
  Unit_box(Execution execution, const Uninitialized_vector<Vector>& points) {
    constexpr std::size_t grain = 65536;
    std::vector<Bounds> parts((points.size() + grain - 1) / grain);
    execution.for_ranges(points.size(), grain, [&](std::size_t begin, std::size_t end) {
      Bounds bounds;
      for(std::size_t i = begin; i < end; ++i)
        bounds.extend(points[i], points[i]);
      parts[begin / grain] = bounds;
    });
    Bounds all;
    for(const Bounds& part : parts)
      all.extend(part.low, part.high);
    low_ = all.low;
    for(int d = 0; d < 3; ++d)
      half_ = (std::max)(half_, half_difference(all.high[d], all.low[d]));
    if(half_ == 0.)
      half_ = 0.5;
  }

  /// half of the caller's unit of length / that of the box: the whole may be beyond all doubles.
  double half_scale() const { return half_; }

  Vector operator()(const Vector& p) const {
    Vector q;
    for(int d = 0; d < 3; ++d)
      q[d] = half_difference(p[d], low_[d]) / half_;
    return q;
  }

private:
  struct Bounds
  {
    static constexpr double most = (std::numeric_limits<double>::max)();
    Vector low = {most, most, most}, high = {-most, -most, -most};

    void extend(const Vector& l, const Vector& h) {
      for(int d = 0; d < 3; ++d) {
        low[d] = (std::min)(low[d], l[d]);
        high[d] = (std::max)(high[d], h[d]);
      }
    }
  };

  Vector low_;
  double half_ = 0.;
};

/// Turns any `FaceListGraph` into a `Flat_mesh`, and refuses, naming the element, whatever is not
/// an oriented 2-manifold triangle mesh. Linear in the size of the mesh. Isolated vertices are left
/// out. The mesh is walked once and in its own order, which its halfedges are likely to follow.
template <typename TriangleMesh, typename VertexIndexMap, typename VertexPointMap>
class Flat_mesh_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  using Coordinate = std::decay_t<decltype(std::declval<const Point&>().x())>;

public:
  Flat_mesh_builder(Execution execution,
                    const TriangleMesh& tm,
                    VertexIndexMap index,
                    VertexPointMap point)
      : execution_(execution)
      , tm_(tm)
      , index_(index)
      , point_(point)
      , rings_(tm, index) {}

  Flat_mesh build() {
    collect_vertices();
    rings_.read(execution_, vertices_);
    curves_ = Boundary_curves(tm_, index_, rings_.take_borders(), index_bound_);
    read_points();
    number_vertices();
    fill_rings();
    add_caps();
    find_components();
    return std::move(mesh_);
  }

  /// the vertex of each index of the flat mesh but for the hubs, which come last; to be called
  /// after `build()`.
  std::vector<vertex_descriptor> take_vertices() { return std::move(vertices_); }

private:
  std::size_t caller_index(vertex_descriptor v) const {
    return static_cast<std::size_t>(get(index_, v));
  }

  // Caller's indices may leave gaps.
  void collect_vertices() {
    vertices_.reserve(num_vertices(tm_));
    for(vertex_descriptor v : vertices(tm_)) {
      index_bound_ = (std::max)(index_bound_, caller_index(v) + 1);
      if(halfedge(v, tm_) != Graph_traits::null_halfedge())
        vertices_.push_back(v);
    }
    if(index_bound_ >= no_index / 2)
      throw Invalid_mesh_exception(Mesh_defect::TOO_LARGE, {}, "the mesh has too many vertices");
  }

  void read_points() {
    points_.resize(vertices_.size());
    First_index not_finite;
    // Exact numbers may share what they are computed from, and know nothing of threads.
    const Execution execution =
        std::is_floating_point<Coordinate>::value ? execution_ : Execution();
    for_each_index(execution, vertices_.size(), [&](std::size_t i) {
      const auto& p = get(point_, vertices_[i]);
      const Vector x = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
      if(!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
        not_finite.see(i);
      points_[i] = x;
    });
    if(not_finite.found())
      throw_vertex_defect(Mesh_defect::NON_FINITE_COORDINATE,
                          caller_index(vertices_[not_finite.get()]), "a coordinate is not finite");
  }

  void number_vertices() {
    const Unit_box box(execution_, points_);
    const std::size_t n = points_.size();
    order_ = space_filling_order(execution_, n, [&](std::size_t i) { return box(points_[i]); });
    const std::size_t n_with_hubs = n + curves_.size();
    mesh_.half_scale = box.half_scale();
    mesh_.first_hub = static_cast<Index>(n);
    mesh_.number_of_hubs = static_cast<Index>(curves_.size());
    mesh_.points.resize(n_with_hubs);
    mesh_.original.resize(n_with_hubs);
    mesh_.row_begin.resize(n_with_hubs + 1);
    flat_index_.resize(index_bound_);
    for_each_index(execution_, index_bound_, [this](std::size_t c) { flat_index_[c] = no_index; });
    std::vector<vertex_descriptor> sorted(n);
    for_each_index(execution_, n, [&](std::size_t i) {
      const vertex_descriptor v = vertices_[order_[i]];
      const std::size_t c = caller_index(v);
      CGAL_precondition_msg(flat_index_[c] == no_index, "the indices of vertices are unique");
      sorted[i] = v;
      mesh_.points[i] = box(points_[order_[i]]);
      mesh_.original[i] = static_cast<Index>(c);
      mesh_.row_begin[i] = rings_[order_[i]].size();
      flat_index_[c] = static_cast<Index>(i);
    });
    Uninitialized_vector<Vector>().swap(points_);
    vertices_ = std::move(sorted);
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
      for(Index u : rings_[order_[i]])
        mesh_.neighbor[position++] = u == no_index ? hub_at(i) : flat_index_[u];
      CGAL_assertion(position == mesh_.row_begin[i + 1]);
      const Ring ring = mesh_.ring(static_cast<Index>(i));
      if(rings_.has_several_fans(order_[i]))
        several_fans.see(i);
      else if(has_repetition(ring))
        parallel_edges.see(i);
    });
    Uninitialized_vector<Index>().swap(order_);
    rings_.clear();
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
          mesh_.original[hub] = static_cast<Index>(index_bound_ + i);
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
  const TriangleMesh& tm_;
  VertexIndexMap index_;
  VertexPointMap point_;
  Flat_mesh mesh_;
  std::size_t index_bound_ = 0;                       // above the caller's indices
  std::vector<vertex_descriptor> vertices_;           // in the order of the mesh, then sorted
  Rings_of_mesh<TriangleMesh, VertexIndexMap> rings_; // in the order of the mesh
  Boundary_curves curves_;
  Uninitialized_vector<Vector> points_;    // in the order of the mesh
  Uninitialized_vector<Index> order_;      // by flat index, the place in the order of the mesh
  Uninitialized_vector<Index> flat_index_; // by caller's index
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_MESH_FLAT_MESH_BUILDER_H
