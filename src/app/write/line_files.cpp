// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/line_files.h"

#include "failure.h"
#include "file_names.h"
#include "words.h"
#include "write/documents.h"

#include <boost/algorithm/string/predicate.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace htloops {
namespace {

// What stands for the mesh in a row: a cell, with its quotes.
std::string first_cell(const std::string& row) {
  if(row.empty() || row.front() != '"')
    return row.substr(0, row.find(','));
  std::size_t end = row.find('"', 1);
  while(end != std::string::npos && row.compare(end + 1, 1, "\"") == 0)
    end = row.find('"', end + 2);
  return row.substr(0, end == std::string::npos ? end : end + 1);
}

// Whether a row that was cut off may be about the mesh of another.
bool may_continue(const std::string& whole, const std::string& part) {
  const std::string begin = first_cell(whole) + ",";
  return boost::algorithm::starts_with(part, begin) || boost::algorithm::starts_with(begin, part);
}

// Lines that are whole, and what follows them.
std::pair<std::vector<std::string>, std::string> parted(const std::string& text) {
  const std::size_t end = text.rfind('\n') + 1;
  return {lines_of(text.substr(0, end)), text.substr(end)};
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for(const std::string& line : lines)
    text += line + "\n";
  return text;
}

void go_on_with_rows(Line_file& rows) {
  auto [lines, rest] = parted(rows.file.old_lines());
  if(!lines.empty() && !rest.empty() && may_continue(lines.back(), rest)) {
    const std::string cell = first_cell(lines.back()); // all of this mesh is to be told again
    while(!lines.empty() && first_cell(lines.back()) == cell)
      lines.pop_back();
  }
  for(const std::string& line : lines)
    rows.meshes.insert(first_cell(line));
  rows.file.go_on_after(joined(lines));
}

void go_on_with_objects(Line_file& objects) {
  const std::vector<std::string> lines = parted(objects.file.old_lines()).first;
  for(const std::string& line : lines) {
    const Json json = Json::parse(line, nullptr, false);
    if(!json.is_object() || !json.contains("mesh") || !json["mesh"].is_string())
      throw wrong_usage(printable(objects.file.target()) +
                        " cannot be resumed: its lines are not JSON objects of meshes");
    objects.meshes.insert(json["mesh"].get<std::string>());
  }
  objects.file.go_on_after(joined(lines));
}

} // namespace

Line_files::Line_files(const std::string& csv_file, const std::string& jsonl_file, Row_kind kind)
    : kind_(kind) {
  if(!csv_file.empty())
    rows_.emplace(Line_file{Growing_file(csv_file, header_of_rows(kind))});
  if(!jsonl_file.empty())
    objects_.emplace(Line_file{Growing_file(jsonl_file)});
}

void Line_files::resume() {
  if(rows_)
    go_on_with_rows(*rows_);
  if(objects_)
    go_on_with_objects(*objects_);
}

bool Line_files::has(const std::string& mesh_file) const {
  return (!rows_ || rows_->meshes.count(as_cell(mesh_file)) != 0) &&
         (!objects_ || objects_->meshes.count(as_utf8(mesh_file)) != 0);
}

void Line_files::add(const Mesh_line& line) {
  Text rows, object;
  if(rows_ && rows_->meshes.insert(as_cell(line.mesh_file)).second) {
    write_rows(rows, line, kind_);
    rows_->file.append(rows.all());
  }
  if(objects_ && objects_->meshes.insert(as_utf8(line.mesh_file)).second) {
    write_mesh_line(object, line);
    objects_->file.append(object.all());
  }
}

} // namespace htloops
