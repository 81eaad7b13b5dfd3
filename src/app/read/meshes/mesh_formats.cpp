// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "read/meshes/mesh_formats.h"

#include "failure.h"
#include "read/meshes/readers.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <utility>

namespace htloops {
namespace {

struct Mesh_format
{
  std::string_view ending;
  Soup (*read)(const Input_file&);
};

constexpr Mesh_format mesh_readers[] = {
    {".off", read_off},   {".obj", read_obj},         {".ply", read_ply}, {".stl", read_stl},
#ifdef HTLOOPS_HAS_GLTF
    {".glb", read_gltf},  {".gltf", read_gltf},
#endif
#ifdef HTLOOPS_HAS_3MF
    {".3mf", read_3mf},
#endif
    {".vtp", read_vtk},   {".vtu", read_vtk},         {".msh", read_msh}, {".msh2", read_msh},
    {".gii", read_gifti}, {".surf", read_freesurfer},
};

struct Missing_format
{
  std::string_view ending;
  const char* needs;
};

constexpr Missing_format missing_formats[] = {
#ifndef HTLOOPS_HAS_GLTF
    {".glb", "tinygltf"},
    {".gltf", "tinygltf"},
#endif
#ifndef HTLOOPS_HAS_3MF
    {".3mf", "Expat"},
#endif
    {"", ""}};

bool is_of_text(char c) { return c == '\t' || c == '\n' || c == '\r' || (' ' <= c && c <= '~'); }

// By the mark and the first character: the header of a binary file may begin as it likes.
bool is_utf16(std::string_view content) {
  if(content.size() < 4)
    return false;
  const std::string_view mark = content.substr(0, 2);
  return (mark == "\xFF\xFE" && is_of_text(content[2]) && content[3] == '\0') ||
         (mark == "\xFE\xFF" && content[2] == '\0' && is_of_text(content[3]));
}

[[noreturn]] void fail_at_format(const Input_file& file) {
  for(const Missing_format& format : missing_formats)
    if(!format.ending.empty() && file.is_of_format(format.ending))
      fail_to_read(file.name(), "this build cannot read " + std::string(format.ending) +
                                    ": it was built without " + format.needs);
  fail_to_read(file.name(), "its extension does not name a supported format; those are: " +
                                words_of_mesh_endings() +
                                " (--format says which one it is, whatever its name)");
}

// How files of some formats begin, whatever their names.
constexpr std::pair<std::string_view, std::string_view> marks[] = {
    {"glTF", ".glb"}, {"ply\n", ".ply"},  {"ply\r", ".ply"},  {"OFF", ".off"},
    {"COFF", ".off"}, {"PK\3\4", ".3mf"}, {"solid ", ".stl"}, {"$MeshFormat", ".msh"},
};

const Mesh_format* format_by_mark(std::string_view content) {
  for(const auto& [mark, ending] : marks)
    if(content.substr(0, mark.size()) == mark)
      for(const Mesh_format& format : mesh_readers)
        if(format.ending == ending)
          return &format;
  return nullptr;
}

std::string format_name(const Mesh_format& format) {
  return boost::algorithm::to_upper_copy(std::string(format.ending.substr(1)));
}

// Only once it has failed, as the header of a binary STL file may begin as it likes.
Soup read_by_format(const Mesh_format& format, const Input_file& file) {
  try {
    return format.read(file);
  } catch(const Failure& failure) {
    const Mesh_format* const other = format_by_mark(file.content());
    if(failure.code() != Exit_code::UNREADABLE_FILE || other == nullptr ||
       other->read == format.read)
      throw;
    fail_to_read(file.name(), "it is not " + format_name(format) + ", but looks like " +
                                  format_name(*other) + "; try --format " +
                                  std::string(other->ending.substr(1)));
  }
}

// Packed by gzip or not.
bool ends_in_one_of(std::string_view file, const std::vector<std::string>& endings) {
  if(boost::algorithm::iends_with(file, ".gz"))
    file.remove_suffix(3);
  return std::any_of(endings.begin(), endings.end(), [file](const std::string& ending) {
    return boost::algorithm::iends_with(file, ending);
  });
}

} // namespace

const std::vector<std::string>& endings_of_meshes() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> all;
    for(const Mesh_format& format : mesh_readers)
      all.emplace_back(format.ending);
    return all;
  }();
  return endings;
}

std::string words_of_mesh_endings() { return boost::algorithm::join(endings_of_meshes(), " "); }

bool is_named_as_mesh(std::string_view file) {
  return is_named_as_freesurfer(file) || ends_in_one_of(file, endings_of_meshes());
}

bool is_named_as_freesurfer(std::string_view file) {
  static const std::vector<std::string> endings = {".orig",     ".nofix",    ".white", ".pial",
                                                   ".smoothwm", ".inflated", ".sphere"};
  return ends_in_one_of(file, endings);
}

Soup read_soup(const Input_file& file) {
  if(is_utf16(file.content()))
    fail_to_read(file.name(), "the file is UTF-16; save it as UTF-8 or ASCII");
  for(const Mesh_format& format : mesh_readers)
    if(file.is_of_format(format.ending))
      return read_by_format(format, file);
  if(is_freesurfer(file.content()))
    return read_freesurfer(file);
  fail_at_format(file);
}

} // namespace htloops
