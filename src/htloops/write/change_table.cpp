// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#include "write/change_table.h"

#include "write/table_rows.h"

namespace htloops {

std::string table_of_changes(const std::string& file, const std::vector<Change>& changes) {
  if(changes.empty())
    return "htloops: " + file + " needed no mending\n";
  std::string table = "htloops: " + file + " was mended:\n";
  for(const Change& change : changes)
    table += formatted("%9zu  ", change.count) + change.words + "\n";
  return table;
}

} // namespace htloops
