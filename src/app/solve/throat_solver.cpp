// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "solve/throat_solver.h"

#include "solve/progress.h"

#include <CGAL/throats.h>

#include <algorithm>
#include <iterator>

namespace htloops {
namespace {

Throats wanted_throats(const Pairs& pairs, const CGAL::Handle_tunnel_loops::Certificate& of_pairs) {
  Throats throats;
  throats.are_wanted = true;
  throats.are_sides_known = of_pairs.handles_bound_inside_alone == pairs.size() &&
                            of_pairs.tunnels_bound_outside_alone == pairs.size();
  return throats;
}

} // namespace

Throats find_throats(const Mesh& mesh,
                     const Pairs& pairs,
                     const CGAL::Handle_tunnel_loops::Certificate& certificate,
                     const std::vector<Mesh::Vertex_index>& through,
                     double least_prominence) {
  const Stopwatch stopwatch;
  Throats throats = wanted_throats(pairs, certificate);
  CGAL::throats<All_threads_tag>(
      mesh, pairs, std::back_inserter(throats.all),
      CGAL::parameters::through_vertices(through,
                                         CGAL::parameters::least_prominence(least_prominence)));
  for(const Mesh::Vertex_index v : through)
    if(std::none_of(throats.all.begin(), throats.all.end(), [v](const Throat& throat) {
         return std::find(throat.through.begin(), throat.through.end(), v) != throat.through.end();
       }))
      throats.in_vain.push_back(v);
  throats.seconds = stopwatch.seconds();
  return throats;
}

Throats classified_throats(const Mesh& mesh,
                           const Pairs& pairs,
                           const CGAL::Handle_tunnel_loops::Certificate& certificate,
                           const std::vector<Loop>& loops) {
  Throats throats = wanted_throats(pairs, certificate);
  throats.all =
      internal::Throats_of_caller(internal::execution_of<All_threads_tag>(), mesh,
                                  get(CGAL::vertex_point, mesh), get(boost::vertex_index, mesh))
          .classified(pairs, loops);
  return throats;
}

} // namespace htloops
