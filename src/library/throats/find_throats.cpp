// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include <CGAL/Handle_tunnel_loops/internal/throats/find_throats.h>

#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/hierarchy/Coarse_mesh_builder.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Crossing_loop.h>
#include <CGAL/Handle_tunnel_loops/internal/mesh/Flat_mesh.h>
#include <CGAL/Handle_tunnel_loops/internal/shortening/Loop_tightening.h>
#include <CGAL/Handle_tunnel_loops/internal/support/collect.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/Distinct_throats.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/contours_of_distances.h>
#include <CGAL/Handle_tunnel_loops/internal/throats/loops_through_vertex.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Throats among loops of a mesh, once they are tight.
class Throat_search
{
public:
  /// \p known is a basis, of which the loops may become throats, too.
  Throat_search(Execution execution,
                const Flat_mesh& mesh,
                const std::vector<Crossing_loop>& known,
                double least_prominence)
      : execution_(execution)
      , mesh_(mesh)
      , known_(known)
      , least_prominence_(least_prominence)
      , tightenings_([=, &mesh] { return std::make_unique<Loop_tightening>(execution, mesh); })
      , throats_(execution, mesh, known, least_prominence) {}

  /// the throats among contours of distances, the known loops, and some others.
  std::vector<Flat_throat> find(std::vector<Flat_throat> loops) {
    for(Crossing_loop& contour :
        short_contours_of_distances(execution_, mesh_, least_of_contours * least_prominence_))
      loops.push_back({std::move(contour), 0., 0.});
    for(const Crossing_loop& loop : known_)
      loops.push_back({loop, 0., 0.});
    return throats_.among(tight(std::move(loops), most_moves));
  }

  /// throats that are known to be some, most of them on a coarse mesh.
  std::vector<Flat_throat> refined(std::vector<Flat_throat> throats) {
    return throats_.among_coarse_ones(tight(std::move(throats), 0));
  }

  /// of the loops through each vertex the first that is a throat.
  std::vector<Flat_throat> through(const std::vector<Index>& vertices) {
    std::vector<Flat_throat> found;
    for(const Index v : vertices)
      Loops_through_vertex(execution_, mesh_, v).for_each_until([&](Crossing_loop loop) {
        Flat_throat throat = {std::move(loop), 0., std::numeric_limits<double>::infinity(), {v}};
        tighten(throat, most_moves);
        const bool is_throat = !throat.loop.empty() && throats_.is_throat(throat);
        if(is_throat)
          found.push_back(std::move(throat));
        return is_throat;
      });
    return found;
  }

private:
  /// how much shorter contours are than those beside them, as a part of what throats are.
  static constexpr double least_of_contours = 0.12;

  /// what tightening gains where a loop is moved aside, and how often it is.
  static constexpr double worth_moving = 0.998;
  static constexpr int most_moves = 4;

  // Those that become points are left out.
  std::vector<Flat_throat> tight(std::vector<Flat_throat> loops, int moves) {
    for_each_index(
        execution_, loops.size(), [&](std::size_t i) { tighten(loops[i], moves); }, 1);
    loops.erase(std::remove_if(loops.begin(), loops.end(),
                               [](const Flat_throat& t) { return t.loop.empty(); }),
                loops.end());
    return loops;
  }

  // A closed geodesic need not be the shortest loop close by: that around the middle of a ball is
  // not. If it is not, it becomes shorter once it is moved a little aside.
  void tighten(Flat_throat& throat, int moves) {
    const auto tightening = tightenings_.borrow();
    tightening->tighten(throat.loop);
    throat.length = length(mesh_, throat.loop);
    for(int i = 0; i < moves && !throat.loop.empty(); ++i) {
      Crossing_loop aside = loop_along(mesh_, nearer_ends(mesh_, throat.loop));
      tightening->tighten(aside);
      const double shorter = length(mesh_, aside);
      if(!(shorter < worth_moving * throat.length))
        return;
      throat.loop = std::move(aside);
      throat.length = shorter;
    }
  }

  Execution execution_;
  const Flat_mesh& mesh_;
  const std::vector<Crossing_loop>& known_;
  double least_prominence_;
  Workspace_pool<Loop_tightening> tightenings_;
  Distinct_throats throats_;
};

/// a coarse mesh on which to look for throats: none where the mesh is small, or would not become
/// much smaller.
static std::optional<Coarse_mesh> coarse_mesh_for_throats(Execution execution,
                                                          const Flat_mesh& mesh) {
  constexpr std::size_t least_vertices = 10000, least_ratio = 8, most_work = 4;
  if(mesh.number_of_vertices() < least_vertices)
    return {};
  return Coarse_mesh_builder(execution, mesh, vertices_of_cell, mesh.seeds)
      .build(mesh.number_of_vertices() / least_ratio, most_work * mesh.neighbor.size());
}

/// throats of a coarse mesh, as loops on the fine one. How prominent they are is
/// known from there, too.
static std::vector<Flat_throat> throats_of_coarse_mesh(Execution execution,
                                                       const Coarse_mesh& coarse,
                                                       const std::vector<Crossing_loop>& known,
                                                       double least_prominence) {
  std::vector<Crossing_loop> known_there;
  for(const Crossing_loop& loop : known)
    known_there.push_back(coarse.projected(loop));
  std::vector<Flat_throat> throats =
      Throat_search(execution, coarse.mesh, known_there, least_prominence).find({});
  for(Flat_throat& throat : throats)
    throat.loop = coarse.lifted(throat.loop);
  return throats;
}

std::vector<Flat_throat> find_flat_throats(Execution execution,
                                           const Flat_mesh& mesh,
                                           const std::vector<Crossing_loop>& known,
                                           const Throat_limits& limits) {
  if(mesh.number_of_vertices() == 0)
    return {};
  const double least = limits.least_prominence;
  Throat_search search(execution, mesh, known, least);
  // What is asked for may be too small for a coarse mesh.
  std::vector<Flat_throat> throats = search.through(limits.through_vertices);
  if(const auto coarse = coarse_mesh_for_throats(execution, mesh)) {
    for(Flat_throat& throat : throats_of_coarse_mesh(execution, *coarse, known, least))
      throats.push_back(std::move(throat));
    throats = search.refined(std::move(throats));
  } else
    throats = search.find(std::move(throats));
  std::stable_sort(throats.begin(), throats.end(), [](const auto& a, const auto& b) {
    return std::make_tuple(-a.prominence * a.length, a.length) <
           std::make_tuple(-b.prominence * b.length, b.length);
  });
  return throats;
}

} // namespace CGAL::Handle_tunnel_loops::internal
