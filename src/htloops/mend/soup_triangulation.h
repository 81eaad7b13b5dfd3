// Copyright (c) 2026 The Handle_tunnel_loops authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Handle_tunnel_loops authors

#ifndef HTLOOPS_SOUP_TRIANGULATION_H
#define HTLOOPS_SOUP_TRIANGULATION_H

#include "mend/mended_soup.h"

namespace htloops {

/// makes triangles of all faces of more than three vertices. Vertices stay; no diagonal becomes an
/// edge of a further face, if that can be. Points must be finite.
void triangulate(Mended_soup& mended);

} // namespace htloops

#endif // HTLOOPS_SOUP_TRIANGULATION_H
