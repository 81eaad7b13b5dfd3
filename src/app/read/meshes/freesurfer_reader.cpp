// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/meshes/readers.h"
#include "read/sources.h"

#include <array>

namespace htloops {
namespace {

constexpr std::string_view of_triangles = "\xFF\xFF\xFE", of_quadrangles = "\xFF\xFF\xFF";

// Three bytes; a line of who made it, and when, and an empty one; how many vertices and faces there
// are; coordinates, and numbers of vertices; all with the highest byte first. What follows is about
// the volume in which the surface was found.
class Freesurfer_reader
{
public:
  explicit Freesurfer_reader(const Input_file& file)
      : file_(file)
      , data_(file.name(), file.content(), end_of_text(), false) {}

  Soup read() {
    const std::size_t points = count("vertices"), faces = count("faces");
    constexpr std::size_t row = 12;
    if(data_.bytes_left() / row < points || data_.bytes_left() / row - points < faces)
      data_.fail("it declares " + std::to_string(points) + " vertices and " +
                 std::to_string(faces) + " faces, but ends before the last of them");
    for(std::size_t i = 0; i < points; ++i) {
      const auto [x, y, z] = read_row<float>();
      soup_.points.emplace_back(x, y, z);
    }
    for(std::size_t i = 0; i < faces; ++i)
      soup_.add_face(read_row<std::uint32_t>());
    check_corners(file_.name(), soup_);
    soup_.facts.unit = Unit::MILLIMETER;
    soup_.facts.volume_geometry =
        file_.content().substr(file_.content().size() - data_.bytes_left());
    return std::move(soup_);
  }

private:
  std::size_t end_of_text() const {
    const std::string_view content = file_.content();
    if(content.substr(0, of_quadrangles.size()) == of_quadrangles)
      fail_to_read(
          file_.name(),
          "FreeSurfer quadrangle surfaces are not supported: convert the file with mris_convert");
    const std::size_t line = content.find('\n');
    if(content.substr(0, of_triangles.size()) != of_triangles || line == content.npos)
      fail_to_read(file_.name(), "it is not a FreeSurfer surface");
    return content.substr(line + 1, 1) == "\n" ? line + 2 : line + 1;
  }

  std::size_t count(const char* of) {
    std::int32_t number = 0;
    if(!data_.read(number) || number < 0)
      data_.fail("its number of " + std::string(of) + " is missing");
    return static_cast<std::size_t>(number);
  }

  // There is one.
  template <typename T> std::array<T, 3> read_row() {
    std::array<T, 3> row{};
    for(T& number : row)
      data_.read(number);
    return row;
  }

  const Input_file& file_;
  Binary_source data_;
  Soup soup_;
};

} // namespace

bool is_freesurfer(std::string_view content) {
  const std::string_view magic = content.substr(0, of_triangles.size());
  return magic == of_triangles || magic == of_quadrangles;
}

Soup read_freesurfer(const Input_file& file) { return Freesurfer_reader(file).read(); }

} // namespace htloops
