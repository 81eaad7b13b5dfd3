// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/mesh_writer.h"

#include "read/meshes/mesh_formats.h"
#include "write/files.h"
#include "write/meshes/msh_writer.h"
#include "write/meshes/writers.h"

namespace htloops {
namespace {

namespace generators = CGAL::Handle_tunnel_loops::generators;

template <void (*write_groups)(Text_writer&, const generators::Soup&, const Named_groups&)>
void write_msh(Text_writer& out, const Written_mesh& written) {
  write_groups(out, written.mesh, {});
}

constexpr File_format<void(Text_writer&, const Written_mesh&)> mesh_formats[] = {
    {".off", write_off},
    {".obj", write_obj},
    {".ply", write_ply},
    {".ascii.stl", write_stl_text},
    {".stl", write_stl},
    {".glb", write_glb},
    {".3mf", write_3mf},
    {".binary.vtp", write_polydata_bytes},
    {".vtp", write_polydata},
    {".binary.vtu", write_grid_bytes},
    {".vtu", write_grid},
    {".msh", write_msh<write_msh4>},
    {".msh2", write_msh<write_msh2>},
    {".gii", write_gifti},
    {".surf", write_freesurfer},
};

// The standard output has no name that could tell a format, and FreeSurfer's surfaces have many.
std::string name_with_format(const std::string& file) {
  return file == "-" ? "mesh.off" : is_named_as_freesurfer(file) ? "mesh.surf" : file;
}

const auto& format_of(const std::string& file) {
  return format_of(name_with_format(file), mesh_formats);
}

generators::Soup soup_of(const Mesh& mesh) {
  generators::Soup soup;
  soup.points.reserve(mesh.number_of_vertices());
  soup.triangles.reserve(mesh.number_of_faces());
  for(const Point& p : mesh.points())
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    soup.triangles.push_back(
        {mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return soup;
}

void write(const std::string& file, const Written_mesh& written) {
  Text_writer out(file);
  format_of(file).write(out, written);
  out.finish();
}

} // namespace

void check_mesh_format(const std::string& file) {
  check_format(name_with_format(file), mesh_formats);
}

std::string words_of_written_meshes() {
  std::string words;
  for(const auto& format : mesh_formats)
    words += (words.empty() ? "\n" : " ") + std::string(format.suffix);
  return words;
}

void write_mesh(const std::string& file, const generators::Soup& mesh, const File_facts& facts) {
  write(file, {mesh, {}, "", facts});
}

bool has_unit(const std::string& file) {
  const auto write = format_of(file).write;
  return write == write_glb || write == write_3mf || write == write_gifti ||
         write == write_freesurfer;
}

Vertex_properties kept_by_format(const std::string& file, const Vertex_properties& properties) {
  const auto& format = format_of(file);
  if(format.write == write_ply)
    return properties;
  Vertex_properties colours;
  if(format.write == write_off)
    for(const char* name : {"red", "green", "blue", "alpha"})
      for(const Vertex_property& property : properties)
        if(property.name == name)
          colours.push_back(property);
  return colours.size() < 3 ? Vertex_properties() : colours;
}

void write_mesh(const std::string& file,
                const Mesh& mesh,
                const Vertex_properties& properties,
                const std::string& comment,
                const File_facts& facts) {
  write(file, {soup_of(mesh), properties, comment, facts});
}

} // namespace htloops
