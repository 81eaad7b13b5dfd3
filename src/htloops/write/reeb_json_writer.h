// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_REEB_JSON_WRITER_H
#define HTLOOPS_REEB_JSON_WRITER_H

#include "solve/reeb_answer.h"

#include <string>

namespace htloops {

/// writes a Reeb graph in the format "htloops-reeb/1"; every number reads back as exactly itself.
void write_reeb_json(const std::string& target,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     double read_seconds);

} // namespace htloops

#endif // HTLOOPS_REEB_JSON_WRITER_H
