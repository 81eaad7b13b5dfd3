// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_REQUESTED_SOUP_H
#define BENCHMARK_REQUESTED_SOUP_H

#include "generators/generators.h"

#include <sstream>
#include <stdexcept>
#include <string>

/// \file Requested_soup.h
/// Generated meshes by their names on a command line.

/// the mesh that is given as KIND:FACES:GENUS[:HOLES[:FACES OF EACH[:ragged]]].
inline CGAL::Handle_tunnel_loops::generators::Soup generate(const std::string& request) {
  std::istringstream in(request);
  std::string name, faces, genus, holes, hole_faces, is_ragged;
  std::getline(in, name, ':');
  std::getline(in, faces, ':');
  std::getline(in, genus, ':');
  std::getline(in, holes, ':');
  std::getline(in, hole_faces, ':');
  std::getline(in, is_ragged, ':');
  for(const auto& kind : CGAL::Handle_tunnel_loops::generators::kinds())
    if(kind.name == name) {
      CGAL::Handle_tunnel_loops::generators::Request r;
      r.faces = std::stoul(faces);
      r.genus = std::stoul(genus);
      if(holes.empty())
        return kind.make(r);
      CGAL::Handle_tunnel_loops::generators::Hole_request h;
      h.number = std::stoul(holes);
      if(!hole_faces.empty())
        h.faces = std::stoul(hole_faces);
      h.is_ragged = is_ragged == "ragged";
      h.may_be_fewer = true;
      return with_holes(kind.make(r), h);
    }
  throw std::runtime_error("no such kind of mesh: " + name);
}

/// a `CGAL::Surface_mesh` of a soup.
template <typename Mesh> Mesh mesh_of(const CGAL::Handle_tunnel_loops::generators::Soup& soup) {
  using Vertex = typename Mesh::Vertex_index;
  Mesh mesh;
  for(const auto& [x, y, z] : soup.points)
    mesh.add_vertex({x, y, z});
  for(const auto& [a, b, c] : soup.triangles)
    mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  return mesh;
}

#endif // BENCHMARK_REQUESTED_SOUP_H
