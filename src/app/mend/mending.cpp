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
#include "mend/near_points.h"
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

double length_on(const Soup& soup, const Relative_length& length) {
  if(!length.is_share || soup.points.empty())
    return length.value;
  return length.value * diagonal_of(CGAL::bbox_3(soup.points.begin(), soup.points.end()));
}

// While edges have the numbers that they had, and before faces are divided.
void report_edges_and_turns(Mended_soup& mended, const Gluing& gluing, const Remedies& remedies) {
  if(remedies.has(Repair_step::SPLIT))
    for(const Crowded_edge& edge : gluing.crowded_edges)
      mended.log.add(Change_kind::EDGES_SPLIT, [&edge] {
        return name_of_edge(edge.vertices[0], edge.vertices[1]) + " with " +
               std::to_string(edge.number_of_faces) + " faces";
      });
  if(remedies.has(Repair_step::ORIENT))
    for(std::size_t f = 0; f < mended.soup.faces.size(); ++f)
      if(gluing.is_turned[f])
        mended.log.add_face(Change_kind::FACES_TURNED, mended.face_in_file[f]);
}

class Repair
{
public:
  Repair(Mended_soup& mended, const Remedies& remedies)
      : mended_(mended)
      , remedies_(remedies)
      , before_(mended.soup) {}

  // Polygons are cut after this.
  void mend_points() {
    drop_degenerate(); // whose sides are no edges
    if(has(Repair_step::WELD))
      is_welded_ = weld_points(mended_);
    throw_if_interrupted();
    drop_degenerate();
  }

  // Works on triangles alone.
  void mend_surface() {
    drop_degenerate(); // those that were cut off polygons
    if(has(Repair_step::DUPLICATES))
      drop_duplicate_faces(mended_);
    throw_if_interrupted();
    std::optional<Gluing> gluing;
    if(goes_by_neighbors())
      gluing = glue_faces(mended_, has(Repair_step::ONE_SIDED));
    throw_if_interrupted();
    mended_.is_one_sided = goes_by_neighbors() && !gluing;
    if(gluing)
      mend_neighbors(*gluing);
  }

  void finish_report() {
    if(!is_compared_)
      compare_vertices();
  }

private:
  bool has(Repair_step step) const { return remedies_.has(step); }

  bool goes_by_neighbors() const {
    return has(Repair_step::ONE_SIDED) || has(Repair_step::PILLOWS) || has(Repair_step::ORIENT) ||
           has(Repair_step::SPLIT);
  }

  // What goes by edges wants triangles of three vertices.
  void drop_degenerate() {
    if(has(Repair_step::DEGENERATE) || has(Repair_step::DUPLICATES) || goes_by_neighbors())
      drop_degenerate_faces(mended_);
  }

  // Splitting wants neighbors that agree: so faces that are not to be turned are turned back.
  void mend_neighbors(Gluing& gluing) {
    if(has(Repair_step::PILLOWS))
      drop_pillows(mended_, gluing);
    report_edges_and_turns(mended_, gluing, remedies_);
    if(has(Repair_step::SPLIT)) {
      is_split_ = split_vertices(mended_, gluing.neighbors);
      compare_vertices();
      divide_parallel_edges(mended_, gluing);
    }
    if(!has(Repair_step::ORIENT))
      turn(mended_.soup, gluing.is_turned);
  }

  // Before edges are divided, which makes corners that no face of the file has.
  void compare_vertices() {
    is_compared_ = true;
    if(is_welded_ || is_split_)
      report_vertices(before_, mended_);
  }

  Mended_soup& mended_;
  const Remedies remedies_;
  const Soup before_;
  bool is_welded_ = false, is_split_ = false, is_compared_ = false;
};

} // namespace

const char* name_of(Repair_step step) {
  constexpr const char* names[number_of_repair_steps] = {
      "degenerate", "weld", "duplicates", "one-sided", "pillows", "orient", "split"};
  return names[static_cast<std::size_t>(step)];
}

Mended_soup mend(Soup soup, const Remedies& remedies) {
  Mended_soup mended;
  mended.soup = std::move(soup);
  if(!can_be_mended(mended.soup))
    return mended;
  mended.face_in_file.resize(mended.soup.faces.size());
  std::iota(mended.face_in_file.begin(), mended.face_in_file.end(), 0u);
  std::optional<Soup> before;
  if(remedies.do_repair || remedies.weld)
    before = mended.soup;
  if(remedies.weld)
    weld_near_points(mended, length_on(mended.soup, *remedies.weld));
  std::optional<Repair> repair;
  if(remedies.do_repair)
    repair.emplace(mended, remedies).mend_points();
  if(remedies.do_triangulate)
    triangulate(mended);
  throw_if_interrupted();
  if(repair && mended.soup.further_corners.empty())
    repair->mend_surface();
  if(repair)
    repair->finish_report();
  if(before && mended.log.has_any())
    report_boundary(*before, mended);
  mended.changes = mended.log.changes();
  return mended;
}

} // namespace htloops
