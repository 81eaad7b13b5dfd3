// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_READERS_H
#define HTLOOPS_READERS_H

#include "read/input_file.h"
#include "read/soup.h"

namespace htloops {

// One for each format. Vertices keep the order of the file; points of formats that have no
// vertices, as STL, are numbered as they come, equal ones being one. Each throws `Failure`, which
// names the place, if the content is malformed, ends too early, or names a vertex that is not
// there.

/// reads OFF, also with homogeneous coordinates; colours, normals and texture coordinates are
/// passed over.
Soup read_off(const Input_file& file);

/// reads the vertices and faces of OBJ; all else that the format has is passed over.
Soup read_obj(const Input_file& file);

/// reads the vertices and faces of PLY, in text or binary form, of whatever type their numbers are;
/// all else is passed over.
Soup read_ply(const Input_file& file);

/// reads STL, in text or binary form.
Soup read_stl(const Input_file& file);

/// reads all triangles of the scene of glTF 2.0, in one file or in text with buffers beside it,
/// where its nodes put them. What is compressed is refused by name.
Soup read_gltf(const Input_file& file);

/// reads all objects of a package of 3MF that are to be built, where its items put them.
Soup read_3mf(const Input_file& file);

/// reads the polygons and strips of PolyData, or the faces of an UnstructuredGrid, of VTK's XML.
Soup read_vtk(const Input_file& file);

/// reads the points and triangles of GIFTI.
Soup read_gifti(const Input_file& file);

/// reads a surface of FreeSurfer, of triangles.
Soup read_freesurfer(const Input_file& file);

/// whether a content begins as a surface of FreeSurfer does, whose names end as they like.
bool is_freesurfer(std::string_view content);

/// reads the triangles and quadrangles of Gmsh's formats 2 and 4, as text or bytes; of curved ones
/// the corners.
Soup read_msh(const Input_file& file);

} // namespace htloops

#endif // HTLOOPS_READERS_H
