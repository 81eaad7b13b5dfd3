// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/clean_report.h"

#include "words.h"
#include "write/Json_writer.h"

#include <cstddef>
#include <utility>

namespace htloops {
namespace {

// The first lines of a long list.
std::string lines(const char* name, const char* mark, const std::vector<std::string>& texts) {
  constexpr std::size_t most_lines = 5;
  std::string text;
  for(std::size_t i = 0; i < texts.size() && i < most_lines; ++i)
    text += formatted("  %-10s%s", i == 0 ? name : "", mark) + texts[i] + "\n";
  if(texts.size() > most_lines)
    text += formatted("  %-10s%s", "", mark) + "... " + std::to_string(texts.size() - most_lines) +
            " more\n";
  return text;
}

Json json_of(const Mesh_state& state) {
  return {{"vertices", state.vertices},
          {"faces", state.faces},
          {"parts", state.parts},
          {"boundaries", state.boundaries},
          {"genus", state.genus},
          {"crossings", state.crossings},
          {"volume", state.boundaries == 0 ? Json(state.volume) : Json()}};
}

Json json_of(const Clean_record& record) {
  return {{"step", name_of(record.step)},
          {"count", record.count},
          {"done", record.done},
          {"left", record.left}};
}

} // namespace

std::string words_of(const Mesh_state& state) {
  return counted(state.faces, "face", "faces") + " in " + counted(state.parts, "part", "parts") +
         ", genus " + std::to_string(state.genus) + ", " +
         (state.boundaries == 0 ? "closed, volume " + formatted("%.6g", state.volume)
                                : counted(state.boundaries, "boundary curve", "boundary curves")) +
         (state.crossings == 0
              ? std::string(", no self-intersections")
              : ", " + counted(state.crossings, "pair of faces crosses", "pairs of faces cross"));
}

// What was read comes first, then what the repair did, then the mesh that it is, and so on.
std::string table_of_cleaning(const Cleaned_soup& cleaned) {
  std::string text = "file        " + counted(cleaned.faces_in_file, "face", "faces") + ", " +
                     counted(cleaned.vertices_in_file, "vertex", "vertices") + "\n";
  bool is_mesh = false;
  for(const Clean_record& record : cleaned.records) {
    if(record.step != Clean_step::REPAIR && !std::exchange(is_mesh, true))
      text += "surface     " + words_of(cleaned.before) + "\n";
    text += lines(name_of(record.step), "", record.done);
    text += lines(record.done.empty() ? name_of(record.step) : "", "left: ", record.left);
  }
  return text + "result      " + words_of(cleaned.after) + "\n";
}

void write_clean_json(const std::string& target, const Cleaned_soup& cleaned) {
  Json_writer out(target);
  out.member("format", "htloops-clean/1");
  out.member("input", {{"vertices", cleaned.vertices_in_file}, {"faces", cleaned.faces_in_file}});
  out.member("before", json_of(cleaned.before));
  out.array("steps", cleaned.records, [](const Clean_record& record) { return json_of(record); });
  out.member("after", json_of(cleaned.after));
  out.finish();
}

} // namespace htloops
