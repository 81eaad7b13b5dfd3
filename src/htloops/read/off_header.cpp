// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/off_header.h"

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
    text.fail("an OFF file of the kind " + std::string(keyword) + " is not read");
  if(keyword != "OFF")
    text.fail("an OFF file begins with the word OFF or with the numbers of vertices and faces");
  text.skip_to_content();
  if(Text_cursor ahead = text; ahead.word() == "BINARY")
    text.fail("a binary OFF file is not read; one in text form is");
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

} // namespace

Off_header read_off_header(Text_source& text) {
  Off_header header = read_keyword(text);
  header.number_of_points = read_count(text);
  header.number_of_faces = read_count(text);
  skip_number_of_edges(text);
  header.is_free_form = !text.is_at_line_end();
  if(header.is_free_form &&
     (header.has_texture_coordinates || header.has_colours || header.has_normals))
    text.fail("where vertices have colours or normals, each has a line of its own");
  return header;
}

} // namespace htloops
