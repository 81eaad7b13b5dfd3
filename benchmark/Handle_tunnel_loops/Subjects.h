// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_SUBJECTS_H
#define BENCHMARK_SUBJECTS_H

#include "Command_line.h"
#include "Corpus_answer.h"
#include "Requested_soup.h"

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <optional>

/// \file Subjects.h
/// The meshes of an experiment: shapes that are generated, and those of files.

namespace corpus {

/// A closed mesh with handles.
struct Subject
{
  std::string name;
  Mesh mesh;
  std::size_t genus;
};

/// a generated shape, see `generate()`.
inline Subject generated_subject(const std::string& request) {
  const auto soup = generate(request);
  return {request.substr(0, request.find(':')), mesh_of<Mesh>(soup), HTL::generators::genus(soup)};
}

/// the mesh of a file, unless it cannot be read, has too many faces or no handles, or is refused.
inline std::optional<Subject> subject_of_file(const std::filesystem::path& file,
                                              std::size_t most_faces) {
  Subject subject{file.filename().string(), {}, 0};
  Mesh& mesh = subject.mesh;
  if(!CGAL::IO::read_polygon_mesh(file.string(), mesh) &&
     !CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file.string(), mesh))
    return std::nullopt;
  if(mesh.number_of_faces() > most_faces)
    return std::nullopt;
  try {
    subject.genus =
        Solver(CGAL::Sequential_tag(), mesh, CGAL::parameters::default_values()).genus();
  } catch(const HTL::Invalid_mesh_exception&) {
    return std::nullopt;
  }
  return subject.genus == 0 ? std::nullopt : std::optional<Subject>(std::move(subject));
}

/// round and thin shapes, regular ones and such as are not, with few long triangles and with small
/// handles beside large ones.
inline const std::vector<std::string>& generated_shapes() {
  static const std::vector<std::string> shapes = {
      "torus:3000:1",  "knot:4000:1",   "multi-torus:5000:3", "lattice:6000:5", "gyroid:6000:6",
      "sponge:3000:9", "plates:1000:6", "foam:8000:4",        "chair:12000:7",  "coral:8000:6"};
  return shapes;
}

template <typename Function> void for_each_generated_subject(const Function& f) {
  for(const std::string& shape : generated_shapes())
    f(generated_subject(shape));
}

/// those of the command line that have no more faces than its option `--faces` says.
template <typename Function>
void for_each_subject_of_files(const Command_line& line,
                               std::size_t most_faces,
                               const Function& f) {
  for(const auto& file : line.files())
    if(const auto subject = subject_of_file(file, line.number("--faces", most_faces)))
      f(*subject);
}

/// the ten generated shapes, then those of the command line.
template <typename Function>
void for_each_subject(const Command_line& line, std::size_t most_faces, const Function& f) {
  for_each_generated_subject(f);
  for_each_subject_of_files(line, most_faces, f);
}

} // namespace corpus

#endif // BENCHMARK_SUBJECTS_H
