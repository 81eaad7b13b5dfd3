// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_OF_CALLER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_OF_CALLER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Loop_on_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Certification.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The pairs of one computation, on the mesh of the caller.
template <typename Pair> struct Loops_of_caller : Caller_mesh
{
  std::vector<Pair> pairs;
};

/// What is done with them there. They are certified on the mesh of the caller if it is closed, on
/// the arrays with their caps if not.
///
/// \tparam Surface a `Prepared_surface`
template <typename Surface, typename VertexIndexMap, typename FaceIndexMap, typename GeomTraits>
class Loops_on_mesh final
    : public Loops_of_caller<Handle_tunnel_pair<typename Surface::Mesh, typename Surface::Point>>
{
public:
  using Pair = Handle_tunnel_pair<typename Surface::Mesh, typename Surface::Point>;

  Loops_on_mesh(std::shared_ptr<const Surface> surface,
                VertexIndexMap vertex_index,
                FaceIndexMap face_index,
                const GeomTraits& traits)
      : surface_(std::move(surface))
      , vertex_index_(vertex_index)
      , face_index_(face_index)
      , traits_(traits) {}

  std::vector<Flat_surface::Point> coordinates(Execution execution) const override {
    return surface_->coordinates(execution);
  }

  void convert(Execution execution, const std::vector<Flat_pair>& flat_pairs) override {
    const auto convert = surface_->converter(traits_);
    pairs.resize(flat_pairs.size());
    for_each_index(
        execution, pairs.size(),
        [&](std::size_t i) {
          pairs[i] = Pair(convert(flat_pairs[i].handle, Loop_type::HANDLE, i),
                          convert(flat_pairs[i].tunnel, Loop_type::TUNNEL, i));
        },
        1);
  }

  Certificate certify(Execution execution,
                      const Flat_surface& flat_surface,
                      const Class_options& wanted,
                      Loop_relations relations,
                      Progress& progress) override {
    Naming naming;
    if(surface_->mesh.number_of_hubs == 0)
      naming = certify_and_name(
          execution, Closed_surface(surface_->tm, surface_->point, vertex_index_, face_index_),
          wanted.kind, wanted.offset, pairs, std::move(relations), progress);
    else
      naming = certify_and_name_flat(execution, flat_surface, wanted.kind, wanted.offset,
                                     flat_surface.pairs(surface_->tm, vertex_index_, pairs),
                                     std::move(relations), progress);
    for(std::size_t k = 0; k < pairs.size(); ++k)
      if(naming.is_exchanged[k])
        pairs[k] = pairs[k].exchanged();
    return naming.certificate;
  }

private:
  using Loops_of_caller<Pair>::pairs;

  std::shared_ptr<const Surface> surface_;
  VertexIndexMap vertex_index_;
  FaceIndexMap face_index_;
  GeomTraits traits_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_OF_CALLER_H
