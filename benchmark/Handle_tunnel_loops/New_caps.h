// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_NEW_CAPS_H
#define BENCHMARK_NEW_CAPS_H

#include "Surface_distance.h"

/// \file New_caps.h
/// The pieces of a surface that are not where the old surface was.

namespace judge {

struct Cap
{
  std::vector<Mesh::Face_index> faces;
  std::size_t owner = nobody;
  double area = 0.;
  double rim = 0.;       ///< its length
  double flat_rim = 0.;  ///< how much of it goes on in the plane of the cap
  double even_rim = 0.;  ///< how much goes on at less than 10 degrees to it
  double off_plane = 0.; ///< how far it leaves its plane

  /// how many circles as long as the rim have its area.
  double circles() const { return area * 4. * CGAL_PI / (rim * rim); }

  /// whether it continues the plane around it, as the cap of a bore at its mouth. Single precision
  /// is what coordinates of files often have.
  bool is_flush() const { return off_plane <= 1e-5 * rim && flat_rim >= 0.9 * rim; }

  /// the same where faces were meshed anew, so that no mouth lies in a plane exactly.
  bool is_nearly_flush() const { return off_plane <= 5e-3 * rim && even_rim >= 0.9 * rim; }
};

/// Those new faces of a mesh that do not lie on the old surface, in pieces: what hangs together and
/// is of one handle.
class New_caps
{
public:
  using Owners = Mesh::Property_map<Mesh::Face_index, std::size_t>;

  /// \p tolerance says what lies on the old surface.
  New_caps(const Mesh& after,
           const std::vector<Mesh::Face_index>& new_faces,
           const Owners& owners,
           const Surface_distance& old_surface,
           double tolerance)
      : mesh_(after)
      , owners_(owners) {
    for(const Mesh::Face_index f : new_faces)
      if(!old_surface.is_near(triangle_of(after, f), tolerance))
        cap_of_[f] = nobody;
    for(const auto& [face, cap] : cap_of_)
      if(cap == nobody)
        add_cap(face);
    for(Cap& cap : caps_)
      measure(cap);
  }

  const std::vector<Cap>& caps() const { return caps_; }

  bool is_in_cap(Mesh::Face_index f) const { return cap_of_.count(f) != 0; }

private:
  void add_cap(Mesh::Face_index seed) {
    Cap cap;
    cap.owner = owners_[seed];
    cap.faces.push_back(seed);
    cap_of_[seed] = caps_.size();
    for(std::size_t i = 0; i < cap.faces.size(); ++i)
      for(const Mesh::Face_index f : CGAL::faces_around_face(mesh_.halfedge(cap.faces[i]), mesh_)) {
        const auto place = cap_of_.find(f);
        if(place == cap_of_.end() || place->second != nobody || owners_[f] != cap.owner)
          continue;
        place->second = caps_.size();
        cap.faces.push_back(f);
      }
    caps_.push_back(cap);
  }

  bool is_rim(Mesh::Halfedge_index h) const {
    const Mesh::Face_index f = mesh_.face(mesh_.opposite(h));
    const auto place = cap_of_.find(f);
    return place == cap_of_.end() || place->second != cap_of_.at(mesh_.face(h));
  }

  void measure(Cap& cap) const {
    Vector normal(0., 0., 0.);
    for(const Mesh::Face_index f : cap.faces) {
      cap.area += area_of(triangle_of(mesh_, f));
      normal = normal + normal_of(triangle_of(mesh_, f));
      for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_))
        if(is_rim(h))
          cap.rim += length(h);
    }
    if(length_of(normal) > 0.)
      compare_with_plane(cap, normal / length_of(normal));
  }

  double length(Mesh::Halfedge_index h) const {
    return length_of(point_of(mesh_, mesh_.target(h)) - point_of(mesh_, mesh_.source(h)));
  }

  void compare_with_plane(Cap& cap, const Vector& normal) const {
    const Point origin = triangle_of(mesh_, cap.faces.front())[0];
    for(const Mesh::Face_index f : cap.faces)
      for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(mesh_.halfedge(f), mesh_)) {
        const double off = std::abs((point_of(mesh_, mesh_.target(h)) - origin) * normal);
        cap.off_plane = (std::max)(cap.off_plane, off);
        if(!is_rim(h))
          continue;
        const double bend = bend_beyond(mesh_.opposite(h), normal, 1e-5 * cap.rim);
        cap.flat_rim += bend < 1. ? length(h) : 0.;
        cap.even_rim += bend < 10. ? length(h) : 0.;
      }
  }

  // Of the face of a halfedge against a plane through it, in degrees; 0 if the face does not leave
  // it by more than a tolerance, however narrow it is.
  double bend_beyond(Mesh::Halfedge_index h, const Vector& normal, double tolerance) const {
    const Mesh::Face_index f = mesh_.face(h);
    if(f == Mesh::null_face())
      return 180.;
    const Vector other = normal_of(triangle_of(mesh_, f));
    const Vector up =
        point_of(mesh_, mesh_.target(mesh_.next(h))) - point_of(mesh_, mesh_.source(h));
    if(std::abs(up * normal) <= tolerance && other * normal >= 0.)
      return 0.;
    return bend_between(other, normal);
  }

  const Mesh& mesh_;
  const Owners owners_;
  std::map<Mesh::Face_index, std::size_t> cap_of_;
  std::vector<Cap> caps_;
};

} // namespace judge

#endif // BENCHMARK_NEW_CAPS_H
