// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SOLID_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SOLID_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Pairs of loops as they are found on the arrays, for what goes on there.
class Solid_loops final : public Caller_mesh
{
public:
  /// \p places are those of the vertices, the first \p number of which are no hubs. They must
  /// outlive it.
  Solid_loops(const std::vector<Vector>& places, Index number)
      : places_(places)
      , number_(number) {}

  const std::vector<Flat_pair>& pairs() const { return pairs_; }

  std::vector<Flat_surface::Point> coordinates(Execution) const override {
    std::vector<Flat_surface::Point> coordinates;
    coordinates.reserve(number_);
    for(Index v = 0; v < number_; ++v)
      coordinates.emplace_back(places_[v][0], places_[v][1], places_[v][2]);
    return coordinates;
  }

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

private:
  const std::vector<Vector>& places_;
  Index number_;
  std::vector<Flat_pair> pairs_;
};

/// computes a basis of loops on the arrays.
template <typename ConcurrencyTag>
void find_solid_loops(Execution execution,
                      const Flat_mesh& mesh,
                      const Solver_options& options,
                      const std::function<bool(double)>& callback,
                      Solid_loops& loops) {
  Loop_request request = loop_request(options);
  request.classes.do_link = true; // which of them are handle loops
  request.seeds = mesh.seeds;
  request.put_swept_vertices = [](const Swept_vertices&) {};
  request.make_passes = &make_passes<ConcurrencyTag>;
  const auto nothing = [](Stage) {};
  Statistics statistics;
  Progress progress(callback, nothing, nothing, statistics, Progress::stages_of_loops());
  find_loops(execution, mesh, request, loops, progress, statistics);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SOLID_LOOPS_H
