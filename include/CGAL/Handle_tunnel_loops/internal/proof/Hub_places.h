// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_HUB_PLACES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_HUB_PLACES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Exact_meeting.h>
#include <CGAL/Handle_tunnel_loops/internal/solid/Face_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Sorted_boxes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Span.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Vector.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Some places where the hub of a curve may be, the better ones first.
class Hub_candidates
{
public:
  explicit Hub_candidates(std::vector<Vector> curve)
      : curve_(std::move(curve)) {
    for(const Vector& p : curve_)
      middle_ = middle_ + (1. / double(curve_.size())) * p;
    for(const Vector& p : curve_)
      for(double x : p - middle_)
        size_ = (std::max)(size_, std::abs(x));
  }

  /// the middle of the vertices: in the plane of a curve that is about round.
  const Vector& middle() const { return middle_; }

  /*!
  others, where the middle will not do. The fan of faces from a place off the plane of a flat curve
  does not meet itself, however the curve winds; and if the place is near the plane, above the
  region that the curve encloses, it keeps away from other parts of the surface. For curves that
  are not flat at all, places at random.
  */
  std::vector<Vector> others() const {
    std::vector<Vector> places;
    const Vector up = normal();
    const double length = norm(up);
    if(!(size_ > 0.) || !(length > 0.))
      return places;
    const Vector step = (size_ / length) * up, inner = place_within(up);
    for(const double height : {0., 0.03125, 0.125, 0.25, 0.5, 1., 2., 4.})
      for(const Vector& base : {inner, middle_})
        for(const double side : {height, -height})
          places.push_back(base + side * step);
    std::minstd_rand random;
    for(int i = 0; i < number_of_random_places; ++i) {
      Vector p = middle_;
      for(double& x : p)
        x += 4. * size_ * (double(random()) / double(random.max()) - 0.5);
      places.push_back(p);
    }
    return places;
  }

  /// a box that all of these are in, and the curve.
  Box<3> reach() const {
    constexpr double most = 6., largest = (std::numeric_limits<double>::max)();
    Box<3> box;
    for(int d = 0; d < 3; ++d) {
      box.low[d] = (std::max)(middle_[d] - most * size_, -largest);
      box.high[d] = (std::min)(middle_[d] + most * size_, largest);
    }
    return box;
  }

private:
  static constexpr int number_of_random_places = 256;

  // From the middle, as long as about 1.
  Vector direction(const Vector& p) const { return (1. / size_) * (p - middle_); }

  // Twice the area that the curve encloses, as seen from where it is largest.
  Vector normal() const {
    Vector sum = {0., 0., 0.};
    for(std::size_t i = 0; i < curve_.size(); ++i)
      sum = sum + cross(direction(curve_[i]), direction(curve_[(i + 1) % curve_.size()]));
    return sum;
  }

  // Of places half way between vertices, one far from the curve, if there is any within it as seen
  // along `up`.
  Vector place_within(const Vector& up) const {
    constexpr std::size_t most = 24;
    const std::size_t stride = 1 + curve_.size() / most;
    Vector best = middle_;
    double largest = 0.;
    for(std::size_t i = 0; i < curve_.size(); i += stride)
      for(std::size_t j = 0; j < i; j += stride) {
        const Vector p = 0.5 * curve_[i] + 0.5 * curve_[j];
        const double distance = distance_within(p, up);
        if(distance > largest) {
          largest = distance;
          best = p;
        }
      }
    return best;
  }

  // From the curve; 0 outside.
  double distance_within(const Vector& p, const Vector& up) const {
    double angle = 0., least = (std::numeric_limits<double>::infinity)();
    for(std::size_t i = 0; i < curve_.size(); ++i) {
      const Vector a = flat(curve_[i] - p, up), b = flat(curve_[(i + 1) % curve_.size()] - p, up),
                   way = b - a;
      angle += arc_tangent(dot(cross(a, b), up) / norm(up), dot(a, b));
      const double square = dot(way, way),
                   t = square > 0. ? (std::max)(0., (std::min)(1., -dot(a, way) / square)) : 0.;
      least = (std::min)(least, norm(a + t * way));
    }
    constexpr double half_turn = 3.;
    return angle > half_turn ? least : 0.;
  }

