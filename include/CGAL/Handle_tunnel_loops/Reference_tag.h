// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_REFERENCE_TAG_H
#define CGAL_HANDLE_TUNNEL_LOOPS_REFERENCE_TAG_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/make_reference_passes.h>

#include <CGAL/tags.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

A concurrency tag that requests the reference solver: the method of
\cgalCite{weinrauch2023variational}, in one thread, as a baseline for comparisons. Use it as the
`ConcurrencyTag` of `CGAL::handle_tunnel_loops()`,
`CGAL::Handle_tunnel_loops_solver::find_loops()` and `CGAL::reeb_graph()`. If a rule of the paper
does not work on all meshes, the reference solver uses another rule, unless you select the literal
rule in `Literal_rules`; \ref HTLLetter "the manual" lists these rules.

The fields of the initial pass are the rows of a sparse matrix and follow the equation of section 3
of the paper with all its terms. The fields of the other two passes cover the whole mesh. Tunnel
loops, and refined handle loops, are streamlines across the triangles. These passes do not tighten
loops, and they share no algorithm that finds loops with the other solvers. They do share the mesh
adaptor and its arrays, the representation of loops as sequences of crossed edges, the order of the
passes, the conversion of the result, the linking numbers and the offset criterion that distinguish
handle loops from tunnel loops, and the certificate.

The stage `CLASSES` that follows is also that of the other solvers. It replaces loops that do not
bound, unless `Solver_options::do_compute_linking` is `false`. It looks for shorter loops and
tightens them, unless `Solver_options::do_tighten` is `false`.

Afterwards, `Handle_tunnel_loops::Statistics::front_events` contains the splits, merges and closings
of the initial pass, and `Handle_tunnel_loops::Statistics::resolution` counts where the mesh was too
coarse for the assumptions of the paper.

A Reeb graph starts from the handle loops of these passes. Its diffusion is one more field over the
whole mesh (section 6 of the paper). The sweep through the arrival times is that of the other
solvers.

The running time of a step is proportional to the size of the whole mesh. Each pass takes about
three times as many steps as the mesh is edges wide, which gives \f$ O(g n^{3/2}) \f$ for
\f$ n \f$ vertices and genus \f$ g \f$. The memory is about 700 bytes per vertex.

The reference solver requires \eigen: the macro `CGAL_EIGEN3_ENABLED` must be defined, as it is in
programs that are linked with the target `CGAL::Eigen3_support`.
*/
struct Reference_tag : public Sequential_tag
{};

namespace Handle_tunnel_loops {

using CGAL::Reference_tag; // its former place

namespace internal {

#ifdef CGAL_EIGEN3_ENABLED
template <> struct Passes_of_tag<Reference_tag> : Passes_of_tag<Sequential_tag>
{
  static constexpr bool may_coarsen = false; // the paper has one mesh

  static std::shared_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return reference::make_reference_passes(mesh, std::move(seeds), options);
  }
};
#else
template <> struct Passes_of_tag<Reference_tag>; // link with CGAL::Eigen3_support
#endif

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REFERENCE_TAG_H
