// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "mend/mesh_reader.h"

#include "face_cuts.h"
#include "failure.h"
#include "mend/mending.h"
#include "mend/remedy_words.h"
#include "read/mesh_builder.h"
#include "read/soup_diagnosis.h"
#include "read/soup_reader.h"
#include "terminal/interrupt.h"

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

} // namespace htloops
