// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_SHAPES_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_SHAPES_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Bridge_arcs.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>
#include <CGAL/squared_distance_3.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// The vertices of a mesh with the values of a function, and the arcs of its Reeb graph that they
/// belong to.
template <typename TriangleMesh_,
          typename VertexIndexMap,
          typename VertexArcMap,
          typename VertexValueMap>
class Vertices_on_arcs
{
public:
  using Triangle_mesh = TriangleMesh_;
  using Vertex = typename boost::graph_traits<Triangle_mesh>::vertex_descriptor;

  Vertices_on_arcs(const Triangle_mesh& tm,
                   VertexIndexMap index,
                   VertexArcMap arc,
                   VertexValueMap value)
      : tm_(tm)
      , index_(index)
      , arc_(arc)
      , value_(value) {}

  const Triangle_mesh& mesh() const { return tm_; }
  std::size_t arc(Vertex v) const { return get(arc_, v); }
  double value(Vertex v) const { return get(value_, v); }

  /// by value, of equal ones by number.
  bool is_before(Vertex v, Vertex w) const {
    return std::make_pair(value(v), get(index_, v)) < std::make_pair(value(w), get(index_, w));
  }

  /// the same for both directions of an edge.
  std::uint64_t edge(Vertex v, Vertex w) const { return edge_key(get(index_, v), get(index_, w)); }

private:
  const Triangle_mesh& tm_;
  VertexIndexMap index_;
  VertexArcMap arc_;
  VertexValueMap value_;
};

/*!
The levels at which arcs meet.

Two arcs meet along the contour of the node between them; but where the simplification moved that
node, along one at another level, and where it took leaves off, not quite along a contour. So each
border between two arcs, as far as it is connected, gets the level at which it crosses most of its
edges.
*/
template <typename Vertices> class Border_levels
{
  using Triangle_mesh = typename Vertices::Triangle_mesh;
  using Vertex = typename Vertices::Vertex;
  using Halfedge = typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor;

public:
  /// `node_level(a, b)` is the level of the node at which arc a ends and b begins, if there is one.
  template <typename NodeLevel>
  Border_levels(const Vertices& vertices, const NodeLevel& node_level)
      : vertices_(vertices) {
    find_crossed_edges();
    levels_.resize(crossed_.size());
    for(const auto& number_and_border : connected_borders()) {
      const std::vector<Index>& border = number_and_border.second;
      const Crossed_edge& some = crossed_[border.front()];
      const double level = best_level(border, node_level(some.low_arc, some.high_arc));
      for(const Index i : border)
        levels_[i] = level;
    }
  }

  /// at an edge between vertices of two arcs.
  double level(Vertex v, Vertex w) const { return levels_[numbers_.at(vertices_.edge(v, w))]; }

private:
  struct Crossed_edge
  {
    Halfedge halfedge;
    double low, high;
    std::size_t low_arc, high_arc;

    bool is_between_arcs_of(const Crossed_edge& other) const {
      return std::minmax(low_arc, high_arc) == std::minmax(other.low_arc, other.high_arc);
    }
  };

  void find_crossed_edges() {
    for(const auto e : edges(vertices_.mesh())) {
      const Halfedge h = halfedge(e, vertices_.mesh());
      Vertex v = source(h, vertices_.mesh()), w = target(h, vertices_.mesh());
      if(vertices_.arc(v) == vertices_.arc(w))
        continue;
      if(vertices_.is_before(w, v))
        std::swap(v, w);
      numbers_.emplace(vertices_.edge(v, w), static_cast<Index>(crossed_.size()));
      crossed_.push_back(
          {h, vertices_.value(v), vertices_.value(w), vertices_.arc(v), vertices_.arc(w)});
    }
  }

  // By the first edge of each.
  std::map<Index, std::vector<Index>> connected_borders() const {
    Sets_of_indices sets(crossed_.size());
    const Triangle_mesh& tm = vertices_.mesh();
    for(Index i = 0; i < crossed_.size(); ++i)
      for(const Halfedge side : {crossed_[i].halfedge, opposite(crossed_[i].halfedge, tm)})
        for(const Halfedge other : {next(side, tm), prev(side, tm)}) {
          const auto beside = numbers_.find(vertices_.edge(source(other, tm), target(other, tm)));
          if(!is_border(side, tm) && beside != numbers_.end() &&
             crossed_[beside->second].is_between_arcs_of(crossed_[i]))
            sets.unite(i, beside->second);
        }
    std::map<Index, std::vector<Index>> borders;
    for(Index i = 0; i < crossed_.size(); ++i)
      borders[sets.find(i)].push_back(i);
    return borders;
  }

  double best_level(const std::vector<Index>& border, const std::optional<double>& node) const {
    std::vector<double> lows, highs;
    for(const Index i : border) {
      lows.push_back(crossed_[i].low);
      highs.push_back(crossed_[i].high);
    }
    std::sort(lows.begin(), lows.end());
    std::sort(highs.begin(), highs.end());
    const auto crossed_at = [&](double level) { // edges that begin below it less those that end
      return (std::upper_bound(lows.begin(), lows.end(), level) - lows.begin()) -
             (std::lower_bound(highs.begin(), highs.end(), level) - highs.begin());
    };
    // Most are crossed just above the low end of some edge, up to the next high end.
    double best = node.value_or(lows.back());
    auto most = node ? crossed_at(*node) : 0;
    for(const double low : lows)
      if(const auto count = crossed_at(low); count > most) {
        most = count;
        best = low / 2. + *std::lower_bound(highs.begin(), highs.end(), low) / 2.;
      }
    return best;
  }

  const Vertices& vertices_;
  std::vector<Crossed_edge> crossed_;
  std::unordered_map<std::uint64_t, Index> numbers_; // of crossed edges
  std::vector<double> levels_;                       // by crossed edge
};

