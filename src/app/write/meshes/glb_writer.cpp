// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/Gltf_document.h"
#include "write/meshes/single_precision.h"

namespace htloops {

void write_glb(Text_writer& out, const Written_mesh& written) {
  check_single_precision(written);
  Gltf_document document;
  if(!written.mesh.triangles.empty())
    document.add_node("surface", written.mesh.points, {}, written.mesh.triangles);
  Json root = {{"name", "all"}};
  const double scale = words_of(written.facts.unit).metres;
  if(scale != 1.)
    root["scale"] = {scale, scale, scale};
  out << document.file(std::move(root));
}

} // namespace htloops
