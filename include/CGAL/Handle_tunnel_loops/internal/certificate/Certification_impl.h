// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFICATION_IMPL_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFICATION_IMPL_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification.h>

#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

CGAL_HTL_CORE Certificate certify_flat(Execution execution,
                                       const Flat_surface& surface,
                                       Basis_kind kind,
                                       const std::vector<Flat_surface::Pair>& pairs,
                                       bool do_link) {
  return certify(execution, surface, kind, pairs, do_link);
}

CGAL_HTL_CORE Naming certify_and_name_flat(Execution execution,
                                           const Flat_surface& surface,
                                           Basis_kind kind,
                                           double offset,
                                           const std::vector<Flat_surface::Pair>& pairs,
                                           Loop_relations relations,
                                           Progress& progress) {
  return certify_and_name(execution, surface, kind, offset, pairs, std::move(relations), progress);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_CERTIFICATION_IMPL_H
