// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_PAIR_CSV_H
#define HTLOOPS_PAIR_CSV_H

#include "write/pair_listing.h"

#include "solve/answer.h"

#include <string>

namespace htloops {

/// writes a header and a row for each listed pair, as RFC 4180 has it: numbers, lengths, the side
/// on which each loop bounds, and where the shorter loop is. Numbers read back exactly.
void write_pair_csv(const std::string& target, const Answer& answer, const Pair_listing& listing);

} // namespace htloops

#endif // HTLOOPS_PAIR_CSV_H
