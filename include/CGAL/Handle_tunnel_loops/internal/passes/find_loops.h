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
#include <CGAL/Handle_tunnel_loops/internal/certificate/Triangle_list.h>
#include <CGAL/Handle_tunnel_loops/internal/field/Swept_vertices.h>
#include <CGAL/Handle_tunnel_loops/internal/homology/Class_options.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/passes/backend.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
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

/// The mesh of a caller, for what knows no type of mesh: it holds pairs of loops on it. See
/// `Loops_of_caller`.
class Caller_mesh
{
public:
  virtual ~Caller_mesh() = default;

  /// the coordinates of the vertices but for the hubs.
  virtual std::vector<Simple_cartesian<double>::Point_3> coordinates(Execution execution) const = 0;

  /// takes pairs.
  virtual void convert(Execution execution, const std::vector<Flat_pair>& pairs) = 0;

  /// reads the mesh anew, for the certificate.
  virtual Triangle_list triangles(Execution execution, bool with_points) const = 0;

  /// the loops of the pairs as they are on the mesh, handles and tunnels in turn.
  virtual std::vector<Listed_loop> listed_loops() const = 0;

  /// changes which loop of a pair is the handle and which the tunnel.
  virtual void exchange(std::size_t pair) = 0;
};

class Progress;

/// Who is told how far a computation has come. The callback returns whether to go on.
struct Listeners
{
  std::function<bool(double)> callback;
  std::function<void(Stage)> start_stage = [](Stage) {}, end_stage = [](Stage) {};
};

/// One computation: the passes, the right classes, the caller's own loops, their certificate and
/// their names. The pairs are with \p caller afterwards.
///
/// \throws Uncertified_loops_exception, Interrupted_exception, std::invalid_argument, and what the
///   passes throw
Certificate find_loops(Execution execution,
                       const Flat_mesh& mesh,
                       const Loop_request& request,
                       Caller_mesh& caller,
                       Progress& progress,
                       Statistics& statistics);

Certificate find_loops(Execution execution,
                       const Flat_mesh& mesh,
                       const Loop_request& request,
                       Caller_mesh& caller,
                       const Listeners& listeners,
                       Statistics& statistics);

/// pairs of loops as they are found on the arrays, for what goes on there. The seeds of the request
/// are those of the mesh, and nothing is asked of it but pairs. \p coordinates are those of the
/// vertices but for the hubs.
std::vector<Flat_pair> loops_on_arrays(Execution execution,
                                       const Flat_mesh& mesh,
                                       std::vector<Simple_cartesian<double>::Point_3> coordinates,
                                       Loop_request request,
                                       const std::function<bool(double)>& callback = {});

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_PASSES_FIND_LOOPS_H
