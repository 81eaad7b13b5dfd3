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
#include <CGAL/boost/graph/generators.h>

namespace {

// A torus of 4 times 4 squares; the seeds are about it.
htloops::Mesh make_torus() {
  htloops::Mesh mesh;
  std::vector<htloops::Mesh::Vertex_index> v;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j)
      v.push_back(mesh.add_vertex(htloops::Point(i, j, i * j)));
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < 4; ++j) {
      const auto a = v[4 * i + j], b = v[4 * ((i + 1) % 4) + j], c = v[4 * i + (j + 1) % 4],
                 d = v[4 * ((i + 1) % 4) + (j + 1) % 4];
      mesh.add_face(a, b, d);
      mesh.add_face(a, d, c);
    }
  return mesh;
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
