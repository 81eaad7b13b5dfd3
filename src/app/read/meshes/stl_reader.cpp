// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/meshes/readers.h"

#include "read/input_file.h"
#include "read/sources.h"
#include "words.h"

#include <algorithm>

namespace htloops {
namespace {

char in_lower_case(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Both cases are in use.
bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char a, char b) { return in_lower_case(a) == b; });
}

class Stl_text_parser
{
public:
  Stl_text_parser(const std::string& file, std::string_view text)
      : text_(file, text) {}

  Soup parse() {
    text_.skip_to_content();
    if(!is_keyword(text_.word(), "solid"))
      text_.fail("a text STL file begins with the word solid");
    skip_name();
    bool is_in_solid = true;
    while(text_.skip_to_content()) {
      const std::string_view word = text_.word();
      if(is_in_solid && is_keyword(word, "facet")) {
        read_facet();
      } else if(is_keyword(word, is_in_solid ? "endsolid" : "solid")) {
        is_in_solid = skip_name() || !is_in_solid;
      } else {
        text_.fail("unexpected " + in_quotes(word));
      }
    }
    if(is_in_solid)
      text_.fail_incomplete("expected endsolid after " + std::to_string(soup_.faces.size()) +
                            " faces");
    soup_.points = merger_.take_points();
    return std::move(soup_);
  }

private:
  // A name may be any words to the end of the line, but not the beginning of a face: there are
  // files of one line. So what follows the name of an endsolid may be another solid, or be out of
  // place.
  bool skip_name() {
    bool is_solid_begun = false;
    while(!text_.is_at_line_end()) {
      Text_source ahead = text_;
      const std::string_view word = ahead.word();
      const bool is_facet = is_keyword(word, "facet") && ahead.skip_to_content() &&
                            is_keyword(ahead.word(), "normal");
      if(is_facet || is_keyword(word, "endsolid"))
        return is_solid_begun;
      is_solid_begun = is_solid_begun || is_keyword(word, "solid");
      text_.word();
    }
    text_.skip_line();
    return false;
  }

  void read_facet() {
    Soup_face& face = soup_.faces.emplace_back();
    face.resize(3);
    skip_normal();
    expect("loop");
    for(std::size_t corner = 0; corner < 3; ++corner) {
      expect("vertex");
      face[corner] = merger_.number(read_point());
    }
    expect("endloop");
    expect("endfacet");
  }

  // Programs write what they like for the normal of a face without area.
  void skip_normal() {
    while(text_.skip_to_content())
      if(is_keyword(text_.word(), "outer"))
        return;
    fail_to_find("outer");
  }

  void expect(const char* keyword) {
    if(!text_.skip_to_content() || !is_keyword(text_.word(), keyword))
      fail_to_find(keyword);
  }

  Point read_point() {
    double coordinates[3];
    for(double& x : coordinates)
      if(!text_.skip_to_content() || !text_.read(x))
        fail_to_find("three coordinates");
    return Point(coordinates[0], coordinates[1], coordinates[2]);
  }

  [[noreturn]] void fail_to_find(const std::string& expected) const {
    text_.fail_incomplete(name_of_face(soup_.faces.size() - 1) + ": expected " + expected);
  }

  Text_source text_;
  Soup soup_;
  Point_merger merger_;
};

Soup read_binary(const std::string& file, std::string_view content) {
  constexpr std::size_t header_size = 80, normal_size = 12, attribute_size = 2, facet_size = 50;
  std::uint32_t announced = 0;
  Binary_source data(file, content, (std::min)(header_size, content.size()), true);
  if(!data.read(announced))
    fail_to_read(file, "it is too short to be an STL file");
  const std::size_t found = data.bytes_left() / facet_size;
  if(found < announced)
    fail_to_read(file, "it ends after " + std::to_string(found) + " of " +
                           std::to_string(announced) + " faces");
  if(found > announced) // less than a face may follow
    fail_to_read(file, "its header declares " + counted(announced, "face", "faces") +
                           ", but the file holds " + std::to_string(found));
  Soup soup;
  Point_merger merger;
  for(std::uint32_t facet = 0; facet < announced; ++facet) {
    Soup_face& face = soup.faces.emplace_back();
    face.resize(3);
    data.skip(normal_size);
    for(std::size_t corner = 0; corner < 3; ++corner) {
      float x = 0, y = 0, z = 0;
      data.read(x);
      data.read(y);
      data.read(z);
      face[corner] = merger.number(Point(x, y, z));
    }
    data.skip(attribute_size);
  }
  soup.points = merger.take_points();
  return soup;
}

} // namespace

// The word solid opens many a binary file, but no text has a zero byte, which each binary file of
// less than 2^24 faces has at the end of their number.
Soup read_stl(const Input_file& file) {
  const std::string_view content = file.content();
  const bool is_binary = content.find('\0') != content.npos;
  return is_binary ? read_binary(file.name(), content)
                   : Stl_text_parser(file.name(), content).parse();
}

} // namespace htloops
