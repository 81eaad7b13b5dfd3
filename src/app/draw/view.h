// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_VIEW_H
#define HTLOOPS_VIEW_H

#include "scene/scene.h"

#include <array>
#include <optional>
#include <vector>

namespace htloops {

using Polyline = std::vector<std::array<double, 3>>;

/// How a surface is seen, in a picture, or at first on a page. Empty for the default.
struct View
{
  std::vector<double> from;     ///< the direction from the surface to the eye
  std::vector<double> up;       ///< the direction that is upright
  std::vector<Polyline> chosen; ///< closed lines that are to be seen
  bool is_for_rows = true;      ///< scenes tell from where those of each row are seen, too
  int number_of_threads = 0;    ///< that search; 0: as many as there are
};

/// A view without defaults.
struct Whole_view
{
  std::array<double, 3> from, up;
};

/// what was given. Of what was not, upright is what `upright_direction()` says; and the surface is
/// seen from where most of the length of the chosen lines lies open and large, the short ones above
/// all, and much of the surface. That is found by samples, and for the best directions with all
/// triangles: the time is linear in the size of the mesh.
Whole_view whole_view(const View& given, const htl_scene::Surface& surface);

/// the same of lines inside a surface that is looked through, closed or not, of which none are
/// chosen: they are spread over the picture, with few before others, and so is the surface.
Whole_view view_through(const View& given,
                        const htl_scene::Surface& surface,
                        const std::vector<Polyline>& lines);

/// How a surface is seen with all of its lines, and with those of each group: `whole_view()` and
/// `best_views()`, together in less time.
struct Views
{
  Whole_view whole;
  std::vector<std::optional<std::array<double, 3>>> of_groups;
};

Views views_of(const View& given,
               const htl_scene::Surface& surface,
               const std::vector<std::vector<Polyline>>& groups);

/// by group of closed lines, the direction from which it is seen best, of length one; none if less
/// than half of its length is seen from anywhere outside. In linear time.
std::vector<std::optional<std::array<double, 3>>>
best_views(const htl_scene::Surface& surface,
           const std::vector<std::vector<Polyline>>& groups,
           const std::array<double, 3>& up);

/// Closed lines on a surface.
struct Lines_on_surface
{
  const htl_scene::Surface& surface;
  std::vector<Polyline> lines;
};

/// the direction from which most of the lines on some surfaces is seen, each of which is looked at
/// without the others and counts as much. In linear time.
std::array<double, 3> best_common_view(const std::vector<Lines_on_surface>& seen,
                                       const std::array<double, 3>& up);

} // namespace htloops

#endif // HTLOOPS_VIEW_H
