// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/remedy_words.h"

#include "mend/mending.h"

#include <algorithm>

namespace htloops {
namespace {

bool has_only(const std::vector<Defect>& defects, Mesh_defect kind) {
  return std::all_of(defects.begin(), defects.end(),
                     [kind](const Defect& defect) { return defect.kind == kind; });
}

bool would_help(const Soup& soup, const Remedies& remedies) {
  return diagnose(mend(soup, remedies).soup).defects.empty();
}

// What it would do, where that can be said in a word.
std::string words_for(const Remedies& remedies, const std::vector<Defect>& defects) {
  if(remedies.do_triangulate && remedies.do_repair)
    return "--triangulate and --repair together mend this";
  const bool is_one = defects.front().count == 1;
  if(remedies.do_triangulate)
    return std::string("--triangulate makes ") + (is_one ? "it triangles" : "them triangles");
  if(has_only(defects, Mesh_defect::BOUNDARY_EDGE))
    return "--repair welds them";
  if(has_only(defects, Mesh_defect::DEGENERATE_FACE))
    return std::string("--repair drops ") + (is_one ? "it" : "them");
  if(has_only(defects, Mesh_defect::NON_MANIFOLD_VERTEX))
    return std::string("--repair splits ") + (is_one ? "it" : "them");
  return "--repair mends this";
}

} // namespace

// What helps alone is said even where the other one was given: it was of no use.
std::string
words_on_remedy(const Soup& soup, const std::vector<Defect>& defects, const Remedies& given) {
  constexpr Remedies both = {true, true}, candidates[] = {{true, false}, {false, true}, both};
  const bool are_all_given = given.do_triangulate && given.do_repair;
  for(const Remedies& remedies : candidates) {
    const bool is_given =
        remedies.do_triangulate == given.do_triangulate && remedies.do_repair == given.do_repair;
    if(!are_all_given && !is_given && would_help(soup, remedies))
      return words_for(remedies, defects);
  }
  if(mend(soup, both).is_one_sided)
    return "no option mends this, as the surface is not orientable";
  return given.any() ? "no other option mends this" : "no option mends this";
}

} // namespace htloops
