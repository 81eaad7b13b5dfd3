// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Boundary_check.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/mesh_checks.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

[[noreturn]] void throw_not_triangulated(std::size_t u, std::size_t v) {
  throw_edge_defect(Mesh_defect::NOT_TRIANGULATED, u, v, "a face at an edge is not a triangle");
}

Certificate certify(Execution execution,
                    Triangle_list list,
                    const std::vector<Listed_loop>& loops,
                    Basis_kind kind,
                    bool do_link) {
  const Closed_triangles triangles(std::move(list));
  Certification certification(triangles, kind);
  if(certification.are_closed(execution, triangles.loops(loops))) {
    certification.check_basis(execution);
    if(certification.are_as_many_as_asked_for())
      certification.relate(execution, do_link);
  }
  return certification.finish();
}

Naming certify_and_name(Execution execution,
                        const std::function<Triangle_list(bool with_points)>& read,
                        const std::vector<Listed_loop>& loops,
                        Basis_kind kind,
                        double offset,
                        Loop_relations relations,
                        Progress& progress) {
  Naming naming = {{}, std::vector<char>(loops.size() / 2, 0)};
  std::optional<Closed_triangles> triangles;
  std::optional<Certification> certification;
  bool are_closed = false;
  progress.run(Stage::CERTIFICATE, [&] {
    triangles.emplace(read(!relations.is_linked));
    certification.emplace(*triangles, kind);
    are_closed = certification->are_closed(execution, triangles->loops(loops));
    if(are_closed)
      certification->check_basis(execution);
  });
  progress.run(Stage::CLASSIFY, [&] {
    if(are_closed) {
      certification->relate(std::move(relations));
      const std::size_t number_of_pairs = naming.is_exchanged.size();
      std::vector<int> handles(number_of_pairs);
      for(std::size_t k = 0; k < number_of_pairs; ++k)
        handles[k] = certification->handle_of_pair(k);
      std::optional<Closed_triangles> with_points;
      if(std::count(handles.begin(), handles.end(), 0) > 0 && !triangles->has_points())
        with_points.emplace(read(true));
      const Closed_triangles& placed = with_points ? *with_points : *triangles;
      const Offset_classifier<Closed_triangles, Closed_triangles::Point_map> classifier(
          placed, placed.point(), offset);
      for_each_index(
          execution, number_of_pairs,
          [&](std::size_t k) {
            if(handles[k] == 0)
              handles[k] = certification->outward_of_pair(k) *
                           classifier.compare_growth(certification->loops()[2 * k],
                                                     certification->loops()[2 * k + 1]);
            naming.is_exchanged[k] = handles[k] < 0;
          },
          1);
      certification->exchange(naming.is_exchanged);
    }
    naming.certificate = certification->finish();
  });
  return naming;
}

std::vector<std::string>
reasons_not_closed(Execution execution, Triangle_list list, const std::vector<Listed_loop>& loops) {
  const Closed_triangles triangles(std::move(list));
  Loop_certifier certifier(triangles);
  certifier.set_loops(execution, triangles.loops(loops));
  return certifier.reasons_not_closed();
}

std::vector<std::size_t> pairs_of_different_class(Execution execution,
                                                  Triangle_list list,
                                                  const std::vector<Listed_loop>& loops) {
  const Closed_triangles triangles(std::move(list));
  Loop_certifier certifier(triangles, Caps::OUTSIDE);
  certifier.set_loops(execution, triangles.loops(loops));
  return certifier.pairs_of_different_class(execution);
}

std::vector<std::string> problems_of_waists(Execution execution,
                                            Triangle_list list,
                                            const std::vector<Listed_loop>& curves,
                                            const std::vector<Listed_waist>& waists) {
  const Closed_triangles triangles(std::move(list));
  return Boundary_check(execution, triangles).problems_of_waists(triangles.loops(curves), waists);
}

std::vector<std::string> problems_of_boundaries(Execution execution,
                                                Triangle_list list,
                                                const std::vector<Listed_loop>& curves,
                                                const std::vector<Listed_waist>& waists) {
  const Closed_triangles triangles(std::move(list));
  return Boundary_check(execution, triangles).problems(triangles.loops(curves), waists);
}

} // namespace CGAL::Handle_tunnel_loops::internal