/// A part of a face, or of an edge: where the function has values from `low` to `high`, it belongs
/// to an arc.
struct Face_part
{
  std::size_t arc;
  double low, high;

  friend bool operator==(const Face_part& a, const Face_part& b) {
    return a.arc == b.arc && a.low == b.low && a.high == b.high;
  }
};

/*!
The arcs that faces belong to. A face whose vertices belong to different arcs is passed by fronts of
all these, one after the other: they meet at the contours of the nodes between them, or, where the
simplification moved these, at those of `Border_levels`.
*/
template <typename Vertices, typename Graph> class Face_arcs
{
public:
  using Vertex = typename Vertices::Vertex;
  using Corners = std::array<Vertex, 3>;

  /// all that is given must outlive the object.
  Face_arcs(const Vertices& vertices, const Graph& graph)
      : vertices_(vertices)
      , graph_(graph)
      , low_node_(num_edges(graph))
      , high_node_(num_edges(graph))
      , arcs_up_(num_vertices(graph)) {
    for(const auto e : CGAL::make_range(edges(graph))) {
      const std::size_t arc = graph[e].index;
      low_node_[arc] = source(e, graph);
      high_node_[arc] = target(e, graph);
    }
    for(std::size_t arc = 0; arc < low_node_.size(); ++arc)
      arcs_up_[low_node_[arc]].push_back(arc);
    borders_.emplace(vertices,
                     [this](std::size_t a, std::size_t b) { return level_between(a, b); });
  }

  /// the vertices of a face by increasing value.
  Corners corners_of(
      typename boost::graph_traits<typename Vertices::Triangle_mesh>::face_descriptor f) const {
    Corners corners;
    std::size_t i = 0;
    for(const Vertex v :
        CGAL::vertices_around_face(halfedge(f, vertices_.mesh()), vertices_.mesh()))
      corners[i++] = v;
    std::sort(corners.begin(), corners.end(),
              [this](Vertex v, Vertex w) { return vertices_.is_before(v, w); });
    return corners;
  }

  /// the parts of the face that has these vertices, by increasing value, from below, as one finds
  /// them on the way over the one in the middle.
  std::vector<Face_part> parts_of(const Corners& corners) {
    if(is_of_one_arc(corners))
      return {{vertices_.arc(corners[0]), value(corners[0]), value(corners[2])}};
    std::vector<Face_part> parts = parts_of(corners[0], corners[1]);
    append(corners[1], corners[2], parts);
    return parts;
  }

  /// the parts of an edge, from its lower vertex upwards.
  std::vector<Face_part> parts_of(Vertex low, Vertex high) {
    std::vector<Face_part> parts = {{vertices_.arc(low), value(low), value(low)}};
    append(low, high, parts);
    return parts;
  }

private:
  using Path = std::vector<std::size_t>;

  double value(Vertex v) const { return vertices_.value(v); }

  // As nearly always.
  bool is_of_one_arc(const Corners& corners) const {
    const std::size_t arc = vertices_.arc(corners[0]);
    return vertices_.arc(corners[1]) == arc && vertices_.arc(corners[2]) == arc;
  }

  // What is passed on the way from a vertex to a higher one of the same face.
  void append(Vertex from, Vertex to, std::vector<Face_part>& parts) {
    const Path passed = path_along_edge(from, to);
    for(const std::size_t arc : passed) {
      const double level = passed.size() == 1 ? borders_->level(from, to)
                                              : level_between(parts.back().arc, arc).value();
      // Borders that are not quite contours leave the level here and there.
      const double least = (std::max)(parts.back().low, value(from));
      parts.back().high = std::clamp(level, least, value(to));
      parts.push_back({arc, parts.back().high, value(to)});
    }
    parts.back().high = value(to);
  }

  // The arcs after the first one. Where several ways lead upwards, a vertex beside the edge that is
  // between its ends tells which of them is meant.
  Path path_along_edge(Vertex from, Vertex to) {
    const std::size_t first = vertices_.arc(from), last = vertices_.arc(to);
    const Path& some = path(first, last);
    if(some.size() <= 1)
      return some;
    const auto& tm = vertices_.mesh();
    const auto h = halfedge(from, to, tm).first;
    for(const auto side : {h, opposite(h, tm)}) {
      if(is_border(side, tm))
        continue;
      const Vertex beside = target(next(side, tm), tm);
      const std::size_t arc = vertices_.arc(beside);
      if(arc == first || arc == last || !(value(from) < value(beside) && value(beside) < value(to)))
        continue;
      Path path_over = path(first, arc);
      const Path& rest = path(arc, last);
      if(level_between(first, path_over.front()) && level_between(arc, rest.front())) {
        path_over.insert(path_over.end(), rest.begin(), rest.end());
        return path_over;
      }
    }
    return some;
  }

  // The arcs after the first one.
  const Path& path(std::size_t from, std::size_t to) {
    const auto [position, is_new] = paths_.try_emplace({from, to});
    if(is_new && from != to)
      position->second = find_path(from, to);
    return position->second;
  }

  // The shortest way upwards; if there is none, straight.
  Path find_path(std::size_t from, std::size_t to) const {
    constexpr std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::size_t> before(low_node_.size(), none);
    std::queue<std::size_t> queue;
    queue.push(from);
    before[from] = from;
    while(!queue.empty() && before[to] == none) {
      for(const std::size_t arc : arcs_up_[high_node_[queue.front()]])
        if(before[arc] == none) {
          before[arc] = queue.front();
          queue.push(arc);
        }
      queue.pop();
    }
    if(before[to] == none)
      return {to};
    Path path;
    for(std::size_t arc = to; arc != from; arc = before[arc])
      path.push_back(arc);
    std::reverse(path.begin(), path.end());
    return path;
  }

  std::optional<double> level_between(std::size_t lower, std::size_t upper) const {
    if(high_node_[lower] != low_node_[upper])
      return std::nullopt;
    return graph_[high_node_[lower]].value;
  }

  const Vertices& vertices_;
  const Graph& graph_;
  std::vector<std::size_t> low_node_, high_node_; // by arc
  std::vector<std::vector<std::size_t>> arcs_up_; // by node
  std::optional<Border_levels<Vertices>> borders_;
  std::map<std::pair<std::size_t, std::size_t>, Path> paths_;
};

