// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/input_file.h"
#include "read/meshes/formats.h"
#include "read/meshes/readers.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace htloops {
namespace {

// takes the first line, without its end, off the text.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = (std::min)(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  const std::size_t length_of_end = text.substr(end, 2) == "\r\n" ? 2 : 1;
  text.remove_prefix((std::min)(end + length_of_end, text.size()));
  return line;
}

// A comment ends with its line, whatever stands there.
bool is_continued(std::string_view line) {
  return !line.empty() && line.back() == '\\' && line.find('#') == line.npos;
}

bool is_passed_over(std::string_view keyword) {
  static constexpr std::string_view keywords[] = {
      "vt",     "vn",       "g",     "o",     "s",        "usemtl",     "mtllib",
      "l",      "p",        "vp",    "mg",    "maplib",   "usemap",     "bevel",
      "lod",    "c_interp", "ctech", "stech", "d_interp", "shadow_obj", "trace_obj",
      "cstype", "deg",      "bmat",  "step",  "curv",     "curv2",      "surf",
      "parm",   "trim",     "hole",  "scrv",  "sp",       "end",        "con",
      "bsp",    "bzp",      "cdc",   "cdp",   "res",      "call",       "csh"};
  return std::find(std::begin(keywords), std::end(keywords), keyword) != std::end(keywords);
}

// Of a corner v, v/t, v//n or v/t/n, the number of the vertex; false if it is none of these.
bool parse_corner(std::string_view word, long long& vertex) {
  const char* const end = word.data() + word.size();
  auto [at, error] = std::from_chars(word.data(), end, vertex);
  if(error != std::errc())
    return false;
  for(int slot = 0; slot < 2 && at != end && *at == '/'; ++slot) {
    long long passed_over;
    at = std::from_chars(at + 1, end, passed_over).ptr;
  }
  return at == end;
}

class Obj_parser
{
public:
  Obj_parser(const std::string& file, const std::string& text)
      : file_(file)
      , text_(file, text) {}

  Soup parse() {
    while(text_.skip_to_content())
      read_element(text_.word());
    if(soup_.points.empty() && soup_.faces.empty())
      fail_to_read(file_, "it has neither vertices nor faces");
    if(furthest_vertex_ > static_cast<long long>(soup_.points.size()))
      furthest_.fail(
          no_such_vertex(furthest_face_, furthest_vertex_, soup_.points.size(), first_vertex));
    return std::move(soup_);
  }

private:
  static constexpr int first_vertex = 1;

  void read_element(std::string_view keyword) {
    if(keyword == "v")
      read_point();
    else if(keyword == "f" || keyword == "fo") // as faces were called of old
      read_face();
    else if(is_passed_over(keyword))
      text_.skip_line();
    else
      text_.fail("unknown OBJ keyword " + in_quotes(keyword));
  }

  // The coordinates may be followed by a weight or a colour.
  void read_point() {
    double x, y, z;
    if(!text_.read(x) || !text_.read(y) || !text_.read(z))
      text_.fail_incomplete("a vertex does not have three coordinates");
    soup_.points.emplace_back(x, y, z);
    text_.skip_numbers();
  }

  void read_face() {
    Soup_face face;
    while(!text_.is_at_line_end()) {
      const std::uint32_t vertex = read_vertex();
      face.resize(face.size() + 1);
      soup_.set_corner(face, face.size() - 1, vertex);
    }
    soup_.faces.push_back(face);
  }

  // A negative number counts back from the last vertex so far; a positive one may be that of a
  // vertex to come.
  std::uint32_t read_vertex() {
    const std::string_view word = text_.word();
    long long number;
    if(!parse_corner(word, number))
      text_.fail(in_quotes(word) + " is not a face corner");
    const auto size = static_cast<long long>(soup_.points.size());
    if(number == 0 || number < -size || number > (std::numeric_limits<std::uint32_t>::max)())
      text_.fail(no_such_vertex(soup_.faces.size(), number, soup_.points.size(), first_vertex));
    if(number < 0)
      return static_cast<std::uint32_t>(size + number);
    if(number > furthest_vertex_) {
      furthest_vertex_ = number;
      furthest_face_ = soup_.faces.size();
      furthest_ = text_;
    }
    return static_cast<std::uint32_t>(number - first_vertex);
  }

  const std::string& file_;
  Text_source text_;
  Soup soup_;
  // The largest number of a vertex and where it stands: whether there is one so large shows at the
  // end.
  long long furthest_vertex_ = 0;
  std::size_t furthest_face_ = 0;
  Text_source furthest_ = text_;
};

} // namespace

std::string join_continued_lines(std::string text) {
  if(text.find("\\\n") == text.npos && text.find("\\\r") == text.npos)
    return text;
  std::string joined;
  joined.reserve(text.size() + 1);
  std::size_t line_ends = 0;
  for(std::string_view rest = text; !rest.empty();) {
    const std::string_view line = take_line(rest);
    ++line_ends;
    if(is_continued(line)) {
      joined.append(line.substr(0, line.size() - 1)).append(" ");
    } else {
      joined.append(line).append(line_ends, '\n');
      line_ends = 0;
    }
  }
  return joined;
}

Soup read_obj(const Input_file& file) {
  const std::string lines = join_continued_lines(std::string(file.content()));
  return Obj_parser(file.name(), lines).parse();
}

} // namespace htloops
