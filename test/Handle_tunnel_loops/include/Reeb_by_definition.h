#ifndef HTL_TEST_REEB_BY_DEFINITION_H
#define HTL_TEST_REEB_BY_DEFINITION_H

#include "Meshes_of_soups.h"

#include "generators/Random.h"

#include <CGAL/Handle_tunnel_loops/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <ostream>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

// The Reeb graph by its definition, from the triangles of a surface, with boundary or without: the
// components of each level set are points. A level set lies between two consecutive vertices; its
// components are pieces in triangles that meet at edges.

namespace reeb_by_definition {

using generators::Random;
using Number = std::uint32_t;
using Edge = std::pair<Number, Number>; // the lower end first

// The vertices at which not one component goes over into one, that an arc joins, and the others
// that it passes.
struct Arc
{
  Number lower, upper;
  std::vector<Number> vertices;

  bool operator<(const Arc& other) const {
    return std::tie(lower, upper, vertices) < std::tie(other.lower, other.upper, other.vertices);
  }
  bool operator==(const Arc& other) const {
    return std::tie(lower, upper, vertices) == std::tie(other.lower, other.upper, other.vertices);
  }
  friend std::ostream& operator<<(std::ostream& out, const Arc& arc) {
    out << arc.lower << " - " << arc.upper << ":";
    for(const Number v : arc.vertices)
      out << " " << v;
    return out;
  }
};

using Components = std::map<Edge, Edge>; // by crossed edge, one of the same component

// Of the level just below the vertex of a rank.
inline Components components(const Soup& soup, const std::vector<Number>& rank, Number level) {
  Components parent;
  const auto root = [&](Edge e) {
    while(parent.at(e) != e)
      e = parent.at(e);
    return e;
  };
  for(const auto& t : soup.triangles) {
    std::vector<Edge> crossed;
    for(int i = 0; i < 3; ++i) {
      Edge e(t[i], t[(i + 1) % 3]);
      if(rank[e.first] > rank[e.second])
        std::swap(e.first, e.second);
      if(rank[e.first] < level && rank[e.second] >= level)
        crossed.push_back(e);
    }
    for(const Edge& e : crossed)
      parent.emplace(e, e);
    if(!crossed.empty())
      parent[root(crossed[0])] = root(crossed[1]);
  }
  Components result;
  for(const auto& entry : parent)
    result[entry.first] = root(entry.first);
  return result;
}

// How long the components are, of the level just below a vertex, that come to this vertex: pieces
// in triangles, at the value of the vertex.
inline std::vector<double> lengths_below(const Soup& soup,
                                         const std::vector<Number>& order,
                                         const std::vector<double>& function,
                                         Number v) {
  std::vector<Number> rank(order.size());
  for(Number r = 0; r < order.size(); ++r)
    rank[order[r]] = r;
  const Components all = components(soup, rank, rank[v]);
  std::map<Edge, double> length; // by component
  for(const auto& [e, component] : all)
    if(e.second == v)
      length[component] = 0.;
  for(const auto& t : soup.triangles) {
    std::vector<std::array<double, 3>> ends;
    Edge component;
    for(int i = 0; i < 3; ++i) {
      Edge e(t[i], t[(i + 1) % 3]);
      if(rank[e.first] > rank[e.second])
        std::swap(e.first, e.second);
      const auto found = all.find(e);
      if(found == all.end())
        continue;
      component = found->second;
      const double range = function[e.second] - function[e.first];
      const double ratio = range > 0. ? (function[v] - function[e.first]) / range : 0.;
      ends.emplace_back();
      for(int d = 0; d < 3; ++d)
        ends.back()[d] = (1. - ratio) * soup.points[e.first][d] + ratio * soup.points[e.second][d];
    }
    if(!ends.empty() && length.count(component) != 0)
      length[component] +=
          std::hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1], ends[0][2] - ends[1][2]);
  }
  std::vector<double> lengths;
  for(const auto& entry : length)
    lengths.push_back(entry.second);
  return lengths;
}

