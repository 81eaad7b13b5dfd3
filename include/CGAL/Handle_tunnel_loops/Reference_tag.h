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

#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>
#include <CGAL/Handle_tunnel_loops/internal/reference/Reference_passes.h>

#include <CGAL/tags.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgHandleTunnelLoopsRef

As the `ConcurrencyTag` of `CGAL::handle_tunnel_loops()`, of
`CGAL::Handle_tunnel_loops_solver::find_loops()` and of `CGAL::reeb_graph()`, it asks for the
reference solver: the method of \cgalCite{weinrauch2023variational}, in one thread, to compare
others with. Where a rule of the paper does not hold on any mesh there is another one in its place,
unless `Literal_rules` ask for the letter; \ref HTLLetter "the manual" lists them.

All fields of the initial pass are the rows of a sparse matrix, and obey the equation of the paper's
section 3 with all its terms; the fields of the other two passes cover the whole mesh; tunnels, and
handles after the refinement, are streamlines across the triangles. These passes tighten nothing,
and share no algorithm that finds loops with the other solvers; they share with them the adaptor and
its arrays, the sequences of crossed edges that loops are, the order of the passes, the conversion
of the answer, the linking numbers and the offset criterion that tell handles from tunnels, and the
certificate. The stage `CLASSES` that follows is that of the other solvers too: it replaces loops
that do not bound, unless `Solver_options::do_compute_linking` is switched off, and looks for
shorter ones, which are tightened, unless `do_tighten` is.
`Handle_tunnel_loops::Statistics::front_events` holds the splits, merges and closings of the initial
pass afterwards, and `Handle_tunnel_loops::Statistics::resolution` where the mesh was too coarse for
what the paper takes for granted.

A Reeb graph starts from the handle loops of these passes, and its diffusion is one more field over
the whole mesh, section 6 of the paper; the sweep through the arrival times is that of the other
solvers.

Each step costs time in proportion to the whole mesh and there are about as many steps as the mesh
is edges wide, times three, for each pass: \f$ O(g n^{3/2}) \f$ on a mesh with n vertices. Memory is
about 700 bytes per vertex.

It needs Eigen; the macro `CGAL_EIGEN3_ENABLED` has to be defined, as it is in programs that are
linked with the target `CGAL::Eigen3_support`.
*/
struct Reference_tag : public Sequential_tag
{};

namespace Handle_tunnel_loops {

using CGAL::Reference_tag; // where it was at first

namespace internal {

#ifdef CGAL_EIGEN3_ENABLED
template <> struct Passes_of_tag<Reference_tag> : Passes_of_tag<Sequential_tag>
{
  static constexpr bool may_coarsen = false; // the paper has one mesh

  static std::unique_ptr<Passes>
  make(const Flat_mesh& mesh, std::vector<Index> seeds, const Pass_options& options) {
    return std::make_unique<reference::Reference_passes>(mesh, std::move(seeds), options);
  }
};
#else
template <> struct Passes_of_tag<Reference_tag>; // link with CGAL::Eigen3_support
#endif

} // namespace internal
} // namespace Handle_tunnel_loops
} // namespace CGAL

#endif // CGAL_HANDLE_TUNNEL_LOOPS_REFERENCE_TAG_H
