// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/certification.h"

#include "solve/boundaries.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Boundary_check.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/self_contact.h>

namespace htloops {
namespace {

namespace internal = CGAL::Handle_tunnel_loops::internal;

class Watch_by_function final : public internal::Watch
{
public:
  explicit Watch_by_function(const std::function<void()>& look)
      : look_(look) {}

  void look() override { look_(); }

private:
  const std::function<void()>& look_;
};

} // namespace

Certificate certify(const Mesh& mesh, const Pairs& pairs, Basis_kind basis_kind, bool with_sides) {
  CGAL::Handle_tunnel_loops::Solver_options options;
  options.do_compute_linking = with_sides;
  return CGAL::certify_handle_tunnel_loops<CGAL::Parallel_if_available_tag>(
      mesh, pairs,
      CGAL::parameters::basis_kind(basis_kind, CGAL::parameters::solver_options(options)));
}

std::vector<std::string> problems_of_boundaries(const Mesh& mesh,
                                                const std::vector<Loop>& curves,
                                                const std::vector<Loop>& waists) {
  auto vertex_index = get(boost::vertex_index, mesh);
  auto face_index = get(boost::face_index, mesh);
  const internal::Boundary_check<Mesh, decltype(vertex_index), decltype(face_index), Loop> check(
      mesh, vertex_index, face_index);
  return check.problems(find_boundaries(mesh, false).curves, curves, waists);
}

bool touches_itself(const Mesh& mesh, const std::function<void()>& look) {
  Watch_by_function watch(look);
  const auto execution = internal::execution_of<CGAL::Parallel_if_available_tag>();
  return internal::touches_itself(execution.watched_by(watch), mesh, get(CGAL::vertex_point, mesh),
                                  get(boost::vertex_index, mesh));
}

} // namespace htloops