template <typename Point> double distance_of_points(const Point& p, const Point& q) {
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q)));
}

/// Contours just below a vertex: they part the vertices before it from the others.
template <typename Vertices, typename VertexPointMap> class Contour_below
{
  using Triangle_mesh = typename Vertices::Triangle_mesh;
  using Vertex = typename Vertices::Vertex;
  using Halfedge = typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor;

public:
  Contour_below(const Vertices& vertices, VertexPointMap point, Vertex v)
      : vertices_(vertices)
      , tm_(vertices.mesh())
      , point_(point)
      , v_(v) {}

  bool is_below(Vertex u) const { return vertices_.is_before(u, v_); }

  /// calls `f(h)` for the edges at a vertex that contours cross, with the lower end as the source.
  template <typename Function> void for_each_crossed_edge_at(Vertex u, const Function& f) const {
    for(const Halfedge in : CGAL::halfedges_around_target(halfedge(u, tm_), tm_))
      if(is_below(source(in, tm_)) != is_below(u))
        f(is_below(u) ? opposite(in, tm_) : in);
  }

  /// goes along the contour that crosses an edge, unless it has been there: returns its length, and
  /// calls `visit(low, high)` for the ends of all edges that it crosses.
  template <typename Visit> std::optional<double> follow(Halfedge first, const Visit& visit) {
    if(!arrive(first, visit))
      return std::nullopt;
    double length = 0.;
    Halfedge h = first;
    while(!is_border(h, tm_)) { // the face to the left of it is next
      const bool is_apex_below = is_below(target(next(h, tm_), tm_));
      const Halfedge to = opposite(is_apex_below ? next(h, tm_) : prev(h, tm_), tm_);
      length += distance_of_points(place(h), place(to));
      if(to == first)
        return length;
      arrive(to, visit);
      h = to;
    }
    for(h = opposite(first, tm_); !is_border(h, tm_);) { // and backwards from where it began
      const bool is_apex_below = is_below(target(next(h, tm_), tm_));
      const Halfedge from = is_apex_below ? prev(h, tm_) : next(h, tm_);
      length += distance_of_points(place(opposite(h, tm_)), place(from));
      arrive(from, visit);
      h = opposite(from, tm_);
    }
    return length;
  }

private:
  template <typename Visit> bool arrive(Halfedge h, const Visit& visit) {
    const Vertex low = source(h, tm_), high = target(h, tm_);
    if(!seen_.insert(vertices_.edge(low, high)).second)
      return false;
    visit(low, high);
    return true;
  }

  auto place(Halfedge h) const {
    const Vertex v = source(h, tm_), w = target(h, tm_);
    const double low = vertices_.value(v), high = vertices_.value(w);
    const double ratio = low < high ? (vertices_.value(v_) - low) / (high - low) : 0.;
    return get(point_, v) + ratio * (get(point_, w) - get(point_, v));
  }

  const Vertices& vertices_;
  const Triangle_mesh& tm_;
  VertexPointMap point_;
  Vertex v_;
  std::unordered_set<std::uint64_t> seen_; // edges
};

