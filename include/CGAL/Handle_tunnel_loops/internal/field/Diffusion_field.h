// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_DIFFUSION_FIELD_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_DIFFUSION_FIELD_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/field/Narrow_band.h>
#include <CGAL/Handle_tunnel_loops/internal/loops/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Progress.h>

#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The arrival times of fronts that start at several vertices at once, in all components.
class Diffusion_field
{
public:
  Diffusion_field(Execution execution, const Flat_mesh& mesh, const Field_constants& constants)
      : mesh_(mesh)
      , stencils_(execution, mesh)
      , band_(mesh, stencils_, step_coefficients(constants))
      , has_source_(mesh.seeds.size(), 0) {}

  void add_source(Index v) {
    sources_.push_back(v);
    has_source_[mesh_.component[v]] = 1;
  }

  /// from both sides of a loop.
  void add_source(const Crossing_loop& loop) {
    for(const Crossing& c : loop) {
      add_source(c.left);
      add_source(c.right);
    }
  }

  /// In components without a source the fronts start from the vertex that is reached last from the
  /// seed: from the end of a limb, where there are limbs.
  void complete_sources(Progress& progress) {
    std::vector<Index> last = mesh_.seeds;
    std::size_t missing = 0;
    for(Index component = 0; component < mesh_.seeds.size(); ++component)
      if(!has_source_[component])
        add_source_with_ring(band_, mesh_, mesh_.seeds[component]);
    for(Index component : mesh_.component)
      missing += !has_source_[component];
    if(missing == 0)
      return;
    grow_to(missing, progress);
    for(Index v = 0; v < mesh_.number_of_vertices(); ++v) {
      Index& u = last[mesh_.component[v]];
      if(band_.is_reached(v) && is_later(v, u))
        u = v;
    }
    band_.reset();
    for(Index component = 0; component < last.size(); ++component)
      if(!has_source_[component])
        add_source(last[component]);
  }

  std::vector<Time> times(Progress& progress) {
    for(Index v : sources_)
      band_.add_source(v, 0);
    for(Index v : sources_)
      for(Index u : mesh_.ring(v))
        band_.add_source(u, 1);
    grow_to(mesh_.number_of_vertices(), progress);
    return band_.take_times();
  }

private:
  bool is_later(Index v, Index u) const {
    return band_.time(v) > band_.time(u) ||
           (band_.time(v) == band_.time(u) && mesh_.original[v] < mesh_.original[u]);
  }

  void grow_to(std::size_t number_of_vertices, Progress& progress) {
    grow(band_, number_of_vertices, [&](double part) { progress.advance(part); });
  }

  const Flat_mesh& mesh_;
  Stencils stencils_;
  Narrow_band band_;
  std::vector<char> has_source_; // by component
  std::vector<Index> sources_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_FIELD_DIFFUSION_FIELD_H
