// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Grid_graph.h"
#include "Random.h"
#include "Tubes.h"
#include "kinds.h"
#include "mesh_of_field.h"
#include "request_checks.h"

#include <cstddef>

namespace CGAL {
namespace Handle_tunnel_loops {
namespace generators {
namespace {

Soup make_shell(const Request& request) {
  constexpr double outer_radius = 0.24, inner_radius = 0.12;
  require_faces(request, "shell", 1000 + 600 * request.genus);
  Random random(request.seed);
  const std::size_t inner_genus = random.below(request.genus / 2 + 1);
  const std::size_t outer_genus = request.genus - inner_genus;
  const Grid_graph graph(outer_genus, random);
  const auto outer = graph.segments(), inner = graph.segments_with_cycles(inner_genus);
  // Thin tubes need as many faces as thick ones.
  const std::size_t inner_faces = request.faces * inner.size() / (inner.size() + outer.size());
  return joined(
      {mesh_of_field(Tubes(outer, outer_radius), {request.faces - inner_faces, outer_genus},
                     "shell"),
       reversed(mesh_of_field(Tubes(inner, inner_radius), {inner_faces, inner_genus}, "shell"))});
}

} // namespace

const Kind shell_kind = {
    "shell",
    "hollow tubes along the edges of a cubic grid, the hollow along some of them: a surface and "
    "one in it that share the handles; any genus g, from 1000 + 600 g faces",
    make_shell};

} // namespace generators
} // namespace Handle_tunnel_loops
} // namespace CGAL
