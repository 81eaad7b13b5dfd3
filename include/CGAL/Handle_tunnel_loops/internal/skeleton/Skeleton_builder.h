// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_BUILDER_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_BUILDER_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/linking/Component_orientation.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Arc_smoothing.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Ball_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inlet_ways.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_balls.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Inner_cycles.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Limbs.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Loop_curtains.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Segments_apart.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Skeleton_draft.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Surface_pieces.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Surface_samples.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/Wall.h>
#include <CGAL/Handle_tunnel_loops/internal/skeleton/find_skeleton.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Shortest_paths.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// the same places, scaled by a power of two so that no coordinate is larger than 1.
inline std::vector<Vector> scaled_places(const std::vector<Vector>& places, int exponent) {
  std::vector<Vector> scaled = places;
  for(Vector& p : scaled)
    for(double& x : p)
      x = std::ldexp(x, -exponent);
  return scaled;
}

inline int exponent_of_largest(const std::vector<Vector>& places) {
  double largest = 0.;
  for(const Vector& p : places)
    for(double x : p)
      largest = (std::max)(largest, std::abs(x));
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}

/// makes points that an edge of no length joins one.
inline void contract_points(Flat_skeleton& flat) {
  const std::size_t n = flat.points.size();
  Sets_of_indices sets(n);
  for(const auto& [p, q] : flat.edges)
    if(flat.points[p] == flat.points[q])
      sets.unite(p, q);
  std::vector<Index> number(n);
  Index next = 0;
  for(Index p = 0; p < n; ++p) {
    if(const Index first = sets.find(p); first != p) {
      number[p] = number[first];
      continue;
    }
    number[p] = next;
    flat.points[next] = flat.points[p];
    flat.radii[next] = flat.radii[p];
    flat.component_of[next] = flat.component_of[p];
    flat.is_inlet[next] = flat.is_inlet[p];
    ++next;
  }
  flat.points.resize(next);
  flat.radii.resize(next);
  flat.component_of.resize(next);
  flat.is_inlet.resize(next);
  std::size_t kept = 0;
  for(const auto& [p, q] : flat.edges)
    if(number[p] != number[q])
      flat.edges[kept++] = {number[p], number[q]};
  flat.edges.resize(kept);
}

/*!
Finds a skeleton in the steps that the files of this folder are named after: balls in the middle of
the solid and the graph of these; cycles, which are a basis; inlets and limbs; joints as stars and
smooth arcs; and proves it.
*/
class Skeleton_builder
{
public:
  Skeleton_builder(Execution execution,
                   const Flat_mesh& mesh,
                   const std::vector<Vector>& places,
                   const std::vector<Flat_pair>& pairs,
                   const Skeleton_options& options,
                   const Face_number& face_number)
      : execution_(execution)
      , mesh_(mesh)
      , places_(places)
      , exponent_(exponent_of_largest(places))
      , points_(scaled_places(places, exponent_))
      , pairs_(pairs)
      , options_(options)
      , face_number_(face_number)
      , faces_(execution, mesh, points_)
      , wall_(mesh, points_, faces_)
      , area_(area())
      , pieces_(execution, mesh, wall_, spacing())
      , balls_(wall_, inward_sides())
      , paths_(paths_around())
      , samples_(execution, pieces_, balls_, least_extent(), paths_)
      , neighbors_(samples_.neighbors(execution)) {}

  Found_skeleton build() {
    graph_ = graph_builder().build();
    const std::vector<Index> inlets =
        Inlet_ways(mesh_, points_, wall_, pieces_, samples_).add(graph_);
    take_cycles();
    Limbs(graph_, samples_, neighbors_, options_.shortest_limb)
        .add(roots_, inlets, least_length(), is_taken_);
    Found_skeleton found;
    for(const bool is_smooth : {true, false}) {
      Skeleton_draft draft(graph_, is_taken_, roots_);
      if(is_smooth)
        draft.draw_stars(wall_);
      found.skeleton = drawn(draft, is_smooth);
      move_apart(found.skeleton);
      measure(found.skeleton);
      found.point_of_vertex = points_of_vertices(found.skeleton);
      scale_back(found.skeleton);
      found.certificate = certify_skeleton(execution_, mesh_, places_, found.skeleton,
                                           walks_across(), face_number_);
      if(found.certificate)
        break;
    }
    found.number_of_balls = graph_.balls.size();
    return found;
  }

private:
  static constexpr double largest_number_of_samples = 60000., number_of_pieces = 50000.,
                          part_of_diagonal = 0.025;

