// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTL_PICTURE_LAYERS_H
#define HTL_PICTURE_LAYERS_H

#include "Camera.h"
#include "picture.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace htl_picture {

/// What of a mesh is seen at each sample of a picture: the nearest triangle and how near it is.
class Surface_layer
{
public:
  static constexpr std::uint32_t no_triangle = 0xffffffffu;

  /// `look` is called again and again, and may end it by throwing.
  Surface_layer(const std::vector<Projected_point>& points,
                const std::vector<Triangle>& triangles,
                int width,
                int height,
                const std::function<void()>& look);

  int width() const { return width_; }
  int height() const { return height_; }
  std::uint32_t triangle(int x, int y) const { return triangles_[index(x, y)]; }

  /// zero where there is no triangle.
  float inverse_depth(int x, int y) const { return inverse_depths_[index(x, y)]; }

private:
  std::size_t index(int x, int y) const { return std::size_t(y) * width_ + x; }

  void draw(std::uint32_t triangle, Projected_point a, Projected_point b, Projected_point c);

  int width_, height_;
  std::vector<float> inverse_depths_;
  std::vector<std::uint32_t> triangles_;
};

/// the weights of the corners of a triangle at the point of it that is seen at a place of the
/// picture.
std::array<float, 3>
corner_weights(const std::array<Projected_point, 3>& corners, float x, float y);

/// The lines at each sample of a picture: the nearest of those in front of the surface and the
/// nearest of those behind it.
class Line_layer
{
public:
  static constexpr std::uint32_t no_line = 0xffffffffu;

  /// What is seen of a line at a sample.
  struct Sample
  {
    float inverse_depth = 0.f;
    std::uint32_t line = no_line;
    float across = 0.f; ///< the distance from the middle of the line, in units of half its width
    float radius = 0.f; ///< half the width, in the unit of the frame; none of a ball
    float inverse_depth_of_rim = 0.f; ///< of the nearest line that passes beside
    std::uint32_t line_of_rim = no_line;

    /// whether there is a gap, so that the line seems to pass below one that is nearer, or that
    /// comes first.
    bool is_gap() const {
      if(line == no_line || line_of_rim == no_line || line_of_rim == line || !(radius > 0.f))
        return false;
      const float nearer = 1.f / inverse_depth - 1.f / inverse_depth_of_rim;
      return nearer > radius || (nearer > -radius && line_of_rim < line);
    }
  };

  /// draws lines that are `radius` samples wide to each side, if they say nothing else. `look` is
  /// called again and again, and may end it by throwing.
  Line_layer(const Camera& camera,
             const Surface_layer& surface,
             const std::vector<Line>& lines,
             float radius,
             const std::function<void()>& look);

  const Sample& in_front(int x, int y) const { return in_front_.at(x, y); }
  const Sample& behind(int x, int y) const { return behind_.at(x, y); }

private:
  // Lines are at few samples: squares of them are made where there are any.
  class Samples
  {
  public:
    Samples(int width, int height)
        : squares_in_row_((width + side - 1) / side)
        , squares_(std::size_t(squares_in_row_) * ((height + side - 1) / side)) {}

    const Sample& at(int x, int y) const {
      static const Sample none;
      const auto& square = squares_[number(x, y)];
      return square.empty() ? none : square[place(x, y)];
    }

    Sample& made_at(int x, int y) {
      auto& square = squares_[number(x, y)];
      if(square.empty())
        square.resize(side * side);
      return square[place(x, y)];
    }

  private:
    static constexpr int side = 32;

    std::size_t number(int x, int y) const {
      return std::size_t(y / side) * squares_in_row_ + x / side;
    }
    static std::size_t place(int x, int y) { return std::size_t(y % side) * side + x % side; }

    int squares_in_row_;
    std::vector<std::vector<Sample>> squares_;
  };

  /// A place of a line, and how wide that is there to each side, in samples.
  struct Place : Projected_point
  {
    float radius;
    bool is_ball = false; ///< these make no room for lines that end there
  };

  Place place_on(const Line& line, std::size_t point) const;
  void draw_line(std::uint32_t line, const Line& points);
  void draw_segment(std::uint32_t line, Place a, Place b, float lift);
  void draw_sample(std::uint32_t line, int x, int y, Place middle, float distance, float lift);

  const Camera& camera_;
  const Surface_layer& surface_;
  float radius_;
  Samples in_front_, behind_;
};

} // namespace htl_picture

#endif // HTL_PICTURE_LAYERS_H
