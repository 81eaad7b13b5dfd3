// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOPS_JSON_WRITER_H
#define HTLOOPS_LOOPS_JSON_WRITER_H

#include "mesh_types.h"
#include "solve/answer.h"
#include "write/json_writer.h"

#include <string>

namespace htloops {

/// What was asked for, beside the mesh itself.
struct Run_record
{
  std::string mesh_file;
  Json options; ///< an object
  double read_seconds = 0.;
};

/// writes an answer in the format "htloops/1", of which
/// doc/Handle_tunnel_loops/schemas/loops.schema.json is the schema; every number reads back as
/// exactly itself.
void write_loops_json(const std::string& target,
                      const Mesh& mesh,
                      const Answer& answer,
                      const Run_record& run);

} // namespace htloops

#endif // HTLOOPS_LOOPS_JSON_WRITER_H
