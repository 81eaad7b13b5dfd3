// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CLEAN_REPORT_H
#define HTLOOPS_CLEAN_REPORT_H

#include "clean/soup_cleaning.h"

#include <string>

namespace htloops {

/// what a mesh is, in a line.
std::string words_of(const Mesh_state& state);

/// what each step did and left, for a person; what it did not do is left out.
std::string table_of_cleaning(const Cleaned_soup& cleaned);

/// writes the same in the format "htloops-clean/1"; the name "-" is the standard output.
void write_clean_json(const std::string& target, const Cleaned_soup& cleaned);

} // namespace htloops

#endif // HTLOOPS_CLEAN_REPORT_H
