// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_WRITERS_H
#define HTLOOPS_WRITERS_H

#include "generators/generators.h"
#include "mesh_types.h"
#include "read/soup.h"
#include "write/files.h"

#include <string>

namespace htloops {

/// What a file of a mesh is to tell; properties are as long as there are points.
struct Written_mesh
{
  const CGAL::Handle_tunnel_loops::generators::Soup& mesh;
  const Vertex_properties& properties;
  const std::string& comment;
  const File_facts& facts;
};

/// what a comment says of the unit, after some words; empty if none is known.
std::string comment_on_unit(const char* before, const Written_mesh& written, const char* after);

// One for each format. Those of text write numbers that read back as exactly themselves.

void write_off(Text_writer& out, const Written_mesh& written);
void write_obj(Text_writer& out, const Written_mesh& written);
void write_ply(Text_writer& out, const Written_mesh& written);
void write_stl_text(Text_writer& out, const Written_mesh& written);

// VTK's XML, as text or as bytes in base 64.
void write_polydata(Text_writer& out, const Written_mesh& written);
void write_polydata_bytes(Text_writer& out, const Written_mesh& written);
void write_grid(Text_writer& out, const Written_mesh& written);
void write_grid_bytes(Text_writer& out, const Written_mesh& written);

/// in the unit of the coordinates if it is known, else in millimeters.
void write_3mf(Text_writer& out, const Written_mesh& written);

// In these, numbers are rounded to single precision.

/// Throws `Failure` if points would fall together, as STL has no vertices but by their places.
void write_stl(Text_writer& out, const Written_mesh& written);

/// in meters: if the coordinates are known to be of another unit, a node scales them.
void write_glb(Text_writer& out, const Written_mesh& written);

// in millimeters.
void write_gifti(Text_writer& out, const Written_mesh& written);

/// with the geometry of the volume that the file had from which the mesh is.
void write_freesurfer(Text_writer& out, const Written_mesh& written);

} // namespace htloops

#endif // HTLOOPS_WRITERS_H
