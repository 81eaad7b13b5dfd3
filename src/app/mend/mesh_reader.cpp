// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/mesh_reader.h"

#include "failure.h"
#include "interrupt.h"

#include <algorithm>
#include <utility>

namespace htloops {
namespace {

std::string message(const std::string& file, const std::vector<Defect>& defects) {
  if(defects.size() == 1)
    return file + ": " + defects.front().message + "; ";
  std::string text = file + " is no oriented manifold of triangles:";
  for(const Defect& defect : defects)
    text += "\n  " + defect.message;
  return text + "\n";
}

// What has been done already, as numbers are those of afterwards.
std::string words_on_changes(const std::vector<Change>& changes) {
  std::string text = changes.empty() ? "" : "\nthat is after it was mended:";
  for(const Change& change : changes)
    text += "\n  " + std::to_string(change.count) + " " + change.words;
  return text;
}

// The file is read once more, as mending has used up what there was.
[[noreturn]] void refuse(const Input_file& file,
                         const std::vector<Defect>& defects,
                         const Remedies& remedies,
                         const std::vector<Change>& changes) {
  const std::string remedy = words_on_remedy(read_soup(file), defects, remedies);
  throw Failure(Exit_code::UNACCEPTABLE_MESH,
                message(file.name(), defects) + remedy + words_on_changes(changes));
}

void mark_cuts(Mesh& mesh, const Mended_soup& mended) {
  const Face_cuts cuts = add_face_cuts(mesh);
  for(const Mesh::Edge_index e : mesh.edges()) {
    const std::uint32_t u = mended.in_file(mesh.vertex(e, 0).idx());
    const std::uint32_t v = mended.in_file(mesh.vertex(e, 1).idx());
    cuts[e] = std::binary_search(mended.diagonals.begin(), mended.diagonals.end(),
                                 std::array<std::uint32_t, 2>{(std::min)(u, v), (std::max)(u, v)});
  }
}

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

Mended_mesh read_mesh(const Input_file& file, const Remedies& remedies) {
  Mended_soup mended;
  if(remedies.any())
    mended = mend(read_soup(file), remedies);
  else
    mended.soup = read_soup(file);
  throw_if_interrupted();
  const Diagnosis diagnosis = diagnose(mended.soup);
  throw_if_interrupted();
  if(!diagnosis.defects.empty())
    refuse(file, diagnosis.defects, remedies, mended.changes);
  Mesh mesh = build_mesh(mended.soup, diagnosis);
  if(!mended.diagonals.empty())
    mark_cuts(mesh, mended);
  return {std::move(mesh), std::move(mended.changes), std::move(mended.origins)};
}

Mesh read_mesh(const Input_file& file) { return read_mesh(file, Remedies()).mesh; }

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