/// how long the contour of an arc is half way. See `CGAL::reeb_arc_girths()`.
template <typename Vertices, typename Arc, typename VertexPointMap>
double girth_of_arc(const Vertices& vertices,
                    const Arc& arc,
                    typename Vertices::Vertex lower,
                    typename Vertices::Vertex upper,
                    VertexPointMap point) {
  using Vertex = typename Vertices::Vertex;
  const Vertex middle = arc.vertices.empty() ? upper : arc.vertices[arc.vertices.size() / 2];
  Contour_below<Vertices, VertexPointMap> contours(vertices, point, middle);
  std::pair<std::size_t, double> best; // edges of the arc, length
  const auto follow = [&](const auto h, const auto& counts) {
    std::size_t count = 0;
    const auto length =
        contours.follow(h, [&](Vertex low, Vertex high) { count += counts(low, high) ? 1 : 0; });
    if(length)
      best = (std::max)(best, std::make_pair(count, *length));
  };
  const auto is_on_arc = [&](Vertex low, Vertex high) {
    return vertices.arc(low) == arc.index && vertices.arc(high) == arc.index;
  };
  for(const Vertex u : arc.vertices)
    if(contours.is_below(u))
      contours.for_each_crossed_edge_at(u, [&](const auto h) {
        if(vertices.arc(target(h, vertices.mesh())) == arc.index)
          follow(h, is_on_arc);
      });
  if(best.first == 0) // it has hardly any vertices: it leads from its lower node to the middle
    contours.for_each_crossed_edge_at(
        middle, [&](const auto h) { follow(h, [&](Vertex low, Vertex) { return low == lower; }); });
  return best.second;
}

