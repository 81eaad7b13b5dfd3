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

std::vector<htl_picture::Line> tubes_along(const Exported_lines& lines) {
  std::vector<htl_picture::Line> tubes;
  for(const Exported_line& line : lines.lines)
    tubes.push_back({coordinates(line.points), line.colour, line.is_closed});
  return tubes;
}

} // namespace

void export_picture(const std::string& file,
                    const View& view,
                    const Drawn_surface& surface,
                    const Exported_lines& lines) {
  htl_picture::Options picture;
  const auto [from, up] = whole_view(view, surface);
  picture.view = from;
  picture.up = up;
  std::string content;
  try {
    content = htl_picture::encode_picture(surface.points, surface.triangles, surface.colours,
                                          tubes_along(lines), picture);
  } catch(const std::runtime_error& error) {
    throw Failure(Exit_code::WRONG_USAGE, "--picture " + file + ": " + error.what());
  }
  // The file is begun when the picture is there, which takes its time, and never by libpng, which
  // would remove what it cannot write to.
  Text_writer out(file);
  out << content;
  out.finish();
}

} // namespace htloops

#endif // HTLOOPS_HAS_PICTURE