// Each vertex has a face; \p order has them from the lowest to the highest.
inline std::vector<Arc> arcs_of(const Soup& soup, const std::vector<Number>& order) {
  std::vector<Number> rank(order.size());
  for(Number r = 0; r < order.size(); ++r)
    rank[order[r]] = r;
  std::vector<Arc> arcs;
  std::map<Edge, std::size_t> arc_of; // by crossed edge
  for(Number r = 0; r < order.size(); ++r) {
    const Number v = order[r];
    const Components above = components(soup, rank, r + 1);
    std::set<std::size_t> ending;
    std::set<Edge> beginning;
    for(const auto& [e, arc] : arc_of)
      if(e.second == v)
        ending.insert(arc);
    for(const auto& [e, component] : above)
      if(e.first == v)
        beginning.insert(component);
    std::map<Edge, std::size_t> arc_of_component;
    if(ending.size() == 1 && beginning.size() == 1) {
      arcs[*ending.begin()].vertices.push_back(v);
      arc_of_component[*beginning.begin()] = *ending.begin();
    } else {
      for(const std::size_t arc : ending)
        arcs[arc].upper = v;
      for(const Edge& component : beginning) {
        arc_of_component[component] = arcs.size();
        arcs.push_back({v, v, {}});
      }
    }
    for(const auto& [e, component] : above)
      if(e.first != v)
        arc_of_component.emplace(component, arc_of.at(e));
    arc_of.clear();
    for(const auto& [e, component] : above)
      arc_of[e] = arc_of_component.at(component);
  }
  for(Arc& arc : arcs)
    std::sort(arc.vertices.begin(), arc.vertices.end());
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

// The same of a full graph that was computed: nodes at one vertex are one, and no node if it is
// only passed.
template <typename Graph> std::vector<Arc> arcs_of(const Graph& graph) {
  std::vector<Arc> arcs;
  for(const auto e : CGAL::make_range(edges(graph))) {
    Arc arc = {graph[source(e, graph)].vertex, graph[target(e, graph)].vertex, {}};
    for(const auto v : graph[e].vertices)
      arc.vertices.push_back(v);
    arcs.push_back(arc);
  }
  std::map<Number, std::vector<std::size_t>> below, above; // by vertex
  std::vector<Number> vertices_of_nodes;
  for(std::size_t a = 0; a < arcs.size(); ++a)
    if(arcs[a].lower != arcs[a].upper) {
      above[arcs[a].lower].push_back(a);
      below[arcs[a].upper].push_back(a);
    }
  for(const auto v : CGAL::make_range(vertices(graph)))
    vertices_of_nodes.push_back(graph[v].vertex);
  std::set<Number> nodes(vertices_of_nodes.begin(), vertices_of_nodes.end());
  std::set<std::size_t> gone;
  std::vector<Number> passed;
  for(const Number v : std::set<Number>(nodes))
    if(below[v].size() == 1 && above[v].size() == 1) {
      const std::size_t a = below[v][0], b = above[v][0];
      arcs[a].vertices.insert(arcs[a].vertices.end(), arcs[b].vertices.begin(),
                              arcs[b].vertices.end());
      arcs[a].vertices.push_back(v);
      arcs[a].upper = arcs[b].upper;
      std::replace(below[arcs[b].upper].begin(), below[arcs[b].upper].end(), b, a);
      gone.insert(b);
      nodes.erase(v);
    }
  std::vector<Arc> result;
  for(std::size_t a = 0; a < arcs.size(); ++a)
    if(arcs[a].lower != arcs[a].upper && gone.count(a) == 0) {
      std::set<Number> passed_vertices;
      for(const Number v : arcs[a].vertices)
        if(nodes.count(v) == 0)
          passed_vertices.insert(v);
      result.push_back({arcs[a].lower, arcs[a].upper,
                        std::vector<Number>(passed_vertices.begin(), passed_vertices.end())});
    }
  std::sort(result.begin(), result.end());
  return result;
}

// ---- surfaces with boundary

// A surface with so many faces less, taken off one by one at random, unless it would be no surface;
// without the vertices that have no face.
inline Soup with_fewer_faces(const Soup& soup, std::size_t number, Random& random) {
  std::vector<std::vector<std::size_t>> faces_at(soup.points.size());
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    for(const Number v : soup.triangles[f])
      faces_at[v].push_back(f);
  // Whether the faces at a vertex, without one of them, hang together.
  const auto is_fan = [&](Number v, std::size_t left_out) {
    std::vector<std::size_t> left;
    for(const std::size_t f : faces_at[v])
      if(f != left_out)
        left.push_back(f);
    std::set<std::size_t> reached;
    std::vector<std::size_t> stack(left.begin(), left.begin() + (left.empty() ? 0 : 1));
    while(!stack.empty()) {
      const std::size_t f = stack.back();
      stack.pop_back();
      if(!reached.insert(f).second)
        continue;
      for(const std::size_t g : left)
        for(const Number u : soup.triangles[f])
          if(u != v && std::count(soup.triangles[g].begin(), soup.triangles[g].end(), u) != 0)
            stack.push_back(g);
    }
    return reached.size() == left.size();
  };
  std::vector<std::size_t> faces(soup.triangles.size());
  std::iota(faces.begin(), faces.end(), std::size_t(0));
  random.shuffle(faces);
  std::set<std::size_t> gone;
  for(const std::size_t f : faces) {
    const auto& t = soup.triangles[f];
    if(gone.size() == number || gone.size() + 1 == faces.size())
      break;
    if(std::all_of(t.begin(), t.end(), [&](Number v) { return is_fan(v, f); })) {
      gone.insert(f);
      for(const Number v : t)
        faces_at[v].erase(std::find(faces_at[v].begin(), faces_at[v].end(), f));
    }
  }
  Soup result;
  std::map<Number, Number> new_number;
  for(std::size_t f = 0; f < soup.triangles.size(); ++f)
    if(gone.count(f) == 0) {
      auto t = soup.triangles[f];
      for(Number& v : t) {
        const auto [position, is_new] =
            new_number.emplace(v, static_cast<Number>(new_number.size()));
        if(is_new)
          result.points.push_back(soup.points[v]);
        v = position->second;
      }
      result.triangles.push_back(t);
    }
  return result;
}

// Genus and numbers of cycles are summed over the components.
struct Topology
{
  std::size_t number_of_components = 0, genus = 0;
  std::size_t most_cycles =
      0; // of a Reeb graph: the genus, or 2 g + b - 1 of a component with boundary
};

inline Topology topology_of(const Soup& soup) {
  const std::size_t n = soup.points.size();
  std::vector<Number> component(n), along(n);
  std::iota(component.begin(), component.end(), Number(0));
  along = component;
  const auto root = [](std::vector<Number>& parent, Number v) {
    while(parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  std::set<Edge> halfedges;
  for(const auto& t : soup.triangles)
    for(int i = 0; i < 3; ++i) {
      halfedges.insert({t[i], t[(i + 1) % 3]});
      component[root(component, t[i])] = root(component, t[(i + 1) % 3]);
    }
  std::map<Number, std::ptrdiff_t> characteristic, boundaries; // by component
  std::set<Number> on_boundary;
  for(const auto& t : soup.triangles)
    ++characteristic[root(component, t[0])];
  for(Number v = 0; v < n; ++v)
    ++characteristic[root(component, v)];
  for(const Edge& h : halfedges) {
    const bool is_border = halfedges.count({h.second, h.first}) == 0;
    if(is_border || h.first < h.second)
      --characteristic[root(component, h.first)];
    if(is_border) {
      along[root(along, h.first)] = root(along, h.second);
      on_boundary.insert(h.first);
    }
  }
  for(const Number v : on_boundary)
    if(root(along, v) == v)
      ++boundaries[root(component, v)];
  Topology topology;
  for(const auto& [c, sum] : characteristic) {
    const std::ptrdiff_t b = boundaries[c];
    ++topology.number_of_components;
    topology.genus += static_cast<std::size_t>(2 - b - sum) / 2;
    topology.most_cycles += static_cast<std::size_t>(b == 0 ? (2 - sum) / 2 : 1 - sum);
  }
  return topology;
}

} // namespace reeb_by_definition

#endif // HTL_TEST_REEB_BY_DEFINITION_H
