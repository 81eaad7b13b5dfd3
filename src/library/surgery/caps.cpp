// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/surgery/caps.h>

#include <CGAL/Handle_tunnel_loops/internal/support/sets.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Rim.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Triangulated_polygon.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/insert_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/make_smooth.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A hole of a region, and the triangles that fill it.
struct Filled_rim
{
  explicit Filled_rim(Polygon_in_space polygon)
      : rim(std::move(polygon))
      , filling(rim)
      , is_flush(internal::is_flush(rim)) {}
  Filled_rim(const Filled_rim&) = delete;
  Filled_rim& operator=(const Filled_rim&) = delete;

  Polygon_in_space rim;
  Triangulated_polygon filling;
  bool is_flush;
};

/// the triangles that fill the holes of a region, without vertices of their own.
static Patch
plain_caps(const Surgery_mesh& mesh, const Cut_region& region, const std::deque<Filled_rim>& rims) {
  Patch patch;
  for(std::size_t i = 0; i < rims.size(); ++i) {
    patch.caps.push_back(patch.faces.size());
    const Closed_walk rim = region.vertices_of(mesh, i);
    for(const Triangulated_polygon::Triangle& t : rims[i].filling.triangles())
      patch.faces.push_back({rim[t[0]], rim[t[1]], rim[t[2]]});
  }
  return patch;
}

/// A copy of what is around a region, in which its holes are filled.
class Holes_of_region
{
  using Mesh = Surface_mesh<Surgery_mesh::Point>;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;

public:
  /// with vertices in the caps, as dense as those around; not in those that are flush.
  Holes_of_region(const Surgery_mesh& mesh,
                  const Cut_region& region,
                  const std::deque<Filled_rim>& rims)
      : mesh_(mesh) {
    is_good_ = copy_surroundings(region);
    number_around_ = static_cast<Index>(copy_.number_of_vertices());
    first_cap_face_ = static_cast<Index>(copy_.number_of_faces());
    for(std::size_t i = 0; i < rims.size(); ++i) {
      const std::size_t begin = copy_.number_of_faces();
      caps_.push_back(begin - first_cap_face_);
      is_good_ = is_good_ && fill(region.vertices_of(mesh, i), rims[i].filling);
      if(is_good_ && !rims[i].is_flush)
        refine(begin);
    }
  }

  bool are_filled() const { return is_good_; }

  /// makes the caps smooth, if they have vertices.
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
    patch.caps = caps_;
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
      // Vertices are numbered as they come, in the same order by all compilers.
      std::array<Vertex, 3> corners;
      for(std::size_t k = 3; k-- > 0;)
        corners[k] = copied(c[k]);
      is_complete =
          copy_.add_face(corners[0], corners[1], corners[2]) != Mesh::null_face() && is_complete;
    });
    return is_complete;
  }

  // Each triangle has two sides that are there already, as those between its corners come first.
  bool fill(const Closed_walk& rim, const Triangulated_polygon& filling) {
    for(const Triangulated_polygon::Triangle& t : filling.triangles())
      if(copy_.add_face(copies_.at(rim[t[0]]), copies_.at(rim[t[1]]), copies_.at(rim[t[2]])) ==
         Mesh::null_face())
        return false;
    return filling.is_good();
  }

  void refine(std::size_t first_face) {
    std::vector<Mesh::Face_index> cap;
    for(std::size_t f = first_face; f < copy_.number_of_faces(); ++f)
      cap.push_back(Mesh::Face_index(static_cast<Index>(f)));
    insert_vertices(copy_, cap, own_);
  }

  const Surgery_mesh& mesh_;
  Mesh copy_;
  std::unordered_map<Index, Vertex> copies_;
  std::unordered_set<Index> copied_faces_;
  std::vector<Index> originals_; // by vertex of the copy
  std::vector<Vertex> own_;      // put in by `refine()`
  Index number_around_ = 0, first_cap_face_ = 0;
  std::vector<std::size_t> caps_; // where each begins, counted from the first face of all
  bool is_good_ = false;
};

void for_each_cap(const Surgery_mesh& mesh,
                  const Cut_region& region,
                  const Patch_visitor& is_wanted) {
  std::deque<Filled_rim> rims;
  for(std::size_t i = 0; i < region.number_of_borders(); ++i) {
    rims.emplace_back(rim_of(mesh, region, i));
    if(!rims.back().filling.is_good())
      return;
  }
  const bool are_flush =
      std::all_of(rims.begin(), rims.end(), [](const Filled_rim& rim) { return rim.is_flush; });
  if(!are_flush) {
    Holes_of_region holes(mesh, region, rims);
    if(!holes.are_filled())
      return;
    const Patch refined = holes.caps();
    if((holes.fair() && is_wanted(holes.caps())) || is_wanted(refined))
      return;
  }
  is_wanted(plain_caps(mesh, region, rims));
}

} // namespace CGAL::Handle_tunnel_loops::internal