/// by arc. See `CGAL::reeb_arc_girths()`.
template <typename Vertices, typename Graph, typename VertexPointMap>
std::vector<double>
girths_of_arcs(const Vertices& vertices, const Graph& graph, VertexPointMap point) {
  std::vector<double> girths(num_edges(graph));
  for(const auto e : CGAL::make_range(edges(graph)))
    girths[graph[e].index] = girth_of_arc(vertices, graph[e], graph[source(e, graph)].vertex,
                                          graph[target(e, graph)].vertex, point);
  return girths;
}

// Vertices and points of a polyline follow each other by the same values, so that the nearest one
// is not far from that of the vertex before.
template <typename Point>
std::size_t nearest_place(const std::vector<Point>& line, const Point& p, std::size_t k) {
  const auto squared = [&](std::size_t i) { return CGAL::squared_distance(line[i], p); };
  while(k + 1 < line.size() && squared(k + 1) <= squared(k))
    ++k;
  while(k > 0 && squared(k - 1) < squared(k))
    --k;
  return k;
}

// Fills places without a number from both sides.
inline void fill_gaps(const std::vector<std::size_t>& counts, std::vector<double>& numbers) {
  const std::size_t n = numbers.size();
  for(std::size_t i = 0; i < n; ++i) {
    if(counts[i] > 0)
      continue;
    std::size_t end = i;
    while(end < n && counts[end] == 0)
      ++end;
    const double before = i > 0 ? numbers[i - 1] : numbers[end];
    const double after = end < n ? numbers[end] : before;
    for(std::size_t k = i; k < end; ++k) {
      const double t = static_cast<double>(k - i + 1) / static_cast<double>(end - i + 1);
      numbers[k] = before + t * (after - before);
    }
    i = end;
  }
}

/// by point of the polyline of an arc, how far away its vertices are. See `CGAL::Reeb_arc_shapes`.
template <typename Arc, typename VertexPointMap>
std::vector<double> radii_of_arc(const Arc& arc, VertexPointMap point, double girth) {
  std::vector<double> radii(arc.polyline.size(), 0.);
  std::vector<std::size_t> counts(radii.size(), 0);
  std::size_t k = 0;
  for(const auto v : arc.vertices) {
    k = nearest_place(arc.polyline, get(point, v), k);
    radii[k] += distance_of_points(arc.polyline[k], get(point, v));
    ++counts[k];
  }
  if(arc.vertices.empty())
    return std::vector<double>(radii.size(), girth / (2. * CGAL_PI));
  for(std::size_t i = 0; i < radii.size(); ++i)
    if(counts[i] > 0)
      radii[i] /= static_cast<double>(counts[i]);
  fill_gaps(counts, radii);
  return radii;
}

/// by arc, whether the graph stays connected without it.
template <typename Graph> std::vector<bool> arcs_on_cycles(const Graph& graph) {
  Flat_reeb_graph flat;
  flat.nodes.resize(num_vertices(graph));
  flat.arcs.resize(num_edges(graph));
  for(const auto e : CGAL::make_range(edges(graph))) {
    flat.arcs[graph[e].index].lower = static_cast<Index>(source(e, graph));
    flat.arcs[graph[e].index].upper = static_cast<Index>(target(e, graph));
  }
  const std::vector<double> weights(flat.arcs.size());
  const Bridge_arcs bridges(flat, weights);
  std::vector<bool> is_on_cycle(flat.arcs.size());
  for(Index arc = 0; arc < is_on_cycle.size(); ++arc)
    is_on_cycle[arc] = !bridges.is_bridge(arc);
  return is_on_cycle;
}

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_REEB_ARC_SHAPES_H
