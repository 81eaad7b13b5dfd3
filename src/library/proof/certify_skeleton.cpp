// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/proof/certify_skeleton.h>

#include <CGAL/Handle_tunnel_loops/internal/proof/Hub_places.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Places_of_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Skeleton_checker.h>
#include <CGAL/Handle_tunnel_loops/internal/proof/Solid_pieces.h>

#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

Skeleton_certificate certify_skeleton(Execution execution,
                                      const Flat_mesh& mesh,
                                      const std::vector<Vector>& places,
                                      const Flat_skeleton& skeleton,
                                      const std::vector<std::vector<Index>>& loops,
                                      const Face_number& face_number,
                                      const Point_name& point_name,
                                      bool* do_caps_meet) {
  Skeleton_checker checker(execution, mesh, places, skeleton, loops, face_number, point_name);
  Skeleton_certificate certificate = checker.run();
  if(do_caps_meet != nullptr)
    *do_caps_meet = checker.do_caps_meet();
  return certificate;
}

void place_hubs(Execution execution, const Flat_mesh& mesh, std::vector<Vector>& places) {
  Hub_places(execution, mesh, places).find();
}

std::string
join_components_of_solids(Execution execution, Flat_mesh& mesh, const std::vector<Vector>& places) {
  if(mesh.seeds.size() == 1)
    return "";
  const Solid_pieces pieces(execution, mesh, places);
  for_each_index(execution, mesh.component.size(),
                 [&](std::size_t v) { mesh.component[v] = pieces.outer()[mesh.component[v]]; });
  return pieces.taken_alone();
}

void find_places(Execution execution,
                 const Flat_mesh& mesh,
                 const std::vector<Vector>& places,
                 Flat_skeleton& skeleton) {
  Places_of_skeleton(execution, mesh, places).find(skeleton);
}

void note_self_contact(Skeleton_certificate& certificate, bool with_caps) {
  certificate.inside = certificate.basis = false;
  certificate.failure =
      "the surface" +
      std::string(with_caps ? ", with the caps that close its boundary curves," : "") +
      " crosses or touches itself: nothing can be proved about its inside" +
      (certificate.failure.empty() ? "" : "\n") + certificate.failure;
}

} // namespace CGAL::Handle_tunnel_loops::internal
