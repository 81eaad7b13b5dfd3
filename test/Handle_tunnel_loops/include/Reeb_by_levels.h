#ifndef HTL_TEST_REEB_BY_LEVELS_H
#define HTL_TEST_REEB_BY_LEVELS_H

#include <CGAL/Handle_tunnel_loops/internal/reeb/Flat_reeb_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/reeb/Sweep_order.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

// The Reeb graph by its definition: the contours between any two consecutive vertices, and which of
// them touch the vertex in between.

namespace reeb_by_levels {

using namespace CGAL::Handle_tunnel_loops::internal;

// The critical points that an arc joins, and the regular vertices on it. Unfolded saddles count as
// one.
using Arc = std::tuple<Index, Index, std::vector<Index>>;

using Edge = std::pair<Index, Index>; // the lower end first
using Contours = std::map<Edge, int>; // by crossed edge, a number for each contour

// The contours at the level below the vertex of a rank: edges of one triangle are on one of them.
inline Contours contours_below(const Flat_mesh& mesh, const Sweep_order& order, Index rank) {
  std::map<Edge, int> number;
  for(Index u = 0; u < mesh.number_of_vertices(); ++u)
    for(const Index v : mesh.ring(u))
      if(order.rank(u) < rank && order.rank(v) >= rank)
        number.emplace(Edge(u, v), static_cast<int>(number.size()));
  std::vector<int> parent(number.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i) {
    while(parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  for(const auto& [edge, i] : number) {
    const auto ring = mesh.ring(edge.first);
    const Index apex = ring.after(edge.second);
    const Edge next = order.rank(apex) < rank ? Edge(apex, edge.second) : Edge(edge.first, apex);
    parent[root(i)] = root(number.at(next));
  }
  for(auto& [edge, i] : number)
    i = root(i);
  return number;
}

inline bool is_saddle(const Flat_mesh& mesh, const Sweep_order& order, Index v) {
  const auto ring = mesh.ring(v);
  int changes = 0;
  for(Index p = 0; p < ring.size(); ++p)
    changes +=
        (order.rank(ring[p]) < order.rank(v)) != (order.rank(ring[ring.next(p)]) < order.rank(v));
  return changes > 2;
}

inline std::vector<Arc> reeb_arcs(const Flat_mesh& mesh, const Sweep_order& order) {
  std::vector<Arc> arcs;
  std::map<Edge, std::size_t> arc_of_edge; // at the present level
  for(Index r = 0; r < mesh.number_of_vertices(); ++r) {
    const Index v = order.vertices()[r];
    std::set<std::size_t> below;
    for(const Index u : mesh.ring(v))
      if(order.rank(u) < r)
        below.insert(arc_of_edge.at({u, v}));
    std::set<int> above;
    const Contours contours = contours_below(mesh, order, r + 1);
    for(const Index u : mesh.ring(v))
      if(order.rank(u) > r)
        above.insert(contours.at({v, u}));
    std::map<int, std::size_t> arc_of_contour;
    for(const auto& [edge, contour] : contours)
      if(edge.first != v && above.count(contour) == 0)
        arc_of_contour.emplace(contour, arc_of_edge.at(edge));
    if(below.size() == 1 && above.size() == 1 && !is_saddle(mesh, order, v)) {
      arc_of_contour[*above.begin()] = *below.begin();
      std::get<2>(arcs[*below.begin()]).push_back(v);
    } else {
      for(const std::size_t arc : below)
        std::get<1>(arcs[arc]) = v;
      for(const int contour : above) {
        arc_of_contour[contour] = arcs.size();
        arcs.push_back({v, no_index, {}});
      }
    }
    arc_of_edge.clear();
    for(const auto& [edge, contour] : contours)
      arc_of_edge[edge] = arc_of_contour.at(contour);
  }
  for(Arc& arc : arcs)
    std::sort(std::get<2>(arc).begin(), std::get<2>(arc).end());
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

// The same of a graph that was computed otherwise.
inline std::vector<Arc> reeb_arcs(const Flat_reeb_graph& graph) {
  std::vector<std::vector<Index>> vertices(graph.arcs.size());
  std::set<Index> critical;
  for(const auto& node : graph.nodes)
    critical.insert(node.vertex);
  for(Index v = 0; v < graph.vertex_arc.size(); ++v)
    if(critical.count(v) == 0)
      vertices.at(graph.vertex_arc[v]).push_back(v);
  std::vector<Arc> arcs;
  for(std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const Index lower = graph.nodes.at(graph.arcs[a].lower).vertex;
    const Index upper = graph.nodes.at(graph.arcs[a].upper).vertex;
    if(lower != upper)
      arcs.push_back({lower, upper, vertices[a]});
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

} // namespace reeb_by_levels

#endif // HTL_TEST_REEB_BY_LEVELS_H
