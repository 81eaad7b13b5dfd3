// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_WRITER_H
#define HTLOOPS_MESH_WRITER_H

#include "generators/generators.h"
#include "mesh_types.h"
#include "read/soup.h"

#include <cstddef>
#include <string>

namespace htloops {

/// throws `Failure` if the name of a file does not tell a format that meshes can be written in.
void check_mesh_format(const std::string& file);

/// how the names of files may end that meshes are written to, for a sentence.
std::string words_of_written_meshes();

/// writes a mesh in the format that the extension tells; OFF on the standard output, "-". Each
/// coordinate reads back as exactly itself where the format has room for it. A unit and the like
/// are written where there is a place for them.
void write_mesh(const std::string& file,
                const CGAL::Handle_tunnel_loops::generators::Soup& mesh,
                const File_facts& facts = {});

/// whether such a file has a place for the unit of lengths.
bool has_unit(const std::string& file);

/// the properties that such a file has room for: all in PLY, colours in OFF, else none.
Vertex_properties kept_by_format(const std::string& file, const Vertex_properties& properties);

/// the colours of vertices as properties; `colour_of(v)` is that of one.
template <typename Colour_of>
Vertex_properties colour_properties(std::size_t number_of_vertices, Colour_of colour_of) {
  Vertex_properties properties = {
      {"red", "uchar", {}}, {"green", "uchar", {}}, {"blue", "uchar", {}}};
  for(std::size_t v = 0; v < number_of_vertices; ++v) {
    const auto colour = colour_of(v);
    for(std::size_t i = 0; i < 3; ++i)
      properties[i].values.push_back(colour[i]);
  }
  return properties;
}

/// writes a mesh of which elements may have been removed; the others keep their order. All vertices
/// have a value of each property, and the file has room for them. Only PLY has room for a comment.
void write_mesh(const std::string& file,
                const Mesh& mesh,
                const Vertex_properties& properties = {},
                const std::string& comment = "",
                const File_facts& facts = {});

} // namespace htloops

#endif // HTLOOPS_MESH_WRITER_H
