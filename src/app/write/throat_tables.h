// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_THROAT_TABLES_H
#define HTLOOPS_THROAT_TABLES_H

#include "solve/throat_solver.h"
#include "write/documents.h"
#include "write/files.h"
#include "write/tables.h"

#include <cstddef>
#include <string>
#include <vector>

namespace htloops {

/// The header before rows of throats, as RFC 4180 has it.
constexpr char throat_header[] = "mesh,throat,length,diameter,prominence,separating,bounds,pair,"
                                 "kind,through,x,y,z,xmin,ymin,zmin,xmax,ymax,zmax,genus,error";

constexpr Table_column throat_columns[] = {
    {"throat", 6, true, {}, "The number of the throat"},
    {"length", 12, true, {}, "The length of the loop around the narrow place"},
    {"diameter", 12, true, {}, "The diameter of a circle as long as the loop"},
    {"prominence",
     12,
     true,
     {},
     "About how much longer the loop must become before it slips off; any: it never does"},
    {"bounds",
     9,
     false,
     {},
     "The side of the surface on which the loop bounds a disk or another surface"},
    {"class of",
     10,
     false,
     {},
     "The handle or tunnel loop into which it can be deformed; none: it cuts the surface in "
     "two"},
    {"center", 0, false, {}, "The center of the bounding box of the loop"}};

/// what stands in the columns.
std::vector<std::string> cells_of(const Throats& throats, const Throat& throat);

/// a table of throats for a person, the most prominent first, and through which vertices there are
/// no loops. Empty if they were not asked for.
std::string table_of_throats(const Throats& throats, bool show_all);

/// writes the cells of a throat, without the end of the line. Where it cannot slip away, its
/// prominence is "inf".
void write_throat_row(Text& out,
                      const std::string& mesh_file,
                      const Throats& throats,
                      const Throat& throat,
                      std::size_t genus);

/// what a document says of a throat besides its line; an infinite prominence is null.
Json json_of(const Throats& throats, const Throat& throat);

/// of loops that separate.
constexpr Colour colour_of_separating = {204, 121, 167};

/// the colour of a throat: that of the loops of its class, or one for those that separate.
Colour colour_of(const Throat& throat);

} // namespace htloops

#endif // HTLOOPS_THROAT_TABLES_H