  // ---- the surface

  double area() const {
    double sum = 0.;
    for(Index f = 0; f < wall_.size(); ++f)
      if(!wall_.is_of_cap(f))
        sum += 0.5 * norm(wall_.normal(f));
    return sum;
  }

  // Faces without any area are not divided.
  double spacing() const {
    return area_ > 0. ? std::sqrt(area_ / number_of_pieces)
                      : std::numeric_limits<double>::infinity();
  }

  // Of the region of a sample.
  double least_extent() const { return std::sqrt(area_ / largest_number_of_samples); }

  double least_length() const {
    Box<3> all = Box<3>::empty();
    for(const Vector& p : points_)
      all.extend({p, p});
    return part_of_diagonal * norm(all.high - all.low);
  }

  // Where the bounded side of the components is.
  std::vector<int> inward_sides() const {
    std::vector<int> sides = signs_of_volumes(mesh_.seeds.size(), [this](const auto& add) {
      for(Index f = 0; f < wall_.size(); ++f)
        add(wall_.component(f), faces_.triangle(f));
    });
    for(int& side : sides)
      side = -side;
    return sides;
  }

  Vector place(const Crossing& c) const {
    const double ratio = ratio_on_surface(mesh_, c);
    return (1. - ratio) * points_[c.left] + ratio * points_[c.right];
  }

  // Whether the loops that are called handles are known to bound on the bounded side: on the walls
  // of a cavity the solid is outside, and with a boundary it is where the normals do not look.
  bool are_names_known() const { return mesh_.seeds.size() == 1 && mesh_.number_of_hubs == 0; }

  // Which loops of a pair lead around inside.
  std::vector<const Crossing_loop*> loops_around() const {
    std::vector<const Crossing_loop*> loops;
    for(const Flat_pair& pair : pairs_) {
      loops.push_back(&pair.tunnel);
      if(!are_names_known())
        loops.push_back(&pair.handle);
    }
    return loops;
  }
  std::vector<const Crossing_loop*> loops_across() const {
    std::vector<const Crossing_loop*> loops;
    for(const Flat_pair& pair : pairs_) {
      loops.push_back(&pair.handle);
      if(!are_names_known())
        loops.push_back(&pair.tunnel);
    }
    return loops;
  }

  // The pieces that loops pass which lead around.
  std::vector<std::vector<Index>> paths_around() const {
    std::vector<std::vector<Index>> paths;
    const double step = 0.25 * spacing();
    for(const Crossing_loop* loop : loops_around()) {
      std::vector<Index> path;
      for(std::size_t i = 0; i < loop->size(); ++i) {
        const Crossing &a = (*loop)[i], &b = (*loop)[i + 1 < loop->size() ? i + 1 : 0];
        const Index f = pieces_.face_left_of(a.left, a.right);
        if(wall_.is_of_cap(f))
          continue;
        const Vector from = place(a), way = place(b) - from;
        const int n = 1 + static_cast<int>(norm(way) / step);
        for(int k = 0; k < n; ++k) {
          const Index piece = pieces_.piece_at(f, from + ((k + 0.5) / n) * way);
          if(path.empty() || path.back() != piece)
            path.push_back(piece);
        }
      }
      paths.push_back(std::move(path));
    }
    return paths;
  }

  // ---- cycles

  // A loop passes an edge to a hub at its other end.
  std::vector<std::vector<Index>> walks_across() const {
    std::vector<std::vector<Index>> walks;
    for(const Crossing_loop* loop : loops_across()) {
      std::vector<Index> walk;
      for(const Crossing& c : *loop)
        if(const Index v = mesh_.is_hub(c.left) ? c.right : c.left;
           walk.empty() || walk.back() != v)
          walk.push_back(v);
      while(walk.size() > 1 && walk.front() == walk.back())
        walk.pop_back();
      walks.push_back(std::move(walk));
    }
    return walks;
  }

  void take_cycles() {
    std::vector<std::vector<Index>> walks = walks_across();
    std::stable_sort(walks.begin(), walks.end(), [this](const auto& a, const auto& b) {
      return mesh_.component[a[0]] < mesh_.component[b[0]];
    });
    std::vector<std::vector<Vector>> loops;
    std::vector<Index> components;
    for(const std::vector<Index>& walk : walks) {
      components.push_back(mesh_.component[walk[0]]);
      loops.emplace_back();
      for(Index v : walk)
        loops.back().push_back(points_[v]);
    }
    const auto choose = [&] {
      const Inner_cycles cycles(execution_, graph_, loops, components, genus());
      is_taken_ = cycles.is_taken();
      roots_ = cycles.roots();
      return cycles.number_of_missing_cycles();
    };
    if(choose() > 0) { // holes that are small against the balls around them
      graph_builder().add_ways_along_wall(paths_, graph_);
      choose();
    }
    prune();
  }

