// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "export_lines.h"

#include "export_formats.h"
#include "failure.h"

#include <string_view>

namespace htloops {
namespace {

struct Format
{
  std::string_view suffix;
  void (*write)(Text_writer&, const Exported_lines&);
};

constexpr Format formats[] = {
    {".ply", write_lines_ply},
    {".obj", write_lines_obj},
    {".polylines.txt", write_lines_polylines},
    {".vtp", write_lines_vtp},
};

const Format& format_of(std::string_view file) {
  std::string known;
  for(const Format& format : formats) {
    if(file.size() > format.suffix.size() &&
       file.substr(file.size() - format.suffix.size()) == format.suffix)
      return format;
    known += " " + std::string(format.suffix);
  }
  throw Failure(Exit_code::WRONG_USAGE,
                "--lines " + std::string(file) + ": the name must end in one of" + known);
}

} // namespace

void check_lines_format(const std::string& file) { format_of(file); }

void export_lines(const std::string& file, const Exported_lines& lines) {
  Text_writer out(file);
  format_of(file).write(out, lines);
  out.finish();
}

} // namespace htloops
