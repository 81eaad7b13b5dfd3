// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_ANSWER_H
#define HTLOOPS_ANSWER_H

#include "Unit.h"
#include "mesh_types.h"

#include "solve/boundaries.h"
#include "solve/throat_solver.h"

#include <CGAL/Handle_tunnel_loops/Certificate_record.h>
#include <CGAL/Handle_tunnel_loops/Handle_measures.h>
#include <CGAL/Handle_tunnel_loops/Removal_costs.h>
#include <CGAL/Handle_tunnel_loops/Round_bore.h>
#include <CGAL/Handle_tunnel_loops/stages.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

using CGAL::Handle_tunnel_loops::Certificate;
using CGAL::Handle_tunnel_loops::Loop_linking;
using CGAL::Handle_tunnel_loops::Statistics;

/// How the fronts of the first pass came to the vertices: by vertex, the layer, from 1, and the
/// time in steps. Those that have no faces are in layer 0, and have the time -1. Empty unless asked
/// for.
struct Vertex_layers
{
  std::vector<std::size_t> layers;
  std::vector<double> times;
};

using Bore = CGAL::Handle_tunnel_loops::Round_bore<Point>;

/// By pair, the bore that its tunnel loop goes around, if that is one; empty if nobody looked.
using Bores = std::vector<std::optional<Bore>>;

using Ball = CGAL::Handle_tunnel_loops::Threaded_ball<Point>;
using Measure = CGAL::Handle_tunnel_loops::Handle_measures<Point>;

/// By pair; empty if nobody measured.
using Measures = std::vector<Measure>;

/// By pair, what it would take to remove its handle; empty if nobody asked.
using Costs = std::vector<CGAL::Handle_tunnel_loops::Removal_costs>;

/// What a backend returns: certified pairs, and how they were found. Boundaries and bores are
/// looked for by `add_details()`, measures are taken by `find_measures()`, costs
/// are told by `find_costs()`.
struct Answer
{
  Pairs pairs;
  std::vector<std::size_t> components; ///< that the pairs are on; empty if there is one
  Boundaries boundaries;
  Bores bores;
  Measures measures;
  Costs costs;
  Throats throats;
  Statistics statistics;
  Vertex_layers vertex_layers;
  std::string backend;
  int number_of_threads = 1;
  double total_seconds = 0.; ///< without reading and writing
  Certificate certificate;
  Unit unit = Unit::NONE; ///< of lengths, if the file of the mesh tells it
};

} // namespace htloops

#endif // HTLOOPS_ANSWER_H
