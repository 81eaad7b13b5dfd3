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
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <CGAL/Simple_cartesian.h>

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

/// What is done with them there.
///
/// \tparam Surface a `Prepared_surface`
template <typename Surface, typename VertexIndexMap, typename FaceIndexMap, typename GeomTraits>
class Loops_on_mesh final
    : public Loops_of_caller<Handle_tunnel_pair<typename Surface::Mesh, typename Surface::Point>>
{
  using Reader = Triangle_reader<typename Surface::Mesh, FaceIndexMap>;

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

  std::vector<Simple_cartesian<double>::Point_3> coordinates(Execution execution) const override {
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

  Triangle_list triangles(Execution execution, bool with_points) const override {
    return reader().read(execution, vertex_index_, surface_->point, with_points);
  }

  std::vector<Listed_loop> listed_loops() const override { return reader().loops_of(pairs); }

  void exchange(std::size_t k) override { pairs[k] = pairs[k].exchanged(); }

private:
  using Loops_of_caller<Pair>::pairs;

  Reader reader() const { return Reader(surface_->tm, face_index_); }

  std::shared_ptr<const Surface> surface_;
  VertexIndexMap vertex_index_;
  FaceIndexMap face_index_;
  GeomTraits traits_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_OF_CALLER_H