  Vector flat(const Vector& v, const Vector& up) const {
    const Vector w = (1. / size_) * v;
    return w - (dot(w, up) / dot(up, up)) * up;
  }

  std::vector<Vector> curve_;
  Vector middle_ = {0., 0., 0.};
  double size_ = 0.;
};

/*!
Places the hubs of the caps, so that the surface with its caps does not meet itself if the surface
does not: in the middle of the curve, or, where the cap meets itself or something else there, at the
first candidate where it meets nothing. If there is none it stays in the middle. The cap of a flat
piece of surface would lie upon it, but for rounding: where there is one, a place is preferred that
leaves room between them.
*/
class Hub_places
{
public:
  /// \p places has those of the vertices, and may have those of the hubs.
  Hub_places(Execution execution, const Flat_mesh& mesh, std::vector<Vector>& places)
      : execution_(execution)
      , mesh_(mesh)
      , places_(places)
      , is_moved_(mesh.number_of_hubs, 0) {}

  /// appends the places of the hubs.
  void find() {
    for(Index hub = mesh_.first_hub; hub < mesh_.number_of_vertices(); ++hub)
      places_.push_back(candidates(hub).middle());
    if(mesh_.number_of_hubs == 0)
      return;
    const Face_tree faces(execution_, mesh_, span_of(places_));
    to_move_ = caps_met(faces, Contact::NEARLY);
    std::vector<Box<3>> reaches;
    for(Index hub : to_move_)
      reaches.push_back(candidates(hub).reach());
    reaches_.emplace(execution_, reaches);
    for(Index hub : to_move_)
      move(faces, hub);
  }

  /// what is no better than to meet.
  enum class Contact { EXACTLY, NEARLY };

  /// the hubs, which have places, of caps that meet themselves, the surface or each other.
  std::vector<Index> caps_met(const Face_tree& faces, Contact contact = Contact::EXACTLY) const {
    std::vector<char> is_met(mesh_.number_of_hubs);
    for_each_index(
        execution_, is_met.size(),
        [&](std::size_t i) { is_met[i] = is_cap_met(faces, mesh_.first_hub + Index(i), contact); },
        1);
    std::vector<Index> hubs;
    for(Index i = 0; i < is_met.size(); ++i)
      if(is_met[i] != 0)
        hubs.push_back(mesh_.first_hub + i);
    return hubs;
  }

private:
  using Corners = Face_tree::Corners;

  Hub_candidates candidates(Index hub) const {
    std::vector<Vector> curve;
    for(Index v : mesh_.ring(hub))
      curve.push_back(places_[v]);
    return Hub_candidates(std::move(curve));
  }

  void move(const Face_tree& faces, Index hub) {
    const Vector middle = places_[hub];
    std::vector<Vector> all = candidates(hub).others();
    all.insert(all.begin(), middle); // other caps have been moved
    for(const Contact contact : {Contact::NEARLY, Contact::EXACTLY})
      for(const Vector& p : all) {
        places_[hub] = p;
        if(is_cap_met(faces, hub, contact))
          continue;
        is_moved_[hub - mesh_.first_hub] = p != middle;
        return;
      }
    places_[hub] = middle;
  }

  // Whether the cap meets itself, the surface or another cap.
  bool is_cap_met(const Face_tree& faces, Index hub, Contact contact) const {
    const std::vector<Corners> cap = faces_of_cap(hub);
    std::vector<Box<3>> boxes;
    Box<3> around = Box<3>::empty();
    for(const Corners& face : cap) {
      boxes.push_back(box(face));
      around.extend(boxes.back());
    }
    const Box_tree<3> tree(boxes);
    const auto is_met_by = [&](const Corners& face) {
      return tree.any_meeting(box(face), [&](Index i, const Box<3>&) {
        return cap[i] != face && do_meet_elsewhere(cap[i], face, contact);
      });
    };
    for(std::size_t i = 0; i < cap.size(); ++i)
      if(is_degenerate(cap[i]) || is_met_by(cap[i]) ||
         faces.boxes().any_meeting(boxes[i], [&](Index f) {
           return is_where_it_was(faces.corners(f), hub) &&
                  do_meet_elsewhere(cap[i], faces.corners(f), contact);
         }))
        return true;
    return reaches_ && reaches_->any_meeting(around, [&](Index i, const Box<3>&) {
      if(is_moved_[to_move_[i] - mesh_.first_hub] == 0)
        return false;
      const std::vector<Corners> others = faces_of_cap(to_move_[i]);
      return std::any_of(others.begin(), others.end(), is_met_by);
    });
  }

