// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LOOPS_READER_H
#define HTLOOPS_LOOPS_READER_H

#include "mesh_types.h"
#include "read/input_file.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace htloops {

/// A place on an edge as it stands in a file, not yet known to be on a mesh.
struct Location_record
{
  long long source, target;
  double ratio;
};

struct Loop_record
{
  double length = 0.;
  std::vector<Location_record> locations;
  std::vector<std::array<double, 3>> points;
};

struct Pair_record
{
  Loop_record handle, tunnel;

  const Loop_record& loop(Loop_type type) const {
    return type == Loop_type::HANDLE ? handle : tunnel;
  }
};

/// A boundary curve, and what was found to go around the same.
struct Boundary_record
{
  Loop_record curve;
  std::optional<Loop_record> waist;
};

/// What a file of the format "htloops/1" says of where loops are, and of which mesh.
struct Loops_record
{
  std::size_t number_of_vertices = 0;
  std::size_t number_of_faces = 0;
  Basis_kind basis_kind = Basis_kind::PURE;
  std::vector<Pair_record> pairs;
  bool has_boundaries = false; ///< older files do not say
  std::vector<Boundary_record> boundaries;
  std::vector<Loop_record> throats;
};

/// reads a file of the format "htloops/1"; throws `Failure`, naming what is missing or of the wrong
/// type, if it is none. Whether the numbers make sense is not looked at.
Loops_record read_loops_json(const Input_file& file);

/// Loops from a file as loops on a mesh, as far as they are ones.
struct Bound_loops
{
  Basis_kind basis_kind;            ///< what they are meant to be
  Pairs pairs;                      ///< complete only if there is no problem
  bool has_boundaries = false;      ///< whether the file tells of them
  std::vector<Loop> curves, waists; ///< of the boundary
  std::vector<Loop> throats;
  bool are_placed = true;            ///< whether all that is named is on the mesh
  std::vector<std::string> problems; ///< in words, naming pair, kind and position; worst first
};

/// finds the places that a file names on the mesh. A problem is another mesh, an index or a ratio
/// out of range, two vertices without an edge, a point that is not where its location is, a wrong
/// length. Where that is all, loops are complete, with the lengths that they have. If most points
/// are wrong, there is one problem in their place: the loops are not placed.
Bound_loops bind_loops(const Loops_record& record, const Mesh& mesh);

} // namespace htloops

#endif // HTLOOPS_LOOPS_READER_H
