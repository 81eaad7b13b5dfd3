// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef BENCHMARK_JUDGED_MEASURES_H
#define BENCHMARK_JUDGED_MEASURES_H

#include "Voxel_measures.h"

#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/handle_measures.h>
#include <CGAL/handle_tunnel_loops.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

/// \file Judged_measures.h
/// Measures of handles beside what is known of them.

namespace judged_measures {

using Mesh = CGAL::Surface_mesh<voxel_measures::Point>;
using Pairs = std::vector<CGAL::Handle_tunnel_pair<Mesh>>;
using voxel_measures::Interval;
using voxel_measures::Line;
using voxel_measures::Measures;

inline Pairs find_loops(const Mesh& mesh) {
  Pairs pairs;
  CGAL::handle_tunnel_loops(mesh, std::back_inserter(pairs));
  return pairs;
}

inline double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// A measure, by what is to be judged.
struct Measure
{
  double diameter, error;
  Line curve;
};

/// In falling order.
struct Answer
{
  std::vector<Measure> thickness, clear_width;
  std::string why;
  double seconds = 0.;
};

inline Answer answer(const Mesh& mesh, const Pairs& pairs) {
  Answer answer;
  const double began = seconds();
  std::vector<CGAL::Handle_tunnel_loops::Handle_measures<voxel_measures::Point>> found;
  CGAL::handle_measures(mesh, pairs, std::back_inserter(found));
  answer.seconds = seconds() - began;
  for(const auto& m : found) {
    if(m.thickness)
      answer.thickness.push_back({m.thickness->diameter, m.thickness->error, m.thickness->curve});
    if(m.clear_width)
      answer.clear_width.push_back(
          {m.clear_width->diameter, m.clear_width->error, m.clear_width->curve});
    answer.why = m.why;
  }
  for(auto* list : {&answer.thickness, &answer.clear_width})
    std::sort(list->begin(), list->end(),
              [](const Measure& a, const Measure& b) { return a.diameter > b.diameter; });
  return answer;
}

inline std::vector<voxel_measures::Triangle> triangles_of(const Mesh& mesh) {
  std::vector<voxel_measures::Triangle> triangles;
  for(const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    triangles.push_back({mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                         mesh.point(target(next(h, mesh), mesh))});
  }
  return triangles;
}

inline std::vector<Line> lines_of(const Pairs& pairs) {
  std::vector<Line> lines;
  for(const auto& pair : pairs) {
    lines.push_back(pair.handle().points());
    lines.push_back(pair.tunnel().points());
  }
  return lines;
}

/// What the voxels tell, at two resolutions.
struct Truth
{
  Measures coarse, fine;
  double seconds = 0.;
};

/// with voxels in two places, so that each is a check of the other.
inline Truth truth(const Mesh& mesh, const Pairs& pairs) {
  const CGAL::Side_of_triangle_mesh<Mesh, voxel_measures::Kernel> side(mesh);
  Truth truth;
  const double began = seconds();
  for(const bool is_fine : {false, true}) {
    voxel_measures::Voxel_measures voxels(
        triangles_of(mesh), lines_of(pairs),
        [&](const auto& p) { return side(p) == CGAL::ON_BOUNDED_SIDE; }, is_fine ? 1 : 0);
    voxels.refine(0.25, 4, 1500000);
    if(is_fine)
      voxels.refine(0.02, 12, 1500000);
    (is_fine ? truth.fine : truth.coarse) = voxels.measures();
  }
  truth.seconds = seconds() - began;
  return truth;
}

/// How lists of measures agree with lists of intervals.
struct Verdict
{
  std::size_t number = 0;  ///< of intervals
  std::size_t missing = 0; ///< measures, or too many
  std::size_t apart = 0;   ///< measures that are not in their interval, for all their error
  double farthest = 0.;    ///< how far a measure is from its interval, as a part of it
  double widest = 0.;      ///< the widest interval, as a part of its middle
  double error = 0.;       ///< the largest that is told, as a part of the measure

  void add(const std::vector<Measure>& measures, const std::vector<Interval>& known) {
    number += known.size();
    missing +=
        (std::max)(measures.size(), known.size()) - (std::min)(measures.size(), known.size());
    for(std::size_t i = 0; i < (std::min)(measures.size(), known.size()); ++i) {
      const auto& [lower, upper] = known[i];
      const Measure& m = measures[i];
      constexpr double rounding = 1e-9;
      apart += m.diameter + m.error < lower * (1. - rounding) ||
               m.diameter - m.error > upper * (1. + rounding);
      farthest = (std::max)({farthest, lower / m.diameter - 1., m.diameter / upper - 1.});
      widest = (std::max)(widest, 2. * (upper - lower) / (upper + lower));
      error = (std::max)(error, m.error / m.diameter);
    }
  }
};

inline Verdict verdict(const Answer& answer, const Measures& known) {
  Verdict verdict;
  verdict.add(answer.thickness, known.thickness);
  verdict.add(answer.clear_width, known.clear_width);
  return verdict;
}

inline bool do_agree(const std::vector<Interval>& a, const std::vector<Interval>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const Interval& i, const Interval& j) {
           return i.lower <= j.upper && j.lower <= i.upper;
         });
}

/// whether the two resolutions contradict each other.
inline bool do_agree(const Truth& truth) {
  return do_agree(truth.coarse.thickness, truth.fine.thickness) &&
         do_agree(truth.coarse.clear_width, truth.fine.clear_width);
}

/// the number of curves along which no ball goes that is as large as is told, and of those that are
/// missing to go around all handles and through all holes.
inline std::size_t wrong_curves(const Mesh& mesh, const Pairs& pairs, const Answer& answer) {
  const voxel_measures::Triangle_tree surface(triangles_of(mesh));
  CGAL::Random random(2);
  std::size_t narrow = 0;
  for(const auto* list : {&answer.thickness, &answer.clear_width})
    for(const Measure& m : *list)
      narrow +=
          2. * voxel_measures::clearance(surface, m.curve) < (1. - 2e-3) * (m.diameter - m.error);
  const auto moved = [&](voxel_measures::Line line,
                         double by) { // so that it is in no plane with a loop
    for(auto& p : line)
      p = {p.x() + random.get_double(-by, by), p.y() + random.get_double(-by, by),
           p.z() + random.get_double(-by, by)};
    return line;
  };
  const voxel_measures::Loop_cones cones(lines_of(pairs), random);
  voxel_measures::Independent_rows rows;
  for(const auto* list : {&answer.thickness, &answer.clear_width})
    for(const Measure& m : *list)
      rows.add(cones.linking(moved(m.curve, 1e-4 * m.diameter)));
  return narrow + (2 * pairs.size() - rows.rank());
}

} // namespace judged_measures

#endif // BENCHMARK_JUDGED_MEASURES_H
