// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SYSTEM_FILES_H
#define HTLOOPS_SYSTEM_FILES_H

#include <cstdio>
#include <filesystem>
#include <string>

namespace htloops {

/// the path of a file whose name is in UTF-8, as all names are here. (Systems other than Windows do
/// not care.)
inline std::filesystem::path path_of(const std::string& name) {
  return std::filesystem::u8path(name);
}

/// and the name of a path, the folders of which are divided by slashes.
inline std::string name_of_path(const std::filesystem::path& path) {
  return path.generic_u8string();
}

/// opens a file as `std::fopen()` does, which knows no such names on Windows. With an "x" in the
/// mode nothing that is there already is opened.
std::FILE* open(const std::string& name, const char* mode);

} // namespace htloops

#endif // HTLOOPS_SYSTEM_FILES_H
