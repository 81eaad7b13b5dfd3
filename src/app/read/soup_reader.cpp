// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup_reader.h"

#include "read/formats.h"

#include <string_view>

namespace htloops {
namespace {

bool is_of_text(char c) { return c == '\t' || c == '\n' || c == '\r' || (' ' <= c && c <= '~'); }

// By the mark and the first character: the header of a binary file may begin as it likes.
bool is_utf16(std::string_view content) {
  if(content.size() < 4)
    return false;
  const std::string_view mark = content.substr(0, 2);
  return (mark == "\xFF\xFE" && is_of_text(content[2]) && content[3] == '\0') ||
         (mark == "\xFE\xFF" && content[2] == '\0' && is_of_text(content[3]));
}

} // namespace

Soup read_soup(const Input_file& file) {
  if(is_utf16(file.content()))
    fail_to_read(file.name(), "the file is UTF-16; save it as UTF-8 or ASCII");
  if(file.is_of_format(".off"))
    return read_off(file.name(), file.content());
  if(file.is_of_format(".obj"))
    return read_obj(file.name(), std::string(file.content()));
  if(file.is_of_format(".ply"))
    return read_ply(file.name(), file.content());
  if(file.is_of_format(".stl"))
    return read_stl(file.name(), file.content());
  fail_to_read(file.name(),
               "its format, which follows from the extension, is not supported; those that are: "
               ".off .obj .ply .stl (--format says which one it is whatever its name)");
}

} // namespace htloops
