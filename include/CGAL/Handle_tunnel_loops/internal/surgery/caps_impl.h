// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>

#include <CGAL/Polygon_mesh_processing/refine.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/iterator.h>
#include <CGAL/version.h>

#include <boost/property_map/property_map.hpp>

#ifdef CGAL_EIGEN3_ENABLED
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The points of a mesh, with predicates that are not exact: enough where any answer is a right
/// one.
template <typename SurfaceMesh> class Approximate_points
{
  using Original = typename SurfaceMesh::Point;

public:
  using key_type = typename SurfaceMesh::Vertex_index;
  using value_type = Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;

  explicit Approximate_points(SurfaceMesh& mesh)
      : points_(mesh.points()) {}

  friend value_type get(const Approximate_points& map, key_type v) {
    const Original& p = map.points_[v];
    return {p.x(), p.y(), p.z()};
  }
  friend void put(const Approximate_points& map, key_type v, const value_type& p) {
    put(map.points_, v, Original(p.x(), p.y(), p.z()));
  }

private:
  typename SurfaceMesh::template Property_map<key_type, Original> points_;
};

/*!
Moves some vertices of a `Surface_mesh` so that the surface there is as little curved as it can be
between the others: the sum of the squared Laplacians is least. Those of the others count, so that
the surface continues their directions, but not where it has a crease, at `is_crease(vertex)`, and
so none that could be continued. Edges have equal weights, which suit an even density.

\returns whether that was done: there is a solution, and Eigen to find it
*/
template <typename SurfaceMesh, typename IsCrease>
bool make_smooth(SurfaceMesh& mesh,
                 const std::vector<typename SurfaceMesh::Vertex_index>& free,
                 const IsCrease& is_crease) {
#ifdef CGAL_EIGEN3_ENABLED
  using Vertex = typename SurfaceMesh::Vertex_index;
  std::vector<int> row(mesh.number_of_vertices(), -1);
  for(std::size_t i = 0; i < free.size(); ++i)
    row[free[i]] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(60 * free.size());
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(free.size(), 3);
  const auto add = [&](int i, Vertex v, double weight) {
    if(row[v] >= 0)
      entries.emplace_back(i, row[v], weight);
    else
      right.row(i) -=
          weight * Eigen::RowVector3d(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  };
  const auto add_laplacian = [&](int i, Vertex v, double weight) {
    for(Vertex w : vertices_around_target(mesh.halfedge(v), mesh))
      add(i, w, weight);
    add(i, v, -weight * mesh.degree(v));
  };
  std::vector<signed char> crease(mesh.number_of_vertices(), -1); // -1: not asked yet
  const auto counts = [&](Vertex v) {
    if(row[v] < 0 && crease[v] < 0)
      crease[v] = is_crease(v) ? 1 : 0;
    return row[v] >= 0 || crease[v] == 0;
  };
  for(Vertex v : free) {
    for(Vertex w : vertices_around_target(mesh.halfedge(v), mesh))
      if(counts(w))
        add_laplacian(row[v], w, 1.);
    add_laplacian(row[v], v, -1. * mesh.degree(v));
  }
  Eigen::SparseMatrix<double> matrix(free.size(), free.size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  if(solver.info() != Eigen::Success)
    return false;
  const Eigen::MatrixX3d places = solver.solve(right);
  for(Vertex v : free)
    mesh.point(v) = {places(row[v], 0), places(row[v], 1), places(row[v], 2)};
  return true;
#else
  (void)mesh;
  (void)free;
  (void)is_crease;
  return false;
#endif
}

/// A copy of what is around a region, in which its holes are filled.
class Holes_of_region
{
  using Mesh = Surface_mesh<Surgery_mesh::Point>;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;

public:
  Holes_of_region(const Surgery_mesh& mesh, const Cut_region& region, Cap_search search)
      : mesh_(mesh)
      , search_(search) {
    is_good_ = copy_surroundings(region);
    number_around_ = static_cast<Index>(copy_.number_of_vertices());
    first_cap_face_ = static_cast<Index>(copy_.number_of_faces());
    for(std::size_t i = 0; i < region.number_of_borders(); ++i)
      is_good_ = is_good_ && triangulate(region.border(i));
  }

  bool are_triangulated() const { return is_good_; }

  /// inserts vertices, as dense as those around. The edges that it flips for that have points on a
  /// plane and a circle as a rule, for which exact predicates would take a third of its time.
  void refine() {
    std::vector<Mesh::Face_index> caps;
    for(Index f = first_cap_face_; f < copy_.number_of_faces(); ++f)
      caps.push_back(Mesh::Face_index(f));
    std::vector<Mesh::Face_index> new_faces;
    Polygon_mesh_processing::refine(copy_, caps, std::back_inserter(new_faces),
                                    std::back_inserter(own_),
                                    parameters::vertex_point_map(Approximate_points<Mesh>(copy_)));
  }

  /// makes them smooth, if there are any.
  bool fair() {
    return !own_.empty() && make_smooth(copy_, own_, [this](Vertex v) { return is_crease(v); });
  }

  Patch caps() const {
    Patch patch;
    for(Index v = number_around_; v < copy_.number_of_vertices(); ++v)
      patch.points.push_back(copy_.point(Vertex(v)));
    for(Index f = first_cap_face_; f < copy_.number_of_faces(); ++f) {
      Surgery_mesh::Face face;
      std::size_t i = 0;
      for(Vertex v : vertices_around_face(copy_.halfedge(Mesh::Face_index(f)), copy_))
        face[i++] =
            v < Vertex(number_around_) ? originals_[v] : Patch::first_own + v - number_around_;
      patch.faces.push_back(face);
    }
    return patch;
  }

private:
  using Normal = Simple_cartesian<double>::Vector_3;

  /// whether a cap has no direction to continue at a vertex of its border: what is kept there bends
  /// by more than half a right angle; or it does so together with what was taken away, and the cap,
  /// as it is now, goes on like that and not like what is kept.
  bool is_crease(Vertex v) const {
    std::vector<Normal> kept, caps, all;
    for(Halfedge h : halfedges_around_target(copy_.halfedge(v), copy_))
      if(!copy_.is_border(h))
        (copy_.face(h) < Mesh::Face_index(first_cap_face_) ? kept : caps)
            .push_back(normal(vertices_around_face(h, copy_), copy_));
    mesh_.for_each_outgoing(originals_[v], [&](Index h) {
      all.push_back(normal(mesh_.corners(mesh_.face(h)), mesh_));
    });
    return !kept.empty() && (bends(kept, kept) || (bends(kept, all) && bends(kept, caps)));
  }

  template <typename Vertices, typename SomeMesh>
  static Normal normal(const Vertices& vertices, const SomeMesh& mesh) {
    std::array<Simple_cartesian<double>::Point_3, 3> p;
    auto next = p.begin();
    for(const auto v : vertices) {
      const auto& q = mesh.point(v);
      *next++ = {q.x(), q.y(), q.z()};
    }
    return cross_product(p[1] - p[0], p[2] - p[0]);
  }

  /// whether some of the others is at more than half a right angle to the first.
  static bool bends(const std::vector<Normal>& first, const std::vector<Normal>& others) {
    const Normal& n = first.front();
    return std::any_of(others.begin(), others.end(), [&](const Normal& m) {
      const double product = n * m, lengths = n.squared_length() * m.squared_length();
      return lengths > 0. && (product < 0. || 2. * product * product < lengths);
    });
  }

  Vertex copied(Index v) {
    const auto [it, is_new] = copies_.insert({v, Vertex()});
    if(is_new) {
      it->second = copy_.add_vertex(mesh_.point(v));
      originals_.push_back(v);
    }
    return it->second;
  }

  // All faces at the holes, so that each edge there is known, and those around them where they fit.
  bool copy_surroundings(const Cut_region& region) {
    const Index_range_set out(region.faces());
    bool is_complete = true;
    for(std::size_t i = 0; i < region.number_of_borders(); ++i)
      for(Index v : region.vertices_of(mesh_, i))
        is_complete = copy_faces_at(v, out) && is_complete;
    const std::size_t number_of_vertices = originals_.size();
    for(std::size_t i = 0; i < number_of_vertices; ++i)
      copy_faces_at(originals_[i], out);
    return is_complete;
  }

  bool copy_faces_at(Index v, const Index_range_set& out) {
    bool is_complete = true;
    mesh_.for_each_outgoing(v, [&](Index h) {
      const Index f = mesh_.face(h);
      if(out.contains(f) || !copied_faces_.insert(f).second)
        return;
      const Surgery_mesh::Face& c = mesh_.corners(f);
      is_complete = copy_.add_face(copied(c[0]), copied(c[1]), copied(c[2])) != Mesh::null_face() &&
                    is_complete;
    });
    return is_complete;
  }

  bool triangulate(const std::vector<Index>& border) {
    const Index h = border.front();
    const Halfedge side = copy_.halfedge(copies_.at(mesh_.source(h)), copies_.at(mesh_.target(h)));
    const std::size_t before = copy_.number_of_faces();
    if(side == Mesh::null_halfedge() || !copy_.is_border(side))
      return false;
    constexpr std::size_t cubic_is_too_slow = 200;
    if(search_ == Cap_search::ALL && border.size() > cubic_is_too_slow)
      return false;
    const auto how = parameters::use_delaunay_triangulation(search_ == Cap_search::DELAUNAY)
                         .do_not_use_cubic_algorithm(search_ == Cap_search::DELAUNAY);
#if CGAL_VERSION_NR < 1050600000
    Polygon_mesh_processing::triangulate_hole(copy_, side, Emptyset_iterator(), how);
#else
    Polygon_mesh_processing::triangulate_hole(copy_, side, how);
#endif
    return copy_.number_of_faces() == before + border.size() - 2;
  }

  const Surgery_mesh& mesh_;
  const Cap_search search_;
  Mesh copy_;
  std::unordered_map<Index, Vertex> copies_;
  std::unordered_set<Index> copied_faces_;
  std::vector<Index> originals_; // by vertex of the copy
  std::vector<Vertex> own_;      // put in by `refine()`
  Index number_around_ = 0, first_cap_face_ = 0;
  bool is_good_ = false;
};

CGAL_HTL_CORE std::vector<Patch>
caps_of(const Surgery_mesh& mesh, const Cut_region& region, Cap_search search) {
  std::vector<Patch> ways;
  Holes_of_region holes(mesh, region, search);
  if(!holes.are_triangulated())
    return ways;
  ways.push_back(holes.caps());
  holes.refine();
  ways.push_back(holes.caps());
  if(holes.fair())
    ways.push_back(holes.caps());
  std::reverse(ways.begin(), ways.end());
  return ways;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_CAPS_IMPL_H
