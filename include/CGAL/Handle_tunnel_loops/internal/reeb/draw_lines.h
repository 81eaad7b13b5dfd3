// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DRAW_LINES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DRAW_LINES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Mesh_view.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Contour_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Reeb_embedding.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/winding_numbers.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Where a contour crosses an edge.
struct Contour_place
{
  Vector point;   ///< the middle of the edge
  Vector outward; ///< a normal of the surface there
};

inline Contour_place contour_place(const Flat_mesh& mesh, const Contour_walk& walk) {
  const Ring ring = mesh.ring(walk.left());
  const Index p = walk.position();
  const Vector &left = mesh.points[walk.left()], &right = mesh.points[ring[p]];
  const Vector& before = mesh.points[ring[ring.previous(p)]];
  const Vector& after = mesh.points[ring[ring.next(p)]];
  return {0.5 * (left + right), cross(right - left, after - before)};
}

/// A ball that touches a contour and lies inside of it.
struct Contour_ball
{
  Vector centre;
  double radius;

  /// how far a point is from the ball; negative within.
  double distance(const Vector& p) const { return norm(p - centre) - radius; }
};

/// places of the contours that come to a vertex from below, evenly apart: some of them where the
/// contours are long, and none where they take more than so many steps.
inline std::vector<Contour_place> contour_places(const Flat_mesh& mesh,
                                                 const Sweep_order& order,
                                                 Index v,
                                                 std::size_t largest_number_of_steps) {
  constexpr std::size_t largest_number = 64;
  std::vector<Contour_place> places;
  std::size_t steps = 0, stride = 1;
  const auto thin_out = [&] {
    for(std::size_t i = 0; i < largest_number / 2; ++i)
      places[i] = places[2 * i];
    places.resize(largest_number / 2);
    stride *= 2;
  };
  const Swept_vertex at(mesh, order, v);
  for(Index i = 0; i < at.number_of_lower_components(); ++i) {
    if(at.is_hole(i))
      continue;
    Contour_walk walk(mesh, order, order.rank(v), at.first_of(i), v);
    const Index begin = walk.slot();
    do {
      if(steps == largest_number_of_steps)
        return {};
      const bool is_at_hole = order.is_hole(mesh.ring(walk.left())[walk.position()]);
      if(steps % stride == 0 && !is_at_hole) { // it goes on beyond the hole
        if(places.size() == largest_number)
          thin_out();
        places.push_back(contour_place(mesh, walk));
      }
      ++steps;
      walk.advance(no_index);
    } while(walk.slot() != begin);
  }
  return places;
}

/// the largest ball that touches the contour at one of its places from inside, and holds no other
/// place.
inline Contour_ball
contour_ball(const std::vector<Contour_place>& places, const Contour_place& place, double sign) {
  const double length = norm(place.outward);
  if(!(length > 0.))
    return {place.point, 0.};
  const Vector inward = (-sign / length) * place.outward;
  double radius = std::numeric_limits<double>::infinity();
  for(const Contour_place& other : places) {
    const Vector way = other.point - place.point;
    const double depth = dot(inward, way);
    if(depth > 0.)
      radius = (std::min)(radius, dot(way, way) / (2. * depth));
  }
  if(!(radius < std::numeric_limits<double>::infinity()))
    return {place.point, 0.};
  return {place.point + radius * inward, radius};
}

/// Centres of balls inside a contour, those nearest to its mean first, by the distance to the ball.
class Centres_of_contour
{
public:
  static constexpr std::size_t largest_number = 4;

  /// \p sign is -1 if the normals of the mesh point inward.
  Centres_of_contour(const std::vector<Contour_place>& places, double sign)
      : places_(places)
      , sign_(sign) {}

  std::vector<Vector> operator()(const Vector& mean) const {
    std::vector<std::pair<double, Vector>> balls;
    const auto add = [&](const Contour_place& place) {
      const Contour_ball ball = contour_ball(places_, place, sign_);
      if(ball.radius > 0.)
        balls.emplace_back(ball.distance(mean), ball.centre);
    };
    constexpr std::size_t number_of_balls = 8;
    const std::size_t stride = places_.size() / number_of_balls + 1;
    for(std::size_t i = 0; i < places_.size(); i += stride)
      add(places_[i]);
    if(!places_.empty())
      add(nearest(mean));
    std::sort(balls.begin(), balls.end());
    std::vector<Vector> centres;
    for(std::size_t i = 0; i < (std::min)(balls.size(), largest_number); ++i)
      centres.push_back(balls[i].second);
    return centres;
  }

private:
  const Contour_place& nearest(const Vector& mean) const {
    const auto squared_distance = [&](const Contour_place& place) {
      return dot(place.point - mean, place.point - mean);
    };
    return *std::min_element(places_.begin(), places_.end(),
                             [&](const Contour_place& a, const Contour_place& b) {
                               return squared_distance(a) < squared_distance(b);
                             });
  }

