// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/cutting/cut_open.h>

#include <CGAL/Handle_tunnel_loops/exceptions.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_graph.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_problem.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_shortening.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Cut_start.h>
#include <CGAL/Handle_tunnel_loops/internal/cutting/Dual_chains.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/surface_components.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/waists.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

static void require_of_cut(bool condition, const char* otherwise) {
  if(!condition)
    throw Uncertified_cut_exception(std::string("the cut fails its check: ") + otherwise);
}

/// into how many pieces the faces fall.
static std::size_t number_of_pieces(const Cut_problem& problem, const Cut_graph& cut) {
  const Flat_halfedges& halfedges = problem.halfedges;
  Sets_of_indices sets(problem.mesh.number_of_faces());
  std::size_t pieces = problem.mesh.number_of_faces();
  for(Index h = 0; h < halfedges.size(); ++h)
    if(!cut.contains(h) && sets.unite(halfedges.face(h), halfedges.face(halfedges.twin(h))))
      --pieces;
  return pieces;
}

/// by component, of how many cycles its boundary is.
static std::vector<std::size_t> numbers_of_cycles(const Cut_problem& problem,
                                                  const Cut_graph& cut) {
  std::vector<std::size_t> cycles(problem.mesh.seeds.size(), 0);
  std::vector<char> is_seen(problem.halfedges.size(), 0);
  for(Index h = 0; h < is_seen.size(); ++h)
    if(cut.contains(h) && !is_seen[h]) {
      ++cycles[problem.mesh.component[problem.halfedges.source(h)]];
      for(Index k = h; !is_seen[k]; k = cut.following(k))
        is_seen[k] = 1;
    }
  return cycles;
}

/*!
Counts what the surface is once it is cut open, by its definition: faces hang together across edges
that are not cut, and a vertex has a copy for each corner between edges that are. A component is a
disk if it is in one piece, its Euler characteristic is 1, and its boundary one cycle. Throws
`Uncertified_cut_exception` if something is not as it was promised.
*/
static void check_cut(const Cut_problem& problem, const Cut_graph& cut) {
  for(Index h = 0; h < problem.rules.size(); ++h)
    require_of_cut(!(cut.contains(h) ? problem.is_avoided(h) : problem.is_kept(h)),
                   "an edge violates its rule");
  const std::vector<Component_size> sizes = component_sizes(problem);
  std::vector<std::size_t> edges(sizes.size(), 0), copies(sizes.size(), 0);
  for(Index v = 0; v < problem.mesh.number_of_vertices(); ++v) {
    require_of_cut(!problem.is_cone(v) || cut.degree(v) != 0, "it does not pass through a cone");
    edges[problem.mesh.component[v]] += cut.degree(v); // twice
    copies[problem.mesh.component[v]] += cut.degree(v) == 0 ? 1 : cut.degree(v);
  }
  require_of_cut(number_of_pieces(problem, cut) == sizes.size(),
                 "a component becomes disconnected");
  const std::vector<std::size_t> cycles = numbers_of_cycles(problem, cut);
  for(std::size_t c = 0; c < sizes.size(); ++c) {
    if(edges[c] == 0 && sizes[c].genus() == 0)
      continue;
    const std::size_t faces = sizes[c].halfedges / 3,
                      all_edges = sizes[c].halfedges / 2 + edges[c] / 2;
    require_of_cut(copies[c] + faces == all_edges + 1, "a component is not a disk");
    require_of_cut(cycles[c] == 1, "the boundary of a component is not one cycle");
  }
}

void check_rules(const Cut_problem& problem) {
  if(problem.has_rules_of_caller)
    Cut_start(problem).find();
}

std::vector<Index> cut_open(Cut_problem problem) {
  add_ends_on_spheres(problem);
  Cut_graph cut = Cut_start(problem).find();
  Cut_shortening(problem, cut).run();
  check_cut(problem, cut);
  std::vector<Index> edges;
  for(Index h = 0; h < problem.halfedges.size(); ++h)
    if(cut.contains(h) && problem.halfedges.source(h) < problem.halfedges.target(h))
      edges.push_back(h);
  return edges;
}

std::vector<Chain_of_halfedges> dual_chains(const Cut_problem& problem) {
  std::vector<Crossing_loop> basis;
  for(const std::vector<Index>& walk : problem.walks)
    basis.push_back(pushed_left(problem.mesh, walk));
  for(const Index hub : hubs_of_basis(problem.mesh))
    basis.push_back(beside_boundary(problem.mesh, hub));
  const std::vector<Index> cut = cut_open(problem);
  std::vector<Chain_of_halfedges> chains;
  for(const auto& chain : Dual_chains(problem, cut).dual_to(basis)) {
    chains.emplace_back();
    for(const auto& [h, times] : chain)
      if(!problem.is_spoke(h))
        chains.back().emplace_back(h, times);
  }
  return chains;
}

} // namespace CGAL::Handle_tunnel_loops::internal
