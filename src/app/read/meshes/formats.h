// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FORMATS_H
#define HTLOOPS_FORMATS_H

#include "read/sources.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace htloops {

/// What an OFF file says before its points: the keyword [ST][C][N][4]OFF, which may be missing, and
/// the counts.
struct Off_header
{
  bool has_texture_coordinates = false;
  bool has_colours = false;
  bool has_normals = false;
  bool is_homogeneous = false; ///< of four coordinates, the last of which divides the others
  std::size_t number_of_points = 0;
  std::size_t number_of_faces = 0;
  bool is_free_form = false; ///< a line may hold several points or faces, and nothing else
};

/// reads the header of an OFF file and goes to what follows it. The number of edges, which nobody
/// needs, may be missing. Throws `Failure` if the header is malformed or of another dialect.
Off_header read_off_header(Text_source& text);

/// the text of an OBJ file, where a backslash continues a line, without continued lines. Their ends
/// are put off to the end of the whole line, so that all other lines keep their numbers.
std::string join_continued_lines(std::string text);

/// A type of the numbers of a PLY file.
struct Ply_type
{
  std::string_view name, other_name;
  bool is_integer;
  bool (*read)(Binary_source&, double&); ///< false if there is no number more
};

/// A number, or a list of numbers preceded by their count, of an element of a PLY file.
struct Ply_property
{
  std::string name;
  std::string type_name;
  const Ply_type* type = nullptr;       ///< of the number or of the items of the list
  const Ply_type* count_type = nullptr; ///< none if it is no list

  bool is_list() const { return count_type != nullptr; }
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  bool has_vertices() const { return name == "vertex" || name == "vertices"; }
  bool has_faces() const { return name == "face" || name == "faces"; }
  /// of triangles, as Stanford's scans have.
  bool has_strips() const { return name == "tristrips"; }
};

enum class Ply_format { ASCII, BINARY_LITTLE_ENDIAN, BINARY_BIG_ENDIAN };

struct Ply_header
{
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
};

/// reads the header of a PLY file and goes to the data. Throws `Failure` if it is malformed or
/// declares a type that PLY does not have.
Ply_header read_ply_header(Text_source& text);

/// The data of a PLY file, in binary form, or as text in which each element has a line.
class Ply_numbers
{
public:
  /// the text of the file has been read up to the data.
  Ply_numbers(const std::string& file,
              std::string_view content,
              const Text_source& data,
              Ply_format format)
      : is_text_(format == Ply_format::ASCII)
      , text_(data)
      , bytes_(file, content, data.position(), format == Ply_format::BINARY_LITTLE_ENDIAN) {}

  void begin_element() {
    if(is_text_)
      text_.skip_to_content();
  }

  /// whether nothing is left of the element.
  bool end_element() { return !is_text_ || text_.is_at_line_end(); }

  /// fails if there is more than all elements, but for bytes: some programs fill up the last block.
  void end() {
    if(is_text_)
      text_.expect_end("the last element that the header declares");
  }

  /// reads the next number; false if there is none.
  bool read(const Ply_type& type, double& value);

  /// throws the `Failure` of a file that is wrong here.
  [[noreturn]] void fail(const std::string& problem) const {
    if(is_text_)
      text_.fail(problem);
    bytes_.fail(problem);
  }

  /// the same for what may be missing because the file was cut off.
  [[noreturn]] void fail_incomplete(const std::string& problem) const {
    if(is_text_)
      text_.fail_incomplete(problem);
    bytes_.fail(problem + "; the file ends here");
  }

private:
  bool is_text_;
  Text_source text_;
  Binary_source bytes_;
};

} // namespace htloops

#endif // HTLOOPS_FORMATS_H
