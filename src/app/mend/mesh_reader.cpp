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
#include "mend/steps.h"
#include "read/meshes/mesh_formats.h"

#include <algorithm>
#include <utility>

namespace htloops {
namespace {

std::string message(const std::string& file, const std::vector<Defect>& defects) {
  if(defects.size() == 1)
    return file + ": " + defects.front().message + "; ";
  std::string text = file + " is not an oriented manifold triangle mesh:";
  for(const Defect& defect : defects)
    text += "\n  " + defect.message;
  return text + "\n";
}

std::string lines_of(const std::vector<Change>& changes) {
  std::string text;
  for(const Change& change : changes)
    text += "\n  " + std::to_string(change.count) + " " + change.words;
  return text;
}

// What has been done already, as numbers are those of afterwards.
std::string words_on_changes(const std::vector<Change>& changes) {
  return changes.empty() ? "" : "\nthese repairs were made first:" + lines_of(changes);
}

// The file is read once more if mending has used up what there was.
[[noreturn]] void refuse(const Input_file& file,
                         const std::vector<Defect>& defects,
                         const Remedies& remedies,
                         const Mended_soup& mended) {
  const std::string remedy =
      words_on_remedy(remedies.any() ? read_whole_soup(file) : mended.soup, defects, remedies);
  throw Failure(Exit_code::UNACCEPTABLE_MESH,
                message(file.name(), defects) + remedy + words_on_changes(mended.changes));
}

Face_cuts cuts_of(const Mesh& mesh, const Mended_soup& mended) {
  if(mended.diagonals.empty())
    return {};
  Face_cuts cuts(mesh.number_of_halfedges(), 0);
  for(const Mesh::Edge_index e : mesh.edges()) {
    const std::uint32_t u = mended.in_file(mesh.vertex(e, 0).idx());
    const std::uint32_t v = mended.in_file(mesh.vertex(e, 1).idx());
    cuts[e.idx()] =
        std::binary_search(mended.diagonals.begin(), mended.diagonals.end(),
                           std::array<std::uint32_t, 2>{(std::min)(u, v), (std::max)(u, v)});
  }
  return cuts;
}

// Whether all that would be done is of a kind, and to as many elements as were found.
bool is_only(const std::vector<Change>& changes, Change_kind kind, const Defect& defect) {
  return std::all_of(changes.begin(), changes.end(), [&](const Change& change) {
    return change.kind == kind && change.count == defect.count;
  });
}

// In a word where that says it all, else in full what it would do.
std::string words_for(const Remedies& remedies,
                      const Remedies& given,
                      const std::vector<Defect>& defects,
                      const std::vector<Change>& changes) {
  const Defect& first = defects.front();
  const bool is_one = first.count == 1;
  const std::string repair =
      given.do_repair && !given.steps.all() ? "--repair without --repair-steps" : "--repair";
  if(defects.size() == 1) {
    if(is_only(changes, Change_kind::FACES_TRIANGULATED, first))
      return std::string("--triangulate splits ") + (is_one ? "it" : "them") + " into triangles";
    if(is_only(changes, Change_kind::DEGENERATE_FACES_DROPPED, first))
      return repair + " drops " + (is_one ? "it" : "them");
    if(is_only(changes, Change_kind::VERTICES_SPLIT, first))
      return repair + " splits " + (is_one ? "it" : "them");
  }
  return (remedies.do_triangulate && remedies.do_repair
              ? "--triangulate and " + repair + " together fix"
          : remedies.do_triangulate ? "--triangulate fixes"
                                    : repair + " fixes") +
         " this:" + lines_of(changes);
}

bool is_said_to_be_one_sided(const std::vector<Defect>& defects) {
  return std::any_of(defects.begin(), defects.end(),
                     [](const Defect& defect) { return defect.is_not_orientable; });
}

} // namespace

Soup read_whole_soup(const Input_file& file) {
  Soup soup = read_soup(file);
  return soup.facts.is_parted_at_seams ? join_seams(std::move(soup)) : soup;
}

Mended_mesh read_mesh(Input_file file, const Remedies& remedies) {
  Mended_soup mended;
  mended.soup = read_whole_soup(file);
  if(remedies.any())
    mended = mend(std::move(mended.soup), remedies);
  else // then the file is not looked at again
    file.close();
  throw_if_interrupted();
  Built_mesh built = build_mesh(mended.soup);
  throw_if_interrupted();
  if(!built.defects.empty())
    refuse(file, built.defects, remedies, mended);
  Face_cuts cuts = cuts_of(built.mesh, mended);
  return {std::move(built.mesh), std::move(mended.changes), std::move(mended.origins),
          std::move(cuts), std::move(mended.soup.facts)};
}

Mesh read_mesh(Input_file file) { return read_mesh(std::move(file), Remedies()).mesh; }

// What helps alone is said even where the other one was given: it was of no use.
std::string
words_on_remedy(const Soup& soup, const std::vector<Defect>& defects, const Remedies& given) {
  constexpr bool candidates[][2] = {{true, false}, {false, true}, {true, true}};
  const bool are_all_given = given.do_triangulate && given.do_repair && given.steps.all();
  bool is_one_sided = false;
  for(const auto& [do_triangulate, do_repair] : candidates) {
    const Remedies remedies = {do_triangulate, do_repair};
    const Mended_soup mended = mend(soup, remedies);
    is_one_sided = mended.is_one_sided;
    if(!are_all_given && diagnose(mended.soup).empty())
      return words_for(remedies, given, defects, mended.changes);
  }
  if(is_one_sided && !is_said_to_be_one_sided(defects))
    return "no option fixes this: the surface is not orientable";
  return given.any() ? "no other option fixes this" : "no option fixes this";
}

} // namespace htloops
