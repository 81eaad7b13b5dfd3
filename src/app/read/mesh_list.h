// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MESH_LIST_H
#define HTLOOPS_MESH_LIST_H

#include <string>
#include <vector>

namespace htloops {

/// the files that a word stands for: of a folder those in it that are named as meshes, of a pattern
/// with *, ? and [] what it fits, if there is no file of this very name; sorted. What stands for
/// nothing stays as it is.
std::vector<std::string> files_of(const std::string& word);

/// the same of several words, each file once.
std::vector<std::string> files_of(const std::vector<std::string>& words);

/// whether words may stand for more than one file, even if they do not.
bool may_be_many(const std::vector<std::string>& words);

} // namespace htloops

#endif // HTLOOPS_MESH_LIST_H
