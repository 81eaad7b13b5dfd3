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

#include "solve/answer.h"
#include "write/pair_listing.h"
#include "write/text_writer.h"

#include <string>

namespace htloops {

/// Writes a header and a row for each listed pair, as RFC 4180 has it: the mesh, the number, the
/// lengths, the side on which each loop bounds, and where the shorter loop is. Numbers read back
/// exactly.
class Pair_csv_writer
{
public:
  explicit Pair_csv_writer(const std::string& target);

  void add(const std::string& mesh_file, const Answer& answer, const Pair_listing& listing);
  void finish() { out_.finish(); }

private:
  Text_writer out_;
};

/// writes the pairs of one mesh.
void write_pair_csv(const std::string& target,
                    const std::string& mesh_file,
                    const Answer& answer,
                    const Pair_listing& listing);

} // namespace htloops

#endif // HTLOOPS_PAIR_CSV_H
