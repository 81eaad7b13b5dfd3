// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "draw/layers.h"

#include "solve/reeb_solver.h"
#include "write/mesh_writer.h"

#include <CGAL/Handle_tunnel_loops/internal/support/elementary_functions.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace htloops {
namespace {

// A wave over two bands.
double light_at(double time, double last) {
  constexpr double mean = 0.5 * (1. + light_of_dark_bands);
  const double band = last > 0. ? time / last * number_of_time_bands : 0.;
  return mean + (1. - mean) * internal::cosine(pi * band);
}

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

// The parts of faces that differ in color: layers, dark and light bands of these, and what no front
// has come to yet.
class Layer_parts
{
  using Vertex = Mesh::Vertex_index;
  using Parts = std::vector<CGAL::Handle_tunnel_loops::internal::Face_part>;

public:
  Layer_parts(const Answer& answer, double now)
      : told_(answer.vertex_layers)
      , ends_(ends_of_layers(answer))
      , now_(now) {}

  Parts parts_of(const std::array<Vertex, 3>& corners) {
    Parts parts = parts_of(corners[0], corners[1]);
    append(corners[1], corners[2], parts);
    return parts;
  }

  Parts parts_of(Vertex low, Vertex high) {
    Parts parts;
    append(low, high, parts);
    return parts;
  }

  static Colour colour_of_part(std::size_t part) {
    const bool is_dark = part % 2 != 0;
    return part == rest ? colour_of_rest
                        : darkened(colour_of_layer(part / 2), is_dark ? light_of_dark_bands : 1.);
  }

private:
  static constexpr std::size_t rest = 0; // as no layer has the number 0

  void append(Vertex from, Vertex to, Parts& parts) {
    find_levels(from, to);
    double low = value(from);
    for(const double high : levels_) {
      const std::size_t part = part_at(from, to, 0.5 * (low + high));
      if(!parts.empty() && !(parts.back().low < parts.back().high))
        parts.pop_back();
      if(parts.empty() || (parts.back().arc != part && low < high))
        parts.push_back({part, low, high});
      else
        parts.back().high = high;
      low = high;
    }
  }

  // Where the color may change on an edge: between layers, between bands, and now. The last one is
  // its upper end.
  void find_levels(Vertex from, Vertex to) {
    levels_ = {now_};
    if(layer(from) != layer(to))
      levels_.push_back(border(from, to));
    if(width_of_band_ > 0.)
      for(double k = std::floor(value(from) / width_of_band_) + 1.; k * width_of_band_ < value(to);
          ++k)
        levels_.push_back(k * width_of_band_);
    levels_.erase(
        std::remove_if(levels_.begin(), levels_.end(),
                       [&](double level) { return level <= value(from) || level >= value(to); }),
        levels_.end());
    levels_.push_back(value(to));
    std::sort(levels_.begin(), levels_.end());
    levels_.erase(std::unique(levels_.begin(), levels_.end()), levels_.end());
  }

  // Where the layer of a vertex ends and that of a later one begins.
  double border(Vertex from, Vertex to) const {
    return std::clamp(ends_[layer(from)], value(from), value(to));
  }

  std::size_t part_at(Vertex from, Vertex to, double level) const {
    if(!(level <= now_))
      return rest;
    const bool is_dark =
        width_of_band_ > 0. && std::fmod(std::floor(level / width_of_band_), 2.) != 0.;
    const Vertex nearest = level <= border(from, to) ? from : to;
    return 2 * layer(nearest) + (is_dark ? 1 : 0);
  }

  std::size_t layer(Vertex v) const { return told_.layers[v.idx()]; }
  double value(Vertex v) const { return told_.times[v.idx()]; }

  const Vertex_layers& told_;
  std::vector<double> ends_;
  const double now_, width_of_band_ = last_time(told_) / number_of_time_bands;
  std::vector<double> levels_; // of the present edge
};

// The contours of a level: closed, or from border to border.
class Contour_walker
{
public:
  Contour_walker(const Mesh& mesh, const std::vector<double>& values, double level)
      : mesh_(mesh)
      , values_(values)
      , level_(level) {}

  std::vector<Exported_line> walk() {
    const std::vector<Mesh::Edge_index> edges = edges_by_vertices(mesh_);
    for(const bool from_border : {true, false})
      for(const Mesh::Edge_index e : edges)
        for(const Mesh::Halfedge_index h : {mesh_.halfedge(e), mesh_.opposite(mesh_.halfedge(e))})
          if(rises(h) && is_walked_[h.idx()] == 0 && !mesh_.is_border(h) &&
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
    line.index = lines_.size();
    while(is_walked_[h.idx()] == 0) {
      is_walked_[h.idx()] = 1;
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
  // By halfedge that rises.
  std::vector<char> is_walked_ = std::vector<char>(mesh_.number_of_halfedges(), 0);
  std::vector<Exported_line> lines_;
};

} // namespace

Colour colour_of_layer(std::size_t layer) { return colour_of_arc(layer == 0 ? 0 : layer - 1); }

Colour darkened(Colour colour, double light) {
  for(unsigned char& part : colour)
    part = static_cast<unsigned char>(light * part);
  return colour;
}

double last_time(const Vertex_layers& layers) {
  return layers.times.empty() ? 0. : *std::max_element(layers.times.begin(), layers.times.end());
}

void export_layers(const std::string& file, const Mesh& mesh, const Vertex_layers& layers) {
  const double last = last_time(layers);
  Vertex_properties properties = colour_properties(layers.layers.size(), [&](std::size_t v) {
    return darkened(colour_of_layer(layers.layers[v]), light_at(layers.times[v], last));
  });
  properties.push_back({"layer", "int", {layers.layers.begin(), layers.layers.end()}});
  properties.push_back({"time", "double", layers.times});
  write_mesh(file, mesh, properties);
}

Grown_layers grown_layers(const Mesh& mesh, const Answer& answer, double part) {
  const std::vector<double>& times = answer.vertex_layers.times;
  const double now = part * last_time(answer.vertex_layers);
  Layer_parts parts(answer, now);
  return {drawn_surface(Level_cutter(mesh, times).cut(parts), Layer_parts::colour_of_part),
          {"fronts", "front", Contour_walker(mesh, times, now).walk()}};
}

} // namespace htloops
