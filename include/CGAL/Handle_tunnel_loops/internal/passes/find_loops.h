// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIND_LOOPS_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIND_LOOPS_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/Solver_options.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/find_right_classes.h>
#include <CGAL/Handle_tunnel_loops/internal/linking/Surface_curves.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_surface.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/run_passes.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// What a computation is asked for.
struct Loop_request
{
  Pass_options passes;
  Class_options classes;
  std::vector<Index> seeds; ///< one in each component
  std::function<void(const Swept_vertices&)> put_swept_vertices;

  /// who does the passes: `internal::make_passes()` of a tag.
  Make_passes make_passes;
};

/// a request for what the options of a solver say, but for seeds and who does the passes.
inline Loop_request
loop_request(const Solver_options& options, bool wants_layers = false, bool wants_times = false) {
  Loop_request request;
  request.passes = {options, wants_layers, wants_times};
  request.passes.do_coarsen = options.do_coarsen && options.do_tighten;
  request.classes.do_link = options.do_compute_linking;
  request.classes.do_shorten = options.do_tighten;
  request.classes.search_effort = options.search_effort;
  return request;
}

/// The mesh of a caller, for what knows no type of mesh: it holds pairs of loops on it, and
/// certifies them there. See `Loops_of_caller`.
class Caller_mesh
{
public:
  virtual ~Caller_mesh() = default;

  /// the coordinates of the vertices but for the hubs.
  virtual std::vector<Flat_surface::Point> coordinates(Execution execution) const = 0;

  /// takes pairs.
  virtual void convert(Execution execution, const std::vector<Flat_pair>& pairs) = 0;

  /// certifies and names them, see `certify_and_name()`.
  virtual Certificate certify(Execution execution,
                              const Flat_surface& surface,
                              const Class_options& wanted,
                              Loop_relations relations,
                              Progress& progress) = 0;
};

/// One computation: the passes, the right classes, the caller's own loops, their certificate and
/// their names. The pairs are with \p caller afterwards.
///
/// \throws Uncertified_loops_exception, Interrupted_exception, std::invalid_argument, and what the
///   passes throw
CGAL_HTL_CORE Certificate find_loops(Execution execution,
                                     const Flat_mesh& mesh,
                                     const Loop_request& request,
                                     Caller_mesh& caller,
                                     Progress& progress,
                                     Statistics& statistics);

} // namespace CGAL::Handle_tunnel_loops::internal

#ifndef CGAL_LINKED_WITH_HTL_CORE
#include <CGAL/Handle_tunnel_loops/internal/passes/find_loops_impl.h>
#endif

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIND_LOOPS_H
