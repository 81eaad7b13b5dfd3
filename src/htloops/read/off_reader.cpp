// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/off_reader.h"

#include "failure.h"
#include "read/text_cursor.h"

#include <algorithm>

namespace htloops {
namespace {

enum class Dialect { PLAIN, OTHER, NOT_OFF };

void remove_prefix_if(std::string_view& word, std::string_view prefix) {
  if(word.substr(0, prefix.size()) == prefix)
    word.remove_prefix(prefix.size());
}

// The keyword is [ST][C][N][4][n]OFF, or SKEL, which only CGAL knows.
Dialect dialect_of(std::string_view keyword) {
  for(const char* ignored : {"ST", "C", "N"})
    remove_prefix_if(keyword, ignored);
  if(keyword == "OFF")
    return Dialect::PLAIN;
  for(const char* number_of_coordinates : {"4", "n"})
    remove_prefix_if(keyword, number_of_coordinates);
  return keyword == "OFF" || keyword == "SKEL" ? Dialect::OTHER : Dialect::NOT_OFF;
}

class Off_parser
{
public:
  Off_parser(const Input_file& file, Soup& soup)
      : file_(file)
      , cursor_(file.content())
      , soup_(soup) {}

  bool parse() {
    cursor_.skip_to_content();
    const Dialect dialect = dialect_of(cursor_.word());
    if(dialect == Dialect::NOT_OFF)
      fail("an OFF file begins with the word OFF");
    if(dialect == Dialect::OTHER)
      return false;
    if(is_binary()) // where the reader of CGAL loses its way after the first face
      fail("a binary OFF file is not read; one in text form is");
    read_counts();
    read_points();
    read_faces();
    return true;
  }

private:
  bool is_binary() {
    cursor_.skip_to_content();
    Text_cursor ahead = cursor_;
    return ahead.word() == "BINARY";
  }

  void read_counts() {
    long long counts[3]; // of vertices, faces and edges; the last is often 0, and nobody needs it
    for(long long& count : counts)
      if(!cursor_.skip_to_content() || !cursor_.read(count) || count < 0)
        fail_incomplete("expected the numbers of vertices, faces and edges");
    number_of_points_ = static_cast<std::size_t>(counts[0]);
    number_of_faces_ = static_cast<std::size_t>(counts[1]);
    cursor_.skip_line();
  }

  // No more than what the text has room for, whatever its header says.
  template <typename Elements> void reserve(Elements& elements, std::size_t announced) const {
    constexpr std::size_t shortest_line = 6;
    elements.reserve((std::min)(announced, file_.content().size() / shortest_line));
  }

  void read_points() {
    reserve(soup_.points, number_of_points_);
    for(std::size_t i = 0; i < number_of_points_; ++i) {
      if(!cursor_.skip_to_content())
        fail_at_end("vertices", i, number_of_points_);
      double x, y, z;
      if(!cursor_.read(x) || !cursor_.read(y) || !cursor_.read(z))
        fail_incomplete("vertex " + std::to_string(i) + " has no three coordinates");
      soup_.points.emplace_back(x, y, z);
      cursor_.skip_line();
    }
  }

  void read_faces() {
    reserve(soup_.faces, number_of_faces_);
    for(std::size_t i = 0; i < number_of_faces_; ++i) {
      if(!cursor_.skip_to_content())
        fail_at_end("faces", i, number_of_faces_);
      read_face(i);
      cursor_.skip_line();
    }
  }

  void read_face(std::size_t index) {
    long long size;
    if(!cursor_.read(size) || size < 0)
      fail("face " + std::to_string(index) + " does not begin with its number of vertices");
    Soup_face& face = soup_.faces.emplace_back();
    face.resize(static_cast<std::size_t>(size));
    for(std::size_t i = 0; i < face.size(); ++i)
      face[i] = read_vertex(index, i);
  }

  std::uint32_t read_vertex(std::size_t face, std::size_t corner) {
    long long vertex;
    if(!cursor_.read(vertex))
      fail_incomplete("face " + std::to_string(face) + " ends after " + std::to_string(corner) +
                      " of " + std::to_string(soup_.faces[face].size()) + " vertices");
    if(vertex < 0 || static_cast<std::size_t>(vertex) >= number_of_points_)
      fail("face " + std::to_string(face) + " names vertex " + std::to_string(vertex) + " of " +
           std::to_string(number_of_points_) + " (they count from 0)");
    return static_cast<std::uint32_t>(vertex);
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Failure(Exit_code::UNREADABLE_FILE,
                  file_.name() + ":" + std::to_string(cursor_.line()) + ": " + problem);
  }

  // for what may be missing because the file was cut off.
  [[noreturn]] void fail_incomplete(const std::string& problem) const {
    Text_cursor rest = cursor_;
    rest.skip_line();
    fail(problem + (rest.skip_to_content() ? "" : "; the file ends here"));
  }

  [[noreturn]] void fail_at_end(const char* what, std::size_t found, std::size_t announced) const {
    fail_incomplete("only " + std::to_string(found) + " of " + std::to_string(announced) + " " +
                    what);
  }

  const Input_file& file_;
  Text_cursor cursor_;
  Soup& soup_;
  std::size_t number_of_points_ = 0;
  std::size_t number_of_faces_ = 0;
};

} // namespace

bool read_plain_off(const Input_file& file, Soup& soup) { return Off_parser(file, soup).parse(); }

} // namespace htloops
