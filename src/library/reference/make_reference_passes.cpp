// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/reference/make_reference_passes.h>

#ifdef CGAL_EIGEN3_ENABLED

#include <CGAL/Handle_tunnel_loops/internal/reference/Reference_passes.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal::reference {

std::shared_ptr<Passes> make_reference_passes(const Flat_mesh& mesh,
                                              std::vector<Index> seeds,
                                              const Pass_options& options) {
  return std::make_shared<Reference_passes>(mesh, std::move(seeds), options);
}

} // namespace CGAL::Handle_tunnel_loops::internal::reference

#endif // CGAL_EIGEN3_ENABLED
