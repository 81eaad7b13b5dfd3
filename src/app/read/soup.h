// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_H
#define HTLOOPS_SOUP_H

#include "Unit.h"
#include "mesh_types.h"

#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace htloops {

/// The vertices of a face. Only the first three are kept here: so a million faces need no million
/// allocations, and a damaged file that announces a face of a billion vertices does no harm.
class Soup_face
{
public:
  void resize(std::size_t size) { size_ = size; }
  std::size_t size() const { return size_; }
  bool is_triangle() const { return size_ == 3; }

  std::uint32_t& operator[](std::size_t i) { return vertices_[i < 3 ? i : 3]; }
  std::uint32_t operator[](std::size_t i) const { return vertices_[i < 3 ? i : 3]; }

  const std::uint32_t* begin() const { return vertices_.data(); }
  const std::uint32_t* end() const { return begin() + (size_ < 3 ? size_ : 3); }
  std::uint32_t* begin() { return vertices_.data(); }
  std::uint32_t* end() { return begin() + (size_ < 3 ? size_ : 3); }

private:
  std::array<std::uint32_t, 4> vertices_{}; // the last one takes what is not kept
  std::size_t size_ = 0;
};

/// What a file says besides points and faces.
struct File_facts
{
  Unit unit = Unit::NONE; ///< of the coordinates
  /// What a surface of FreeSurfer has after its faces, as it stands there: the geometry of the
  /// volume.
  std::string volume_geometry = {};
  std::vector<std::string> unread = {}; ///< what is not read, in words
  /// Whether vertices are parted where normals or texture coordinates differ, as in glTF.
  bool is_parted_at_seams = false;
};

/// Points and faces as they stand in a file, nothing known about them.
struct Soup
{
  static constexpr std::size_t largest_number_of_halfedges =
      CGAL::Handle_tunnel_loops::internal::most_halfedges;

  std::vector<Point> points;
  std::vector<Soup_face> faces;
  /// What faces of more than three vertices have from the fourth on, one face after the other.
  std::vector<std::uint32_t> further_corners = {};
  File_facts facts = {};

  /// sets a corner of the face that is being read; corners come in their order.
  void set_corner(Soup_face& face, std::size_t i, std::uint32_t vertex) {
    if(i < 3)
      face[i] = vertex;
    else
      further_corners.push_back(vertex);
  }

  /// adds a face of any numbers; those that no vertex can have become the largest one.
  template <typename Range> void add_face(const Range& corners) {
    constexpr auto largest = (std::numeric_limits<std::uint32_t>::max)();
    Soup_face face;
    face.resize(corners.size());
    for(std::size_t i = 0; i < corners.size(); ++i)
      set_corner(face, i,
                 static_cast<std::uint64_t>(corners[i]) < largest
                     ? static_cast<std::uint32_t>(corners[i])
                     : largest);
    faces.push_back(face);
  }

  /// the vertex at which halfedge 3 * face + i, from corner i to corner i + 1, begins.
  std::uint32_t source(std::uint32_t halfedge) const { return faces[halfedge / 3][halfedge % 3]; }
};

/// the halfedge after one in its triangle, where halfedges are numbered by triangles.
inline std::uint32_t next_in_triangle(std::uint32_t halfedge) {
  return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1;
}

inline std::string name_of_face(std::size_t face) { return "face " + std::to_string(face); }

inline std::string name_of_vertex(std::size_t vertex) { return "vertex " + std::to_string(vertex); }

inline std::string name_of_edge(std::size_t u, std::size_t v) {
  return "edge " + std::to_string(u) + "-" + std::to_string(v);
}

/// that a face names a vertex, counted from `first`, which is not among those of the file.
inline std::string
no_such_vertex(std::size_t face, long long vertex, std::size_t number_of_vertices, int first = 0) {
  return name_of_face(face) + " uses vertex " + std::to_string(vertex) + ", but there are only " +
         std::to_string(number_of_vertices) + " (numbered from " + std::to_string(first) + ")";
}

/// throws `Failure` if a face names a vertex that is not there.
void check_corners(const std::string& file, const Soup& soup);

/// throws `Failure` if the soup has become larger than there is room for, as few bytes of a file
/// may name a part of it again and again; and `Interrupted` on Ctrl-C.
void check_size(const std::string& file, const Soup& soup);

/// How often something was found, and where first.
class Finding
{
public:
  template <typename Name_of_element> void add(Name_of_element name) {
    if(count_++ == 0)
      example_ = name();
  }

  std::size_t count() const { return count_; }

  /// what was found, without the count: of one element, or of several.
  std::string words(const std::string& one, const std::string& many) const {
    return count_ == 1 ? one + ": " + example_ : many + ", first: " + example_;
  }

private:
  std::size_t count_ = 0;
  std::string example_;
};

/// Numbers different points as they come. A table with open addressing: most of the time of reading
/// an STL file goes here.
class Point_merger
{
public:
  /// the number of a point, a new one if it has not come yet. Bits are compared, but for
  /// the two zeros. A point that is nowhere, as a coordinate is infinite or not a number, is at the
  /// place of no other.
  std::uint32_t number(const Point& point);

  /// the points by their numbers, which are taken away.
  std::vector<Point> take_points() { return std::move(points_); }

private:
  static constexpr std::uint32_t nothing = static_cast<std::uint32_t>(-1);

  std::size_t slot_of(const Point& point) const;
  void grow();

  std::vector<Point> points_;
  // Numbers of points; a power of two of them.
  std::vector<std::uint32_t> slots_ = std::vector<std::uint32_t>(1024, nothing);
};

} // namespace htloops

#endif // HTLOOPS_SOUP_H
