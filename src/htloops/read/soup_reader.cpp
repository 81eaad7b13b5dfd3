// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup_reader.h"

#include "read/input_file.h"
#include "read/obj_reader.h"
#include "read/off_reader.h"
#include "read/ply_reader.h"
#include "read/stl_guard.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace htloops {
namespace {

// Without its dot, in lower case.
std::string extension_of(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  extension.erase(0, 1);
  for(char& c : extension)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

bool is_known(const std::string& extension) {
  const char* known[] = {"off", "obj", "ply", "stl", "ts"};
  return std::find(std::begin(known), std::end(known), extension) != std::end(known);
}

// CGAL says no more than whether it could read the file.
std::string explain(const std::string& extension, const Soup& soup) {
  if(!is_known(extension))
    return "the format follows from the extension, which is one of .off, .obj, .ply, .stl and .ts";
  std::string problem = "it is malformed or ends too early";
  if(extension == "stl") // may have been read twice, as text and as binary
    return problem;
  return problem + " (reading stopped after " + std::to_string(soup.points.size()) +
         " vertices and " + std::to_string(soup.faces.size()) + " faces)";
}

// Not every reader of CGAL checks this.
void check_indices(const std::string& file, const Soup& soup) {
  for(std::size_t i = 0; i < soup.faces.size(); ++i)
    for(const std::uint32_t vertex : soup.faces[i])
      if(vertex >= soup.points.size())
        fail_to_read(file, "face " + std::to_string(i) + " names a vertex that is not among the " +
                               std::to_string(soup.points.size()) + " of the file");
}

void read_with_cgal(const std::string& file, const std::string& extension, Soup& soup) {
  const auto size = static_cast<std::size_t>(size_of_file(file));
  soup.points.set_limit(size);
  soup.faces.set_limit(size);
  bool is_read = false;
  try {
    is_read = CGAL::IO::read_polygon_soup(file, soup.points, soup.faces,
                                          CGAL::parameters::verbose(false));
  } catch(const std::exception& exception) {
    fail_to_read(file, std::string("it cannot be read: ") + exception.what());
  }
  if(!is_read)
    fail_to_read(file, explain(extension, soup));
}

} // namespace

Soup read_soup(const std::string& file) {
  const std::string extension = extension_of(file);
  Soup soup;
  if(extension == "off")
    return read_off(file, read_whole_file(file));
  if(extension == "obj")
    return read_obj(file, read_whole_file(file));
  if(extension == "ply")
    return read_ply(file, read_whole_file(file));
  if(extension == "stl")
    check_stl(file);
  read_with_cgal(file, extension, soup);
  check_indices(file, soup);
  return soup;
}

} // namespace htloops
