// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "clean/soup_cleaning.h"

#include "failure.h"
#include "interrupt.h"
#include "mend/near_points.h"
#include "read/soup_diagnosis.h"

#include <string>
#include <utility>

namespace htloops {
namespace {

[[noreturn]] void refuse(const std::vector<Defect>& defects) {
  std::string text = "it is not an oriented manifold triangle mesh:";
  for(const Defect& defect : defects)
    text += "\n  " + defect.message;
  throw Failure(Exit_code::UNACCEPTABLE_MESH, text);
}

// What has become of the boundary is not what was done.
bool is_told_of_boundary(Change_kind kind) {
  return kind == Change_kind::BOUNDARY_EDGES_CLOSED || kind == Change_kind::BOUNDARY_EDGES_OPENED;
}

Soup_as_mesh mended_mesh(Soup soup, const Remedies& remedies) {
  Soup_as_mesh result;
  result.mended = mend(std::move(soup), remedies);
  throw_if_interrupted();
  Built_mesh built = build_mesh(result.mended.soup);
  if(!built.defects.empty())
    refuse(built.defects);
  result.mesh = std::move(built.mesh);
  for(const Change& change : result.mended.changes) {
    result.record.count += is_told_of_boundary(change.kind) ? 0 : change.count;
    result.record.done.push_back(std::to_string(change.count) + " " + change.words);
  }
  return result;
}

// A surface of which more than crumbs is one-sided bounds nothing: then it is refused.
Soup_as_mesh mesh_without_crumbs(Soup soup, Remedies remedies) {
  constexpr std::size_t least_share = 100;
  Soup_as_mesh result = mended_mesh(soup, remedies);
  for(const Change& change : result.mended.changes)
    if(change.kind == Change_kind::ONE_SIDED_COMPONENT_DROPPED &&
       change.count > soup.faces.size() / least_share)
    {
      remedies.steps.reset(static_cast<std::size_t>(Repair_step::ONE_SIDED));
      return mended_mesh(std::move(soup), remedies);
    }
  return result;
}

// Of the file, that lie within a hundred thousandth of the diagonal of its box.
constexpr Relative_length nearly_the_same = {1e-5, true};

} // namespace

Soup_as_mesh mesh_for_cleaning(Soup soup,
                               const Clean_options& options,
                               const std::optional<Relative_length>& weld) {
  Remedies remedies;
  remedies.do_triangulate = remedies.do_repair = options.has(Clean_step::REPAIR);
  remedies.weld = weld;
  if(weld || !options.has(Clean_step::REPAIR))
    return mesh_without_crumbs(std::move(soup), remedies);
  Soup_as_mesh unwelded = mesh_without_crumbs(soup, remedies);
  const Near_boundary found = near_boundary_of(unwelded.mesh);
  if(found.words().empty() || found.is_exact)
    return unwelded;
  remedies.weld = nearly_the_same;
  try {
    return mesh_without_crumbs(std::move(soup), remedies);
  } catch(const Failure& failure) {
    unwelded.record.left.push_back(failure.what());
    return unwelded;
  }
}

Cleaned_soup clean(Soup soup,
                   const Clean_options& options,
                   const std::optional<Relative_length>& weld,
                   Progress& progress) {
  const std::size_t vertices = soup.points.size(), faces = soup.faces.size();
  Soup_as_mesh made = mesh_for_cleaning(std::move(soup), options, weld);
  Cleaned_soup result{clean(made.mesh, options, progress), std::move(made.mesh), vertices, faces};
  const auto trace = [](Origins& origins, const auto& in_file) {
    for(std::int64_t& origin : origins)
      if(origin != nothing_before)
        origin = in_file(static_cast<std::uint32_t>(origin));
  };
  const Mended_soup& mended = made.mended;
  trace(result.vertex_origins, [&](std::uint32_t v) { return mended.in_file(v); });
  for(Origins* origins : {&result.face_origins, &result.face_parents})
    trace(*origins, [&](std::uint32_t f) { return mended.face_in_file[f]; });
  if(options.has(Clean_step::REPAIR))
    result.records.insert(result.records.begin(), std::move(made.record));
  return result;
}

} // namespace htloops