  // Whether it is a face other than of this cap, and not of one that has been moved.
  bool is_where_it_was(const Corners& face, Index hub) const {
    return std::none_of(face.begin(), face.end(), [&](Index v) {
      return v == hub || (mesh_.is_hub(v) && is_moved_[v - mesh_.first_hub] != 0);
    });
  }

  std::vector<Corners> faces_of_cap(Index hub) const {
    std::vector<Corners> faces;
    const Ring curve = mesh_.ring(hub);
    for(Index i = 0; i < curve.size(); ++i)
      faces.push_back({hub, curve[i], curve[curve.next(i)]});
    return faces;
  }

  Box<3> box(const Corners& face) const {
    Box<3> box = box_around(places_[face[0]], places_[face[1]]);
    box.extend({places_[face[2]], places_[face[2]]});
    return box;
  }

  // ---- two faces

  Exact_point point(Index v) const { return exact_point(places_[v]); }
  Exact_triangle triangle(const Corners& face) const {
    return {point(face[0]), point(face[1]), point(face[2])};
  }
  bool is_degenerate(const Corners& face) const {
    return CGAL::collinear(point(face[0]), point(face[1]), point(face[2]));
  }

  // Whether two faces meet elsewhere than in the corners and the side that they share.
  bool do_meet_elsewhere(const Corners& a, const Corners& b, Contact contact) const {
    std::vector<int> in_a, in_b;
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        if(a[i] == b[j]) {
          in_a.push_back(i);
          in_b.push_back(j);
        }
    switch(in_a.size()) {
    case 0:
      return any_side_meets(a, triangle(b)) || any_side_meets(b, triangle(a));
    case 1: // where they meet, both are star-shaped from the corner
      return do_meet(side(a, in_a[0]), triangle(b)) || do_meet(side(b, in_b[0]), triangle(a));
    case 2: {
      const Index u = a[in_a[0]], v = a[in_a[1]], p = a[3 - in_a[0] - in_a[1]],
                  q = b[3 - in_b[0] - in_b[1]];
      return do_overlap_at_side(u, v, p, q) ||
             (contact == Contact::NEARLY && is_angle_tiny(u, v, p, q));
    }
    default:
      return true;
    }
  }

  // Opposite to a corner.
  Exact_segment side(const Corners& face, int corner) const {
    return {point(face[(corner + 1) % 3]), point(face[(corner + 2) % 3])};
  }

  bool any_side_meets(const Corners& face, const Exact_triangle& t) const {
    for(int i = 0; i < 3; ++i)
      if(do_meet(side(face, i), t))
        return true;
    return false;
  }

  bool do_overlap_at_side(Index u, Index v, Index p, Index q) const {
    const Exact_point a = point(u), b = point(v), c = point(p), d = point(q);
    return CGAL::orientation(a, b, c, d) == COPLANAR && !CGAL::collinear(a, b, c) &&
           !CGAL::collinear(a, b, d) && CGAL::coplanar_orientation(a, b, c, d) == POSITIVE;
  }

  // Between faces with a common side: no more than rounding may make of two in one plane.
  bool is_angle_tiny(Index u, Index v, Index p, Index q) const {
    constexpr double tiny = 0x1p-30;
    const Vector side = direction(u, v), normal_p = cross(side, direction(u, p)),
                 normal_q = cross(side, direction(u, q)), turn = cross(normal_p, normal_q);
    return dot(normal_p, normal_q) > 0. && norm(turn) <= tiny * norm(normal_p) * norm(normal_q);
  }

  // Of a length that is neither large nor small.
  Vector direction(Index from, Index to) const {
    const Vector way = places_[to] - places_[from];
    const double size = (std::max)({std::abs(way[0]), std::abs(way[1]), std::abs(way[2])});
    return size > 0. ? (1. / size) * way : way;
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  std::vector<Vector>& places_;
  std::vector<char> is_moved_; // by hub, from the first one on
  std::vector<Index> to_move_; // hubs, in that order
  std::optional<Sorted_boxes<3>> reaches_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PROOF_HUB_PLACES_H
