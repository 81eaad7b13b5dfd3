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

#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <functional>
#include <optional>
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
    Statistics statistics;
    mesh_ = &mesh;
    surface_.emplace(mesh, coordinates_);
    find_loops(execution, mesh, request, *this, Listeners{callback}, statistics);
    return pairs_;
  }

  const std::vector<Flat_pair>& pairs() const { return pairs_; }

private:
  std::vector<Flat_surface::Point> coordinates(Execution) const override { return coordinates_; }

  void convert(Execution, const std::vector<Flat_pair>& pairs) override { pairs_ = pairs; }

  Triangle_list triangles(Execution execution, bool with_points) const override {
    Triangle_list list =
        reader().read(execution, surface_->vertex_index(), surface_->point(), with_points);
    if(mesh_->number_of_hubs > 0)
      list.first_hub = mesh_->original[mesh_->first_hub];
    return list;
  }

  std::vector<Listed_loop> listed_loops() const override {
    return reader().loops_of(surface_->pairs(pairs_));
  }

  void exchange(std::size_t k) override { std::swap(pairs_[k].handle, pairs_[k].tunnel); }

  Triangle_reader<Flat_graph, Flat_surface::Face_index_map> reader() const {
    return {surface_->mesh(), surface_->face_index()};
  }

  std::vector<Flat_surface::Point> coordinates_;
  std::vector<Flat_pair> pairs_;
  const Flat_mesh* mesh_ = nullptr;
  std::optional<Flat_surface> surface_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_ON_ARRAYS_H