  const std::vector<Contour_place>& places_;
  double sign_;
};

/*!
Moves means of contours that lie outside of the solid inside. Each is that of the contours at a
vertex; where one parts there, of a part, and the whole contour is looked at. It goes to the centre
of a ball that touches one of these and holds none of their places: the nearest ball of which the
centre is inside, if there is one. All other means stay.

Contours are walked along as long as they are not longer, on the average, than so many times the
number of vertices in all.
*/
inline void lead_inside(Execution execution,
                        const Flat_mesh& mesh,
                        const Sweep_order& order,
                        const std::vector<Index>& vertices,
                        std::vector<Vector>& means) {
  constexpr std::size_t steps_per_vertex = 2;
  const std::vector<int> winding = winding_numbers(execution, mesh, means);
  std::vector<std::size_t> outside;
  std::ptrdiff_t sum = 0;
  for(std::size_t i = 0; i < winding.size(); ++i) {
    sum += winding[i];
    if(winding[i] == 0)
      outside.push_back(i);
  }
  if(outside.empty())
    return;
  const double sign = sum < 0 ? -1. : 1.;
  const std::size_t largest_number = steps_per_vertex * mesh.number_of_vertices() / outside.size();
  std::vector<std::vector<Vector>> centres(outside.size());
  for_each_index(
      execution, outside.size(),
      [&](std::size_t i) {
        const auto places = contour_places(mesh, order, vertices[outside[i]], largest_number);
        centres[i] = Centres_of_contour(places, sign)(means[outside[i]]);
      },
      16);
  std::vector<Vector> all;
  for(const std::vector<Vector>& some : centres)
    all.insert(all.end(), some.begin(), some.end());
  const std::vector<int> winding_of_centres = winding_numbers(execution, mesh, all);
  if(winding_of_centres.empty())
    return;
  std::size_t next = 0;
  for(std::size_t i = 0; i < outside.size(); ++i) {
    bool is_outside = true;
    for(const Vector& centre : centres[i]) {
      if(is_outside && winding_of_centres[next] != 0) {
        means[outside[i]] = centre;
        is_outside = false;
      }
      ++next;
    }
  }
}

/// How much of each line lies outside of the solid, about: looked at in places that are so far
/// apart, and at least once on each of its segments. Nothing where winding numbers are not known.
inline std::vector<double> lengths_outside(Execution execution,
                                           const Flat_mesh& mesh,
                                           const std::vector<Polyline>& lines,
                                           double spacing) {
  struct Part
  {
    std::size_t line;
    double length;
  };
  constexpr double largest_number = 32.;
  std::vector<Vector> places;
  std::vector<Part> parts;
  for(std::size_t l = 0; l < lines.size(); ++l)
    for(std::size_t i = 1; i < lines[l].size(); ++i) {
      const Vector &a = lines[l][i - 1], way = lines[l][i] - a;
      const double length = norm(way);
      if(!(length > 0.))
        continue;
      const int number = static_cast<int>((std::min)(length / spacing, largest_number)) + 1;
      for(int j = 0; j < number; ++j) {
        places.push_back(a + ((j + 0.5) / number) * way);
        parts.push_back({l, length / number});
      }
    }
  const std::vector<int> winding = winding_numbers(execution, mesh, places);
  std::vector<double> outside(lines.size(), 0.);
  for(std::size_t i = 0; i < winding.size(); ++i)
    if(winding[i] == 0)
      outside[parts[i].line] += parts[i].length;
  return outside;
}

/// rounds off the steps of a polyline; the ends stay.
inline void smooth(Polyline& line, int number_of_rounds) {
  for(int round = 0; round < number_of_rounds; ++round) {
    Vector before = line.front();
    for(std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Vector old = line[i];
      line[i] = 0.25 * (before + line[i + 1]) + 0.5 * old;
      before = old;
    }
  }
}

