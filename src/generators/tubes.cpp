// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "Tubes.h"
#include "Random.h"
#include "kinds.h"
#include "mesh_of_field.h"

#include <cstddef>
#include <vector>

namespace CGAL::Handle_tunnel_loops::generators {
namespace {

Soup make_foam(const Request& request) {
  constexpr double jitter = 0.22, least_radius = 0.1, most_radius = 0.2;
  require_faces(request, "foam", 600 + 600 * request.genus);
  Random random(request.seed);
  const auto segments = Grid_graph(request.genus, random, jitter).segments();
  std::vector<double> radii;
  for(std::size_t i = 0; i < segments.size(); ++i)
    radii.push_back(random.uniform(least_radius, most_radius));
  return mesh_of_field(Tubes(segments, radii), request, "foam");
}

/// tubes along the edges of a grid, moved by the same distance along all axes.
Soup make_grid(double moved, const Request& request, Random& random) {
  constexpr double jitter = 0.05, radius = 0.14;
  auto segments = Grid_graph(request.genus, random, jitter).segments();
  for(auto& [a, b] : segments) {
    a += Vector(moved, moved, moved);
    b += Vector(moved, moved, moved);
  }
  return mesh_of_field(Tubes(segments, radius), request, "interlaced");
}

Soup make_interlaced(const Request& request) {
  require_faces(request, "interlaced", 1000 + 400 * request.genus);
  Random random(request.seed);
  const std::size_t genus = request.genus / 2, faces = request.faces / 2;
  const Soup first = make_grid(0., {request.faces - faces, request.genus - genus}, random);
  return joined({first, make_grid(0.5, {faces, genus}, random)});
}

Soup make_lattice(const Request& request) {
  require_faces(request, "lattice", 400 + 250 * request.genus);
  Random random(request.seed);
  return mesh_of_field(Tubes(Grid_graph(request.genus, random).segments()), request, "lattice");
}

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

const Kind foam_kind = {
    "foam",
    "struts of random radii along the edges of a grid whose nodes are moved at random; any genus "
    "g, from 600 + 600 g faces",
    make_foam};

const Kind interlaced_kind = {
    "interlaced",
    "two grids of tubes, each through the holes of the other; any genus g, half of it each, from "
    "1000 + 400 g faces",
    make_interlaced};

const Kind lattice_kind = {
    "lattice",
    "tubes along the edges of a cubic grid, some of them left out at random; any genus g, from "
    "400 + 250 g faces",
    make_lattice};

const Kind shell_kind = {
    "shell",
    "hollow tubes along the edges of a cubic grid, the hollow along some of them: a surface and "
    "one in it that share the handles; any genus g, from 1000 + 600 g faces",
    make_shell};

} // namespace CGAL::Handle_tunnel_loops::generators
