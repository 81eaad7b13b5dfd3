// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PAIR_TABLE_H
#define HTLOOPS_PAIR_TABLE_H

#include "solve/answer.h"
#include "write/pair_listing.h"
#include "write/table_rows.h"

#include <string>
#include <vector>

namespace htloops {

struct Table_options
{
  bool show_all = false; ///< otherwise the middle of a long table is left out
  bool use_colour = false;
  bool is_verbose = false; ///< why no device was used, too
};

constexpr Table_column pair_columns[] = {{"pair", 5, true},
                                         {"handle", 12, true},
                                         {"tunnel", 12, true},
                                         {"size", 8, true},
                                         {"centre of the shorter", 34, false},
                                         {"its box", 0, false}};

/// what stands in the columns.
std::vector<std::string> cells_of(const Listed_pair& pair);

/// a table of pairs for a person: how long the loops are, and where the handles are.
std::string table_of_pairs(const Pair_listing& listing, const Table_options& options);

/// lines that sum up an answer and what it took, and why loops do not bound, if there are such.
std::string summary(const Answer& answer, double read_seconds, const Table_options& options);

} // namespace htloops

#endif // HTLOOPS_PAIR_TABLE_H
