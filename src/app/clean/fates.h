// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_FATES_H
#define HTLOOPS_FATES_H

#include "clean/cleaning.h"
#include "clean/parts.h"

#include <vector>

namespace htloops {

/// What becomes of the parts of a mesh, and the records of the steps that say so.
struct Part_fates
{
  std::vector<Face_fate> fates; ///< by part
  Clean_record floaters{Clean_step::FLOATERS}, shells{Clean_step::SHELLS};
};

/*!
Decides which parts go. Small parts: each less than a share of the volume, and than that to the
power of 2/3 of the area, as what is thin and wide is no crumb; those that meet no other one; and
all of them if they are, together, less than five times as much, else none. What has a boundary that
could not be closed has no volume: such parts go if they are, together, less than a hundredth of the
area. Shells: what lies inside of another part; but where both had a boundary, and the inner one is
no less than that of the area, they may be one wall, as of a bowl that lacks its rim; and those that
bound a hollow, or lie in one, stay if without them the volume of the piece would change much,
unless that is asked for. The largest part stays.
\param is_copy by part, whether it is one of another, at the same place: these go as shells do
\param was_open by part, whether it had a boundary before that was closed
\param is_separated by part, whether channels to one around it have been closed: the hollow is to go
*/
Part_fates fates_of(const Parts& parts,
                    const std::vector<char>& is_copy,
                    const std::vector<char>& was_open,
                    const std::vector<char>& is_separated,
                    const Clean_options& options);

} // namespace htloops

#endif // HTLOOPS_FATES_H
