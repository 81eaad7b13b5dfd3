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

#include <CGAL/Handle_tunnel_loops/internal/certificate/Closed_triangles.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/Loop_certifier.h>
#include <CGAL/Handle_tunnel_loops/internal/certificate/certify.h>
#include <CGAL/Handle_tunnel_loops/internal/support/parallel.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// See `problems_of_boundaries()`.
class Boundary_check
{
  using Loop = Closed_triangles::Loop;
  using Problems = std::vector<std::string>;

public:
  Boundary_check(Execution execution, const Closed_triangles& triangles)
      : execution_(execution)
      , triangles_(triangles) {}

  Problems problems(const std::vector<Loop>& curves,
                    const std::vector<Listed_waist>& waists) const {
    Problems problems;
    std::map<Corners, std::size_t> times;
    for(const Closed_triangles::Walk& walk : triangles_.boundaries())
      times.emplace(corners_of(walk), 0);
    for(std::size_t i = 0; i < curves.size(); ++i) {
      const auto found = times.find(corners_of(curves[i]));
      if(found == times.end())
        problems.push_back("boundary " + std::to_string(i) +
                           " is not a boundary curve of the mesh");
      else if(found->second++ > 0)
        problems.push_back("boundary " + std::to_string(i) + " appears twice");
    }
    if(curves.size() < times.size())
      problems.push_back("it lists only " + std::to_string(curves.size()) + " of the " +
                         std::to_string(times.size()) + " boundary curves");
    return problems.empty() ? problems_of_waists(curves, waists) : problems;
  }

  Problems problems_of_waists(const std::vector<Loop>& curves,
                              const std::vector<Listed_waist>& waists) const {
    Problems problems;
    std::vector<Loop> pairs;
    std::vector<std::string> names; // by pair
    for(const Listed_waist& waist : waists) {
      const std::vector<Loop> loop = triangles_.loops({waist.loop});
      const std::string name = "boundary " + std::to_string(waist.curve) + ": its waist ";
      if(certifier_of(loop).are_closed_on_surface()) {
        pairs.insert(pairs.end(), {curves[waist.curve], loop.front()});
        names.push_back(name);
      } else
        problems.push_back(name + "is not a closed curve on the surface");
    }
    if(pairs.empty())
      return problems;
    for(const std::size_t i : certifier_of(pairs).pairs_of_different_class(execution_))
      problems.push_back(names[i] + "is not homologous to the curve");
    return problems;
  }

private:
  using Corners = std::vector<Index>;

  Loop_certifier certifier_of(const std::vector<Loop>& loops) const {
    Loop_certifier certifier(triangles_, Caps::OUTSIDE);
    certifier.set_loops(execution_, loops);
    return certifier;
  }

  // The vertices of a curve along edges, from the smallest one on, in the direction of its smaller
  // neighbor; none if the curve is not along edges.
  Corners corners_of(const Loop& curve) const {
    Corners corners;
    for(const Loop::Step& step : curve.steps()) {
      if(!step.is_vertex())
        return {};
      corners.push_back(step.ratio == 1. ? target(step.halfedge, triangles_)
                                         : source(step.halfedge, triangles_));
    }
    return in_order(std::move(corners));
  }

  Corners corners_of(const Closed_triangles::Walk& walk) const {
    Corners corners;
    for(const Closed_triangles::Halfedge h : walk)
      corners.push_back(target(h, triangles_));
    return in_order(std::move(corners));
  }

  static Corners in_order(Corners corners) {
    if(corners.empty())
      return {};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if(corners.size() > 2 && corners.back() < corners[1])
      std::reverse(corners.begin() + 1, corners.end());
    return corners;
  }

  Execution execution_;
  const Closed_triangles& triangles_;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_CERTIFICATE_BOUNDARY_CHECK_H
