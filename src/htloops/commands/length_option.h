// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_LENGTH_OPTION_H
#define HTLOOPS_LENGTH_OPTION_H

#include "mesh_types.h"

#include <string>

namespace htloops {

/// A length that is given as it is, or as a percentage of the diagonal of the mesh's bounding box.
struct Length_option
{
  double value = 0.;
  bool is_percentage = false;
};

/// understands "0.25" and "3%"; throws `Failure`, naming the option, if the text is no positive
/// length.
Length_option parse_length(const std::string& option, const std::string& text);

double length_on(const Mesh& mesh, const Length_option& length);

} // namespace htloops

#endif // HTLOOPS_LENGTH_OPTION_H
