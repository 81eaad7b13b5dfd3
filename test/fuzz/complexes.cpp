// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors
//
// Small complexes, closed or not, manifold or not, at any coordinates: what is a surface, or is
// made one, has certified loops as many as its genus says, cuts to disks and a Reeb graph.

#include "fuzz_target.h"

#include "mend/mending.h"
#include "mesh_types.h"
#include "read/soup_diagnosis.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>
#include <CGAL/Handle_tunnel_loops_solver.h>
#include <CGAL/cut_to_disk.h>
#include <CGAL/reeb_graph.h>

#include <cstring>
#include <iterator>
#include <vector>

namespace {

using namespace htloops;

// The first byte is the number of vertices, and what their coordinates are: small integers, so that
// many coincide, or any doubles. The rest are faces, three bytes each.
Soup soup_of(const std::string& input) {
  Soup soup;
  if(input.empty())
    return soup;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(input[i]); };
  const std::uint32_t n = 3 + byte(0) % 30;
  const bool has_doubles = byte(0) >= 128;
  std::size_t at = 1;
  const auto coordinate = [&] {
    double x = 0.;
    if(has_doubles && at + sizeof x <= input.size()) {
      std::memcpy(&x, input.data() + at, sizeof x);
      at += sizeof x;
    } else if(at < input.size())
      x = double(byte(at++) % 8);
    return x;
  };
  for(std::uint32_t v = 0; v < n; ++v) {
    const double x = coordinate(), y = coordinate();
    soup.points.emplace_back(x, y, coordinate());
  }
  for(; at + 3 <= input.size() && soup.faces.size() < 200; at += 3) {
    soup.faces.emplace_back();
    soup.faces.back().resize(3);
    for(std::size_t i = 0; i < 3; ++i)
      soup.faces.back()[i] = byte(at + i) % n;
  }
  return soup;
}

void solve(const Mesh& mesh) {
  CGAL::Handle_tunnel_loops_solver<Mesh> solver(mesh);
  Pairs pairs;
  solver.find_loops(std::back_inserter(pairs));
  require(pairs.size() == solver.genus(), "there are as many pairs as handles");
  require(bool(CGAL::certify_handle_tunnel_loops(mesh, pairs)), "the loops are certified");
  std::vector<Mesh::Edge_index> cut;
  CGAL::cut_to_disk(mesh, std::back_inserter(cut), CGAL::parameters::known_loops(pairs));
  const auto number_of_cycles = [&](bool is_capped) {
    CGAL::Handle_tunnel_loops::Reeb_options options;
    options.capped = is_capped;
    CGAL::Reeb_graph<Mesh> graph;
    CGAL::reeb_graph(mesh, graph, CGAL::parameters::reeb_options(options));
    return num_edges(graph) + solver.number_of_components() - num_vertices(graph);
  };
  require(number_of_cycles(true) == solver.genus(),
          "a capped Reeb graph has as many cycles as there are handles");
  const std::size_t cycles = number_of_cycles(false);
  require(cycles >= solver.genus() && (cycles == solver.genus() || !CGAL::is_closed(mesh)),
          "a Reeb graph has as many cycles, or more at a boundary");
}

void solve_if_sound(const Soup& soup) {
  const Built_mesh built = build_mesh(soup);
  require(built.defects.size() == diagnose(soup).size(), "what is built is sound");
  if(built.defects.empty())
    solve(built.mesh);
}

} // namespace

void fuzz_complexes(const std::string& input) {
  const Soup soup = soup_of(input);
  solve_if_sound(soup);
  solve_if_sound(mend(soup, {false, true}).soup);
}
