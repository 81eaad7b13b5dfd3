// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_DOCUMENTS_H
#define HTLOOPS_DOCUMENTS_H

#include "mesh_types.h"
#include "solve/answer.h"
#include "solve/cut_solver.h"
#include "solve/reeb_solver.h"
#include "solve/removal_solver.h"
#include "solve/skeleton_solver.h"

#include <nlohmann/json.hpp>

#include <string>

namespace htloops {

/// Members keep their order. What is not finite is written as null, as JSON has no infinity, which
/// a length may reach where coordinates almost do.
using Json = nlohmann::ordered_json;

/// on one line. A name of a file may be anything; what is no UTF-8 is replaced.
std::string text_of(const Json& value);

/// What was asked for, beside the mesh itself.
struct Run_record
{
  std::string mesh_file;
  Json options; ///< an object
  double read_seconds = 0.;
  Face_cuts cuts = {};
};

/// writes an answer in the format "htloops/1", of which
/// doc/Handle_tunnel_loops/schemas/loops.schema.json is the schema; every number reads back as
/// exactly itself.
void write_loops_json(const std::string& target,
                      const Mesh& mesh,
                      const Answer& answer,
                      const Run_record& run);

/// the same as a value.
Json loops_document(const Mesh& mesh, const Answer& answer, const Run_record& run);

/// writes a Reeb graph in the format "htloops-reeb/1"; every number reads back as exactly itself.
void write_reeb_json(const std::string& target,
                     const Mesh& mesh,
                     const Reeb_answer& answer,
                     double read_seconds);

/// writes a curve skeleton in the format "htloops-skeleton/1"; every number reads back as exactly
/// itself.
void write_skeleton_json(const std::string& file,
                         const Skeleton_answer& answer,
                         const Run_record& run);

/// the same as a value.
Json skeleton_document(const Skeleton_answer& answer, const Run_record& run);

/// writes what was removed and what was refused in the format "htloops-remove/1"; the name "-" is
/// the standard output.
void write_removal_json(const std::string& file, const Removal_report& report);

/// writes in the format "htloops-map/1" which vertex and face each one of the result was before, or
/// none, and of which face each face is a part.
void write_map_json(const std::string& target,
                    std::size_t number_of_vertices_before,
                    std::size_t number_of_faces_before,
                    const Changed_mesh& changed);

/// writes the cuts, with the loops that they cross, as a document of format "htloops-dual/1".
void write_dual_cuts_json(const std::string& target, const Mesh& mesh, const Dual_cuts& cuts);

/// writes the events of the fronts as JSON, format "htloops-events/1"; `target` may be "-". Only
/// the reference solver knows of a resolution. Throws `Failure` if the file cannot be written.
void write_events(const std::string& target, const Answer& answer);

/// adds what either way to remove a handle would change, or why it cannot be.
void add_costs(Json& pair, const Costs::value_type& costs);

} // namespace htloops

#endif // HTLOOPS_DOCUMENTS_H
