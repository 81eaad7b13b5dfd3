// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/picture_export.h"

#ifdef HTLOOPS_HAS_PICTURE

#include "failure.h"
#include "picture/picture.h"
#include "write/text_writer.h"

#include <stdexcept>

namespace htloops {
namespace {

std::array<double, 3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }

std::vector<std::array<double, 3>> points_of(const Mesh& mesh) {
  std::vector<std::array<double, 3>> points;
  points.reserve(mesh.number_of_vertices());
  for(const Point& p : mesh.points())
    points.push_back(coordinates(p));
  return points;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(mesh.number_of_faces());
  for(const Mesh::Face_index f : mesh.faces()) {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    triangles.push_back(
        {mesh.source(h).idx(), mesh.target(h).idx(), mesh.target(mesh.next(h)).idx()});
  }
  return triangles;
}

std::vector<htl_picture::Line> tubes_along(const Exported_lines& lines) {
  std::vector<htl_picture::Line> tubes;
  for(const Exported_line& line : lines.lines) {
    htl_picture::Line tube;
    for(const Point& p : line.points)
      tube.points.push_back(coordinates(p));
    tube.colour = line.colour;
    tube.closed = line.is_closed;
    tubes.push_back(std::move(tube));
  }
  return tubes;
}

} // namespace

void export_picture(const Picture_options& options,
                    const Mesh& mesh,
                    const Exported_lines& lines,
                    const std::vector<std::array<unsigned char, 3>>& face_colours) {
  htl_picture::Options picture;
  if(!options.view.empty())
    picture.view = {options.view[0], options.view[1], options.view[2]};
  if(!options.up.empty())
    picture.up = {options.up[0], options.up[1], options.up[2]};
  std::string content;
  try {
    content = htl_picture::encode_picture(points_of(mesh), triangles_of(mesh), face_colours,
                                          tubes_along(lines), picture);
  } catch(const std::runtime_error& error) {
    throw Failure(Exit_code::WRONG_USAGE, "--picture " + options.file + ": " + error.what());
  }
  // The file is begun when the picture is there, which takes its time, and never by libpng, which
  // would remove what it cannot write to.
  Text_writer out(options.file);
  out << content;
  out.finish();
}

std::string picture_of(const Mesh& mesh, const Exported_lines& lines) {
  htl_picture::Options picture;
  picture.width = 1000;
  picture.height = 750;
  return htl_picture::encode_picture(points_of(mesh), triangles_of(mesh), tubes_along(lines),
                                     picture);
}

} // namespace htloops

#endif // HTLOOPS_HAS_PICTURE
