// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_BOUNDARY_CHECK_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_BOUNDARY_CHECK_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// Says in words what is wrong with boundary curves, and loops homologous to them, whoever found
/// them.
template <typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap, typename Loop>
class Boundary_check
{
  using Certifier = Loop_certifier<TriangleMesh, VertexIndexMap, FaceIndexMap>;
  using Problems = std::vector<std::string>;

public:
  Boundary_check(Execution execution,
                 const TriangleMesh& tm,
                 VertexIndexMap vertex_index,
                 FaceIndexMap face_index)
      : execution_(execution)
      , tm_(tm)
      , vertex_index_(vertex_index)
      , face_index_(face_index) {}

  /// the curves have to be those of the mesh, \p expected, all of them, and waists closed curves on
  /// it that are homologous to them. Time: that of a walk over the faces, and for each waist over
  /// the pieces into which all loops cut the surface.
  Problems problems(const std::vector<Loop>& expected,
                    const std::vector<Loop>& curves,
                    const std::vector<Loop>& waists) const {
    Problems problems;
    std::map<Corners, std::size_t> times;
    for(const Loop& curve : expected)
      times.emplace(corners_of(curve), 0);
    for(std::size_t i = 0; i < curves.size(); ++i) {
      const auto found = times.find(corners_of(curves[i]));
      if(found == times.end())
        problems.push_back("boundary " + std::to_string(i) +
                           " is not a boundary curve of the mesh");
      else if(found->second++ > 0)
        problems.push_back("boundary " + std::to_string(i) + " appears twice");
    }
    if(curves.size() < expected.size())
      problems.push_back("it lists only " + std::to_string(curves.size()) + " of the " +
                         std::to_string(expected.size()) + " boundary curves");
    return problems.empty() ? problems_of_waists(curves, waists) : problems;
  }

  /// the second part of it: the number of a waist is that of its curve.
  Problems problems_of_waists(const std::vector<Loop>& curves,
                              const std::vector<Loop>& waists) const {
    Problems problems;
    std::vector<const Loop*> pairs;
    const auto name = [](const Loop& waist) {
      return "boundary " + std::to_string(waist.pair_index()) + ": its waist ";
    };
    for(const Loop& waist : waists)
      if(certifier_of({&waist}).are_closed_on_surface())
        pairs.insert(pairs.end(), {&curves[waist.pair_index()], &waist});
      else
        problems.push_back(name(waist) + "is not a closed curve on the surface");
    if(pairs.empty())
      return problems;
    for(const std::size_t i : certifier_of(pairs).pairs_of_different_class(execution_))
      problems.push_back(name(*pairs[2 * i + 1]) + "is not homologous to the curve");
    return problems;
  }

private:
  using Corners = std::vector<std::size_t>;

  Certifier certifier_of(const std::vector<const Loop*>& loops) const {
    Certifier certifier(tm_, vertex_index_, face_index_);
    certifier.set_loops(execution_, loops);
    return certifier;
  }

  // The vertices of a curve along edges, from the smallest one on, in the direction of its smaller
  // neighbor; none if the curve is not along edges.
  Corners corners_of(const Loop& curve) const {
    Corners corners;
    for(const auto& step : curve.steps()) {
      if(!step.is_vertex())
        return {};
      corners.push_back(get(vertex_index_, nearest_end(step, tm_)));
    }
    if(corners.empty())
      return {};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if(corners.size() > 2 && corners.back() < corners[1])
      std::reverse(corners.begin() + 1, corners.end());
    return corners;
  }

  Execution execution_;
  const TriangleMesh& tm_;
  VertexIndexMap vertex_index_;
  FaceIndexMap face_index_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_BOUNDARY_CHECK_H
