// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_ON_ARRAYS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_ON_ARRAYS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Pairs of loops as they are found on the arrays, for what goes on there.
class Loops_on_arrays final : private Caller_mesh
{
public:
  /// \p coordinates are those of the vertices but for the hubs.
  explicit Loops_on_arrays(std::vector<Flat_surface::Point> coordinates)
      : coordinates_(std::move(coordinates)) {}

  /// finds a basis. The seeds of the request are those of the mesh, and nothing is asked of it but
  /// pairs.
  const std::vector<Flat_pair>& find(Execution execution,
                                     const Flat_mesh& mesh,
                                     Loop_request request,
                                     const std::function<bool(double)>& callback = {}) {
    request.seeds = mesh.seeds;
    request.put_swept_vertices = [](const Swept_vertices&) {};
    const auto nothing = [](Stage) {};
    Statistics statistics;
    Progress progress(callback, nothing, nothing, statistics, Progress::stages_of_loops());
    find_loops(execution, mesh, request, *this, progress, statistics);
    return pairs_;
  }

  const std::vector<Flat_pair>& pairs() const { return pairs_; }

private:
  std::vector<Flat_surface::Point> coordinates(Execution) const override { return coordinates_; }

  void convert(Execution, const std::vector<Flat_pair>& pairs) override { pairs_ = pairs; }

  Certificate certify(Execution execution,
                      const Flat_surface& surface,
                      const Class_options& wanted,
                      Loop_relations relations,
                      Progress& progress) override {
    const Naming naming =
        certify_and_name_flat(execution, surface, wanted.kind, wanted.offset, surface.pairs(pairs_),
                              std::move(relations), progress);
    for(std::size_t k = 0; k < pairs_.size(); ++k)
      if(naming.is_exchanged[k])
        std::swap(pairs_[k].handle, pairs_[k].tunnel);
    return naming.certificate;
  }

  std::vector<Flat_surface::Point> coordinates_;
  std::vector<Flat_pair> pairs_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_ON_ARRAYS_H
