// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/meshes/formats.h"
#include "read/meshes/readers.h"
#include "words.h"

#include <algorithm>

namespace htloops {
namespace {

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if(word.substr(0, prefix.size()) != prefix)
    return false;
  word.remove_prefix(prefix.size());
  return true;
}

// Geomview reads files whose keyword is missing, too.
bool begins_with_counts(Text_source text) {
  long long count;
  return text.read(count);
}

Off_header read_keyword(Text_source& text) {
  Off_header header;
  text.skip_to_content();
  if(begins_with_counts(text))
    return header;
  std::string_view keyword = text.word();
  header.has_texture_coordinates = take_prefix(keyword, "ST");
  header.has_colours = take_prefix(keyword, "C");
  header.has_normals = take_prefix(keyword, "N");
  header.is_homogeneous = take_prefix(keyword, "4");
  if(keyword == "nOFF" || keyword == "SKEL")
    text.fail("OFF files of kind " + std::string(keyword) + " are not supported");
  if(keyword != "OFF")
    text.fail("an OFF file begins with the word OFF or with the numbers of vertices and faces");
  text.skip_to_content();
  if(Text_source ahead = text; ahead.word() == "BINARY")
    text.fail("binary OFF is not supported, only text");
  return header;
}

std::size_t read_count(Text_source& text) {
  long long count;
  if(!text.skip_to_content() || !text.read(count) || count < 0)
    text.fail_incomplete("expected the numbers of vertices, faces and edges");
  return static_cast<std::size_t>(count);
}

// The number of edges stands on the line of the others or on its own; a point has more numbers.
void skip_number_of_edges(Text_source& text) {
  if(!text.is_at_line_end()) {
    read_count(text);
    return;
  }
  Text_source ahead = text;
  long long count;
  if(ahead.skip_to_content() && ahead.read(count) && ahead.is_at_line_end())
    text = ahead;
}

class Off_parser
{
public:
  Off_parser(const std::string& file, std::string_view text)
      : size_of_text_(text.size())
      , text_(file, text) {}

  Soup parse() {
    read_points();
    read_faces();
    text_.expect_end("the last of " + counted(header_.number_of_faces, "face", "faces"));
    return std::move(soup_);
  }

private:
  static constexpr std::size_t shortest_element = 6;

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
    soup_.points.reserve((std::min)(count, size_of_text_ / shortest_element));
    for(std::size_t i = 0; i < count; ++i) {
      if(!text_.skip_to_content())
        fail_at_end("vertices", i, count);
      double x, y, z, w = 1.;
      if(!read(x) || !read(y) || !read(z))
        text_.fail_incomplete(name_of_vertex(i) + " does not have three coordinates");
      if(header_.is_homogeneous && !read(w))
        text_.fail_incomplete(name_of_vertex(i) + " does not have four coordinates");
      soup_.points.emplace_back(x / w, y / w, z / w);
      end_element();
    }
  }

  void read_faces() {
    const std::size_t count = header_.number_of_faces;
    soup_.faces.reserve((std::min)(count, size_of_text_ / shortest_element));
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

  const std::size_t size_of_text_; // there is no room for more, whatever the header says
  Text_source text_;
  const Off_header header_ = read_off_header(text_);
  Soup soup_;
};

} // namespace

Off_header read_off_header(Text_source& text) {
  Off_header header = read_keyword(text);
  header.number_of_points = read_count(text);
  header.number_of_faces = read_count(text);
  skip_number_of_edges(text);
  header.is_free_form = !text.is_at_line_end();
  if(header.is_free_form &&
     (header.has_texture_coordinates || header.has_colours || header.has_normals))
    text.fail("vertices with colors or normals need a line each");
  return header;
}

Soup read_off(const Input_file& file) { return Off_parser(file.name(), file.content()).parse(); }

} // namespace htloops
