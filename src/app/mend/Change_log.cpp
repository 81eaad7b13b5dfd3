// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/Change_log.h"

#include <algorithm>

namespace htloops {
namespace {

// What happened to one element, or to several. What has no words here comes with words of its own.
struct Words_of_change
{
  const char* one;
  const char* many;
};

constexpr Words_of_change words_of_kinds[Change_log::number_of_kinds] = {
    {"boundary vertex welded to a nearby one", "boundary vertices welded to nearby ones"},
    {"vertex welded to another at the same place", "vertices welded to others at the same place"},
    {"degenerate face dropped", "degenerate faces dropped"},
    {"face with repeated vertices simplified", "faces with repeated vertices simplified"},
    {"face with more than three vertices triangulated",
     "faces with more than three vertices triangulated"},
    {"duplicate face dropped", "duplicate faces dropped"},
    {"face of a zero-thickness flap dropped", "faces of zero-thickness flaps dropped"},
    {"", ""},
    {"face of a pillow dropped", "faces of pillows dropped (two faces that share all edges)"},
    {"edge with more than two faces split", "edges with more than two faces split"},
    {"face flipped", "faces flipped"},
    {"vertex split", "vertices split"},
    {"edge with the same ends as another split at its midpoint",
     "edges with the same ends as others split at their midpoints"},
    {"", ""},
    {"", ""}};

} // namespace

bool Change_log::has_any() const {
  return !remarks_.empty() || std::any_of(findings_.begin(), findings_.end(),
                                          [](const Finding& f) { return f.count() != 0; });
}

std::vector<Change> Change_log::changes() const {
  std::vector<Change> changes = remarks_;
  for(std::size_t i = 0; i < number_of_kinds; ++i)
    if(findings_[i].count() != 0)
      changes.push_back({static_cast<Change_kind>(i), findings_[i].count(),
                         findings_[i].words(words_of_kinds[i].one, words_of_kinds[i].many)});
  std::stable_sort(changes.begin(), changes.end(),
                   [](const Change& a, const Change& b) { return a.kind < b.kind; });
  return changes;
}

} // namespace htloops
