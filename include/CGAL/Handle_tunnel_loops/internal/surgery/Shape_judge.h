// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHAPE_JUDGE_H
#define CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHAPE_JUDGE_H

#include <CGAL/license/Handle_tunnel_loops.h>

#include <CGAL/Handle_tunnel_loops/Removal_report.h>
#include <CGAL/Handle_tunnel_loops/internal/support/Box_tree.h>
#include <CGAL/Handle_tunnel_loops/internal/support/arrays.h>
#include <CGAL/Handle_tunnel_loops/internal/support/macros.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Patch.h>
#include <CGAL/Handle_tunnel_loops/internal/surgery/Surgery_mesh.h>

#include <string>
#include <vector>

namespace CGAL::Handle_tunnel_loops::internal {

/// A change of the shape, with what only decides whether it is a repair.
struct Judged_change : Shape_change
{
  /// the largest angle by which faces bend at an edge of a cap and did not before, in degrees.
  double new_fold = 0.;
  /// the same where membranes stand on the surface, at right angles as a rule.
  double fold_at_membranes = 0.;
};

/// What a change must not be, besides what none may be.
struct Intended_change
{
  bool may_remove, may_add; ///< solid
  double length;            ///< of the loop that distances are measured by
  bool may_be_far = false;  ///< whether distances are no matter
  bool may_cross = false;   ///< whether caps may cross what they take the place of has crossed
};

/// Measures how a patch changes the shape, and says whether that is a repair.
class Shape_judge
{
public:
  /// notes what the whole shape is. Linear in the size of the mesh. With \p force everything is
  /// allowed.
  Shape_judge(const Surgery_mesh& mesh, bool force);

  /// whether everything is allowed.
  bool is_forced() const { return force_; }

  /// 1 if the faces point out of the solid, -1 if they point into it. Where there is a boundary,
  /// inside is behind the faces.
  double outward() const { return outward_; }

  /// what happens if a patch takes the place of some faces. Distances take most of the time, and
  /// are measured where nothing else speaks against the change. Near linear in the number of faces.
  Judged_change change(const Surgery_mesh& mesh,
                       const std::vector<Index>& out,
                       const Patch& patch,
                       const Intended_change& intended) const;

  /// why a change is no repair, with the number that tells; empty if it is one.
  std::string objection(const Judged_change& change, const Intended_change& intended) const;

private:
  const bool force_;
  const bool is_closed_;
  Box<3> box_ = Box<3>::empty();
  double size_ = 0.; // the largest side of the box
  double outward_ = 1.;
  double volume_ = 0.;
};

} // namespace CGAL::Handle_tunnel_loops::internal

#endif // CGAL_HANDLE_TUNNEL_LOOPS_INTERNAL_SURGERY_SHAPE_JUDGE_H