constexpr int rounds_of_smoothing = 10;

/// rounds off the steps of the lines; where that takes a line outside, less, or not at all.
inline void round_off(Execution execution,
                      const Flat_mesh& mesh,
                      double spacing,
                      std::vector<Polyline>& lines) {
  constexpr int fewer_rounds[] = {3, 0};
  constexpr double gain = 0.8; // of the length outside is left at most, where a line is less round
  const std::vector<Polyline> edged = lines;
  for_each_index(
      execution, lines.size(), [&](std::size_t i) { smooth(lines[i], rounds_of_smoothing); }, 256);
  const std::vector<double> outside = lengths_outside(execution, mesh, lines, spacing);
  std::vector<Polyline> others;
  for(std::size_t i = 0; i < lines.size(); ++i)
    if(outside[i] > 0.)
      for(const int rounds : fewer_rounds) {
        others.push_back(edged[i]);
        smooth(others.back(), rounds);
      }
  const std::vector<double> others_outside = lengths_outside(execution, mesh, others, spacing);
  std::size_t next = 0;
  for(std::size_t i = 0; i < lines.size(); ++i)
    if(outside[i] > 0.) {
      double least = outside[i];
      for(std::size_t j = next; j < next + std::size(fewer_rounds); ++j)
        if(others_outside[j] < gain * least) {
          least = others_outside[j];
          lines[i] = std::move(others[j]);
        }
      next += std::size(fewer_rounds);
    }
}

/// what is drawn of saddles and along arcs goes inside, where it is not.
inline void lead_inside(Execution execution,
                        const Flat_mesh& mesh,
                        const Sweep_order& order,
                        std::vector<Flat_reeb_graph::Node>& nodes,
                        std::vector<Reeb_means>& all_means) {
  std::vector<Index> vertices;
  std::vector<Vector> points;
  const auto add = [&](Index vertex, const Vector& point) {
    vertices.push_back(vertex);
    points.push_back(point);
  };
  for(const Flat_reeb_graph::Node& node : nodes)
    if(node.kind == Node_kind::SADDLE)
      add(node.vertex, node.position);
  for(const Reeb_means& means : all_means)
    for(const Reeb_mean& mean : means)
      add(mean.vertex, to_vector(mean.position));
  lead_inside(execution, mesh, order, vertices, points);
  auto point = points.begin();
  for(Flat_reeb_graph::Node& node : nodes)
    if(node.kind == Node_kind::SADDLE)
      node.position = *point++;
  for(Reeb_means& means : all_means)
    for(Reeb_mean& mean : means)
      mean.position = to_float_point(*point++);
}

/// whether there are so many means that the function must be noise, which nobody looks at.
inline bool are_means_of_noise(const Flat_mesh& mesh, const std::vector<Reeb_means>& means) {
  std::size_t number = means.size();
  for(const Reeb_means& some : means)
    number += some.size();
  return number > mesh.number_of_vertices() / 8 + 1000;
}

/// Draws the lines of a graph, inside of the solid as far as may be. What is inside already stays
/// where it is, and so does all where the function is noise.
inline void draw_lines(Execution execution,
                       const Flat_mesh& mesh,
                       const Sweep_order& order,
                       Undrawn_reeb_graph& undrawn) {
  Embedded_reeb_graph& graph = undrawn.graph;
  const bool is_noise = are_means_of_noise(mesh, undrawn.means);
  if(!is_noise)
    lead_inside(execution, mesh, order, graph.nodes, undrawn.means);
  std::vector<Polyline> lines(graph.arcs.size());
  for(std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].push_back(graph.nodes[graph.arcs[i].lower].position);
    for(const Reeb_mean& mean : undrawn.means[i])
      lines[i].push_back(to_vector(mean.position));
    lines[i].push_back(graph.nodes[graph.arcs[i].upper].position);
  }
  if(!is_noise)
    round_off(execution, mesh, mean_edge_length(mesh), lines);
  else
    for_each_index(
        execution, lines.size(), [&](std::size_t i) { smooth(lines[i], rounds_of_smoothing); },
        256);
  for(std::size_t i = 0; i < lines.size(); ++i)
    graph.arcs[i].line = std::move(lines[i]);
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_DRAW_LINES_H
