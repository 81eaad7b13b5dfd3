// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors
//
// A file of loops, read and bound to a mesh, and certified there: whatever it says, and of whatever
// mesh it was, the answer is a certificate or a refusal.

#include "fuzz_target.h"

#include "failure.h"
#include "mesh_types.h"
#include "read/loops_reader.h"

#include <CGAL/Handle_tunnel_loops/certificate.h>

#include <array>
#include <utility>
#include <vector>

namespace {

// A torus of 4 times 4 squares; the seeds are about it.
htloops::Mesh make_torus() {
  std::vector<htloops::Point> points;
  std::vector<std::array<int, 3>> triangles;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j) {
      points.emplace_back(i, j, i * j);
      const int a = 4 * i + j, b = 4 * ((i + 1) % 4) + j, c = 4 * i + (j + 1) % 4,
                d = 4 * ((i + 1) % 4) + (j + 1) % 4;
      triangles.insert(triangles.end(), {{a, b, d}, {a, d, c}});
    }
  return {std::move(points), triangles};
}

} // namespace

void fuzz_loops_json(const std::string& input) {
  static const htloops::Mesh mesh = make_torus();
  try {
    const htloops::Bound_loops loops = htloops::bind_loops(
        htloops::read_loops_json(htloops::Input_file::in_memory("loops.json", input)), mesh);
    if(loops.problems.empty())
      CGAL::certify_handle_tunnel_loops(mesh, loops.pairs);
  } catch(const htloops::Failure&) {
  }
}
