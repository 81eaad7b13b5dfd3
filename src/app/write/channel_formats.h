// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_CHANNEL_FORMATS_H
#define HTLOOPS_CHANNEL_FORMATS_H

#include "solve/channels.h"

#include <string>
#include <vector>

namespace htloops {

/// throws `Failure` if the name of a file does not tell a format that channels can be written in.
void check_channel_format(const std::string& file);

/// writes channels as atoms with their radii in the column of B factors, which PyMOL and ChimeraX
/// read (.pdb), as balls of ChimeraX (.bild), or as a table (.csv). Throws `Failure` if PDB has no
/// room for the coordinates.
void write_channels(const std::string& file, const std::vector<Channel>& channels);

} // namespace htloops

#endif // HTLOOPS_CHANNEL_FORMATS_H
