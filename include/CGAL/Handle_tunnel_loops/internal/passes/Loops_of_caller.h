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
#include <CGAL/Handle_tunnel_loops/internal/linking/Loop_linker.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Offset_classifier.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Prepared_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace internal {

/// The pairs of one computation, on the mesh of the caller.
template <typename Pair> struct Loops_of_caller : Caller_mesh
{
  std::vector<Pair> pairs;
};

/// What is done with them there.
///
/// \tparam Surface a `Prepared_surface`
/// \tparam ClosedSurface a `Closed_surface` or a `Capped_surface`, on which pairs are related and
///   certified
template <typename Surface, typename ClosedSurface, typename GeomTraits>
class Loops_on_closed_surface final
    : public Loops_of_caller<Handle_tunnel_pair<typename Surface::Mesh, typename Surface::Point>>
{
public:
  using Pair = Handle_tunnel_pair<typename Surface::Mesh, typename Surface::Point>;

  Loops_on_closed_surface(std::shared_ptr<const Surface> surface,
                          std::shared_ptr<const ClosedSurface> closed,
                          const GeomTraits& traits)
      : surface_(std::move(surface))
      , closed_(std::move(closed))
      , traits_(traits) {}

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

  Loop_relations relate(Execution execution) const override {
    using Point_map = decltype(closed_->point());
    using Index_map = decltype(closed_->vertex_index());
    const auto& closed_pairs = closed_->pairs(pairs);
    using Loop = typename std::decay_t<decltype(closed_pairs)>::value_type::Loop;
    std::vector<const Loop*> loops;
    for(const auto& pair : closed_pairs)
      loops.insert(loops.end(), {&pair.handle(), &pair.tunnel()});
    const auto& tm = closed_->mesh();
    const Index_map vertex_index = closed_->vertex_index();
    Loop_linker<typename ClosedSurface::Mesh, Loop, Point_map, Index_map> linker(
        tm, closed_->point(), vertex_index);
    linker.set_boundaries(closed_->boundaries());
    const std::vector<std::size_t> components = components_by_index();
    const auto component = [&](const auto& f) {
      return components[get(vertex_index, target(halfedge(f, tm), tm))];
    };
    linker.set_loops(execution, loops, component, surface_->mesh.seeds.size());
    linker.link(execution);
    return linker.take_relations();
  }

  // The linking numbers that tell handles from tunnels are part of the certificate.
  Certificate certify(Execution execution,
                      const Class_options& wanted,
                      std::optional<Loop_relations> relations,
                      Progress& progress) override {
    const auto& closed_pairs = closed_->pairs(pairs);
    using Closed_pair = typename std::decay_t<decltype(closed_pairs)>::value_type;
    Certification<ClosedSurface, Closed_pair> certification(*closed_, wanted.kind);
    bool are_closed = false;
    progress.run(Stage::CERTIFICATE, [&] {
      are_closed = certification.are_closed(execution, closed_pairs);
      if(are_closed)
        certification.check_basis(execution);
    });
    progress.start(Stage::CLASSIFY);
    if(are_closed) {
      if(relations)
        certification.relate(std::move(*relations));
      else
        certification.relate(execution, wanted.do_link);
      name(execution, certification, closed_pairs, wanted.offset);
    }
    return certification.finish();
  }

private:
  using Loops_of_caller<Pair>::pairs;

  // By the caller's index of the vertices.
  std::vector<std::size_t> components_by_index() const {
    const Flat_mesh& mesh = surface_->mesh;
    const auto largest = *std::max_element(mesh.original.begin(), mesh.original.end());
    std::vector<std::size_t> components(
        (std::max)(std::size_t(num_vertices(surface_->tm)), std::size_t(1) + largest), 0);
    for(std::size_t v = 0; v < mesh.original.size(); ++v)
      components[mesh.original[v]] = mesh.component[v];
    return components;
  }

  // Handles and tunnels by their linking numbers, or by their growth along the normals where these
  // do not tell (paper, 4.5).
  template <typename Certification, typename ClosedPairs>
  void name(Execution execution,
            Certification& certification,
            const ClosedPairs& closed_pairs,
            double offset) {
    const Offset_classifier<typename ClosedSurface::Mesh, decltype(closed_->point())> classifier(
        closed_->mesh(), closed_->point(), offset);
    std::vector<char> is_exchanged(pairs.size(), 0);
    for_each_index(
        execution, pairs.size(),
        [&](std::size_t k) {
          int handle = certification.handle_of_pair(k);
          if(handle == 0)
            handle = certification.outward_of_pair(k) *
                     classifier.compare_growth(closed_pairs[k].handle(), closed_pairs[k].tunnel());
          is_exchanged[k] = handle < 0;
        },
        1);
    certification.exchange(is_exchanged);
    for(std::size_t k = 0; k < pairs.size(); ++k)
      if(is_exchanged[k])
        pairs[k] = pairs[k].exchanged();
  }

  std::shared_ptr<const Surface> surface_;
  std::shared_ptr<const ClosedSurface> closed_;
  GeomTraits traits_;
};

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_LOOPS_OF_CALLER_H
