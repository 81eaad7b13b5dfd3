// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/off_reader.h"

#include "read/off_header.h"
#include "read/soup_words.h"
#include "words.h"

#include <algorithm>

namespace htloops {
namespace {

class Off_parser
{
public:
  Off_parser(const std::string& file, std::string_view text)
      : size_of_text_(text.size())
      , text_(file, text)
      , header_(read_off_header(text_)) {}

  Soup parse() {
    read_points();
    read_faces();
    text_.expect_end("the last of " + counted(header_.number_of_faces, "face", "faces"));
    return std::move(soup_);
  }

private:
  // No more than what the text has room for, whatever its header says.
  template <typename Elements> void reserve(Elements& elements, std::size_t announced) const {
    constexpr std::size_t shortest_element = 6;
    elements.reserve((std::min)(announced, size_of_text_ / shortest_element));
  }

  template <typename Number> bool read(Number& number) {
    if(header_.is_free_form)
      text_.skip_to_content();
    return text_.read(number);
  }

  void end_element() {
    if(!header_.is_free_form)
      text_.skip_numbers();
  }

  void read_points() {
    const std::size_t count = header_.number_of_points;
    reserve(soup_.points, count);
    for(std::size_t i = 0; i < count; ++i) {
      if(!text_.skip_to_content())
        fail_at_end("vertices", i, count);
      double x, y, z, w = 1.;
      if(!read(x) || !read(y) || !read(z))
        text_.fail_incomplete(name_of_vertex(i) + " has no three coordinates");
      if(header_.is_homogeneous && !read(w))
        text_.fail_incomplete(name_of_vertex(i) + " has no four coordinates");
      soup_.points.emplace_back(x / w, y / w, z / w);
      end_element();
    }
  }

  void read_faces() {
    const std::size_t count = header_.number_of_faces;
    reserve(soup_.faces, count);
    for(std::size_t i = 0; i < count; ++i) {
      if(!text_.skip_to_content())
        fail_at_end("faces", i, count);
      read_face(i);
      end_element();
    }
  }

  void read_face(std::size_t index) {
    long long size;
    if(!read(size) || size < 0)
      text_.fail(name_of_face(index) + " does not begin with its number of vertices");
    Soup_face& face = soup_.faces.emplace_back();
    face.resize(static_cast<std::size_t>(size));
    for(std::size_t i = 0; i < face.size(); ++i)
      soup_.set_corner(face, i, read_vertex(index, i));
  }

  std::uint32_t read_vertex(std::size_t face, std::size_t corner) {
    long long vertex;
    if(!read(vertex))
      text_.fail_incomplete(name_of_face(face) + " ends after " + std::to_string(corner) + " of " +
                            std::to_string(soup_.faces[face].size()) + " vertices");
    if(vertex < 0 || static_cast<std::size_t>(vertex) >= header_.number_of_points)
      text_.fail(no_such_vertex(face, vertex, header_.number_of_points));
    return static_cast<std::uint32_t>(vertex);
  }

  [[noreturn]] void fail_at_end(const char* what, std::size_t found, std::size_t announced) const {
    text_.fail_incomplete("only " + std::to_string(found) + " of " + std::to_string(announced) +
                          " " + what);
  }

  const std::size_t size_of_text_;
  Text_source text_;
  const Off_header header_;
  Soup soup_;
};

} // namespace

Soup read_off(const std::string& file, std::string_view text) {
  return Off_parser(file, text).parse();
}

} // namespace htloops