  // By component: each pair is of one.
  std::vector<std::size_t> genus() const {
    std::vector<std::size_t> genus(mesh_.seeds.size(), 0);
    for(const Flat_pair& pair : pairs_)
      ++genus[mesh_.component[pair.handle.front().left]];
    return genus;
  }

  Ball_graph_builder graph_builder() const {
    return {execution_, wall_, pieces_, balls_, samples_, neighbors_};
  }

  // Takes back what leads to no cycle.
  void prune() {
    std::vector<Index> degree(graph_.balls.size(), 0), ends;
    for(Index e = 0; e < graph_.edges.size(); ++e)
      if(is_taken_[e])
        for(Index b : graph_.edges[e])
          ++degree[b];
    for(Index b = 0; b < degree.size(); ++b)
      if(degree[b] == 1)
        ends.push_back(b);
    while(!ends.empty()) {
      const Index b = ends.back();
      ends.pop_back();
      graph_.for_each_beside(b, [&](Index other, Index e) {
        if(is_taken_[e] == 0)
          return;
        is_taken_[e] = 0;
        --degree[b];
        if(--degree[other] == 1)
          ends.push_back(other);
      });
    }
  }

  // ---- the drawing

  Flat_skeleton drawn(const Skeleton_draft& draft, bool is_smooth) const {
    Flat_skeleton flat;
    std::vector<Index> point(draft.size(), no_index);
    const auto add = [&](const Inner_ball& ball, const Skeleton_draft::Place& of, bool is_inlet) {
      flat.points.push_back(ball.centre);
      flat.radii.push_back(ball.radius);
      flat.component_of.push_back(of.component);
      flat.is_inlet.push_back(is_inlet);
      return static_cast<Index>(flat.points.size() - 1);
    };
    const auto point_of = [&](Index p) {
      if(point[p] == no_index)
        point[p] = add(draft[p].ball, draft[p], draft[p].is_inlet);
      return point[p];
    };
    const std::vector<std::vector<Index>> arcs = draft.arcs();
    std::vector<Arc_smoothing::Balls> lines(arcs.size());
    const Arc_smoothing smooth(wall_, balls_, least_extent());
    for_each_index(
        execution_, arcs.size(),
        [&](std::size_t i) {
          for(Index p : arcs[i])
            lines[i].push_back(draft[p].ball);
          if(is_smooth)
            lines[i] =
                smooth(lines[i], draft[arcs[i].front()].is_inlet, draft[arcs[i].back()].is_inlet);
          if(is_smooth && !draft.is_node(arcs[i].front())) // a cycle: also where it began
            lines[i] = smooth(turned_by_half(lines[i]), false, false);
        },
        1);
    for(Index p = 0; p < draft.size(); ++p)
      if(draft[p].beside.empty() && draft[p].ball.radius >= 0.)
        point_of(p);
    for(std::size_t i = 0; i < arcs.size(); ++i) {
      const Skeleton_draft::Place& front = draft[arcs[i].front()];
      const bool is_cycle = !draft.is_node(arcs[i].front());
      const Index first =
          is_cycle ? add(lines[i].front(), front, false) : point_of(arcs[i].front());
      Index before = first;
      for(std::size_t k = 1; k < lines[i].size(); ++k) {
        const Index next = k + 1 < lines[i].size() ? add(lines[i][k], front, false)
                           : is_cycle              ? first
                                                   : point_of(arcs[i].back());
        flat.edges.push_back({before, next});
        before = next;
      }
    }
    contract_points(flat);
    return flat;
  }

  // The same cycle from another place.
  static Arc_smoothing::Balls turned_by_half(Arc_smoothing::Balls cycle) {
    cycle.pop_back();
    std::rotate(cycle.begin(), cycle.begin() + static_cast<std::ptrdiff_t>(cycle.size() / 2),
                cycle.end());
    cycle.push_back(cycle.front());
    return cycle;
  }

