// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/mending.h"

#include "interrupt.h"
#include "mend/steps.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace htloops {
namespace {

// Nothing exact can be said of points that are nowhere, and halfedges have numbers of 32 bits.
bool can_be_mended(const Soup& soup) {
  return 3 * (soup.faces.size() + soup.further_corners.size()) <=
             Soup::largest_number_of_halfedges &&
         soup.points.size() <= Soup::largest_number_of_halfedges &&
         std::all_of(soup.points.begin(), soup.points.end(), is_finite);
}

void repair_triangles(Mended_soup& mended) {
  drop_degenerate_faces(mended);
  drop_duplicate_faces(mended);
  throw_if_interrupted();
  std::optional<Neighbors> neighbors = glue_faces(mended);
  throw_if_interrupted();
  mended.is_one_sided = !neighbors;
  if(!neighbors)
    return;
  split_vertices(mended, *neighbors);
  divide_parallel_edges(mended, *neighbors);
}

} // namespace

Mended_soup mend(Soup soup, const Remedies& remedies) {
  Mended_soup mended;
  mended.soup = std::move(soup);
  if(!can_be_mended(mended.soup))
    return mended;
  mended.face_in_file.resize(mended.soup.faces.size());
  std::iota(mended.face_in_file.begin(), mended.face_in_file.end(), 0u);
  if(remedies.do_repair) {
    drop_degenerate_faces(mended); // whose sides are no edges
    weld_points(mended);
    throw_if_interrupted();
    drop_degenerate_faces(mended);
  }
  if(remedies.do_triangulate)
    triangulate(mended);
  throw_if_interrupted();
  if(remedies.do_repair && mended.soup.further_corners.empty())
    repair_triangles(mended);
  return mended;
}

} // namespace htloops
