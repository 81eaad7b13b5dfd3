// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_MENDING_H
#define HTLOOPS_MENDING_H

#include "mend/mended_soup.h"

namespace htloops {

/// applies remedies. What they do not help against stays: points that are nowhere, surfaces that
/// are not orientable. A sound soup is left as it is. Takes a time that is linear but for sorting.
Mended_soup mend(Soup soup, const Remedies& remedies);

} // namespace htloops

#endif // HTLOOPS_MENDING_H
