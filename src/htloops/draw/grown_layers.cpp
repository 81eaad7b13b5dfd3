// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/grown_layers.h"

#include "draw/layer_mesh.h"
#include "draw/level_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace htloops {
namespace {

using Colour = std::array<unsigned char, 3>;

constexpr Colour colour_of_rest = {222, 226, 232}, colour_of_front = {170, 20, 30};

// The times at which the layers end, by layer.
std::vector<double> ends_of_layers(const Answer& answer) {
  const auto& [layers, times] = answer.vertex_layers;
  std::vector<double> ends(1 + *std::max_element(layers.begin(), layers.end()), 0.);
  for(std::size_t v = 0; v < layers.size(); ++v)
    ends[layers[v]] = (std::max)(ends[layers[v]], times[v]);
  for(const auto& event : answer.statistics.front_events)
    for(const auto& front : event.before)
      if(front.layer < ends.size() && event.vertex < times.size())
        ends[front.layer] = (std::max)(ends[front.layer], times[event.vertex]);
  return ends;
}

class Layer_painter
{
public:
  Layer_painter(const Mesh& mesh, const Answer& answer, double now)
      : mesh_(mesh)
      , layers_(answer.vertex_layers.layers)
      , cutter_(mesh, answer.vertex_layers.times)
      , ends_(ends_of_layers(answer))
      , width_of_band_(last_time(answer.vertex_layers) / number_of_time_bands)
      , now_(now) {}

  Drawn_surface paint() {
    for(const Mesh::Face_index f : mesh_.faces())
      paint(f);
    surface_.points = cutter_.take_points();
    return std::move(surface_);
  }

private:
  using Corners = Level_cutter::Corners;

  void paint(Mesh::Face_index f) {
    const Corners corners = cutter_.corners_of(f);
    const bool is_turned = !cutter_.has_orientation(f, corners);
    const double low = cutter_.value(corners[0]), high = cutter_.value(corners[2]);
    find_levels(corners);
    if(levels_.empty())
      return add({corners[0].idx(), corners[1].idx(), corners[2].idx()}, is_turned,
                 colour_between(corners, low, high));
    double from = low;
    levels_.push_back(high);
    for(const double to : levels_) {
      add(cutter_.polygon(corners, from, to), is_turned, colour_between(corners, from, to));
      from = to;
    }
  }

  // Where the colour may change within a face: between layers, between bands, and now.
  void find_levels(const Corners& corners) {
    levels_.clear();
    for(int i = 0; i < 2; ++i)
      if(layer(corners[i]) != layer(corners[i + 1]))
        levels_.push_back(border(corners, i));
    const double low = cutter_.value(corners[0]), high = cutter_.value(corners[2]);
    if(width_of_band_ > 0.)
      for(double k = std::floor(low / width_of_band_) + 1.; k * width_of_band_ < high; ++k)
        levels_.push_back(k * width_of_band_);
    levels_.push_back(now_);
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
    levels_.erase(std::remove_if(levels_.begin(), levels_.end(),
                                 [&](double level) { return level <= low || level >= high; }),
                  levels_.end());
  }

  // Where the layer of a corner ends and that of the next one begins.
  double border(const Corners& corners, int i) const {
    return std::clamp(ends_[layer(corners[i])], cutter_.value(corners[i]),
                      cutter_.value(corners[i + 1]));
  }

  Colour colour_between(const Corners& corners, double from, double to) const {
    const double middle = 0.5 * (from + to);
    if(!(middle <= now_))
      return colour_of_rest;
    int i = 0;
    while(i < 2 && border(corners, i) < middle)
      ++i;
    const bool is_dark =
        width_of_band_ > 0. && std::fmod(std::floor(middle / width_of_band_), 2.) != 0.;
    return darkened(colour_of_layer(layer(corners[i])), is_dark ? light_of_dark_bands : 1.);
  }

  std::size_t layer(Mesh::Vertex_index v) const { return layers_[v.idx()]; }

  void add(const Level_cutter::Polygon& polygon, bool is_turned, const Colour& colour) {
    for_each_triangle(polygon, is_turned, [&](const std::array<std::uint32_t, 3>& triangle) {
      surface_.triangles.push_back(triangle);
      surface_.colours.push_back(colour);
    });
  }

  const Mesh& mesh_;
  const std::vector<std::size_t>& layers_;
  Level_cutter cutter_;
  std::vector<double> ends_;
  double width_of_band_, now_;
  std::vector<double> levels_; // of the present face
  Drawn_surface surface_;
};

// The contours of a level: closed, or from border to border.
class Contour_walker
{
public:
  Contour_walker(const Mesh& mesh, const std::vector<double>& values, double level)
      : mesh_(mesh)
      , values_(values)
      , level_(level)
      , is_walked_(mesh.number_of_halfedges(), 0) {}

  std::vector<Exported_line> walk() {
    for(const bool from_border : {true, false})
      for(const Mesh::Halfedge_index h : mesh_.halfedges())
        if(rises(h) && is_walked_[h] == 0 && !mesh_.is_border(h) &&
           (!from_border || mesh_.is_border(mesh_.opposite(h))))
          lines_.push_back(line_from(h));
    return std::move(lines_);
  }

private:
  bool rises(Mesh::Halfedge_index h) const {
    return value(mesh_.source(h)) <= level_ && level_ < value(mesh_.target(h));
  }

  double value(Mesh::Vertex_index v) const { return values_[v.idx()]; }

  Exported_line line_from(Mesh::Halfedge_index h) {
    Exported_line line;
    line.kind = "front";
    line.colour = colour_of_front;
    line.is_outlined = true;
    line.index = lines_.size();
    while(is_walked_[h] == 0) {
      is_walked_[h] = 1;
      line.points.push_back(point_on(h));
      if(mesh_.is_border(h))
        return line;
      Mesh::Halfedge_index out = mesh_.next(h); // of the other two one falls
      if(!rises(mesh_.opposite(out)))
        out = mesh_.next(out);
      h = mesh_.opposite(out);
    }
    line.is_closed = true;
    return line;
  }

  Point point_on(Mesh::Halfedge_index h) const {
    const Point &p = mesh_.point(mesh_.source(h)), &q = mesh_.point(mesh_.target(h));
    const double low = value(mesh_.source(h)), high = value(mesh_.target(h));
    return p + (level_ - low) / (high - low) * (q - p);
  }

  const Mesh& mesh_;
  const std::vector<double>& values_;
  double level_;
  std::vector<char> is_walked_; // by halfedge that rises
  std::vector<Exported_line> lines_;
};

} // namespace

Grown_layers grown_layers(const Mesh& mesh, const Answer& answer, double part) {
  const double now = part * last_time(answer.vertex_layers);
  return {Layer_painter(mesh, answer, now).paint(),
          {"fronts", "front", Contour_walker(mesh, answer.vertex_layers.times, now).walk()}};
}

} // namespace htloops
