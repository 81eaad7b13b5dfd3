// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_SCENE_SCENE_H
#define HTL_SCENE_SCENE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// \file scene.h
/// What is looked at, as plain arrays: pages and pictures are two ways to draw it.

namespace htl_scene {

using Colour = std::array<unsigned char, 3>; ///< sRGB
using Point = std::array<double, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// A surface; of several a page shows one at a time, a picture all of them side by side.
struct Surface
{
  std::string name;
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> triangle_parts; ///< empty, or for each triangle a part
  std::vector<Colour> part_colours;          ///< by part
};

/// A sort of lines; who looks at a page can choose not to see it.
struct Line_group
{
  std::string name;
  Colour colour;
  double width = 1.;          ///< as a multiple of that of others, below 4000
  bool is_outlined = false;   ///< in pictures, as it has a dark surface below
  bool is_in_pictures = true; ///< and what a page looks at when it is asked for a row
};

constexpr std::size_t every_surface = static_cast<std::size_t>(-1);
constexpr std::size_t no_way = static_cast<std::size_t>(-1);

/// A polyline; a ball if it is closed and has a single point.
struct Line
{
  std::vector<Point> points;
  bool closed;
  std::size_t group; ///< its number
  std::size_t row;   ///< the row of the table that tells of it; `no_row` if none does
  std::size_t surface = every_surface; ///< its number, if it is seen with this one only
  /// by point, how thick it is if the viewer wants that, in the unit of the points; or none.
  std::vector<double> radii = {};
  std::size_t way =
      no_way; ///< the number of a line along which a slider moves it, from its first point
  std::string label = {}; ///< what is written beside it in pictures with labels
};

constexpr std::size_t no_row = static_cast<std::size_t>(-1);

/// What the colour of a part of a surface means.
struct Patch
{
  std::string name;
  Colour colour;
};

struct Column
{
  std::string name;
  bool is_number;
  std::string explanation = {}; ///< a sentence, without its point
};

constexpr std::size_t no_part = static_cast<std::size_t>(-1);

/// What rows may be hidden by, and lines be coloured by, besides their lengths.
struct Scale
{
  std::string name;
  std::vector<double> values; ///< by row; what is not known is not finite
};

/// What is told beside the surface, and which lines belong to what is told.
struct Table
{
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<double> lengths;      ///< by row: a slider hides rows, with their lines, by it
  std::vector<Scale> scales;        ///< or by one of these
  std::vector<std::size_t> parts;   ///< by row: the part of the surface it tells of, or
                                    ///< `no_part`, or empty: of surfaces that have parts
  std::vector<std::size_t> numbers; ///< by row: the number by which it is chosen, of the first ones
  /// a command for the chosen rows: what stands before their numbers, and behind them.
  std::array<std::string, 2> choice;
  std::string noun = "loop"; ///< what lengths are of
  std::string empty;         ///< a sentence that says why there are no rows, and what one can do
  /// by row: the direction from which its lines are seen from outside, if there is one; or empty.
  std::vector<std::optional<Point>> views;
};

/// What a page shows.
struct Scene
{
  std::string name;                    ///< of the file that a saved picture gets, without its end
  std::string title;                   ///< as it is to be read
  std::vector<std::string> paragraphs; ///< as they are to be read
  std::vector<Surface> surfaces;       ///< at least one
  std::vector<Line_group> groups;
  std::vector<Line> lines;
  std::vector<Patch> patches;
  Table table;
  Point view = {0.6, -1., 0.5}; ///< the direction from the surface to the eye, at first
  Point up = {0., 0., 1.};      ///< the direction that is upright, at first
  double opacity = 1.;          ///< of the surface, at first, 0 to 1
  Colour surface_colour = {204, 212, 222};
  bool has_bones = false; ///< lines are inside: a surface that is not opaque lies over them
  std::string unit = {}; ///< of coordinates and lengths, as it is written; empty if it is not known
};

} // namespace htl_scene

#endif // HTL_SCENE_SCENE_H
