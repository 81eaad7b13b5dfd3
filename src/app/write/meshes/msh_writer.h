// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MSH_WRITER_H
#define HTLOOPS_MSH_WRITER_H

#include "generators/generators.h"
#include "write/files.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace htloops {

/// Triangles of a mesh, by their numbers, under a name without quotes.
struct Named_faces
{
  std::string name;
  std::vector<std::uint32_t> faces;
};

/// Edges from vertex to vertex under such a name; one that counts twice comes twice.
struct Named_edges
{
  std::string name;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

/// What solvers call physical groups. Faces that are in none make one, `surface`.
struct Named_groups
{
  std::vector<Named_faces> faces;
  std::vector<Named_edges> edges;
};

/// write a mesh with its groups as Gmsh does, as text, in version 4.1 or 2.2 of the format. Groups
/// are numbered from 1, those of faces first, whatever their dimension. What is in several groups
/// is there several times, once for each.
void write_msh4(Text_writer& out,
                const CGAL::Handle_tunnel_loops::generators::Soup& mesh,
                const Named_groups& groups = {});
void write_msh2(Text_writer& out,
                const CGAL::Handle_tunnel_loops::generators::Soup& mesh,
                const Named_groups& groups = {});

} // namespace htloops

#endif // HTLOOPS_MSH_WRITER_H
