// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/soup_reader.h"

#include "read/non_finite_points.h"
#include "read/off_reader.h"
#include "read/ply_guard.h"
#include "read/stl_guard.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <boost/interprocess/streams/bufferstream.hpp>

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
void check_indices(const Input_file& file, const Soup& soup) {
  for(std::size_t i = 0; i < soup.faces.size(); ++i)
    for(const std::uint32_t vertex : soup.faces[i])
      if(vertex >= soup.points.size())
        fail_to_read(file, "face " + std::to_string(i) + " names a vertex that is not among the " +
                               std::to_string(soup.points.size()) + " of the file");
}

// As `CGAL::IO::read_polygon_soup()` of a file does, but for its second reading of an STL file,
// which only differs from the first where the ends of lines are translated.
bool read_polygon_soup(std::istream& stream, const std::string& extension, Soup& soup) {
  const auto quiet = CGAL::parameters::verbose(false);
  const bool may_be_binary = extension == "ply" || extension == "stl";
  CGAL::IO::set_mode(stream, may_be_binary ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  if(extension == "off")
    return CGAL::IO::read_OFF(stream, soup.points, soup.faces, quiet);
  if(extension == "obj")
    return CGAL::IO::read_OBJ(stream, soup.points, soup.faces, quiet);
  if(extension == "ply")
    return CGAL::IO::read_PLY(stream, soup.points, soup.faces, quiet);
  if(extension == "stl")
    return CGAL::IO::read_STL(stream, soup.points, soup.faces, quiet);
  return extension == "ts" && CGAL::IO::read_GOCAD(stream, soup.points, soup.faces, quiet);
}

void read_with_cgal(const Input_file& file, const std::string& extension, Soup& soup) {
  const std::string_view content = file.content();
  soup.points.set_limit(content.size());
  soup.faces.set_limit(content.size());
  boost::interprocess::ibufferstream stream(content.data(), content.size());
  bool is_read = false;
  try {
    is_read = read_polygon_soup(stream, extension, soup);
  } catch(const std::exception& exception) {
    fail_to_read(file, std::string("it cannot be read: ") + exception.what());
  }
  if(!is_read)
    check_points_are_finite(file, extension);
  if(!is_read && extension == "obj")
    check_indices(file, soup); // the reason, if all was read
  if(!is_read)
    fail_to_read(file, explain(extension, soup));
}

} // namespace

Soup read_soup(const Input_file& file) {
  const std::string extension = extension_of(file.name());
  Soup soup;
  if(extension == "off" && read_plain_off(file, soup))
    return soup;
  if(extension == "ply")
    check_ply(file);
  if(extension == "stl")
    check_stl(file);
  read_with_cgal(file, extension, soup);
  check_indices(file, soup);
  return soup;
}

} // namespace htloops