  void measure(Flat_skeleton& flat) const {
    for_each_index(
        execution_, flat.points.size(),
        [&](std::size_t p) {
          if(flat.is_inlet[p] == 0)
            flat.radii[p] =
                wall_.nearest(flat.points[p], std::numeric_limits<double>::infinity()).distance;
        },
        64);
  }

  // Moves points of edges that meet a little: on shapes with a plane of symmetry, edges in it may.
  void move_apart(Flat_skeleton& flat) const {
    constexpr int most_rounds = 32;
    constexpr double part = 1e-3; // of the radius
    std::minstd_rand random;
    const auto number = [&] { return 2. * double(random()) / double(random.max()) - 1.; };
    for(int round = 0; round < most_rounds; ++round) {
      const auto pairs = Segments_apart(flat).edges_that_meet(execution_);
      if(pairs.empty())
        return;
      for(const auto& [a, b] : pairs)
        for(const auto& edge : {a, b})
          for(Index p : edge)
            if(flat.is_inlet[p] == 0) {
              const double most = part * flat.radii[p];
              flat.points[p] =
                  flat.points[p] + Vector{most * number(), most * number(), most * number()};
            }
    }
  }

  void scale_back(Flat_skeleton& flat) const {
    for(Vector& p : flat.points)
      for(double& x : p)
        x = std::ldexp(x, exponent_);
    for(double& r : flat.radii)
      r = std::ldexp(r, exponent_);
  }

  // ---- the parts of the surface

  struct Label
  {
    double distance = (std::numeric_limits<double>::infinity)();
    Index point = no_index;
  };

  // The point that is nearest to the ball of a vertex, inside.
  std::vector<Index> points_of_vertices(const Flat_skeleton& flat) const {
    Shortest_paths<Label> paths(graph_.balls.size());
    start_at_points(flat, paths);
    graph_.grow(
        paths, [this](Index e) { return graph_.length(e); },
        [](const Label& before, double distance, Index) {
          return Label{distance, before.point};
        });
    std::vector<Index> points(mesh_.number_of_vertices(), no_index);
    for_each_index(execution_, mesh_.first_hub, [&](std::size_t i) {
      const Index v = static_cast<Index>(i);
      for(Index u : mesh_.ring(v))
        if(const Index f = pieces_.face_left_of(v, u); !wall_.is_of_cap(f)) {
          const Index sample = samples_.region(pieces_.piece_at(f, points_[v]));
          points[v] = sample == no_index ? no_index : paths[graph_.ball_of_sample[sample]].point;
          break;
        }
      if(points[v] == no_index) // on a surface that crosses itself, or of faces without area
        points[v] = first_point_of(flat, mesh_.component[v]);
    });
    return points;
  }

  static Index first_point_of(const Flat_skeleton& flat, Index component) {
    const auto it = std::find(flat.component_of.begin(), flat.component_of.end(), component);
    return it == flat.component_of.end() ? no_index
                                         : static_cast<Index>(it - flat.component_of.begin());
  }

  // Balls that hold a point of the skeleton begin with the nearest of these.
  void start_at_points(const Flat_skeleton& flat, Shortest_paths<Label>& paths) const {
    std::vector<Box<3>> boxes;
    for(const Vector& p : flat.points)
      boxes.push_back({p, p});
    const Box_tree<3> tree(std::move(boxes));
    for(Index b = 0; b < graph_.balls.size(); ++b) {
      const Inner_ball& ball = graph_.balls[b];
      const Vector corner = {ball.radius, ball.radius, ball.radius};
      Label best;
      tree.for_each_meeting({ball.centre - corner, ball.centre + corner},
                            [&](Index p, const Box<3>& box) {
                              const double distance = norm(box.low - ball.centre);
                              if(flat.component_of[p] == graph_.component[b] &&
                                 distance < ball.radius && distance < best.distance)
                                best = {distance, p};
                            });
      if(best.point != no_index)
        paths.reach(b, best);
    }
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const std::vector<Vector>& places_;
  int exponent_;
  std::vector<Vector> points_;
  const std::vector<Flat_pair>& pairs_;
  Skeleton_options options_;
  const Face_number& face_number_;
  Face_tree faces_;
  Wall wall_;
  double area_;
  Surface_pieces pieces_;
  Inner_balls balls_;
  std::vector<std::vector<Index>> paths_;
  Surface_samples samples_;
  std::vector<std::pair<Index, Index>> neighbors_;
  Ball_graph graph_;
  std::vector<char> is_taken_; // by edge
  std::vector<Index> roots_;   // by component
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SKELETON_SKELETON_BUILDER_H
