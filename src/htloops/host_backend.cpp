// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "host_backend.h"

#include "interrupt.h"
#include "stopwatch.h"
#include "thread_limit.h"

#include <CGAL/Handle_tunnel_loops/parameters.h>
#include <CGAL/Handle_tunnel_loops_solver.h>

#include <CGAL/tags.h>

#include <functional>
#include <iterator>

namespace htloops {
namespace {

namespace parameters = CGAL::parameters;
using CGAL::Handle_tunnel_loops::Stage;

class Show_stages : public CGAL::Handle_tunnel_loops::Default_visitor
{
public:
  explicit Show_stages(Progress_bar& bar)
      : bar_(bar) {}

  void start_stage(Stage stage) { bar_.start(CGAL::Handle_tunnel_loops::stage_name(stage)); }

private:
  Progress_bar& bar_;
};

template <typename NamedParameters>
void solve(const Mesh& mesh, const NamedParameters& np, Answer& answer) {
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh, np);
  solver.template find_loops<CGAL::Parallel_if_available_tag>(std::back_inserter(answer.pairs), np);
  answer.statistics = solver.statistics();
  answer.certificate = solver.certificate();
}

} // namespace

Answer solve_on_host(const Mesh& mesh, const Solve_options& options, Progress_bar& bar) {
  const Thread_limit limit(options.number_of_threads);
  Show_stages visitor(bar);
  const std::function<bool(double)> callback = [&bar](double fraction) {
    bar.update(fraction);
    return interrupting_signal() == 0;
  };
  const auto np = parameters::do_refine_handles(
      options.do_refine_handles,
      parameters::do_tighten(options.do_tighten,
                             parameters::do_compute_linking(
                                 options.do_compute_linking,
                                 parameters::callback(callback).visitor(std::ref(visitor)))));

  Answer answer;
  answer.backend = "host";
  answer.number_of_threads = limit.number_of_threads();
  const Stopwatch stopwatch;
  if(options.seed)
    solve(mesh, parameters::seed_vertex(*options.seed, np), answer);
  else
    solve(mesh, np, answer);
  answer.total_seconds = stopwatch.seconds();
  bar.erase();
  return answer;
}

} // namespace htloops
